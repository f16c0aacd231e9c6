"""What stays of a task that is forgotten: that a client asked for it, what it asked, and how it ended."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from typing import Final

from pydantic import JsonValue

from tandem.skills.ports.tasks import TaskStatus

KEPT_IDS: Final = 50_000
"""Clients' ids that are kept beyond the history: some 25 MB, and years of a robot's work."""
DIGEST: Final = "sha256"
"""Stands for the document of a request that is forgotten."""


def stub_of(status: TaskStatus) -> TaskStatus:
    """Return the task with nothing in it that takes room."""
    return TaskStatus(
        task=status.task,
        kind=status.kind,
        request={DIGEST: _digest(status.request)},
        state=status.state,
        accepted_at=status.accepted_at,
        ended_at=status.ended_at,
        client_id=status.client_id,
        begun=status.begun,
    )


def same_request(kept: Mapping[str, JsonValue], document: Mapping[str, JsonValue]) -> bool:
    """Say whether a document is the one that is kept, or of which only the digest is."""
    return kept == document or kept == {DIGEST: _digest(document)}


def _digest(document: Mapping[str, JsonValue]) -> str:
    return hashlib.sha256(json.dumps(document, sort_keys=True).encode()).hexdigest()
