"""What one running application holds; made when it starts, closed when it stops."""

from dataclasses import dataclass

from sqlalchemy import Engine
from sqlalchemy.orm import Session, sessionmaker

from app.db.session import make_engine, session_factory
from app.services.catalogue import CatalogueCache
from app.services.examples import ExampleService, examples_folder
from app.services.selection import SelectionService
from app.services.sizing import SizingService
from app.settings import Settings
from app.web.answers import AnswerCache


@dataclass(frozen=True)
class Running:
    """The parts of a running application; found at ``request.app.state.running``."""

    settings: Settings
    engine: Engine
    sessions: sessionmaker[Session]
    catalogue: CatalogueCache
    sizing: SizingService
    selection: SelectionService
    examples: ExampleService
    answers: AnswerCache

    @classmethod
    def start(cls, settings: Settings) -> "Running":
        """Make all parts; the database is opened by the first request that needs it."""
        engine = make_engine(settings.database_url)
        sessions = session_factory(engine)
        catalogue = CatalogueCache(sessions)
        sizing = SizingService(catalogue)
        return cls(
            settings=settings,
            engine=engine,
            sessions=sessions,
            catalogue=catalogue,
            sizing=sizing,
            selection=SelectionService(catalogue, sizing),
            examples=ExampleService(sizing, examples_folder()),
            answers=AnswerCache(),
        )

    def stop(self) -> None:
        """Close what is open."""
        self.engine.dispose()
