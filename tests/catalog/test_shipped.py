"""The shipped catalogue: complete, sound, and converted as a hand calculation converts the printed rows."""

import csv
import math
import tomllib
from collections import Counter
from pathlib import Path

import pytest
from sqlalchemy import Engine, func, select

from app.catalog.load import load_catalog
from app.catalog.repository import CatalogRepository
from app.catalog.schema import TABLES
from app.db.models import InductionMotor, InductionMotorOperatingPoint
from app.db.session import make_engine, session_factory

SHIPPED = Path(__file__).resolve().parents[2] / "catalog_data"

# Rows of the published tables as collected. Two synchronous motors that the drive planning handbook of SEW lists among
# the asynchronous ones are servo motors here (441 + 2), beside ten 1FT5 of a course text.
ROWS = {
    "servo_motor": 441 + 2 + 10,
    "servo_gear_unit": 1964,
    "servo_drive": 58,
    "induction_motor": 2125 - 2,
    "motor_brake": 78,
    "gear_unit": 893,
    "inverter": 346,
    "braking_resistor": 55,
    "ball_screw": 904,
    "timing_belt": 109,
    "standard_table": 44,
}


@pytest.fixture
def catalog(any_database: str):
    engine = make_engine(any_database)
    with session_factory(engine)() as session:
        yield CatalogRepository(session)
    engine.dispose()


def rows_of(path: str) -> dict[str, dict[str, str]]:
    with (SHIPPED / path).open(encoding="utf-8", newline="") as file:
        return {row["model"]: row for row in csv.DictReader(file)}


def test_everything_loads_without_a_finding_and_a_second_time_writes_nothing(empty_engine: Engine, content_of):
    report = load_catalog(empty_engine, SHIPPED)
    assert report.ok, report.render()
    assert report.warnings == []
    assert dict(report.rows) == ROWS
    before = content_of(empty_engine)

    again = load_catalog(empty_engine, SHIPPED)
    assert again.ok
    assert again.written == Counter()
    assert sorted(again.unchanged) == sorted(report.loaded)
    assert content_of(empty_engine) == before


def test_every_edition_names_its_document():
    folders = {path.parent for path in SHIPPED.rglob("*.csv")} | {path.parent for path in SHIPPED.rglob("*.json")}
    assert len(folders) > 80
    for folder in folders:
        source = tomllib.loads((folder / "SOURCE.toml").read_text(encoding="utf-8"))
        assert source["maker"], folder
        assert source["document"], folder


def test_counts_by_table(catalog: CatalogRepository):
    motors = ROWS["induction_motor"] - 91  # so many motors have a second row: their other winding
    expected = {name: count for name, count in ROWS.items() if name != "standard_table"} | {"induction_motor": motors}
    assert catalog.counts() == expected
    assert len(catalog.standard_tables()) == ROWS["standard_table"]
    assert len(catalog.servo_motors()) == ROWS["servo_motor"]
    assert len(catalog.servo_gear_units()) == ROWS["servo_gear_unit"]
    assert len(catalog.servo_drives()) == ROWS["servo_drive"]


def test_a_pole_changing_motor_has_two_operating_points(any_database: str):
    engine = make_engine(any_database)
    query = (
        select(InductionMotorOperatingPoint.poles, InductionMotorOperatingPoint.rated_speed_rpm)
        .join(InductionMotor)
        .where(InductionMotor.model == "DT71D8/2 /BM")
        .order_by(InductionMotorOperatingPoint.position)
    )
    with engine.connect() as connection:
        assert [tuple(row) for row in connection.execute(query)] == [(8, 675.0), (2, 2670.0)]  # SEW 2001, 8.3
        per_motor = select(func.count(InductionMotorOperatingPoint.id)).group_by(InductionMotorOperatingPoint.motor_id)
        assert Counter(connection.scalars(per_motor)) == {2: 91, 1: ROWS["induction_motor"] - 2 * 91}
    engine.dispose()


def test_servo_motor_1ft5_104_in_si(catalog: CatalogRepository):
    motor = catalog.servo_motor("servo-motor:siemens:1ft5-lachman-2015:1ft5-104-1ac71")
    # Lachman 2015, table of motors: 2000 rpm, M_0(100 K) 45 N m, M_N(100 K) 35 N m, J 185e-4 kg m2, 39 kg
    assert motor.rated_speed == pytest.approx(2000 * 2 * math.pi / 60, rel=1e-12)
    assert (motor.stall_torque, motor.rated_torque, motor.mass) == (45, 35, 39)
    assert motor.rotor_inertia == pytest.approx(0.0185, rel=1e-12)
    assert motor.peak_torque is None
    assert motor.max_speed is None
    assert "37 N m" in motor.note  # M_0(60 K)
    assert "Lachman" in motor.source


def test_servo_motor_sgm7a_15a_in_si(catalog: CatalogRepository):
    (motor,) = [m for m in catalog.servo_motors() if m.model == "SGM7A-15A"]
    # Yaskawa Sigma-7 manual: 3000/6000 rpm, 4.90/14.7 N m, 9.3/28 A, 1.5 kW, 2.00 (2.25) kg cm2, brake 7.84 N m
    assert motor.max_speed == pytest.approx(628.318530718, rel=1e-11)
    assert (motor.rated_torque, motor.peak_torque, motor.stall_torque) == (4.9, 14.7, None)
    assert (motor.rated_current, motor.peak_current, motor.torque_constant) == (9.3, 28, 0.59)
    assert motor.rated_power == pytest.approx(1500)
    assert motor.rotor_inertia == pytest.approx(2.00e-4, rel=1e-12)
    assert motor.rotor_inertia_with_brake == pytest.approx(2.25e-4, rel=1e-12)
    assert motor.brake_torque == 7.84


def test_inertia_printed_in_another_unit_is_converted(catalog: CatalogRepository):
    printed = rows_of("sew-eurodrive/drive-planning-2001/servo_motor.csv")["DY71SB"]
    assert printed["rotor_inertia_with_brake_kgm2"] == "0.000546"  # SEW 2001, 16: with brake
    (motor,) = [m for m in catalog.servo_motors() if m.model == "DY71SB"]
    assert motor.rotor_inertia_with_brake == pytest.approx(0.000546, rel=1e-12)
    assert motor.rotor_inertia is None
    assert (motor.stall_torque, motor.stall_current) == (2.5, 1.85)


def test_power_printed_in_watts_is_converted(catalog: CatalogRepository):
    printed = rows_of("omron/r88m-1-motors/servo_motor.csv")
    for motor in catalog.servo_motors():
        if motor.manufacturer == "Omron":
            assert motor.rated_power == pytest.approx(float(printed[motor.model]["rated_power_w"]))


def test_servo_gear_unit_tq_060_in_si(catalog: CatalogRepository):
    unit = catalog.servo_gear_unit("servo-gear-unit:bonfiglioli:precision-planetary-r05:tq-060-1-3")
    # Bonfiglioli R05: i = 3, 21/32/60 N m, 3500/6000 rpm, 97 %, 4', 4.8 N m/', 0.36 kg cm2, 1850/1650 N, 2.5 kg
    assert (unit.ratio, unit.stages, unit.efficiency) == (3, 1, 0.97)
    assert (unit.nominal_torque, unit.acceleration_torque, unit.emergency_torque) == (21, 32, 60)
    assert unit.nominal_input_speed == pytest.approx(366.519142919, rel=1e-11)
    assert unit.max_input_speed == pytest.approx(628.318530718, rel=1e-11)
    assert unit.backlash == pytest.approx(4 / 60 * math.pi / 180, rel=1e-12)
    assert unit.torsional_stiffness == pytest.approx(4.8 * 60 * 180 / math.pi, rel=1e-12)
    assert unit.inertia == pytest.approx(3.6e-5, rel=1e-12)
    assert (unit.max_radial_force, unit.max_axial_force, unit.mass) == (1850, 1650, 2.5)


def test_servo_drive_in_si(catalog: CatalogRepository):
    (drive,) = [d for d in catalog.servo_drives() if d.model == "R88D-1SN01H-ECT"]
    # Omron 1S data sheet: 230 V, single phase, 0.8 A, 3.1 A, 0.1 kW
    assert (drive.supply_voltage, drive.phases) == (230, 1)
    assert (drive.continuous_current, drive.peak_current, drive.peak_time) == (0.8, 3.1, None)
    assert drive.motor_power == pytest.approx(100)


def test_load_ratings_printed_in_kilonewtons_are_shown_in_newtons(catalog: CatalogRepository):
    printed = rows_of("thk/general-catalogue/ball_screw.csv")["DIK 1404-6"]
    assert (printed["dynamic_load_kn"], printed["static_load_kn"]) == ("1", "4.2")
    (row,) = catalog.row("ball_screw", "ball-screw:thk:general-catalogue:dik-1404-6")
    assert (row["dynamic_load_n"], row["static_load_n"]) == (1000, 4200)


def test_every_row_in_the_database_is_a_row_of_a_file(catalog: CatalogRepository):
    for name in TABLES:
        printed = Counter(
            row["model"]
            for path in SHIPPED.rglob(f"{name}.csv")
            for row in csv.DictReader(path.read_text(encoding="utf-8").splitlines())
        )
        shown: Counter[str] = Counter()
        for page in range(1, 100):
            rows = catalog.browse(name, _page(page)).rows
            shown.update(row["model"] for row in rows)
            if not rows:
                break
        assert shown == printed


def test_standard_tables_keep_their_values_and_source(catalog: CatalogRepository):
    table = catalog.standard_table("synchronous_speed_rpm")
    assert table.payload["50 Hz"]["4 poles"] == 1500  # 120 * 50 Hz / 4
    assert table.payload["60 Hz"]["6 poles"] == 1200  # 120 * 60 Hz / 6
    assert "SEW" in table.source


def _page(number: int):
    from app.catalog.browse import BrowseQuery

    return BrowseQuery(page=number, page_size=200)
