"""From a client's document to a request that a task can be built from, or to what is wrong with it."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from pydantic import JsonValue, ValidationError

from tandem.executive.ledger.sender import BY_FIELD
from tandem.executive.service.intake.envelope import FIELDS, Envelope
from tandem.skills.ports.documents import parse
from tandem.skills.ports.message import PLAIN_TEXT, Message
from tandem.skills.ports.problems import Problem, problems_of, show
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.utc import iso
from tandem.trees.task import TaskType

KIND_FIELD: Final = "task"
"""Names the kind of task."""
ID_FIELD: Final = "id"
"""The client's own name for its request: repeated in the answer."""
MAX_ID: Final = 64
"""Characters: room for a UUID and a prefix; it is told with every status."""
PLAIN: Final = re.compile(PLAIN_TEXT)
"""Ids stand in logs, in files and on screens."""


@dataclass(frozen=True)
class Asked:
    """A request that may be queued."""

    kind: TaskType[Message]
    request: Message
    document: dict[str, JsonValue]
    """As the client sent it."""
    client_id: str = ""
    envelope: Envelope = field(default_factory=Envelope)


@dataclass(frozen=True)
class Refused:
    """A request that may not, and why."""

    problems: tuple[Problem, ...]
    client_id: str = ""


def read_request(payload: bytes, kinds: Mapping[str, TaskType[Message]], site: Site) -> Asked | Refused:
    """Read a document and check it."""
    document = parse(payload)
    return Refused(document) if isinstance(document, tuple) else check_request(document, kinds, site)


def check_request(
    document: dict[str, JsonValue],
    kinds: Mapping[str, TaskType[Message]],
    site: Site,
    robot: RobotDescription | None = None,
) -> Asked | Refused:
    """Check a document against the kinds of task, their models, what is known beforehand, and the robot."""
    client_id = document.get(ID_FIELD, "")
    if not isinstance(client_id, str) or len(client_id) > MAX_ID or not PLAIN.fullmatch(client_id):
        expected = f"text of at most {MAX_ID} characters, without control characters"
        return Refused((Problem(path=ID_FIELD, expected=expected, found=show(client_id)),))
    name = document.get(KIND_FIELD)
    kind = kinds.get(name) if isinstance(name, str) else None
    if kind is None:
        known = " or ".join(show(each) for each in kinds) or "a task (none is installed)"
        found = show(name) if KIND_FIELD in document else ""
        return Refused((Problem(path=KIND_FIELD, expected=known, found=found),), client_id)
    asked = _checked(document, kind, site, client_id)
    problems = kind.against(asked.request, robot) if isinstance(asked, Asked) else ()
    return Refused(problems, client_id) if problems else asked


def _checked(
    document: dict[str, JsonValue], kind: TaskType[Message], site: Site, client_id: str
) -> Asked | Refused:
    outside = FIELDS - kind.request.model_fields.keys()
    said = {name: value for name, value in document.items() if name in outside}
    found: list[Problem] = []
    envelope = Envelope()
    try:
        envelope = Envelope.model_validate_json(json.dumps(said), strict=True)
    except ValidationError as error:
        found += problems_of(error)
    try:
        body = json.dumps(body_of(document, kind.request))
        request = kind.request.model_validate_json(body, strict=True, context=site)  # it names the items
    except ValidationError as error:
        return Refused((*problems_of(error), *found), client_id)
    problems = (*kind.contradictions(request, site), *found, *_contradictions(envelope))
    if problems:
        return Refused(problems, client_id)
    return Asked(kind, request, document, client_id, envelope)


def _contradictions(envelope: Envelope) -> tuple[Problem, ...]:
    first, last = envelope.not_before, envelope.expires
    if first is None or last is None or first < last:
        return ()
    return (Problem(path="expires", expected=f"a time after not_before ({iso(first)})", found=iso(last)),)


def body_of(document: Mapping[str, JsonValue], model: type[Message]) -> dict[str, JsonValue]:
    """Return what the model itself asks for: without the envelope's fields that it does not have."""
    envelope = {KIND_FIELD, ID_FIELD, BY_FIELD, *FIELDS} - model.model_fields.keys()
    return {name: value for name, value in document.items() if name not in envelope}
