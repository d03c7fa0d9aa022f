"""Loading: all or nothing, once, and a clear place for whatever is wrong."""

import threading
from collections import Counter
from pathlib import Path

import pytest
from sqlalchemy import Engine, func, select

from app.catalog.load import load_catalog
from app.catalog.repository import CatalogRepository
from app.db.models import ServoMotor
from app.db.session import make_engine, session_factory
from tests.catalog.conftest import SERVO_ROW, SOURCE

FILE = "muster/servo-2024/servo_motor.csv"
INDUCTION_HEADER = "manufacturer,model,rotor_inertia_kgm2,winding,poles,rated_power_kw,frequency_hz,rated_speed_rpm"


def test_a_sound_edition_is_loaded_once(empty_engine: Engine, write_edition, servo_file, content_of):
    folder = write_edition(servo_motor=servo_file())
    first = load_catalog(empty_engine, folder)
    assert first.ok, first.render()
    assert (first.loaded, dict(first.written)) == (["muster:servo-2024"], {"servo_motor": 1})
    loaded = content_of(empty_engine)

    second = load_catalog(empty_engine, folder)
    assert (second.loaded, second.unchanged) == ([], ["muster:servo-2024"])
    assert content_of(empty_engine) == loaded


def test_a_changed_edition_replaces_its_rows_and_keeps_the_ids(empty_engine: Engine, write_edition, servo_file):
    load_catalog(empty_engine, write_edition(servo_motor=servo_file()))
    with session_factory(empty_engine)() as session:
        before = CatalogRepository(session)
        version, ids = before.catalogue_version(), [motor.id for motor in before.servo_motors()]
    load_catalog(empty_engine, write_edition(servo_motor=servo_file(SERVO_ROW, "Muster,A,A-2,sync,3000,5,4,12,")))
    with session_factory(empty_engine)() as session:
        after = CatalogRepository(session)
        motors = after.servo_motors()
        assert [motor.model for motor in motors] == ["A-1", "A-2"]
        assert motors[0].id == ids[0] == "servo-motor:muster:servo-2024:a-1"
        assert after.catalogue_version() != version


def test_one_folder_of_an_own_catalogue_leaves_the_others_alone(empty_engine: Engine, write_edition, servo_file):
    root = write_edition(servo_motor=servo_file())
    write_edition(folder="muster/own", servo_motor=servo_file("Muster,B,B-1,sync,3000,5,4,12,"))
    assert load_catalog(empty_engine, root / "muster" / "servo-2024").loaded == ["muster:servo-2024"]
    assert load_catalog(empty_engine, root / "muster" / "own").loaded == ["muster:own"]
    with session_factory(empty_engine)() as session:
        assert {motor.model for motor in CatalogRepository(session).servo_motors()} == {"A-1", "B-1"}


@pytest.mark.parametrize(
    ("change", "place", "text"),
    [
        (("3000", "fast"), ":2:rated_speed_rpm", "'fast' is not a number"),
        (("3000", "3,000"), ":2", "has 10 cells, the header 9"),
        (("3000", '"3,5"'), ":2:rated_speed_rpm", "the decimal sign is a point"),
        (("3000", "NaN"), ":2:rated_speed_rpm", "'NaN' is not a number"),
        (("3000", "inf"), ":2:rated_speed_rpm", "'inf' is not a number"),
        (("3000", "1e400"), ":2:rated_speed_rpm", "too large"),
        (("3000", "-3000"), ":2:rated_speed_rpm", "not plausible"),
        (("3000", "0"), ":2:rated_speed_rpm", "not plausible"),
        (("1.257", "1257"), ":2:rated_power_kw", "1257 kW does not match torque times speed: 1.26 kW"),
        (("5,4,12,1.257", "3.8,4,3.9,1.257"), ":2:peak_torque_nm", "3.9 is less than rated_torque_nm 4"),
        (("12,1.257", "4.5,1.257"), ":2:peak_torque_nm", "4.5 is less than stall_torque_nm 5"),
        ((",sync,", ",synchronous,"), ":2:kind", "'synchronous' is none of sync, async"),
        ((",A-1,", ",,"), ":2:model", "must not be empty"),
        ((",A-1,", f",{'A' * 81},"), ":2:model", "longer than 80 characters"),
        ((",A-1,", ",A\x00B,"), ":2:model", "control character"),
        (("rated_torque_nm", "rated_torque_kw"), ":1:rated_torque_kw", "kW is no unit of torque"),
        (("rated_torque_nm", "rated_torque"), ":1:rated_torque", "needs its unit: 'rated_torque_nm'"),
        (("rated_torque_nm", "rated_torqe_nm"), ":1:rated_torqe_nm", "did you mean 'rated_torque_nm'?"),
        (("rated_torque_nm", "stall_torque_mnm"), ":1:stall_torque_mnm", "stands in two columns"),
        (("kind,", "cooling,"), ":1:kind", "this column is required"),
        (("1.257\n", "1.257\n" + SERVO_ROW + "\n"), ":3:model", "'A-1' stands already in line 2"),
        (("1.257\n", '1.257\n"open'), ":3", "is no valid CSV"),
    ],
)
def test_a_bad_file_changes_nothing_and_is_reported(
    engine: Engine, write_edition, servo_file, content_of, change: tuple[str, str], place: str, text: str
):
    load_catalog(engine, write_edition(servo_motor=servo_file()))
    before = content_of(engine)
    bad = servo_file().replace(*change)
    assert bad != servo_file()
    write_edition(folder="muster/a-sound-one", servo_motor=servo_file("Muster,B,B-1,sync,3000,5,4,12,"))

    report = load_catalog(engine, write_edition(servo_motor=bad))

    assert [line.place for line in report.errors] == [FILE + place]
    assert text in report.errors[0].text
    assert f"{FILE}{place}: error: " in report.render()
    assert content_of(engine) == before


def test_a_bad_file_changes_nothing_on_either_database(empty_engine: Engine, write_edition, servo_file, content_of):
    write_edition(folder="muster/a-sound-one", servo_motor=servo_file())
    before = content_of(empty_engine)
    assert not load_catalog(empty_engine, write_edition(servo_motor=servo_file().replace("3000", "fast"))).ok
    assert content_of(empty_engine) == before


def test_a_failing_write_takes_back_the_editions_before_it(
    empty_engine: Engine, write_edition, servo_file, content_of, monkeypatch: pytest.MonkeyPatch
):
    before = content_of(empty_engine)
    write_edition(folder="muster/a-first", servo_motor=servo_file())
    folder = write_edition(folder="muster/b-second", servo_motor=servo_file())
    import app.catalog.load as load

    write = load._write_edition

    def fail_at_the_second(connection, edition, report):
        if edition.folder.slug == "b-second":
            raise RuntimeError("the disk is full")
        write(connection, edition, report)

    monkeypatch.setattr(load, "_write_edition", fail_at_the_second)
    with pytest.raises(RuntimeError):
        load_catalog(empty_engine, folder)
    assert content_of(empty_engine) == before


def test_every_fault_of_a_file_is_reported_at_once(engine: Engine, write_edition, servo_file):
    rows = ["Muster,A,A-1,sync,fast,5,4,12,x", SERVO_ROW.replace("A-1", "A-2"), "Muster,A,A-3,sync,,-5,4,12,"]
    report = load_catalog(engine, write_edition(servo_motor=servo_file(*rows)))
    places = [(line.line, line.column) for line in report.errors]
    assert places == [(2, "rated_speed_rpm"), (2, "rated_power_kw"), (4, "stall_torque_nm")]


def test_what_merely_looks_odd_is_a_warning(engine: Engine, write_edition, servo_file):
    odd = "Muster,A,A-1,sync,3000,3.5,4,12,1.5"  # stall below rated torque; 1.5 kW printed for 1.257 kW
    report = load_catalog(engine, write_edition(servo_motor=servo_file(odd)))
    assert report.ok
    assert [line.column for line in report.warnings] == ["stall_torque_nm", "rated_power_kw"]
    assert "2 warnings" in report.render()
    with engine.connect() as connection:
        assert connection.execute(select(func.count(ServoMotor.id))).scalar_one() == 1


@pytest.mark.parametrize(
    "as_written",
    [
        lambda text: text.encode("utf-8-sig"),
        lambda text: text.replace("\n", "\r\n").encode(),
        lambda text: text.rstrip("\n").encode(),
        lambda text: (text + "\n,,,,,,,,\n\n").encode(),
        lambda text: text.replace(",", ";").replace("1.257", "1,257").encode("utf-8-sig"),
    ],
    ids=["byte order mark", "CRLF", "no last line end", "blank lines", "semicolons and decimal commas"],
)
def test_files_as_spreadsheets_write_them_are_read(engine: Engine, write_edition, servo_file, as_written):
    report = load_catalog(engine, write_edition(servo_motor=as_written(servo_file())))
    assert report.ok, report.render()
    with session_factory(engine)() as session:
        (motor,) = CatalogRepository(session).servo_motors()
    assert (motor.model, motor.rated_torque) == ("A-1", 4.0)
    assert motor.rated_power == pytest.approx(1257)


def test_a_line_number_counts_lines_inside_quoted_cells(engine: Engine, write_edition):
    text = 'manufacturer,model,kind,note,stall_torque_nm\nMuster,A,sync,"two\nlines",1\nMuster,B,sync,,much\n'
    report = load_catalog(engine, write_edition(servo_motor=text))
    assert [line.place for line in report.errors] == [f"{FILE}:4:stall_torque_nm"]


def test_a_file_in_another_encoding_is_refused_at_its_line(engine: Engine, write_edition, servo_file):
    text = servo_file(SERVO_ROW, "Müster,A,A-2,sync,3000,5,4,12,")
    report = load_catalog(engine, write_edition(servo_motor=text.encode("latin-1")))
    assert [(line.place, line.text) for line in report.errors] == [(f"{FILE}:3", "is not written in UTF-8")]


def test_an_empty_file_is_refused(engine: Engine, write_edition):
    report = load_catalog(engine, write_edition(servo_motor=""))
    assert [line.render() for line in report.errors] == [f"{FILE}:1: error: is empty"]


@pytest.mark.parametrize(
    ("source", "place", "text"),
    [
        (None, "muster/servo-2024/servo_motor.csv", "SOURCE.toml is missing"),
        ("maker = ", "muster/servo-2024/SOURCE.toml", "cannot be read"),
        ('maker = "M"\n', "muster/servo-2024/SOURCE.toml:document", "is missing"),
        (SOURCE + 'page = "4"\n', "muster/servo-2024/SOURCE.toml:page", "unknown entry"),
        (SOURCE + "note = [1]\n", "muster/servo-2024/SOURCE.toml:note", "must be a text"),
        (SOURCE.replace("2024-05", "May 2024"), "muster/servo-2024/SOURCE.toml:date", "is no date"),
        (SOURCE.replace("Muster", ""), "muster/servo-2024/SOURCE.toml:maker", "is empty"),
    ],
)
def test_a_bad_source_is_refused(
    engine: Engine, write_edition, servo_file, content_of, source: str | None, place: str, text: str
):
    before = content_of(engine)
    report = load_catalog(engine, write_edition(source=source, servo_motor=servo_file()))
    assert place in [line.place for line in report.errors]
    assert any(text in line.text for line in report.errors)
    assert content_of(engine) == before


def test_an_unknown_file_an_empty_folder_and_no_folder_are_refused(engine: Engine, write_edition, tmp_path: Path):
    unknown = load_catalog(engine, write_edition(linear_motor="a,b\n1,2\n"))
    assert [line.place for line in unknown.errors] == ["muster/servo-2024/linear_motor.csv"]
    assert "servo_motor" in unknown.errors[0].text
    (tmp_path / "nothing").mkdir()
    assert "holds no catalogue" in load_catalog(engine, tmp_path / "nothing").errors[0].text
    assert "no such folder" in load_catalog(engine, tmp_path / "missing").errors[0].text


def test_two_folders_must_not_be_the_same_edition(engine: Engine, write_edition, servo_file):
    write_edition(folder="one/servo", servo_motor=servo_file())
    report = load_catalog(engine, write_edition(folder="two/servo", servo_motor=servo_file()))
    assert [line.text for line in report.errors] == ["edition muster:servo is also that of one/servo"]


def test_operating_points_of_one_motor(empty_engine: Engine, write_edition):
    sound = f"{INDUCTION_HEADER}\nM,D8/2,0.01,low,8,0.3,50,675\nM,D8/2,0.01,high,2,1.3,50,2680\n"
    report = load_catalog(empty_engine, write_edition(induction_motor=sound))
    assert report.ok, report.render()
    assert report.written == Counter(induction_motor=1, induction_motor_operating_point=2)


@pytest.mark.parametrize(
    ("second", "place", "text"),
    [
        ("M,D8/2,0.02,high,2,1.3,50,2680", ":3:rotor_inertia_kgm2", "differs from line 2"),
        ("M,D8/2,0.01,high,8,1.3,50,680", ":3:model", "'D8/2' stands already in line 2"),
        ("M,D8/2,0.01,high,2,1.3,50,3000", ":3:rated_speed_rpm", "not below the synchronous speed 3000 rpm"),
        ("M,D8/2,0.01,high,2.0,1.3,50,2680", ":3:poles", "'2.0' is not a whole number"),
    ],
)
def test_faults_between_operating_points(engine: Engine, write_edition, second: str, place: str, text: str):
    file = f"{INDUCTION_HEADER}\nM,D8/2,0.01,low,8,0.3,50,675\n{second}\n"
    report = load_catalog(engine, write_edition(induction_motor=file))
    assert [line.place for line in report.errors] == [f"muster/servo-2024/induction_motor.csv{place}"]
    assert text in report.errors[0].text


@pytest.mark.parametrize(
    ("content", "place", "text"),
    [
        ('{"title": "T", "data": }', ":1:24", "is no valid JSON"),
        ('{"title": "T", "data": [NaN]}', "", "NaN is no number"),
        ('{"title": "T", "title": "U", "data": [1]}', "", "'title' stands twice"),
        ("[1]", "", "must be an object"),
        ('{"title": "T"}', ":data", "is missing"),
        ('{"title": "T", "data": [1], "values": 2}', ":values", "unknown entry"),
        ('{"title": "T", "data": {"curves": [[1, 2]]}}', ":data", "must hold curves"),
        ('{"title": "T", "data": {"curves": [{"points": [[1]]}]}}', ":data", "must hold curves"),
        ('{"title": "T", "data": {"curves": [{"points": []}]}}', ":data", "needs points"),
        ('{"title": "T", "data": {"curves": []}}', ":data", "needs points"),
        ('{"title": "T", "data": {"curves": [{"points": [[1, 1e999]]}]}}', ":data", "finite"),
    ],
)
def test_bad_standard_tables_are_refused(engine: Engine, write_edition, content: str, place: str, text: str):
    report = load_catalog(engine, write_edition(standard_x=content))
    assert [line.place for line in report.errors] == [f"muster/servo-2024/standard_x.json{place}"]
    assert text in report.errors[0].text


def test_order_codes_that_differ_in_signs_only_get_different_ids(engine: Engine, write_edition):
    text = "manufacturer,model,kind\nMuster,A+B,sync\nMuster,A-B,sync\nMuster,電動,sync\n"
    assert load_catalog(engine, write_edition(servo_motor=text)).ok
    with session_factory(engine)() as session:
        catalog = CatalogRepository(session)
        motors = catalog.servo_motors()
        assert len({motor.id for motor in motors}) == 3
        assert [catalog.servo_motor(motor.id).model for motor in motors] == ["A+B", "A-B", "電動"]


def test_two_processes_may_load_at_once(empty_engine: Engine, write_edition, servo_file):
    folder = write_edition(servo_motor=servo_file())
    url = empty_engine.url.render_as_string(hide_password=False)
    start = threading.Barrier(2)
    loaded: list[str] = []

    def work() -> None:
        engine = make_engine(url)
        start.wait()
        loaded.extend(load_catalog(engine, folder).loaded)
        engine.dispose()

    threads = [threading.Thread(target=work) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert loaded == ["muster:servo-2024"]  # one wrote, the other found it unchanged
