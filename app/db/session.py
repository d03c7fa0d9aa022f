"""Engines and sessions, made from a database URL by whoever starts the program; importing this opens nothing."""

import sqlite3
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event
from sqlalchemy.engine import URL, make_url
from sqlalchemy.orm import Session, sessionmaker

SQLITE_BUSY_SECONDS = 15.0
"""How long a writer waits for another one to finish before the database counts as locked."""


def driver_url(url: str) -> URL:
    """Parse a database URL; PostgreSQL always goes through psycopg.

    Raises ValueError when the database is neither SQLite nor PostgreSQL.
    """
    parsed = make_url(url)
    backend = parsed.get_backend_name()
    if backend in {"postgresql", "postgres"}:
        return parsed.set(drivername="postgresql+psycopg")
    if backend != "sqlite":
        raise ValueError(f"database {backend!r} is not supported; use sqlite or postgresql")
    return parsed


def make_engine(url: str) -> Engine:
    """Engine for ``url``; the folder of an SQLite file is created on demand, nothing is opened yet.

    SQLite runs with write-ahead log, enforced foreign keys and a busy timeout, and its transactions begin where
    SQLAlchemy begins them, so that reading and writing in one transaction see one state of the data.
    """
    parsed = driver_url(url)
    if parsed.get_backend_name() == "postgresql":
        return create_engine(parsed, pool_pre_ping=True)
    if parsed.database and parsed.database != ":memory:" and not parsed.database.startswith("file:"):
        Path(parsed.database).parent.mkdir(parents=True, exist_ok=True)
    engine = create_engine(parsed, connect_args={"timeout": SQLITE_BUSY_SECONDS})
    event.listen(engine, "connect", _prepare_sqlite)
    event.listen(engine, "begin", _begin_sqlite)
    return engine


def _prepare_sqlite(connection: sqlite3.Connection, _record: Any) -> None:
    connection.isolation_level = None  # the driver's own transactions begin too late: at the first write
    for pragma in ("journal_mode = WAL", "synchronous = NORMAL", "foreign_keys = ON"):
        connection.execute(f"PRAGMA {pragma}")


def _begin_sqlite(connection: Connection) -> None:
    writes = connection.get_execution_options().get("writes", False)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")


def session_factory(engine: Engine) -> sessionmaker[Session]:
    """Factory of sessions on ``engine``. Whoever opens a session commits it; nothing below does."""
    return sessionmaker(engine, expire_on_commit=False)


def take_write_lock(session: Session) -> None:
    """Begin the session's transaction as a writing one; call it before the first statement.

    On SQLite a transaction that first reads and then writes fails at once when another one wrote in between; one
    that takes the lock at its beginning waits for its turn. PostgreSQL locks rows by itself: nothing happens there.
    """
    session.connection(execution_options={"writes": True})
