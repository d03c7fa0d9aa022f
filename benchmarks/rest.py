"""Stateless sizing over HTTP against a bare FastAPI route that returns the same bytes.

Application and bare route are served by a uvicorn process each; one client keeps the same number of connections busy
on both, in turns, so that the ratio does not depend on the machine. Two ratios are reported: `cached` (the same
question again, answered from the store of answers) and `uncached` (every question is new, so every number is
calculated). Prints JSON.
"""

import itertools
import json
import multiprocessing
import socket
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import uvicorn
from fastapi import FastAPI, Request, Response

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from app.db.migrate import upgrade
from app.main import create_app
from app.settings import Settings
from tests.sizing_requests import SCREW_AXIS

TARGET = 0.5
CONNECTIONS = 8
ROUNDS = 15
REQUESTS = {"bare": 800, "cached": 800, "uncached": 80}
PATH = "/api/v1/sizings"


def serve_sizing(listener: socket.socket, folder: str) -> None:
    """Serve the application on a database of its own."""
    settings = Settings(database_url=f"sqlite:///{folder}/bench.db", log_level="warning")
    upgrade(settings.database_url)
    serve(create_app(settings), listener)


def serve_bare(listener: socket.socket, answer: bytes) -> None:
    """Serve one route that returns the given bytes."""
    app = FastAPI()

    @app.post(PATH)
    async def bare(request: Request) -> Response:
        await request.body()
        return Response(answer, media_type="application/json")

    serve(app, listener)


def serve(app: FastAPI, listener: socket.socket) -> None:
    """Serve until the process is ended."""
    uvicorn.Server(uvicorn.Config(app, log_level="warning", access_log=False, timeout_keep_alive=600)).run(
        sockets=[listener]
    )


class Client:
    """Connections that are all kept busy: on each the next question is sent as soon as its answer is read."""

    def __init__(self, port: int, connections: int) -> None:
        self._sockets = [socket.create_connection(("127.0.0.1", port)) for _ in range(connections)]

    def ask(self, bodies: Iterator[bytes]) -> bytes:
        """Send all bodies; the last answer."""
        waiting: list[socket.socket] = []
        answer = b""
        for connection, body in zip(itertools.cycle(self._sockets), bodies, strict=False):
            if len(waiting) == len(self._sockets):
                answer = _read(waiting.pop(0))
            head = (
                f"POST {PATH} HTTP/1.1\r\nhost: bench\r\ncontent-type: application/json\r\ncontent-length: {len(body)}"
            )
            connection.sendall(f"{head}\r\n\r\n".encode() + body)
            waiting.append(connection)
        for connection in waiting:
            answer = _read(connection)
        return answer


def _read(connection: socket.socket) -> bytes:
    data = b""
    while b"\r\n\r\n" not in data:
        data += _received(connection)
    head, _, body = data.partition(b"\r\n\r\n")
    if not head.startswith(b"HTTP/1.1 200"):
        raise RuntimeError(f"{head!r} {body[:300]!r}")
    length = next(int(line[15:]) for line in head.lower().split(b"\r\n") if line.startswith(b"content-length:"))
    parts = [body]
    missing = length - len(body)
    while missing > 0:
        parts.append(_received(connection))
        missing -= len(parts[-1])
    return b"".join(parts)


def _received(connection: socket.socket) -> bytes:
    found = connection.recv(1 << 16)
    if not found:
        raise RuntimeError("the server closed the connection")
    return found


def started(target: Callable[..., None], *args: object) -> tuple[multiprocessing.Process, Client]:
    """A server process and a client of it."""
    listener = socket.create_server(("127.0.0.1", 0), backlog=64)
    # Connections inherit it; asyncio sets it only on sockets that it opened itself, and waiting is not to be measured.
    listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    process = multiprocessing.get_context("fork").Process(target=target, args=(listener, *args), daemon=True)
    process.start()
    return process, Client(listener.getsockname()[1], CONNECTIONS)  # type: ignore[return-value]


def measure(sizing: Client, bare: Client, question: bytes) -> dict[str, float]:
    """Requests per second of each kind: median over rounds in which all kinds take turns."""
    numbers = itertools.count()

    def new_questions(count: int) -> Iterator[bytes]:
        for _ in range(count):
            yield json.dumps({**SCREW_AXIS, "notes": f"question {next(numbers)}"}).encode()

    kinds: dict[str, Callable[[int], object]] = {
        "bare": lambda count: bare.ask(itertools.repeat(question, count)),
        "cached": lambda count: sizing.ask(itertools.repeat(question, count)),
        "uncached": lambda count: sizing.ask(new_questions(count)),
    }
    rates: dict[str, list[float]] = {name: [] for name in kinds}
    for turn in range(ROUNDS + 1):
        for name, ask in kinds.items():
            start = time.perf_counter()
            ask(REQUESTS[name])
            if turn:
                rates[name].append(REQUESTS[name] / (time.perf_counter() - start))
    return {name: statistics.median(found) for name, found in rates.items()}


def main() -> None:
    """Serve, measure, print."""
    question = json.dumps(SCREW_AXIS).encode()
    with tempfile.TemporaryDirectory() as folder:
        process, sizing = started(serve_sizing, folder)
        answer = sizing.ask(iter([question]))
        other, bare = started(serve_bare, answer)
        try:
            rates = measure(sizing, bare, question)
        finally:
            for one in (process, other):
                one.terminate()
                one.join()
    ratios = {name: rates[name] / rates["bare"] for name in ("cached", "uncached")}
    found = {
        "name": "stateless sizing over HTTP",
        "answer_bytes": len(answer),
        "requests_per_second": {name: round(rate, 1) for name, rate in rates.items()},
        "ratios": {name: round(ratio, 3) for name, ratio in ratios.items()},
        "target": TARGET,
        "met": {name: ratio >= TARGET for name, ratio in ratios.items()},
    }
    print(json.dumps(found, indent=2))


if __name__ == "__main__":
    main()
