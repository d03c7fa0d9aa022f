"""Pages for readers: every module of this package that has a ``router`` adds its addresses."""

import importlib
import pkgutil

from fastapi import APIRouter


def pages_router() -> APIRouter:
    """One router with all pages; kept out of the documentation of the REST interface."""
    joined = APIRouter(include_in_schema=False)
    for module in pkgutil.iter_modules(__path__):
        found = getattr(importlib.import_module(f"{__name__}.{module.name}"), "router", None)
        if isinstance(found, APIRouter):
            joined.include_router(found)
    return joined
