"""Command line of Drivewright: ``drivewright --help``.

Every command imports what it needs inside itself, so that ``--help`` is quick and a broken part breaks its own
command only.
"""

from pathlib import Path
from typing import Annotated

import typer

from app.settings import Settings, read_settings, variable_of

app = typer.Typer(
    name="drivewright",
    help="Select an electric drive, with every number open to its formula.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


def _settings() -> Settings:
    """The settings, or a plain message and exit code 2 when the environment holds something impossible."""
    from pydantic import ValidationError

    try:
        return read_settings()
    except ValidationError as error:
        for problem in error.errors():
            typer.echo(f"{variable_of(problem['loc'])}: {problem['msg']}", err=True)
        raise typer.Exit(2) from None


def _migrated() -> Settings:
    """The settings, with their database brought up to date: a command may be the first one ever run."""
    settings = _settings()
    from app.db.migrate import upgrade

    upgrade(settings.database_url)
    return settings


@app.command()
def migrate() -> None:
    """Create the database or bring it up to date."""
    _migrated()


@app.command("load-catalog")
def load_catalog(
    directory: Annotated[
        Path | None, typer.Argument(help="Folder of editions, instead of the shipped catalogue.")
    ] = None,
) -> None:
    """Read a folder of catalogue editions into the database; exit code 1 when a file is refused (nothing is loaded)."""
    from app.catalog import load
    from app.db.session import make_engine

    settings = _migrated()
    engine = make_engine(settings.database_url)
    try:
        report = load.load_catalog(engine, directory or settings.catalog_dir)
    finally:
        engine.dispose()
    typer.echo(report.render(), err=not report.ok)
    if not report.ok:
        raise typer.Exit(1)


@app.command()
def size(
    file: Annotated[Path, typer.Argument(help="JSON file of a sizing request, or of a saved project.")],
    as_json: Annotated[bool, typer.Option("--json", help="Print the whole result as JSON.")] = False,
) -> None:
    """Calculate the axis (or all axes) of a file; exit code 1 when a check fails, 2 when an input cannot be used."""
    from app.services import console
    from app.services.errors import ServiceError

    try:
        with console.services(_migrated().database_url) as parts:
            result = console.size_file(parts.sizing, file)
    except (ServiceError, OSError) as error:
        typer.echo(console.refusal(error), err=True)
        raise typer.Exit(2) from None
    typer.echo(result.as_json() if as_json else result.as_text())
    raise typer.Exit(1 if result.fails else 0)


@app.command()
def examples(
    as_json: Annotated[bool, typer.Option("--json", help="Print every row of every example as JSON.")] = False,
) -> None:
    """Recompute the worked examples; exit code 1 when a number that must be met is not."""
    from app.services import console

    with console.services(_migrated().database_url) as parts:
        found = parts.examples.run_all()
    typer.echo(console.examples_json(found) if as_json else console.examples_text(found))
    raise typer.Exit(0 if all(example.met for example in found) else 1)


@app.command()
def serve(
    host: Annotated[str | None, typer.Option(help="Address to listen on, instead of DRIVEWRIGHT_HOST.")] = None,
    port: Annotated[int | None, typer.Option(help="Port to listen on, instead of DRIVEWRIGHT_PORT.")] = None,
    workers: Annotated[int | None, typer.Option(help="Server processes, instead of DRIVEWRIGHT_WORKERS.")] = None,
) -> None:
    """Serve the pages and the REST interface."""
    import uvicorn

    settings = _settings()
    host, port = host or settings.host, port or settings.port
    shown = "127.0.0.1" if host in {"0.0.0.0", "::"} else host
    typer.echo(f"Drivewright: http://{shown}:{port}")
    uvicorn.run(
        "app.main:create_app_from_environment",
        factory=True,
        host=host,
        port=port,
        workers=workers or settings.workers,
        log_level=settings.log_level,
        access_log=False,  # the address of a project is its key: it must not stand in a log
        proxy_headers=True,
    )
