"""Small catalogues made for one test, and empty databases of both kinds."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from sqlalchemy import Engine, func, select

SOURCE = 'maker = "Muster"\ndocument = "Servo motors"\nedition = "3"\ndate = "2024-05"\n'

SERVO_HEADER = (
    "manufacturer,series,model,kind,rated_speed_rpm,stall_torque_nm,rated_torque_nm,peak_torque_nm,rated_power_kw"
)
SERVO_ROW = "Muster,A,A-1,sync,3000,5,4,12,1.257"  # 4 N m * 3000 * pi / 30 = 1256.6 W


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=pytest.mark.postgres)])
def empty_engine(request: pytest.FixtureRequest) -> Iterator[Engine]:
    """Engine of a migrated database without catalogue, once of each kind."""
    from app.db.migrate import upgrade
    from app.db.session import make_engine

    if request.param == "sqlite":
        url = request.getfixturevalue("empty_database")
    else:
        url = request.getfixturevalue("postgres_databases")()
        upgrade(url)
    engine = make_engine(url)
    yield engine
    engine.dispose()


@pytest.fixture
def engine(empty_database: str) -> Iterator[Engine]:
    """Engine of a migrated SQLite database without catalogue."""
    from app.db.session import make_engine

    engine = make_engine(empty_database)
    yield engine
    engine.dispose()


@pytest.fixture
def write_edition(tmp_path: Path) -> Callable[..., Path]:
    """Write an edition ``muster/servo-2024`` with the given files; the folder of the whole catalogue."""

    def write(source: str | None = SOURCE, folder: str = "muster/servo-2024", **files: str | bytes) -> Path:
        root = tmp_path / "catalogue"
        target = root / folder
        target.mkdir(parents=True, exist_ok=True)
        if source is not None:
            (target / "SOURCE.toml").write_text(source, encoding="utf-8")
        for name, content in files.items():
            suffix = ".json" if name.startswith("standard_") else ".csv"
            data = content if isinstance(content, bytes) else content.encode()
            (target / f"{name}{suffix}").write_bytes(data)
        return root

    return write


@pytest.fixture
def servo_file() -> Callable[..., str]:
    """Text of a sound ``servo_motor.csv``, or one with other lines."""

    def build(*rows: str, header: str = SERVO_HEADER) -> str:
        return "\n".join([header, *(rows or (SERVO_ROW,))]) + "\n"

    return build


@pytest.fixture
def content_of() -> Callable[[Engine], dict[str, object]]:
    """Everything that a load may change: number of rows of each table, and the checksums of the editions."""
    from app.db.base import Base
    from app.db.models import CatalogEdition

    def read(engine: Engine) -> dict[str, object]:
        with engine.connect() as connection:
            found: dict[str, object] = {
                table.name: connection.execute(select(func.count()).select_from(table)).scalar_one()
                for table in Base.metadata.sorted_tables
            }
            editions = select(CatalogEdition.slug, CatalogEdition.checksum, CatalogEdition.loaded_at)
            found["checksums"] = sorted(tuple(row) for row in connection.execute(editions))
        return found

    return read
