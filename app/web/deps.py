"""What handlers are given: services on a session that is committed once, before the answer leaves."""

from collections.abc import Iterator
from typing import Annotated, Any

from fastapi import Depends, Header, Query, Request
from sqlalchemy.orm import Session
from starlette.concurrency import run_in_threadpool

from app.db.repositories.projects import ProjectRepository
from app.services.browsing import BrowsingService
from app.services.catalogue import edition_lines
from app.services.examples import ExampleService
from app.services.projects import ProjectService
from app.services.reading import parse_json
from app.services.selection import SelectionService
from app.services.sizing import SizingService
from app.services.tables import TableService
from app.web.errors import PreconditionRequiredError, UnsupportedMediaError
from app.web.state import Running

MAX_LIMIT = 200
MAX_OFFSET = 1_000_000_000
LARGEST_VERSION = 2**31 - 1


def get_running(request: Request) -> Running:
    """The parts of the running application."""
    running: Running = request.app.state.running
    return running


RunningParts = Annotated[Running, Depends(get_running)]


def get_session(running: RunningParts) -> Iterator[Session]:
    """A session for one request: committed when the handler is done, rolled back when it raises."""
    with running.sessions() as session:
        yield session
        session.commit()


DatabaseSession = Annotated[Session, Depends(get_session, scope="function")]


def get_projects(session: DatabaseSession, running: RunningParts) -> ProjectService:
    """Projects, with the editions that are loaded noted at every save."""
    return ProjectService(ProjectRepository(session), lambda: edition_lines(running.catalogue.snapshot()))


def get_browsing(session: DatabaseSession) -> BrowsingService:
    """The catalogue as printed."""
    return BrowsingService(session)


def get_tables(session: DatabaseSession) -> TableService:
    """The standard tables."""
    return TableService(session)


def get_sizing(running: RunningParts) -> SizingService:
    """Calculation of an axis."""
    return running.sizing


def get_selection(running: RunningParts) -> SelectionService:
    """Search through the catalogue."""
    return running.selection


def get_examples(running: RunningParts) -> ExampleService:
    """Worked examples."""
    return running.examples


Projects = Annotated[ProjectService, Depends(get_projects)]
Browsing = Annotated[BrowsingService, Depends(get_browsing)]
Tables = Annotated[TableService, Depends(get_tables)]
Sizings = Annotated[SizingService, Depends(get_sizing)]
Selections = Annotated[SelectionService, Depends(get_selection)]
Examples = Annotated[ExampleService, Depends(get_examples)]


async def get_bytes(request: Request) -> bytes:
    """The body as it came, if it is declared as JSON (or not declared at all)."""
    declared = request.headers.get("content-type", "application/json").partition(";")[0].strip().lower()
    if declared != "application/json" and not declared.endswith("+json"):
        raise UnsupportedMediaError(f"The body must be application/json, not {declared[:100]!r}.")
    return await request.body()


BodyBytes = Annotated[bytes, Depends(get_bytes)]


async def get_json(body: BodyBytes) -> Any:
    """The body as JSON values; checked against its model by the service."""
    return parse_json(body) if len(body) < 20_000 else await run_in_threadpool(parse_json, body)


JsonBody = Annotated[Any, Depends(get_json)]


def get_version(
    if_match: Annotated[
        str | None,
        Header(description='Version that was edited, as in the ETag of the project: `"3"`', max_length=100),
    ] = None,
) -> int:
    """The version that a change was made from."""
    text = (if_match or "").strip().removeprefix("W/").strip('"')
    if not text.isascii() or not text.isdigit() or int(text[:20]) > LARGEST_VERSION:
        raise PreconditionRequiredError('Name the version that was edited in the header If-Match, for example "3".')
    return int(text)


IfMatch = Annotated[int, Depends(get_version)]
Limit = Annotated[int, Query(ge=1, le=MAX_LIMIT, description="How many entries at most")]
Offset = Annotated[int, Query(ge=0, le=MAX_OFFSET, description="How many entries to skip")]
