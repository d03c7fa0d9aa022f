"""Folders of a catalogue: each edition is a folder with ``SOURCE.toml`` and the files of its tables."""

import hashlib
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from app.catalog.names import slugify
from app.catalog.report import LoadReport
from app.catalog.schema import TABLES
from app.db.models import CatalogEdition

SOURCE_FILE = "SOURCE.toml"
SOURCE_FIELDS = ("maker", "document", "publisher", "edition", "date", "url", "retrieved", "licence", "note")
REQUIRED_FIELDS = ("maker", "document")
STANDARD_SUFFIX = ".json"

_FORMAT = b"catalogue format 1\0"
"""Part of every checksum: count it up when the same files have to be read into the tables anew."""
_DATE = re.compile(r"\d{4}(-(0[1-9]|1[0-2])(-(0[1-9]|[12]\d|3[01]))?)?")
_DATE_FIELDS = ("date", "retrieved")


@dataclass(frozen=True)
class EditionFolder:
    """One edition as found on disk."""

    folder: Path
    name: str
    """The folder relative to what is loaded, as shown in the report."""
    source: dict[str, str]
    files: dict[str, bytes] = field(repr=False)
    """Content of every file of the edition, by file name."""

    @property
    def maker_slug(self) -> str:
        """The maker in product ids."""
        return slugify(self.source["maker"])

    @property
    def slug(self) -> str:
        """The edition in product ids: the name of its folder."""
        return slugify(self.folder.resolve().name)

    @property
    def key(self) -> str:
        """``maker:edition``."""
        return f"{self.maker_slug}:{self.slug}"

    @property
    def checksum(self) -> str:
        """SHA-256 over names and contents of the files."""
        digest = hashlib.sha256(_FORMAT)
        for name in sorted(self.files):
            digest.update(f"{name}\0{len(self.files[name])}\0".encode())
            digest.update(self.files[name])
        return digest.hexdigest()

    def path(self, file: str) -> str:
        """A file of the edition as shown in the report."""
        return f"{self.name}/{file}" if self.name else file


def find_editions(directory: Path, report: LoadReport) -> list[EditionFolder]:
    """Read every edition below ``directory`` (or the one that it is); what is wrong goes into ``report``."""
    if not directory.is_dir():
        report.error(str(directory), "there is no such folder")
        return []
    data_files = [
        path
        for path in sorted(directory.rglob("*"))
        if path.is_file() and not any(part.startswith(".") for part in path.relative_to(directory).parts)
    ]
    folders = sorted({path.parent for path in data_files})
    editions = []
    for folder in folders:
        try:
            found = _read_folder(folder, directory, report)
        except OSError as error:
            report.error(str(folder), f"cannot be read: {error.strerror}")
            continue
        if found is not None:
            editions.append(found)
    if not editions and report.ok:
        report.error(str(directory), f"holds no catalogue: no folder with {SOURCE_FILE}")
    seen: dict[str, str] = {}
    for edition in editions:
        if edition.key in seen:
            report.error(edition.path(SOURCE_FILE), f"edition {edition.key} is also that of {seen[edition.key] or '.'}")
        seen[edition.key] = edition.name
    return editions


def _read_folder(folder: Path, root: Path, report: LoadReport) -> EditionFolder | None:
    name = "" if folder == root else folder.relative_to(root).as_posix()
    shown = f"{name}/" if name else ""
    files = {path.name: path for path in sorted(folder.iterdir()) if path.is_file() and not path.name.startswith(".")}
    tables = [file for file in files if file.endswith((".csv", STANDARD_SUFFIX))]
    if SOURCE_FILE not in files:
        if tables:
            report.error(f"{shown}{tables[0]}", f"has no source: {SOURCE_FILE} is missing in its folder")
        return None
    for file in files:
        if file.endswith(".csv") and file.removesuffix(".csv") not in TABLES:
            report.error(f"{shown}{file}", f"is no table of the catalogue; the tables are {', '.join(TABLES)}")
    if not tables:
        report.warn(f"{shown}{SOURCE_FILE}", "the edition has no table")
    source = _read_source(files[SOURCE_FILE], f"{shown}{SOURCE_FILE}", report)
    if source is None:
        return None
    return EditionFolder(folder, name, source, {file: files[file].read_bytes() for file in [*tables, SOURCE_FILE]})


def _read_source(path: Path, shown: str, report: LoadReport) -> dict[str, str] | None:
    try:
        values = tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        report.error(shown, f"cannot be read: {error}")
        return None
    before = len(report.errors)
    source = {}
    for name, value in values.items():
        text = str(value).strip()
        length = CatalogEdition.__table__.columns[name].type.length if name in SOURCE_FIELDS else 0  # type: ignore[attr-defined]
        if name not in SOURCE_FIELDS:
            report.error(shown, f"unknown entry; the entries are {', '.join(SOURCE_FIELDS)}", column=name)
        elif isinstance(value, (dict, list)) or "\0" in text:
            report.error(shown, "must be a text", column=name)
        elif len(text) > length:
            report.error(shown, f"is longer than {length} characters", column=name)
        elif name in _DATE_FIELDS and not _DATE.fullmatch(text):
            report.error(shown, f"{text!r} is no date: YYYY, YYYY-MM or YYYY-MM-DD", column=name)
        elif text:
            source[name] = text
    for name in REQUIRED_FIELDS:
        if name not in source and name not in values:
            report.error(shown, "is missing", column=name)
        elif name not in source and len(report.errors) == before:
            report.error(shown, "is empty", column=name)
    return source if len(report.errors) == before else None
