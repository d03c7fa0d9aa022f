"""What a load of the catalogue found: one line per finding, with file, line and column."""

from collections import Counter
from dataclasses import dataclass, field
from typing import Literal

Severity = Literal["error", "warning"]


@dataclass(frozen=True)
class ReportLine:
    """One finding; ``file`` is relative to the loaded folder, ``line`` counts from 1 (0: the whole file)."""

    severity: Severity
    file: str
    line: int
    column: str
    text: str

    @property
    def place(self) -> str:
        """``file:line:column`` as far as known."""
        parts = [self.file, str(self.line) if self.line else "", self.column]
        return ":".join(part for part in parts if part)

    def render(self) -> str:
        """The finding in one line."""
        return f"{self.place}: {self.severity}: {self.text}"


@dataclass
class LoadReport:
    """Result of one load. When it holds an error, the database is as it was before."""

    lines: list[ReportLine] = field(default_factory=list)
    rows: Counter[str] = field(default_factory=Counter)
    """Rows read, by table."""
    written: Counter[str] = field(default_factory=Counter)
    """Database rows written, by table; empty when nothing had changed."""
    loaded: list[str] = field(default_factory=list)
    """Keys of the editions that are new or had changed."""
    unchanged: list[str] = field(default_factory=list)
    """Keys of the editions that the database already held exactly so."""

    @property
    def ok(self) -> bool:
        """Whether everything was accepted (warnings are accepted)."""
        return not self.errors

    @property
    def errors(self) -> list[ReportLine]:
        """The findings that prevent the load."""
        return [line for line in self.lines if line.severity == "error"]

    @property
    def warnings(self) -> list[ReportLine]:
        """The findings that merely look odd."""
        return [line for line in self.lines if line.severity == "warning"]

    def error(self, file: str, text: str, line: int = 0, column: str = "") -> None:
        """Add an error."""
        self.lines.append(ReportLine("error", file, line, column, text))

    def warn(self, file: str, text: str, line: int = 0, column: str = "") -> None:
        """Add a warning."""
        self.lines.append(ReportLine("warning", file, line, column, text))

    def render(self, *, with_warnings: bool = True) -> str:
        """The report as text: findings first, then the rows read by table, then what was done."""
        shown = self.lines if with_warnings else self.errors
        text = [line.render() for line in shown]
        text += [f"{table}: {count} rows" for table, count in sorted(self.rows.items())]
        if self.ok:
            text.append(
                f"{len(self.loaded)} editions loaded ({sum(self.written.values())} rows), "
                f"{len(self.unchanged)} unchanged, {len(self.warnings)} warnings"
            )
        else:
            text.append(f"nothing loaded: {len(self.errors)} errors, {len(self.warnings)} warnings")
        return "\n".join(text)
