"""The application: joins services, REST and pages. Importing this module opens nothing."""

import gzip
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import cache
from importlib import resources

from fastapi import FastAPI, Request, Response
from starlette.middleware.gzip import GZipMiddleware
from starlette.staticfiles import StaticFiles

from app.services.version import ENGINE_VERSION
from app.settings import PROJECT_ROOT, Settings, read_settings
from app.web.api.documentation import install_openapi
from app.web.api.router import router as api_router
from app.web.errors import install_errors
from app.web.middleware import Guard
from app.web.pages import pages_router
from app.web.state import Running
from app.web.templating import Templates, english, problem_page

STATIC = PROJECT_ROOT / "static"


def create_app(settings: Settings) -> FastAPI:
    """Build the application; what it opens is opened when it starts and closed when it stops."""

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        app.state.running = Running.start(settings)
        try:
            yield
        finally:
            app.state.running.stop()

    app = FastAPI(
        title="Drivewright",
        version=ENGINE_VERSION,
        lifespan=lifespan,
        docs_url=None,
        redoc_url=None,
        openapi_url="/api/v1/openapi.json",
    )
    app.add_middleware(GZipMiddleware, minimum_size=1000, compresslevel=5)
    app.add_middleware(Guard, max_body_bytes=settings.max_body_bytes)
    install_errors(app)
    app.include_router(api_router)
    app.add_api_route("/healthz", health, include_in_schema=False)
    app.add_api_route("/static/plotly.min.js", plotly_script, include_in_schema=False)
    STATIC.mkdir(exist_ok=True)
    app.state.templates = Templates(english, {"en": "English"})
    app.state.problem_page = problem_page
    app.mount("/static", StaticFiles(directory=STATIC), name="static")
    app.include_router(pages_router())
    install_openapi(app)
    return app


def create_app_from_environment() -> FastAPI:
    """Build the application with the settings of the environment; what a server is pointed at."""
    return create_app(read_settings())


def health() -> dict[str, str]:
    """Answer that the process serves; the database is not asked."""
    return {"status": "ok", "version": ENGINE_VERSION}


def plotly_script(request: Request) -> Response:
    """Plotly's script out of the installed package, so that nothing is fetched from elsewhere.

    Pages ask for it with the package's version in the query, so it may be kept for a year.
    """
    packed = "gzip" in request.headers.get("accept-encoding", "")
    headers = {"Cache-Control": "public, max-age=31536000", "Vary": "Accept-Encoding"}
    if packed:
        headers["Content-Encoding"] = "gzip"
    return Response(_plotly(packed), media_type="text/javascript", headers=headers)


@cache
def _plotly(packed: bool) -> bytes:
    """The script, packed once."""
    script = resources.files("plotly").joinpath("package_data", "plotly.min.js").read_bytes()
    return gzip.compress(script, 6, mtime=0) if packed else script
