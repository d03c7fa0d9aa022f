"""Projects: links, revisions and concurrent saves, on both databases."""

import json
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from sqlalchemy import Engine, text
from sqlalchemy.orm import Session

from app.db.repositories.projects import ProjectRepository
from app.db.session import make_engine, session_factory
from app.services.errors import ConflictError, ForbiddenError, InvalidInputError, NotFoundError
from app.services.projects import OpenedProject, ProjectService, token_hash, view_token_of
from tests.sizing_requests import SCREW_AXIS

EDITIONS = [{"key": "siemens:1ft5", "citation": "Siemens, 1FT5"}]
START = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)


def document(title: str = "Portal", **request: Any) -> dict[str, Any]:
    return {"title": title, "axes": [{"name": "X", "request": {**SCREW_AXIS, **request}}]}


@pytest.fixture
def engine(any_database: str) -> Iterator[Engine]:
    made = make_engine(any_database)
    yield made
    made.dispose()


class Clock:
    """Every look at it is a minute later."""

    def __init__(self) -> None:
        self.now = START

    def __call__(self) -> datetime:
        self.now += timedelta(minutes=1)
        return self.now


@pytest.fixture
def session(engine: Engine) -> Iterator[Session]:
    with session_factory(engine)() as made:
        yield made


@pytest.fixture
def projects(session: Session) -> ProjectService:
    return ProjectService(ProjectRepository(session), lambda: EDITIONS, Clock())


@pytest.fixture
def opened(projects: ProjectService) -> OpenedProject:
    return projects.create(document())


def test_the_edit_link_opens_and_changes_the_view_link_opens_only(projects: ProjectService, opened: OpenedProject):
    assert projects.open(opened.edit_token).can_edit
    viewed = projects.open(opened.view_token)
    assert not viewed.can_edit
    assert viewed.document == projects.open(opened.edit_token).document
    with pytest.raises(ForbiddenError):
        projects.save(opened.view_token, document("other"), 1)
    with pytest.raises(ForbiddenError):
        projects.restore(opened.view_token, 1, 1)
    with pytest.raises(ForbiddenError):
        projects.delete(opened.view_token, 1)


def test_who_edits_can_hand_out_the_view_link_and_not_the_other_way(projects: ProjectService, opened: OpenedProject):
    assert projects.open(opened.edit_token).view_token == opened.view_token == view_token_of(opened.edit_token)
    shown = projects.open(opened.view_token)
    assert opened.edit_token not in repr(shown)
    assert len(opened.edit_token) >= 32


def test_tokens_are_neither_stored_nor_exported(session: Session, projects: ProjectService, opened: OpenedProject):
    rows = session.execute(text("SELECT * FROM project")).all() + session.execute(
        text("SELECT * FROM project_revision")
    ).all()  # fmt: skip
    stored = repr(rows) + json.dumps(projects.export(opened.edit_token))
    assert opened.edit_token not in stored
    assert opened.view_token not in stored
    assert token_hash(opened.edit_token) in stored


@pytest.mark.parametrize("token", ["", "x", "unknown-token", "ü" * 50])
def test_an_unknown_link_opens_nothing(projects: ProjectService, token: str):
    with pytest.raises(NotFoundError):
        projects.open(token)


def test_every_save_is_a_revision_with_version_and_editions(projects: ProjectService, opened: OpenedProject):
    saved = projects.save(opened.edit_token, document("Portal 2"), 1, "longer stroke")
    assert (saved.version, saved.title, saved.comment) == (2, "Portal 2", "longer stroke")
    assert saved.catalogue_editions == EDITIONS
    assert saved.created_at < saved.saved_at
    assert saved.saved_at.tzinfo is not None
    lines, total = projects.revisions(opened.view_token)
    assert (total, [line.number for line in lines]) == (2, [2, 1])
    lines, total = projects.revisions(opened.view_token, limit=1, offset=1)
    assert (total, [line.number for line in lines]) == (2, [1])
    old = projects.open(opened.view_token, 1)
    assert (old.title, old.version, old.newest_version) == ("Portal", 1, 2)
    with pytest.raises(NotFoundError, match="no revision 3"):
        projects.open(opened.view_token, 3)


def test_a_save_from_an_older_version_is_refused_and_changes_nothing(projects: ProjectService, opened: OpenedProject):
    projects.save(opened.edit_token, document("first"), 1)
    with pytest.raises(ConflictError) as caught:
        projects.save(opened.edit_token, document("second"), 1)
    assert caught.value.current == 2
    assert projects.open(opened.edit_token).title == "first"
    with pytest.raises(ConflictError):
        projects.restore(opened.edit_token, 1, 1)
    with pytest.raises(ConflictError):
        projects.delete(opened.edit_token, 1)
    with pytest.raises(ConflictError):
        projects.save(opened.edit_token, document("ahead"), 3)


def test_of_two_saves_at_the_same_time_one_is_refused(engine: Engine):
    """Two sessions, both opened at version 1, as two workers would."""
    factory = session_factory(engine)

    def service(session: Session) -> ProjectService:
        return ProjectService(ProjectRepository(session), lambda: EDITIONS)

    with factory() as first:
        opened = service(first).create(document())
        first.commit()
    with factory() as reader:
        assert service(reader).open(opened.edit_token).version == 1
        with factory() as first:
            service(first).save(opened.edit_token, document("first"), 1)
            first.commit()
    with factory() as second, pytest.raises(ConflictError):
        service(second).save(opened.edit_token, document("second"), 1)
    with factory() as reader:
        assert service(reader).open(opened.edit_token).title == "first"


def test_an_older_revision_is_restored_as_a_new_one(projects: ProjectService, opened: OpenedProject):
    projects.save(opened.edit_token, document("changed", notes="new"), 1)
    restored = projects.restore(opened.edit_token, 1, 2)
    assert (restored.version, restored.title) == (3, "Portal")
    assert restored.document == projects.open(opened.edit_token, 1).document
    assert restored.comment == "Revision 1 restored"


def test_two_revisions_are_compared_value_by_value(projects: ProjectService, opened: OpenedProject):
    projects.save(opened.edit_token, document("Portal", notes="new"), 1)
    (found,) = projects.compare(opened.view_token, 1, 2)
    assert (found.path, found.before, found.after) == (("axes", 0, "request", "notes"), None, "new")
    assert projects.compare(opened.view_token, 2, 2) == []


def test_a_duplicate_goes_its_own_way(projects: ProjectService, opened: OpenedProject):
    copy = projects.duplicate(opened.view_token)
    assert copy.state.title == "Portal (copy)"
    projects.save(copy.edit_token, document("changed"), 1)
    assert projects.open(opened.edit_token).title == "Portal"
    assert copy.edit_token != opened.edit_token


def test_an_export_is_taken_back_as_it_was(projects: ProjectService, opened: OpenedProject):
    exported = projects.export(opened.view_token)
    again = projects.create(json.loads(json.dumps(exported)))
    assert projects.export(again.edit_token) == exported


def test_a_deleted_project_opens_with_no_link(projects: ProjectService, opened: OpenedProject):
    projects.delete(opened.edit_token, 1)
    for token in (opened.edit_token, opened.view_token):
        with pytest.raises(NotFoundError):
            projects.open(token)


def test_what_cannot_be_used_is_not_saved(projects: ProjectService, opened: OpenedProject):
    with pytest.raises(InvalidInputError):
        projects.save(opened.edit_token, {"title": "x"}, 1)
    with pytest.raises(InvalidInputError) as caught:
        projects.save(opened.edit_token, document(), 1, "x" * 501)
    assert caught.value.errors[0].path == ("comment",)
    assert projects.open(opened.edit_token).version == 1
