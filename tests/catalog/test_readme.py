"""The description of the catalogue format names what the loader knows."""

from pathlib import Path

from app.catalog.editions import SOURCE_FIELDS
from app.catalog.schema import TABLES
from app.catalog.standards import FIELDS

README = (Path(__file__).resolve().parents[2] / "catalog_data" / "README.md").read_text(encoding="utf-8")


def test_every_table_and_entry_is_described():
    assert [name for name in TABLES if f"`{name}`" not in README] == []
    assert [name for name in SOURCE_FIELDS if f"`{name}`" not in README] == []
    assert [name for name in FIELDS if f'"{name}": ' not in README] == []
