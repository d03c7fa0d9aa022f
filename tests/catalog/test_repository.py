"""Reading the catalogue: filters, ids, pages."""

import math

import pytest
from sqlalchemy import event

from app.catalog.browse import BrowseError, BrowseQuery
from app.catalog.filters import ProductFilter
from app.catalog.repository import CatalogRepository, ProductNotFoundError
from app.catalog.standards import chart_table
from app.db.session import make_engine, session_factory
from app.engine.products import BrakingResistor, GearUnit, InductionMotor, Inverter, MotorBrake


@pytest.fixture
def catalog(any_database: str):
    engine = make_engine(any_database)
    with session_factory(engine)() as session:
        yield CatalogRepository(session)
    engine.dispose()


@pytest.fixture
def sqlite_catalog(database: str):
    engine = make_engine(database)
    with session_factory(engine)() as session:
        yield CatalogRepository(session)
    engine.dispose()


def test_ids_are_unique_and_lead_back_to_the_product(sqlite_catalog: CatalogRepository):
    for products, find in (
        (sqlite_catalog.servo_motors(), sqlite_catalog.servo_motor),
        (sqlite_catalog.servo_gear_units(), sqlite_catalog.servo_gear_unit),
        (sqlite_catalog.servo_drives(), sqlite_catalog.servo_drive),
    ):
        assert len({product.id for product in products}) == len(products)
        for product in products[::40]:
            assert find(product.id) == product


@pytest.mark.parametrize(
    "product_id",
    [
        "",
        "own",
        "servo-motor:1",
        "servo-motor:siemens:1ft5-lachman-2015:none",
        "servo-drive:siemens:1ft5-lachman-2015:1ft5-104-1ac71",
        "servo-motor:a:b:c:d",
        "'; --",
    ],
)
def test_an_unknown_id_is_not_found(catalog: CatalogRepository, product_id: str):
    with pytest.raises(ProductNotFoundError):
        catalog.servo_motor(product_id)


def test_filters_narrow_the_products(catalog: CatalogRepository):
    everything = catalog.servo_motors()
    lafert = catalog.servo_motors(ProductFilter(manufacturers=["Lafert"]))
    assert [motor for motor in everything if motor.manufacturer == "Lafert"] == lafert
    assert len(lafert) == 113  # rows of the Lafert catalogue of 2008
    both = catalog.servo_motors(ProductFilter(manufacturers=["Lafert", "Siemens"], series=["1FT5"]))
    assert len(both) == 10
    assert catalog.servo_motors(ProductFilter(editions=["siemens:1ft5-lachman-2015"])) == both
    assert catalog.servo_motors(ProductFilter(editions=["siemens:none"])) == []
    assert len(catalog.servo_motors(ProductFilter(kinds=["bldc"]))) == 4  # the four DD drives of INNFOS
    found = catalog.servo_motors(ProductFilter(text="siemens 1ft5 106"))
    assert [motor.model for motor in found] == ["1FT5 106-1AC71"]
    assert catalog.servo_motors(ProductFilter(text="100%")) == []  # a sign, no wildcard
    assert catalog.servo_motors(ProductFilter(text="SIEMENS")) == catalog.servo_motors(ProductFilter(text="siemens"))


def test_voltage_admits_what_is_within_ten_percent(catalog: CatalogRepository):
    at_400 = catalog.browse("servo_motor", BrowseQuery(filter=ProductFilter(voltage=400), page_size=200))
    assert at_400.total > 0
    assert all(360 <= row["supply_voltage_v"] <= 440 for row in at_400.rows)
    drives = catalog.browse("servo_drive", BrowseQuery(filter=ProductFilter(voltage=400), page_size=200)).rows
    assert all(row["supply_voltage_min_v"] <= 440 and row["supply_voltage_max_v"] >= 360 for row in drives)
    assert {"Omron", "Festo"} <= {row["manufacturer"] for row in drives}  # both have three-phase 400 V drives


def test_every_table_can_be_paged_through(sqlite_catalog: CatalogRepository):
    for table, count in sqlite_catalog.counts().items():
        first = sqlite_catalog.browse(table, BrowseQuery(page_size=7))
        assert first.total >= count
        last = sqlite_catalog.browse(table, BrowseQuery(page=first.pages, page_size=7))
        assert len(first.rows) == 7
        assert len(last.rows) == (first.total - 1) % 7 + 1
        assert sqlite_catalog.browse(table, BrowseQuery(page=first.pages + 1, page_size=7)).rows == []
        assert set(first.rows[0]) == {"id", "edition", *(column.name for column in first.columns)}
        assert sqlite_catalog.row(table, first.rows[0]["id"])[0].items() >= first.rows[0].items()


@pytest.mark.parametrize("descending", [False, True])
def test_sorting_puts_missing_values_last(catalog: CatalogRepository, descending: bool):
    query = BrowseQuery(sort="mass_kg", descending=descending, page_size=200)
    pages = [catalog.browse("servo_motor", BrowseQuery(**{**vars(query), "page": page})) for page in (1, 2, 3)]
    masses = [row["mass_kg"] for page in pages for row in page.rows]
    known = [mass for mass in masses if mass is not None]
    assert len(masses) == 453
    assert known == sorted(known, reverse=descending)
    assert masses[: len(known)] == known


def test_sorting_induction_motors_by_a_column_of_their_points(catalog: CatalogRepository):
    rows = catalog.browse("induction_motor", BrowseQuery(sort="rated_power_kw", descending=True, page_size=5)).rows
    assert rows[0]["rated_power_kw"] == 1200  # the largest of all printed rows


@pytest.mark.parametrize(
    ("query", "field"),
    [
        (BrowseQuery(sort="slug"), "sort"),
        (BrowseQuery(sort="mass_kg; drop table servo_motor"), "sort"),
        (BrowseQuery(page=0), "page"),
        (BrowseQuery(page_size=0), "page_size"),
        (BrowseQuery(page_size=10_000), "page_size"),
    ],
)
def test_a_page_that_cannot_be_is_refused(sqlite_catalog: CatalogRepository, query: BrowseQuery, field: str):
    with pytest.raises(BrowseError) as caught:
        sqlite_catalog.browse("servo_motor", query)
    assert caught.value.field == field


def test_a_page_far_beyond_the_last_is_empty(catalog: CatalogRepository):
    assert catalog.browse("servo_motor", BrowseQuery(page=10**15)).rows == []


def test_an_unknown_table_is_not_found(sqlite_catalog: CatalogRepository):
    for call in (sqlite_catalog.columns, sqlite_catalog.makers, sqlite_catalog.series, sqlite_catalog.standard_table):
        with pytest.raises(ProductNotFoundError):
            call("project")
    with pytest.raises(ProductNotFoundError):
        sqlite_catalog.browse("project", BrowseQuery())


def test_editions_makers_and_series(catalog: CatalogRepository):
    editions = {edition.key: edition for edition in catalog.editions()}
    lachman = editions["siemens:1ft5-lachman-2015"]
    assert (lachman.rows, lachman.date) == ({"servo_motor": 10}, "2015-04-13")
    assert sum(edition.rows.get("servo_gear_unit", 0) for edition in editions.values()) == 1964
    assert catalog.edition_checksums() == {key: edition.checksum for key, edition in editions.items()}
    assert catalog.makers("servo_drive") == ["Beckhoff", "Bosch Rexroth", "Festo", "Omron", "TG Drives", "WEG"]
    assert set(catalog.makers("servo_drive")) < set(catalog.makers())
    assert catalog.series("servo_motor", "Siemens") == ["1FT5", "1FT7"]


def test_reading_all_servo_products_takes_four_queries(database: str):
    engine = make_engine(database)
    statements: list[str] = []
    event.listen(engine, "before_cursor_execute", lambda *args: statements.append(args[2]))
    with session_factory(engine)() as session:
        catalog = CatalogRepository(session)
        catalog.servo_motors()
        catalog.servo_gear_units()
        catalog.servo_drives()
    engine.dispose()
    assert len([text for text in statements if text.startswith("SELECT")]) == 4  # the editions once, then each table


def test_an_empty_catalogue_is_empty_and_no_error(empty_database: str):
    engine = make_engine(empty_database)
    with session_factory(engine)() as session:
        catalog = CatalogRepository(session)
        assert catalog.servo_motors() == []
        assert catalog.editions() == []
        assert catalog.makers() == []
        page = catalog.browse("servo_motor", BrowseQuery())
        assert (page.total, page.pages, page.rows) == (0, 1, [])
        assert catalog.catalogue_version()
    engine.dispose()


def test_a_pole_changing_motor_has_its_windings_slow_one_first(sqlite_catalog: CatalogRepository):
    """SEW 2001, ch. 9: DT100LS8/2 with 0.45 kW at 630 rpm and 1.8 kW at 2680 rpm, 9000 and 2600 starts per hour."""
    found = next(one for one in sqlite_catalog.products(InductionMotor) if one.model.startswith("DT100LS8/2"))
    slow, fast = found.windings
    assert (slow.poles, fast.poles) == (8, 2)
    assert slow.rated_power == pytest.approx(450)
    assert fast.rated_speed == pytest.approx(2680 * math.pi / 30)
    assert slow.no_load_starting_frequency == pytest.approx(9000 / 3600)


def test_a_braking_resistor_has_its_rating_by_duty(sqlite_catalog: CatalogRepository):
    """SEW 2001, 9.2: BW100-002 bears 0.2 kW at 100 %, 0.6 kW at 25 %, 1.9 kW at 6 % duty, 120 s."""
    found = next(one for one in sqlite_catalog.products(BrakingResistor) if one.model == "BW100-002")
    assert dict(found.ratings)[0.25] == pytest.approx(600)
    assert found.ratings[0] == pytest.approx((0.06, 1900))
    assert found.ratings[-1] == pytest.approx((1.0, 200))
    assert found.duty_cycle_time == 120


@pytest.mark.parametrize("kind", [GearUnit, Inverter, MotorBrake])
def test_every_other_type_is_read_in_si(sqlite_catalog: CatalogRepository, kind: type):
    found = sqlite_catalog.products(kind)
    assert found
    assert len({product.id for product in found}) == len(found)


def test_a_chart_is_read_as_curves_and_a_list_is_not():
    data = {"x": "P_S/P_N", "family": "duty", "curves": [{"family": 0.4, "points": [[1, 0.5], [0, 1]]}]}
    table = chart_table("k", "Factor", "source", data)
    assert table is not None
    assert table.value(0.5, 0.4) == pytest.approx(0.75)
    assert table.value(2.0, 0.4) is None
    assert chart_table("k", "Factor", "source", {"a": 1}) is None
