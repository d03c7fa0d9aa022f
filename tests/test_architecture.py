"""The layout and the rules of the code, held to the source of every module."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests import architecture
from tests.architecture import Module

ROOT = Path(__file__).resolve().parent.parent
MODULES = [Module.read(file, ROOT) for file in sorted((ROOT / "app").rglob("*.py"))]

REQUIRED = [
    *("pyproject.toml", "README.md", "CHANGELOG.md", "Makefile", ".ci/run", "Dockerfile", "compose.yaml"),
    *("constraints.txt", "app", "templates", "static", "migrations", "catalog_data", "tests"),
]

FILE_LINES = 400
ENGINE_FILE_LINES = 600
FUNCTION_LINES = 40

LONG_FILES: dict[str, str] = {}
"""Files that may be longer, each with the reason."""

LONG_FUNCTIONS: dict[str, str] = {}
"""Functions that may be longer, as ``path:name``, each with the reason."""


assert MODULES


def offences(rule: Callable[[Module], list[str]]) -> list[str]:
    return [line for module in MODULES for line in rule(module)]


def assert_none(found: list[str]) -> None:
    assert not found, "\n" + "\n".join(found)


def test_everything_required_is_there():
    assert [name for name in REQUIRED if not (ROOT / name).exists()] == []


@pytest.mark.parametrize(
    "rule",
    [
        architecture.unknown_layer,
        architecture.wrong_directions,
        architecture.impure_engine,
        architecture.misplaced_libraries,
        architecture.bad_habits,
    ],
    ids=lambda rule: rule.__name__,
)
def test_no_module_breaks(rule: Callable[[Module], list[str]]):
    assert_none(offences(rule))


def test_no_modules_import_each_other_in_a_circle():
    assert_none(architecture.circles(MODULES))


def test_functions_are_short():
    found = [line for module in MODULES for line in architecture.long_functions(module, FUNCTION_LINES)]
    excused = [tuple(entry.split(":")) for entry in LONG_FUNCTIONS]
    assert_none([line for line in found if not any(line.startswith(p) and f" {f} " in line for p, f in excused)])


def test_files_are_short():
    found = []
    for folder, pattern in [("app", "*.py"), ("tests", "*.py"), ("static", "*.js"), ("templates", "*.html")]:
        for file in (ROOT / folder).rglob(pattern):
            path = file.relative_to(ROOT).as_posix()
            limit = ENGINE_FILE_LINES if path.startswith("app/engine/") else FILE_LINES
            count = len(file.read_text(encoding="utf-8").splitlines())
            if count > limit and path not in LONG_FILES:
                found.append(f"{path}: {count} lines, more than {limit}")
    assert_none(found)


def test_no_file_names_a_package_index():
    hosts = ["pypi" + ".org", "python" + "hosted.org", "registry.npm" + "js.org", "index" + "-url"]
    folders = ["app", "tests", "templates", "static", "migrations", "catalog_data", "docs", "tools", "benchmarks"]
    files = [file for folder in folders for file in (ROOT / folder).rglob("*")]
    files += [file for file in ROOT.iterdir() if file.name != ".git"]
    suffixes = {".py", ".md", ".toml", ".txt", ".yaml", ".html", ".js", ".css", ".json", ".csv", ".ini", ""}
    found = []
    for file in files:
        if file.is_file() and file.suffix in suffixes:
            text = file.read_text(encoding="utf-8", errors="ignore")
            found += [f"{file.relative_to(ROOT)}: {host}" for host in hosts if host in text]
    assert_none(found)


def sample(name: str, source: str) -> Module:
    return Module(name.replace(".", "/") + ".py", name, source)


@pytest.mark.parametrize(
    ("rule", "name", "source", "line"),
    [
        (architecture.wrong_directions, "app.engine.gear", "\nfrom app.db import models\n", 2),
        (architecture.wrong_directions, "app.engine.gear", "from ..catalog import load\n", 1),
        (architecture.wrong_directions, "app.charts.cycle", "import app.reports.pdf\n", 1),
        (architecture.wrong_directions, "app.services.sizing", "def f():\n    from app.web import forms\n", 2),
        (architecture.wrong_directions, "app.db.session", "from app.settings import Settings\n", 1),
        (architecture.wrong_directions, "app.catalog.load", "from app import settings\n", 1),
        (architecture.unknown_layer, "app.helpers.things", "", 1),
        (architecture.impure_engine, "app.engine.gear", "import math\nimport datetime\n", 2),
        (architecture.impure_engine, "app.engine.gear", "from scipy.spatial import ConvexHull\n", 1),
        (architecture.impure_engine, "app.engine.gear", "text = open('x').read()\n", 1),
        (architecture.impure_engine, "app.engine.gear", "def f():\n    global count\n    count = 1\n", 2),
        (architecture.misplaced_libraries, "app.services.sizing", "from fastapi import Request\n", 1),
        (architecture.misplaced_libraries, "app.services.sizing", "from sqlalchemy import select\n", 1),
        (architecture.misplaced_libraries, "app.services.sizing", "def f(s):\n    s.commit()\n", 2),
        (architecture.bad_habits, "app.web.deps", "try:\n    x = 1\nexcept:\n    pass\n", 3),
        (architecture.bad_habits, "app.catalog.load", "print(1)\n", 1),
        (architecture.bad_habits, "app.services.sizing", "raise HTTPException(404)\n", 1),
    ],
)
def test_a_rule_reports_the_offending_line(rule: Callable[[Module], list[str]], name: str, source: str, line: int):
    module = sample(name, source)
    assert [report.split(": ")[0] for report in rule(module)] == [f"{module.path}:{line}"]


@pytest.mark.parametrize(
    ("rule", "name", "source"),
    [
        (
            architecture.wrong_directions,
            "app.web.deps",
            "from app.services import sizing\nfrom app.engine import gear\n",
        ),
        (architecture.wrong_directions, "app.cli", "from app.settings import read_settings\n"),
        (architecture.impure_engine, "app.engine.cycle", "from scipy.spatial import ConvexHull\n"),
        (architecture.misplaced_libraries, "app.services.sizing", "from sqlalchemy.orm import Session\n"),
    ],
)
def test_a_rule_admits_what_is_right(rule: Callable[[Module], list[str]], name: str, source: str):
    assert rule(sample(name, source)) == []


def test_a_circle_is_found_inside_a_function_but_not_for_types():
    first = sample("app.engine.a", "def f():\n    from app.engine import b\n")
    second = sample("app.engine.b", "from app.engine.c import x\n")
    third = sample("app.engine.c", "from app.engine.a import f\n")
    assert architecture.circles([first, second, third]) == [
        "app.engine.a -> app.engine.b -> app.engine.c -> app.engine.a"
    ]
    typed = sample("app.engine.c", "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import app.engine.a\n")
    assert architecture.circles([first, second, typed]) == []


def test_only_lines_of_code_count():
    body = "".join(f"    x{n} = {n}\n\n    # a remark\n" for n in range(5))
    module = sample("app.engine.a", f'def f():\n    """Meaning.\n\n    More.\n    """\n{body}')
    assert architecture.long_functions(module, 5) == []
    assert architecture.long_functions(module, 4) == ["app/engine/a.py:1: f has 5 lines of code, more than 4"]
