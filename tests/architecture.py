"""Rules of the code as functions: each takes source code and returns the offences as ``path:line: what is wrong``.

``tests/test_architecture.py`` applies them to the project, and to short offending sources to show that they bite.
"""

import ast
import io
import tokenize
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

LAYERS = ["main", "cli", "web", "services", "reports", "charts", "catalog", "db", "engine"]
"""Top to bottom: a layer imports from itself and from those after it."""

READERS_OF_SETTINGS = {"main", "cli", "web"}
"""``app.settings`` imports nothing of the project, and everything below gets plain values handed down."""

ENGINE_STDLIB = {
    *("abc", "ast", "bisect", "cmath", "collections", "contextlib", "copy", "csv", "dataclasses"),
    *("decimal", "enum", "fractions", "functools", "heapq", "importlib", "inspect", "itertools", "json"),
    *("keyword", "math", "numbers", "operator", "pkgutil", "re", "statistics", "string", "textwrap"),
    *("types", "typing", "unicodedata"),
}
"""What the engine may use of the standard library: nothing that reads a file, a clock, the network or chance.

``inspect`` finds the source of a formula, ``importlib`` and ``pkgutil`` find the mechanisms in their package.
"""

ENGINE_PACKAGES = {"numpy", "pydantic", "pydantic_core", "typing_extensions"}
ENGINE_EXTRA = {"app.engine.quantity": {"pint"}, "app.engine.cycle": {"scipy"}}
ENGINE_BUILTINS = {"open", "input", "exec", "eval", "__import__"}

WEB_FRAMEWORKS = {"fastapi", "starlette", "uvicorn", "jinja2"}
SQL_FREE_LAYERS = {"web", "services", "reports", "charts"}
SQL_NAMES_ANYWHERE = {"Engine", "Session", "sessionmaker"}


@dataclass(frozen=True)
class Module:
    """One Python source: ``path`` as reported, dotted ``name``, ``source`` text."""

    path: str
    name: str
    source: str

    @classmethod
    def read(cls, file: Path, root: Path) -> "Module":
        """Read ``file``; its dotted name is its path below ``root``."""
        relative = file.relative_to(root)
        parts = relative.with_suffix("").parts
        if parts[-1] == "__init__":
            parts = parts[:-1]
        return cls(relative.as_posix(), ".".join(parts), file.read_text(encoding="utf-8"))

    @cached_property
    def tree(self) -> ast.Module:
        """Syntax tree of the source."""
        return ast.parse(self.source, self.path)

    @property
    def layer(self) -> str:
        """First part below ``app``: ``engine``, ``web`` ...; empty for ``app`` itself."""
        return [*self.name.split("."), ""][1]

    @property
    def package(self) -> str:
        """Package against which a relative import is resolved."""
        return self.name if self.path.endswith("__init__.py") else self.name.rpartition(".")[0]

    def offence(self, node: ast.AST, text: str) -> str:
        """Report line for ``node``."""
        return f"{self.path}:{getattr(node, 'lineno', 1)}: {text}"


@dataclass(frozen=True)
class Import:
    """One imported dotted name: a module, or ``module.name`` of a from-import."""

    node: ast.stmt
    module: str
    name: str | None
    typing_only: bool

    @property
    def top(self) -> str:
        """First part of the module."""
        return self.module.partition(".")[0]


def imports(module: Module) -> Iterator[Import]:
    """Every import of the module, those inside functions included."""
    typing_only = {
        id(child)
        for node in ast.walk(module.tree)
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        for child in ast.walk(node)
    }
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(node, alias.name, None, id(node) in typing_only)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                above = module.package.split(".")[: len(module.package.split(".")) - node.level + 1]
                base = ".".join([*above, base] if base else above)
            for alias in node.names:
                yield Import(node, base, alias.name, id(node) in typing_only)


def wrong_directions(module: Module) -> list[str]:
    """Imports that point upwards in ``LAYERS``."""
    found = []
    for item in imports(module):
        if item.top != "app":
            continue
        parts = [*item.module.split("."), item.name or ""]
        target = parts[1] if len(parts) > 1 else ""
        if target == "settings":
            allowed = module.layer in READERS_OF_SETTINGS
        elif target in LAYERS and module.layer in LAYERS:
            allowed = LAYERS.index(target) >= LAYERS.index(module.layer)
        else:
            allowed = target not in LAYERS or module.layer == ""
        if not allowed:
            found.append(module.offence(item.node, f"{module.name} must not import app.{target}"))
    return found


def unknown_layer(module: Module) -> list[str]:
    """A module outside the layout."""
    known = {*LAYERS, "settings", ""}
    return [] if module.layer in known else [f"{module.path}:1: app/{module.layer} is not part of the layout"]


def impure_engine(module: Module) -> list[str]:
    """Whatever would let the engine read or keep something besides its arguments."""
    found = []
    if module.layer != "engine":
        return found
    allowed = ENGINE_STDLIB | ENGINE_PACKAGES | ENGINE_EXTRA.get(module.name, set()) | {"app"}
    for item in imports(module):
        if item.top not in allowed:
            found.append(module.offence(item.node, f"the engine must not import {item.top}"))
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ENGINE_BUILTINS:
            found.append(module.offence(node, f"the engine must not call {node.func.id}()"))
        if isinstance(node, ast.Global):
            found.append(module.offence(node, "the engine must not change a module's variable"))
    return found


def misplaced_libraries(module: Module) -> list[str]:
    """The web framework outside the web layer, SQL outside repositories, a commit in a service."""
    found = []
    for item in imports(module):
        if item.top in WEB_FRAMEWORKS and module.layer not in {"main", "cli", "web", "reports"}:
            found.append(module.offence(item.node, f"{item.top} belongs to app/web"))
        if item.top == "sqlalchemy" and module.layer in SQL_FREE_LAYERS and item.name not in SQL_NAMES_ANYWHERE:
            found.append(module.offence(item.node, f"SQL belongs to a repository: {item.name or item.module}"))
    if module.layer == "services":
        for node in ast.walk(module.tree):
            if isinstance(node, ast.Attribute) and node.attr == "commit":
                found.append(module.offence(node, "a service must not commit; its caller does, once"))
    return found


def bad_habits(module: Module) -> list[str]:
    """Bare except, print, and a status code raised outside ``app/web``."""
    found = []
    for node in ast.walk(module.tree):
        if isinstance(node, ast.ExceptHandler) and node.type is None:
            found.append(module.offence(node, "bare except"))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "print":
            found.append(module.offence(node, "print(); use the command line's typer.echo or a logger"))
        if isinstance(node, ast.Name) and node.id == "HTTPException" and module.layer != "web":
            found.append(module.offence(node, "only app/web knows status codes"))
    return found


def long_functions(module: Module, limit: int) -> list[str]:
    """Functions whose body has more than ``limit`` lines of code: docstring, comments and blank lines do not count."""
    found = []
    code_lines = _code_lines(module.source)
    for node in ast.walk(module.tree):
        if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        body = node.body[1:] if ast.get_docstring(node, clean=False) is not None else node.body
        if not body:
            continue
        count = len(code_lines & set(range(body[0].lineno, (node.end_lineno or 0) + 1)))
        if count > limit:
            found.append(module.offence(node, f"{node.name} has {count} lines of code, more than {limit}"))
    return found


def _code_lines(source: str) -> set[int]:
    """Numbers of the lines that hold code."""
    silent = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}
    lines: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type not in silent:
            lines.update(range(token.start[0], token.end[0] + 1))
    return lines


def circles(modules: list[Module]) -> list[str]:
    """Every group of modules that import each other in a circle; imports for the type checker only do not count."""
    names = {module.name for module in modules}
    graph = {module.name: _targets(module, names) for module in modules}
    return [" -> ".join([*group, group[0]]) for group in _cycles(graph)]


def _targets(module: Module, names: set[str]) -> set[str]:
    targets = set()
    for item in imports(module):
        full = f"{item.module}.{item.name}" if item.name else item.module
        target = full if full in names else item.module
        if target in names and target != module.name and not item.typing_only:
            targets.add(target)
    return targets


def _cycles(graph: dict[str, set[str]]) -> list[list[str]]:
    """One circle, as a path, for every set of modules that reach each other."""
    reach: dict[str, set[str]] = {}
    for start in graph:
        seen: set[str] = set()
        stack = list(graph[start])
        while stack:
            name = stack.pop()
            if name not in seen:
                seen.add(name)
                stack.extend(graph[name])
        reach[start] = seen
    groups = {frozenset(n for n in reach[start] if start in reach[n]) for start in graph if start in reach[start]}
    return [_one_circle(graph, group) for group in sorted(groups, key=sorted)]


def _one_circle(graph: dict[str, set[str]], group: frozenset[str]) -> list[str]:
    """The shortest circle through the first module of the group."""
    start = min(group)
    paths = [[start]]
    while True:
        path = paths.pop(0)
        for following in sorted(graph[path[-1]] & group):
            if following == start:
                return path
            if following not in path:
                paths.append([*path, following])
