#!/usr/bin/env python3
"""Take the picture of the README: ``tools/screenshot.py [PATH]`` writes ``docs/workbench.png``.

Serves an instance of its own on a temporary database, opens PATH in Chromium and waits until the page is quiet.
"""

import os
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path

import ensure_chromium

ROOT = Path(__file__).resolve().parent.parent
PAGE = "/workbench/ball_screw?example=lachman-ball-screw-axis&request=main#charts"
TARGET = ROOT / "docs" / "workbench.png"
START_SECONDS = 60.0


def free_port() -> int:
    """A TCP port that nobody listens on."""
    with socket.create_server(("127.0.0.1", 0)) as probe:
        return int(probe.getsockname()[1])


def wait_for(address: str, server: "subprocess.Popen[bytes]") -> None:
    """Return once the server answers; raises RuntimeError when it ends or takes too long."""
    deadline = time.monotonic() + START_SECONDS
    while time.monotonic() < deadline and server.poll() is None:
        try:
            urllib.request.urlopen(address + "/healthz", timeout=2).close()
        except OSError:
            time.sleep(0.2)
        else:
            return
    raise RuntimeError("the server did not start")


def photograph(address: str, browser_path: str) -> None:
    """Open the page and save its picture."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=browser_path, args=["--no-sandbox", "--disable-gpu"])
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.goto(address, wait_until="networkidle")
        page.locator(".workbench-result").evaluate("(result) => result.scrollTo(0, 0)")
        page.wait_for_timeout(1500)  # the chart script draws after it has been fetched
        page.screenshot(path=TARGET)
        browser.close()


def main() -> int:
    """Exit code 0 when the picture was taken."""
    browser_path = ensure_chromium.find()
    if browser_path is None:
        print(ensure_chromium.ADVICE, file=sys.stderr)
        return 1
    page = sys.argv[1] if len(sys.argv) > 1 else PAGE
    command = str(Path(sys.executable).parent / "drivewright")
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "DATABASE_URL": f"sqlite:///{folder}/picture.db"}
        for preparation in ("migrate", "load-catalog"):
            subprocess.run([command, preparation], env=environment, stdout=subprocess.DEVNULL, check=True)
        port = free_port()
        server = subprocess.Popen([command, "serve", "--port", str(port)], env=environment)
        try:
            address = f"http://127.0.0.1:{port}"
            wait_for(address, server)
            photograph(address + page, browser_path)
        finally:
            server.terminate()
            server.wait(timeout=20)
    print(f"{TARGET.relative_to(ROOT)} shows {page}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
