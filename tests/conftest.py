"""Fixtures that every part of the suite shares.

Everything heavy is imported inside its fixture: a test of the engine needs neither the database nor the web.

===================== ============== =================================================================
fixture               scope          what it is
===================== ============== =================================================================
settings              test           settings of an instance with its own SQLite file (not yet made)
database              test           URL of that file, migrated and with the shipped catalogue loaded
empty_database        test           URL of a migrated database without catalogue
any_database          test, twice    like ``database``, once on SQLite and once on PostgreSQL
postgres_url          session        URL of an empty PostgreSQL database
postgres_databases    session        call it for the URL of a further empty PostgreSQL database
postgres_database     test           like ``database`` on PostgreSQL
client                test           HTTP client that runs the application in this process
live_server           session        address of a served application (one per worker process)
chromium, page        session, test  see ``tests/browser.py``
===================== ============== =================================================================
"""

import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck
from hypothesis import settings as hypothesis_settings

from tests.servers import PostgresServer, ServedApp

if TYPE_CHECKING:
    from starlette.testclient import TestClient

    from app.settings import Settings

pytest_plugins = ["tests.browser"]

hypothesis_settings.register_profile(
    "house",
    max_examples=50,
    deadline=None,
    derandomize="CI" in os.environ,
    suppress_health_check=[HealthCheck.too_slow],
)
hypothesis_settings.load_profile("house")


@pytest.fixture(autouse=True)
def _no_settings_from_outside(monkeypatch: pytest.MonkeyPatch) -> None:
    """A test must give the same result whatever the developer has exported."""
    for variable in list(os.environ):
        if variable == "DATABASE_URL" or variable.startswith("DRIVEWRIGHT_"):
            monkeypatch.delenv(variable)


def make_settings(database_url: str) -> "Settings":
    """Settings of a test instance on the given database."""
    from app.settings import Settings

    return Settings(database_url=database_url, log_level="warning")


def sqlite_url(path: Path) -> str:
    """URL of an SQLite file."""
    return f"sqlite:///{path}"


def build_database(url: str, *, with_catalog: bool) -> None:
    """Migrate the database at ``url``; on request load the catalogue that is shipped."""
    from app.db.migrate import upgrade

    upgrade(url)
    if not with_catalog:
        return
    from app.catalog.load import load_catalog
    from app.db.session import make_engine

    engine = make_engine(url)
    try:
        report = load_catalog(engine, make_settings(url).catalog_dir)
        assert report.ok, report.render()
    finally:
        engine.dispose()


@pytest.fixture(scope="session")
def migrated_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An SQLite file that is migrated and empty; copied, never used itself."""
    path = tmp_path_factory.mktemp("migrated") / "template.db"
    build_database(sqlite_url(path), with_catalog=False)
    return path


@pytest.fixture(scope="session")
def loaded_file(tmp_path_factory: pytest.TempPathFactory, migrated_file: Path) -> Path:
    """An SQLite file with the shipped catalogue; copied, never used itself."""
    path = tmp_path_factory.mktemp("loaded") / "template.db"
    shutil.copyfile(migrated_file, path)
    build_database(sqlite_url(path), with_catalog=True)
    return path


@pytest.fixture
def settings(tmp_path: Path) -> "Settings":
    """Settings of an instance of its own; its SQLite file does not exist until ``database`` makes it."""
    return make_settings(sqlite_url(tmp_path / "drivewright.db"))


@pytest.fixture
def database(settings: "Settings", loaded_file: Path) -> str:
    """URL of the database of ``settings``: migrated, with the shipped catalogue."""
    shutil.copyfile(loaded_file, settings.database_url.removeprefix("sqlite:///"))
    return settings.database_url


@pytest.fixture
def empty_database(tmp_path: Path, migrated_file: Path) -> str:
    """URL of a migrated SQLite database without any catalogue row."""
    path = tmp_path / "empty.db"
    shutil.copyfile(migrated_file, path)
    return sqlite_url(path)


@pytest.fixture(scope="session")
def postgres_server() -> Iterator[PostgresServer]:
    """A PostgreSQL server for this worker process; skips with the reason where none can be had."""
    server = PostgresServer.start()
    yield server
    server.stop()


@pytest.fixture(scope="session")
def postgres_databases(postgres_server: PostgresServer) -> Callable[[], str]:
    """Call it for the URL of a new, empty PostgreSQL database."""
    return postgres_server.create_database


@pytest.fixture(scope="session")
def postgres_url(postgres_databases: Callable[[], str]) -> str:
    """URL of one PostgreSQL database, empty when the session begins."""
    return postgres_databases()


@pytest.fixture(scope="session")
def postgres_template(postgres_databases: Callable[[], str]) -> str:
    """URL of a PostgreSQL database with the shipped catalogue; copied, never used itself."""
    url = postgres_databases()
    build_database(url, with_catalog=True)
    return url


@pytest.fixture
def postgres_database(postgres_server: PostgresServer, postgres_template: str) -> Iterator[str]:
    """URL of a PostgreSQL database of its own: migrated, with the shipped catalogue."""
    url = postgres_server.create_database(template=postgres_template)
    yield url
    postgres_server.drop_database(url)


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=pytest.mark.postgres)])
def any_database(request: pytest.FixtureRequest) -> str:
    """URL of a migrated and loaded database, once of each kind that the product supports."""
    url: str = request.getfixturevalue("database" if request.param == "sqlite" else "postgres_database")
    return url


@pytest.fixture
def client(settings: "Settings", database: str) -> "Iterator[TestClient]":
    """HTTP client of an application of its own, with start-up and shut-down run."""
    from starlette.testclient import TestClient

    from app.main import create_app

    assert settings.database_url == database
    with TestClient(create_app(settings)) as test_client:
        yield test_client


@pytest.fixture(scope="session")
def live_server(tmp_path_factory: pytest.TempPathFactory, loaded_file: Path) -> Iterator[str]:
    """Address of the application, served over TCP on its own loaded database: ``http://127.0.0.1:<port>``."""
    path = tmp_path_factory.mktemp("served") / "drivewright.db"
    shutil.copyfile(loaded_file, path)
    with ServedApp(make_settings(sqlite_url(path))) as address:
        yield address
