"""The real servers and the real browser that other tests rely on."""

from typing import TYPE_CHECKING

import pytest
from sqlalchemy import create_engine, text

from tests.servers import PostgresServer

if TYPE_CHECKING:
    from playwright.sync_api import Browser


def run(url: str, statement: str) -> list[tuple[object, ...]]:
    engine = create_engine(url)
    try:
        with engine.begin() as connection:
            result = connection.execute(text(statement))
            return [tuple(row) for row in result] if result.returns_rows else []
    finally:
        engine.dispose()


@pytest.mark.postgres
def test_a_postgresql_database_can_be_made_copied_and_dropped(postgres_server: PostgresServer):
    first = postgres_server.create_database()
    run(first, "CREATE TABLE drive (name text)")
    run(first, "INSERT INTO drive VALUES ('hoist')")
    second = postgres_server.create_database(template=first)
    run(second, "INSERT INTO drive VALUES ('lift')")
    assert run(first, "SELECT name FROM drive") == [("hoist",)]
    assert run(second, "SELECT count(*) FROM drive") == [(2,)]
    postgres_server.drop_database(second)
    known = {row[0] for row in run(first, "SELECT datname FROM pg_database")}
    assert second.rpartition("/")[2].partition("?")[0] not in known


@pytest.mark.browser
def test_the_browser_runs_scripts(chromium: "Browser"):
    page = chromium.new_page()
    page.set_content("<p id=speed></p><script>document.getElementById('speed').textContent = 50 * 60 / 2</script>")
    assert page.text_content("#speed") == "1500"
    page.close()


def test_a_database_of_a_test_is_its_own_and_holds_the_catalogue(any_database: str):
    assert run(any_database, "SELECT count(*) FROM servo_drive") > [(0,)]
    run(any_database, "DELETE FROM servo_drive")
    assert run(any_database, "SELECT count(*) FROM servo_drive") == [(0,)]


def test_sqlite_and_postgresql_hold_the_same_rows(database: str, postgres_database: str):
    for table in ("catalog_edition", "servo_motor", "servo_gear_unit", "servo_drive", "standard_table"):
        counted = run(database, f"SELECT count(*) FROM {table}")
        assert counted == run(postgres_database, f"SELECT count(*) FROM {table}")
        assert counted > [(0,)], table
