"""The application as a whole: what it opens and when, health, Plotly's script, headers."""

import gzip
import subprocess
import sys
from importlib import resources
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from app.main import create_app
from app.settings import Settings


def test_importing_and_building_open_nothing(tmp_path: Path):
    code = (
        "import app.main; from app.settings import Settings;"
        f"app.main.create_app(Settings(database_url='sqlite:///{tmp_path}/new/drivewright.db'))"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=Path(__file__).resolve().parents[1])
    assert list(tmp_path.iterdir()) == []


def test_health_needs_no_database(tmp_path: Path):
    with TestClient(create_app(Settings(database_url=f"sqlite:///{tmp_path}/none.db"))) as client:
        assert client.get("/healthz").json()["status"] == "ok"


@pytest.mark.parametrize("encoding", ["gzip", "identity"])
def test_the_chart_script_is_that_of_the_installed_package(client: TestClient, encoding: str):
    script = resources.files("plotly").joinpath("package_data", "plotly.min.js").read_bytes()
    with client.stream("GET", "/static/plotly.min.js", headers={"accept-encoding": encoding}) as response:
        raw = b"".join(response.iter_raw())
    assert "max-age=31536000" in response.headers["cache-control"]
    assert (gzip.decompress(raw) if encoding == "gzip" else raw) == script


def test_nothing_is_fetched_from_elsewhere(client: TestClient):
    policy = client.get("/healthz").headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "http" not in policy


def test_a_new_catalogue_is_noticed(client: TestClient, monkeypatch: pytest.MonkeyPatch):
    from sqlalchemy import text

    running = client.app.state.running  # type: ignore[attr-defined]
    before = running.catalogue.snapshot()
    assert running.catalogue.known_version == before.version
    with running.engine.begin() as connection:
        connection.execute(text("UPDATE catalog_edition SET checksum = 'changed' WHERE id = 1"))
    assert running.catalogue.snapshot() is before
    monkeypatch.setattr(running.catalogue, "_clock", lambda: 1e12)
    assert running.catalogue.known_version == ""
    assert running.catalogue.snapshot().version != before.version
