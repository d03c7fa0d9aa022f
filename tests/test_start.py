"""The commands of ``make run``, in its order, as a user runs them: each in a process of its own in an empty folder."""

import importlib.util
import math
import os
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from starlette.testclient import TestClient

README = Path(__file__).resolve().parent.parent / "README.md"
DRIVEWRIGHT = str(Path(sys.executable).parent / "drivewright")
START_SECONDS = 60.0


def environment() -> dict[str, str]:
    """The environment without any setting of Drivewright."""
    return {k: v for k, v in os.environ.items() if k != "DATABASE_URL" and not k.startswith("DRIVEWRIGHT_")}


def run(folder: Path, *arguments: str) -> str:
    """Standard output of a command that must succeed."""
    done = subprocess.run(
        [DRIVEWRIGHT, *arguments], cwd=folder, env=environment(), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.skipif(importlib.util.find_spec("app.main") is None, reason="there is no application to serve yet")
def test_from_nothing_to_a_page_with_the_commands_of_make_run(tmp_path: Path):
    run(tmp_path, "migrate")
    run(tmp_path, "load-catalog")
    assert (tmp_path / "var/drivewright.db").is_file()
    with socket.create_server(("127.0.0.1", 0)) as probe:
        port = probe.getsockname()[1]
    server = subprocess.Popen(
        [DRIVEWRIGHT, "serve", "--port", str(port)], cwd=tmp_path, env=environment(), stdout=subprocess.PIPE, text=True
    )
    try:
        assert server.stdout is not None
        address = f"http://127.0.0.1:{port}"
        assert server.stdout.readline() == f"Drivewright: {address}\n"
        page = _first_answer(address, server)
        assert re.search(r"<h1[ >]", page)
        health = urllib.request.urlopen(address + "/healthz", timeout=5)
        assert health.status == 200
    finally:
        server.send_signal(signal.SIGTERM)
        server.wait(timeout=20)


def _first_answer(address: str, server: "subprocess.Popen[str]") -> str:
    """Text of the page at ``address`` as soon as the server answers."""
    deadline = time.monotonic() + START_SECONDS
    while time.monotonic() < deadline:
        assert server.poll() is None, "the server ended"
        try:
            with urllib.request.urlopen(address, timeout=5) as answer:
                return str(answer.read().decode())
        except urllib.error.HTTPError:
            raise
        except OSError:
            time.sleep(0.2)
    raise AssertionError("the server did not answer")


def test_the_sizing_of_the_readme_prints_what_the_readme_shows(tmp_path: Path):
    block = re.search(r"^    \$ \.venv/bin/drivewright (size (\S+))\n((?:    .*\n)+)", README.read_text(), re.MULTILINE)
    assert block is not None
    shown = [" ".join(line.split()) for line in block[3].splitlines() if line.strip() != "..."]
    run(tmp_path, "load-catalog")
    printed = [" ".join(line.split()) for line in run(tmp_path, "size", str(README.parent / block[2])).splitlines()]
    assert len(shown) >= 5
    assert [line for line in printed if line in shown] == shown


def test_rest_gives_the_numbers_of_the_readme(client: "TestClient"):
    answer = client.post("/api/v1/sizings", content=(README.parent / "docs/vertical_axis.json").read_bytes())
    assert answer.status_code == 200, answer.text
    checks = {check["name"]: check for check in answer.json()["checks"]}
    # held without help of friction: m g p / (2 pi) = 60 kg * 9.81 m/s2 * 0.01 m / (2 pi)
    assert checks["Holding brake"]["demanded"] == pytest.approx(60 * 9.81 * 0.01 / (2 * math.pi), rel=1e-9)
    assert checks["Holding brake"]["permitted"] == 3.2
    assert checks["Motor speed"]["demanded"] == pytest.approx(2000)  # 20 m/min on a lead of 10 mm


def test_loading_the_catalogue_again_changes_nothing(tmp_path: Path):
    run(tmp_path, "migrate")
    run(tmp_path, "load-catalog")
    before = (tmp_path / "var/drivewright.db").read_bytes()
    run(tmp_path, "migrate")
    run(tmp_path, "load-catalog")
    assert (tmp_path / "var/drivewright.db").read_bytes() == before
