"""What was known at a moment of a record: the last message of each key, and what they say."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeVar

from pydantic import ValidationError

from tandem.executive.records.recording import Recorded
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import Message, RobotTime, read_leniently
from tandem.skills.ports.tasks import TREE, TaskStatus, TreeSnapshot

ALIVE: Final = "recorder/alive"
"""The recorder's own: the names that were announced, whenever they changed (``Alive``)."""
STATUS: Final = "/status"
TASK: Final = "task/"
M = TypeVar("M", bound=Message)


class Alive(Message):
    """The names that are announced on the robot's bus."""

    names: tuple[str, ...]


def names_task(key: str) -> bool:
    """Say whether a key is that of one task's status: ``task/<id>/status``."""
    return key.startswith(TASK) and key.endswith(STATUS) and key.count("/") == TASK.count("/") + 1


def said(model: type[M], message: Recorded | None) -> M | None:
    """Return what a message says; None for one that is none: a record has what was heard, whoever sent it."""
    try:
        return None if message is None else read_leniently(model, message.payload)
    except ValidationError:
        return None


@dataclass(frozen=True)
class Known:
    """What was known at a moment."""

    at: float
    """Robot seconds since the recorder began."""
    stamp: RobotTime | None
    """The robot's time."""
    last: Mapping[str, Recorded] = field(default_factory=dict)
    """The last message of each key."""

    def message(self, topic: Topic[M]) -> M | None:
        """Return the last message of a topic, or None."""
        return said(topic.model, self.last.get(topic.key))

    def statuses(self) -> tuple[TaskStatus, ...]:
        """Return all tasks as they were, in the order in which they were accepted."""
        read = (said(TaskStatus, each) for key, each in self.last.items() if names_task(key))
        found = [each for each in read if each is not None]
        return tuple(sorted(found, key=lambda each: (each.accepted_at, each.task)))

    def tree(self) -> TreeSnapshot:
        """Return the last tree, as ``tree/now`` answers; before the first an empty one."""
        return self.message(TREE) or NO_TREE

    def alive(self) -> frozenset[str]:
        """Return the names that were announced."""
        found = said(Alive, self.last.get(ALIVE))
        return frozenset() if found is None else frozenset(found.names)

    def of_keys(self, beginning: str) -> Iterator[Recorded]:
        """Yield the last message of each key that begins so."""
        return (each for key, each in self.last.items() if key.startswith(beginning))


NO_TREE: Final = TreeSnapshot.model_validate(
    {
        "task": "",
        "kind": "",
        "tick": 0,
        "root": {"path": "idle", "name": "idle", "kind": "action", "type": "Nothing"},
    }
)
"""As the executive answers before it has run a task."""
