"""All REST routers under ``/api/v1``."""

from fastapi import APIRouter

from app.web.api import (
    calculations,
    catalogue,
    charts,
    examples,
    formulas,
    mechanisms,
    projects,
    reports,
    selections,
    sizings,
    supplies,
    tables,
)
from app.web.errors import problems

router = APIRouter(prefix="/api/v1", responses=problems(400, 500))
for part in (
    mechanisms, sizings, supplies, charts, selections, calculations, catalogue, tables, projects, examples, formulas,
    reports,
):  # fmt: skip
    router.include_router(part.router)
