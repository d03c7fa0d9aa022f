#!/usr/bin/env python3
"""Make sure that a Chromium is there for the tests of the pages. Silent when one is; needs only the standard library.

Looks at $CHROMIUM, at the usual names on the PATH and at what Playwright has installed. Where none is found it tries
the system's package (as root, or with a sudo that asks nothing) and then Playwright's own download.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
PLAYWRIGHT_FOLDERS = ("~/.cache/ms-playwright", "~/Library/Caches/ms-playwright")
PLAYWRIGHT_PATTERNS = (
    "chromium-*/chrome-linux*/chrome",
    "chromium-*/chrome-mac*/*.app/Contents/MacOS/*Chrom*",
)
INSTALL_SECONDS = 600
ADVICE = """No Chromium was found, and the tests of the pages need one. Do one of these, then run the tests again:
  Debian, Ubuntu:  sudo apt-get install chromium
  any system:      .venv/bin/playwright install --with-deps chromium
  elsewhere:       set CHROMIUM to the path of a Chromium or Chrome"""


def find() -> str | None:
    """Path of the browser, or None. A $CHROMIUM that names no program counts as none: nothing else is guessed then."""
    chosen = os.environ.get("CHROMIUM")
    if chosen:
        return shutil.which(chosen)
    for name in NAMES:
        path = shutil.which(name)
        if path:
            return path
    folders = [os.environ.get("PLAYWRIGHT_BROWSERS_PATH"), *PLAYWRIGHT_FOLDERS]
    for folder in folders:
        for pattern in PLAYWRIGHT_PATTERNS if folder else ():
            for found in sorted(Path(str(folder)).expanduser().glob(pattern), reverse=True):
                if os.access(found, os.X_OK):
                    return str(found)
    return None


def run(*command: str) -> bool:
    """Run a command without input and without waiting for ever; whether it succeeded."""
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    try:
        done = subprocess.run(
            command, stdin=subprocess.DEVNULL, stdout=sys.stderr, env=environment, timeout=INSTALL_SECONDS, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0


def install() -> None:
    """Try to install one, first as a system package, then by Playwright."""
    if shutil.which("apt-get"):
        if os.geteuid() == 0:
            root: tuple[str, ...] = ()
        elif shutil.which("sudo") and run("sudo", "-n", "true"):
            root = ("sudo", "-n")
        else:
            root = ("false",)
        print("Installing Chromium for the tests of the pages ...", file=sys.stderr)
        run(*root, "apt-get", "-qq", "update")
        if run(*root, "apt-get", "-qq", "install", "-y", "--no-install-recommends", "chromium"):
            return
    run(sys.executable, "-m", "playwright", "install", "chromium")


def main() -> int:
    """0 when a browser is there in the end, 1 with advice when not."""
    if find() is None and not os.environ.get("CHROMIUM"):
        install()
    if find() is None:
        print(ADVICE, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
