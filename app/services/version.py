"""Version of the program, as it stands on results, reports and saved projects."""

from importlib.metadata import PackageNotFoundError, version


def _installed() -> str:
    try:
        return version("drivewright")
    except PackageNotFoundError:
        return "0+unknown"


ENGINE_VERSION = _installed()
"""Two results with the same version, catalogue editions and request are the same."""
