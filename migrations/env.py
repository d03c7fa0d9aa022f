"""How alembic reaches the database: a connection handed over by ``app.db.migrate``, ``-x url=`` or the settings."""

from typing import Any, Literal

from alembic import context
from sqlalchemy import Connection

import app.db.models  # noqa: F401 - makes the tables known
from app.db.base import Base, UtcDateTime
from app.db.session import make_engine


def render_item(kind: str, item: Any, _context: Any) -> str | Literal[False]:
    """Write our own types into a migration as the type that they are in the database."""
    return "sa.DateTime(timezone=True)" if kind == "type" and isinstance(item, UtcDateTime) else False


def migrate(connection: Connection) -> None:
    """Run the migrations that were asked for on ``connection``; SQLite alters a table by copying it (batch mode)."""
    context.configure(
        connection=connection,
        target_metadata=Base.metadata,
        compare_type=True,
        render_item=render_item,
        render_as_batch=True,
        transactional_ddl=True,
    )
    with context.begin_transaction():
        context.run_migrations()


def database_url() -> str:
    """Address for the command line."""
    given = context.get_x_argument(as_dictionary=True).get("url")
    if given:
        return given
    from app.settings import read_settings

    return read_settings().database_url


handed_over = context.config.attributes.get("connection")
if handed_over is not None:
    migrate(handed_over)
else:
    engine = make_engine(database_url())
    with engine.connect() as own, own.begin():
        migrate(own)
    engine.dispose()
