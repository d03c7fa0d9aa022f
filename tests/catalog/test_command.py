"""The command ``drivewright load-catalog``."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Run the command line against a database that does not exist yet."""
    monkeypatch.setenv("DATABASE_URL", f"sqlite:///{tmp_path / 'new.db'}")
    return lambda *arguments: CliRunner().invoke(app, [str(argument) for argument in arguments])


def test_the_shipped_catalogue_loads_into_a_new_database(run):
    result = run("load-catalog")
    assert result.exit_code == 0, result.output
    assert "servo_gear_unit: 1964 rows" in result.output
    assert "0 editions loaded (0 rows)" in run("load-catalog").output


def test_an_own_catalogue_is_loaded_from_its_folder(run, write_edition, servo_file):
    result = run("load-catalog", write_edition(servo_motor=servo_file()))
    assert result.exit_code == 0, result.output
    assert "1 editions loaded (1 rows), 0 unchanged, 0 warnings" in result.output


def test_a_refused_file_ends_with_code_1_and_names_the_place(run, write_edition, servo_file):
    result = run("load-catalog", write_edition(servo_motor=servo_file().replace("3000", "fast")))
    assert result.exit_code == 1
    assert "muster/servo-2024/servo_motor.csv:2:rated_speed_rpm: error: 'fast' is not a number" in result.output
    assert "nothing loaded: 1 errors" in result.output
