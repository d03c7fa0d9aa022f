"""Settings of one running instance: read once from the environment by whoever starts it, then handed down.

Every variable is described in ``docs/settings.md``; a test holds that page to this class.
"""

from pathlib import Path
from typing import Literal

from pydantic import AliasChoices, Field, field_validator
from pydantic_settings import BaseSettings, SettingsConfigDict

PROJECT_ROOT = Path(__file__).resolve().parent.parent
"""The folder that holds ``app/``, ``templates/``, ``static/``, ``migrations/`` and ``catalog_data/``."""


class Settings(BaseSettings):
    """Everything that may differ between two instances. Nothing here changes a calculated number."""

    model_config = SettingsConfigDict(
        env_prefix="DRIVEWRIGHT_",
        env_ignore_empty=True,
        extra="forbid",
        frozen=True,
        validate_by_name=True,
        validate_by_alias=True,
    )

    database_url: str = Field(
        default="sqlite:///var/drivewright.db",
        validation_alias=AliasChoices("DATABASE_URL", "database_url"),
        description="Address of the database: SQLite (a file, made on demand) or PostgreSQL.",
    )
    catalog_dir: Path = Field(
        default=PROJECT_ROOT / "catalog_data",
        description="Folder of catalogue editions that `drivewright load-catalog` reads.",
    )
    host: str = Field(default="127.0.0.1", min_length=1, description="Network address that the server listens on.")
    port: int = Field(default=8000, ge=1, le=65535, description="TCP port that the server listens on.")
    workers: int = Field(default=1, ge=1, le=256, description="Server processes; they share nothing but the database.")
    log_level: Literal["critical", "error", "warning", "info", "debug"] = Field(
        default="info",
        description="Least severe message that is logged.",
    )
    max_body_bytes: int = Field(
        default=1024 * 1024,
        ge=1024,
        description="Largest request body that is read, in bytes; a larger one is answered with 413.",
    )

    @field_validator("database_url")
    @classmethod
    def _name_the_driver(cls, value: str) -> str:
        """Hosting platforms hand out ``postgres://``; SQLAlchemy wants the driver named: psycopg."""
        for prefix in ("postgres://", "postgresql://"):
            if value.startswith(prefix):
                return "postgresql+psycopg://" + value.removeprefix(prefix)
        if not value.startswith(("sqlite:", "postgresql+psycopg:")):
            raise ValueError("only sqlite: and postgresql: addresses are supported")
        return value

    @field_validator("log_level", mode="before")
    @classmethod
    def _any_case(cls, value: object) -> object:
        """``INFO`` and ``info`` mean the same."""
        return value.lower() if isinstance(value, str) else value


def read_settings() -> Settings:
    """Read the settings from the environment.

    Raises pydantic's ``ValidationError``, naming each variable that holds something impossible.
    """
    return Settings()


def variable_of(location: tuple[int | str, ...]) -> str:
    """Environment variable behind a field name or behind the location of a validation error."""
    name = str(location[0]).upper()
    return name if name == "DATABASE_URL" else f"DRIVEWRIGHT_{name}"


def describe_variables() -> list[tuple[str, str, str]]:
    """Each setting as (environment variable, default as text, meaning), in order of declaration."""
    rows = []
    for name, field in Settings.model_fields.items():
        default = "catalog_data" if name == "catalog_dir" else str(field.default)
        rows.append((variable_of((name,)), default, field.description or ""))
    return rows
