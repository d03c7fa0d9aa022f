"""The house itself: settings, documents, container and the way in."""

import itertools
import os
import re
import runpy
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml
from pydantic import ValidationError

from app.settings import Settings, describe_variables, read_settings, variable_of

ROOT = Path(__file__).resolve().parent.parent

ONLY_READS = """
import importlib, pkgutil, sys
import app
ours = []
def watch(event, arguments):
    if event in {"sqlite3.connect", "socket.connect", "socket.bind"}:
        ours.append((event, str(arguments)))
    if event == "open" and isinstance(arguments[1], str) and set(arguments[1]) & set("wax+"):
        ours.append((event, str(arguments)))
sys.addaudithook(watch)
for module in pkgutil.walk_packages(app.__path__, "app."):
    importlib.import_module(module.name)
assert not ours, ours
"""


def test_the_defaults_serve_this_machine_only():
    settings = read_settings()
    assert settings.host == "127.0.0.1"
    assert settings.database_url == "sqlite:///var/drivewright.db"
    assert settings.catalog_dir == ROOT / "catalog_data"
    assert settings.max_body_bytes == 2**20


def test_the_environment_is_read(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("DRIVEWRIGHT_PORT", "8123")
    monkeypatch.setenv("DRIVEWRIGHT_LOG_LEVEL", "WARNING")
    monkeypatch.setenv("DRIVEWRIGHT_HOST", "")
    settings = read_settings()
    assert (settings.port, settings.log_level, settings.host) == (8123, "warning", "127.0.0.1")


@pytest.mark.parametrize("spelling", ["postgres", "postgresql", "postgresql+psycopg"])
def test_every_spelling_of_postgresql_names_the_driver(monkeypatch: pytest.MonkeyPatch, spelling: str):
    monkeypatch.setenv("DATABASE_URL", f"{spelling}://user:word@host/name")
    assert read_settings().database_url == "postgresql+psycopg://user:word@host/name"


@pytest.mark.parametrize(
    ("variable", "value"),
    [
        ("DATABASE_URL", "mysql://host/name"),
        ("DRIVEWRIGHT_PORT", "70000"),
        ("DRIVEWRIGHT_WORKERS", "0"),
        ("DRIVEWRIGHT_LOG_LEVEL", "loud"),
        ("DRIVEWRIGHT_MAX_BODY_BYTES", "12"),
    ],
)
def test_an_impossible_setting_is_refused_by_name(monkeypatch: pytest.MonkeyPatch, variable: str, value: str):
    monkeypatch.setenv(variable, value)
    with pytest.raises(ValidationError) as caught:
        read_settings()
    assert [variable_of(error["loc"]) for error in caught.value.errors()] == [variable]


def test_every_setting_is_in_the_document():
    rows = re.findall(r"^\| `(\w+)` \| `([^`]*)` \| (.*) \|$", (ROOT / "docs/settings.md").read_text(), re.MULTILINE)
    assert rows == describe_variables()
    assert len(rows) == len(Settings.model_fields)


def test_importing_any_module_opens_nothing(tmp_path: Path):
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, "-c", ONLY_READS], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert list(tmp_path.iterdir()) == []


def test_every_dependency_is_pinned():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    declared = list(itertools.chain(project["dependencies"], *project["optional-dependencies"].values()))
    names = {re.split(r"[^\w.-]", entry)[0].lower().replace("_", "-") for entry in declared}
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    pinned = {re.fullmatch(r"([\w.-]+)==[\w.+!]+", line)[1].lower().replace("_", "-") for line in lines if line}
    assert names - pinned == set()


def test_the_first_command_of_the_readme_comes_early():
    lines = (ROOT / "README.md").read_text().splitlines()
    assert next(number for number, line in enumerate(lines, 1) if line.startswith("    make run")) <= 25


def test_every_local_link_of_the_documents_leads_somewhere():
    for document in [ROOT / "README.md", ROOT / "CHANGELOG.md", *(ROOT / "docs").glob("*.md")]:
        for target in re.findall(r"\]\(([^)#]+)[^)]*\)", document.read_text()):
            if "://" not in target:
                assert (document.parent / target).exists(), f"{document.name}: {target}"


def test_the_image_is_pinned_runs_without_root_and_reports_its_health():
    text = (ROOT / "Dockerfile").read_text()
    bases = re.findall(r"^FROM (\S+)", text, re.MULTILINE)
    assert bases
    assert all(re.search(r":\d", base) for base in bases), bases
    last_stage = text[text.rindex("\nFROM ") :]
    user = re.search(r"^USER (\S+)", last_stage, re.MULTILINE)
    assert user is not None
    assert user[1] not in {"root", "0"}
    assert re.search(r"^HEALTHCHECK (.|\n)*?/healthz", last_stage, re.MULTILINE)
    assert not re.search(r"PASSWORD|SECRET|TOKEN", text)


def test_the_image_holds_every_folder_that_runs():
    kept = {line[1:] for line in (ROOT / ".dockerignore").read_text().splitlines() if line.startswith("!")}
    generated = re.compile(r"\..*|.*\.egg-info|__pycache__|var|build|dist|node_modules")
    folders = {path.name for path in ROOT.iterdir() if path.is_dir() and not generated.fullmatch(path.name)}
    assert folders - kept == folders & {"tests", "benchmarks", "docs", "tools"}
    dockerfile = (ROOT / "Dockerfile").read_text()
    copied = re.findall(r"^COPY (?!--from)(.+) \S+$", dockerfile, re.MULTILINE)
    started = re.findall(r"^ENTRYPOINT .*/srv/drivewright/([^\"]+)", dockerfile, re.MULTILINE)
    sources = {source for line in [*copied, *started] for source in line.split()} - {"."}
    assert sources
    assert sources - kept == set()
    assert [source for source in sources if not (ROOT / source).exists()] == []


def test_the_composition_waits_for_its_database_and_brings_no_password():
    services = yaml.safe_load((ROOT / "compose.yaml").read_text())["services"]
    database, application = services["database"], services["app"]
    assert re.fullmatch(r"postgres:\d\S+", database["image"])
    assert database["healthcheck"]["test"]
    assert database["volumes"]
    assert application["depends_on"]["database"]["condition"] == "service_healthy"
    for text in (database["environment"]["POSTGRES_PASSWORD"], application["environment"]["DATABASE_URL"]):
        assert "${POSTGRES_PASSWORD:?" in text


def test_the_build_server_runs_the_tests():
    script = ROOT / ".ci/run"
    assert os.access(script, os.X_OK)
    assert "exec make test" in script.read_text()


@pytest.mark.parametrize("command", ["migrate", "load-catalog", "serve"])
def test_make_run_calls_commands_that_exist(command: str):
    from typer.main import get_command

    from app.cli import app

    assert f"drivewright {command}" in (ROOT / "Makefile").read_text()
    assert command in get_command(app).commands


def test_an_impossible_setting_stops_a_command_without_a_stack_trace(monkeypatch: pytest.MonkeyPatch):
    from typer.testing import CliRunner

    from app.cli import app

    monkeypatch.setenv("DRIVEWRIGHT_WORKERS", "none")
    result = CliRunner().invoke(app, ["migrate"])
    assert result.exit_code == 2
    assert "DRIVEWRIGHT_WORKERS: " in result.output
    assert "Traceback" not in result.output


@pytest.mark.parametrize("script", sorted((ROOT / "benchmarks").glob("*.py")), ids=lambda path: path.stem)
def test_a_measurement_still_finds_what_it_measures(script: Path):
    runpy.run_path(str(script), run_name="imported")
