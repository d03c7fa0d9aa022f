"""Engines and sessions behave alike on both databases."""

import threading
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta, timezone

import pytest
from sqlalchemy import Engine, insert, select, text
from sqlalchemy.exc import IntegrityError, StatementError

from app.db.migrate import upgrade
from app.db.models import CatalogEdition, Project, ProjectRevision, ServoMotor
from app.db.session import driver_url, make_engine, session_factory, take_write_lock


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=pytest.mark.postgres)])
def engine(request: pytest.FixtureRequest) -> Iterator[Engine]:
    """Engine of a migrated, empty database, once of each kind."""
    if request.param == "sqlite":
        url = request.getfixturevalue("empty_database")
    else:
        url = request.getfixturevalue("postgres_databases")()
        upgrade(url)
    engine = make_engine(url)
    yield engine
    engine.dispose()


def new_project(**changes: object) -> Project:
    now = datetime(2026, 3, 29, 1, 30, tzinfo=UTC)
    values = {"view_token_hash": "v" * 64, "edit_token_hash": "e" * 64, "title": "Axis", "version": 1}
    return Project(**{**values, "created_at": now, "updated_at": now, **changes})


def test_a_time_comes_back_as_the_same_moment_in_utc(engine: Engine):
    summer = datetime(2026, 7, 1, 12, 0, tzinfo=timezone(timedelta(hours=2)))
    with session_factory(engine)() as session:
        session.add(new_project(updated_at=summer))
        session.commit()
    with session_factory(engine)() as session:
        stored = session.scalars(select(Project)).one()
        assert stored.updated_at == datetime(2026, 7, 1, 10, 0, tzinfo=UTC)
        assert stored.updated_at.utcoffset() == timedelta(0)
        assert stored.deleted_at is None


def test_a_time_without_zone_is_refused(engine: Engine):
    with session_factory(engine)() as session:
        session.add(new_project(created_at=datetime(2026, 7, 1)))
        with pytest.raises(StatementError, match="time zone"):
            session.flush()


def test_a_json_document_comes_back_as_it_was(engine: Engine):
    document = {"axes": [{"lead_mm": 0.1 + 0.2, "name": "Größe 電動 \U0001f600", "none": None}], "z": 1, "a": 2}
    with session_factory(engine)() as session:
        project = new_project()
        session.add(project)
        session.flush()
        session.add(revision(project.id, document))
        session.commit()
    with session_factory(engine)() as session:
        stored = session.scalars(select(ProjectRevision)).one().document
        assert stored == document
        assert list(stored) == list(document)  # an export keeps the order of its entries


def revision(project_id: int, document: object) -> ProjectRevision:
    return ProjectRevision(
        project_id=project_id,
        number=1,
        document=document,
        engine_version="0.1.0",
        catalogue_editions={},
        created_at=datetime(2026, 1, 1, tzinfo=UTC),
    )


def test_a_foreign_key_must_exist(engine: Engine):
    with session_factory(engine)() as session:
        session.add(revision(4711, {}))
        with pytest.raises(IntegrityError):
            session.flush()


def test_a_token_belongs_to_one_project(engine: Engine):
    with session_factory(engine)() as session:
        session.add_all([new_project(), new_project(edit_token_hash="f" * 64)])
        with pytest.raises(IntegrityError):
            session.flush()


def test_a_product_stands_once_in_an_edition(engine: Engine):
    edition = {"maker": "M", "maker_slug": "m", "slug": "e", "document": "D", "checksum": "c"}
    motor = {"slug": "a-1", "manufacturer": "M", "model": "A-1", "kind": "sync"}
    with engine.begin() as connection:
        statement = insert(CatalogEdition).values(edition | {"loaded_at": datetime(2026, 1, 1, tzinfo=UTC)})
        (edition_id,) = connection.execute(statement).inserted_primary_key
        connection.execute(insert(ServoMotor).values(motor | {"edition_id": edition_id}))
        with pytest.raises(IntegrityError):
            connection.execute(insert(ServoMotor).values(motor | {"edition_id": edition_id}))


def test_two_sessions_that_read_and_then_write_take_turns(engine: Engine):
    with session_factory(engine)() as session:
        session.add(new_project(version=0))
        session.commit()
    failures: list[BaseException] = []
    start = threading.Barrier(2)

    def count_up() -> None:
        start.wait()
        try:
            for _ in range(5):
                with session_factory(engine)() as session:
                    take_write_lock(session)
                    project = session.scalars(select(Project).with_for_update()).one()
                    project.version += 1
                    session.commit()
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=count_up) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert failures == []
    with session_factory(engine)() as session:
        assert session.scalars(select(Project)).one().version == 10


def test_a_rolled_back_session_leaves_nothing(engine: Engine):
    with session_factory(engine)() as session:
        session.add(new_project())
        session.flush()
        session.rollback()
    with session_factory(engine)() as session:
        assert session.scalars(select(Project)).all() == []


def test_sqlite_is_set_up_for_several_readers_and_a_writer(empty_database: str):
    engine = make_engine(empty_database)
    with engine.connect() as connection:
        names = ("journal_mode", "foreign_keys", "busy_timeout")
        pragmas = {name: connection.execute(text(f"PRAGMA {name}")).scalar_one() for name in names}
    engine.dispose()
    assert pragmas == {"journal_mode": "wal", "foreign_keys": 1, "busy_timeout": 15_000}


def test_postgresql_goes_through_psycopg_and_others_are_refused():
    assert driver_url("postgresql://u:p@h/d").drivername == "postgresql+psycopg"
    assert driver_url("postgresql+psycopg://u:p@h/d").drivername == "postgresql+psycopg"
    with pytest.raises(ValueError, match="mysql"):
        driver_url("mysql://u:p@h/d")


def test_making_an_engine_opens_nothing(tmp_path):
    make_engine(f"sqlite:///{tmp_path / 'new.db'}").dispose()
    assert not (tmp_path / "new.db").exists()
