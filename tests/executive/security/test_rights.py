"""The table of rights: every key of the interface has somebody at each of its two ends."""

from __future__ import annotations

import pytest

from tandem.executive.interface.entries import all_entries
from tandem.executive.security.rights import rights_of
from tandem.executive.security.role import PARTS, ROLES
from tandem.executive.system.roles.registry import rights_of_parts
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.match import matches
from tandem.skills.ports.message import Message

EVERYBODY = [rights_of(role) for role in ROLES if role != "robot"] + [
    rights_of("robot", part, rights_of_parts()) for part in PARTS
]


def filled(key: str) -> str:
    """Return a key with names where the interface has ``<name>``."""
    return "/".join("x" if part.startswith("<") else part for part in key.split("/"))


@pytest.mark.parametrize("entry", all_entries(), ids=lambda entry: entry.key)
def test_every_key_has_two_ends(entry: Topic[Message] | Service[Message, Message]) -> None:
    topic = isinstance(entry, Topic)
    near, far = ("tells", "hears") if topic else ("serves", "asks")
    key = filled(entry.key)
    for verb in (near, far):
        allowed = [
            rights for rights in EVERYBODY if any(matches(each, key) for each in rights.model_dump()[verb])
        ]
        assert allowed, f"nobody {verb} {entry.key}: see executive/system/roles and security/access.yaml"


def test_no_client_tells_or_serves_anything_but_requests() -> None:
    for role in ("viewer", "requester", "operator"):
        rights = rights_of(role)
        assert rights.serves == rights.announces == ()
        assert all(key.startswith("task/") and key.endswith("/request") for key in rights.tells)
