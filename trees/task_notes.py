"""What of a task's tree outlives a restart of the executive: notes, and the numbers of its goals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TypeVar

from pydantic import JsonValue, ValidationError

from tandem.skills.ports.message import Message

M = TypeVar("M", bound=Message)


@dataclass(eq=False)
class TaskNotes:
    """The executive writes them to its ledger before the next goal is sent."""

    all: dict[str, JsonValue] = field(default_factory=dict)
    """What ``keep`` noted, by name; also by the tree of before a restart."""
    goals_before: Mapping[str, int] = field(default_factory=dict)
    """The number of the last goal of each node, from before this tree began (once more)."""
    _numbered: dict[str, int] = field(default_factory=dict)

    def keep(self, name: str, what: Message) -> None:
        """Note what this tree or its wind-down must know after a restart; on disk before the next goal."""
        self.all[name] = what.model_dump(mode="json")

    def kept(self, name: str, model: type[M]) -> M | None:
        """Return what was kept; None when nothing was, or by a release with another model."""
        try:
            return model.model_validate(self.all[name]) if name in self.all else None
        except ValidationError:
            return None

    def next_attempt(self, node: str) -> int:
        """Return the number of a node's next goal; none comes twice in a task, not even after a restart."""
        number = self._numbered.get(node, self.goals_before.get(node, 0)) + 1
        self._numbered[node] = number
        return number
