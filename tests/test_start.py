"""The commands of ``make run``, in its order, as a user runs them: each in a process of its own in an empty folder."""

import importlib.util
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

import pytest

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


def test_loading_the_catalogue_again_changes_nothing(tmp_path: Path):
    run(tmp_path, "migrate")
    run(tmp_path, "load-catalog")
    before = (tmp_path / "var/drivewright.db").read_bytes()
    run(tmp_path, "migrate")
    run(tmp_path, "load-catalog")
    assert (tmp_path / "var/drivewright.db").read_bytes() == before
