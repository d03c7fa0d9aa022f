"""Real servers for the tests: PostgreSQL (brought by the package pgserver) and the application itself."""

import itertools
import os
import shutil
import socket
import tempfile
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any
from urllib.parse import urlsplit

import pytest

START_SECONDS = 30.0


@dataclass
class PostgresServer:
    """One PostgreSQL server and the databases made on it."""

    uri: str
    """libpq address of its maintenance database."""
    _handle: Any = None
    _folder: Path | None = None
    _numbers: "itertools.count[int]" = field(default_factory=itertools.count)

    @classmethod
    def start(cls) -> "PostgresServer":
        """Start a server of our own, or use the one that TEST_POSTGRES_URL names.

        The data folder lies directly under the temporary folder: started by root, the server runs as another user,
        who must be able to reach it, and pytest locks its own folders. Skips the test where pgserver is not
        installed (it has no wheels for Python 3.13 and later).
        """
        given = os.environ.get("TEST_POSTGRES_URL")
        if given:
            return cls(uri=given)
        pgserver = pytest.importorskip(
            "pgserver", reason="no PostgreSQL: pgserver is not installed and TEST_POSTGRES_URL names no server"
        )
        folder = Path(tempfile.mkdtemp(prefix="drivewright-pg-"))
        handle = pgserver.get_server(folder, cleanup_mode="stop")
        return cls(uri=handle.get_uri(), _handle=handle, _folder=folder)

    def stop(self) -> None:
        """Stop the server if it is ours, and remove its folder."""
        if self._handle is not None:
            self._handle.cleanup()
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)

    def create_database(self, template: str | None = None) -> str:
        """Create a database, empty or as a copy of the one at the URL ``template``; the SQLAlchemy URL of it."""
        name = f"drivewright_test_{os.getpid()}_{next(self._numbers)}"
        source = f' TEMPLATE "{_database_name(template)}"' if template else ""
        self._run(f'CREATE DATABASE "{name}"{source}')
        parts = urlsplit(self.uri)
        return parts._replace(scheme="postgresql+psycopg", path=f"/{name}").geturl()

    def drop_database(self, url: str) -> None:
        """Drop the database at ``url`` whoever is still connected to it."""
        self._run(f'DROP DATABASE "{_database_name(url)}" WITH (FORCE)')

    def _run(self, statement: str) -> None:
        import psycopg

        with psycopg.connect(self.uri, autocommit=True) as connection:
            connection.execute(statement.encode())


def _database_name(url: str) -> str:
    return urlsplit(url).path.lstrip("/")


class ServedApp:
    """The application behind a real HTTP server in a thread, from ``with`` to the end of its block."""

    def __init__(self, settings: Any) -> None:
        import uvicorn

        from app.main import create_app

        self._socket = socket.create_server(("127.0.0.1", 0))
        config = uvicorn.Config(create_app(settings), log_config=None, timeout_graceful_shutdown=2)
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._server.run, kwargs={"sockets": [self._socket]}, daemon=True)

    def __enter__(self) -> str:
        """Serve; returns once the application has started, with its address."""
        self._thread.start()
        deadline = time.monotonic() + START_SECONDS
        while not self._server.started:
            if not self._thread.is_alive() or time.monotonic() > deadline:
                raise RuntimeError("the application did not start; its log is in the captured output")
            time.sleep(0.02)
        return f"http://127.0.0.1:{self._socket.getsockname()[1]}"

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Stop serving and wait for the thread."""
        self._server.should_exit = True
        self._thread.join(timeout=10)
        self._socket.close()
