"""The action clients that the trees of one executive share, one for each action."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar, cast

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType
from tandem.trees.client import ActionClient, GoalHandle, GoalJournal

G = TypeVar("G", bound=Message)
F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)

AnyGoal = GoalHandle[Message, Message, Message]
"""A goal of whichever action."""


class Clients:
    """Makes a client for an action when it is first used, and moves all of them on."""

    def __init__(self, bus: Bus, clocks: Clocks, owner: str, journal: GoalJournal | None = None) -> None:
        """``owner``: the announced name of this process; ``journal`` is told of each goal first."""
        self._bus, self._clocks, self._owner = bus, clocks, owner
        self.journal = journal
        self._clients: dict[str, ActionClient[Message, Message, Message]] = {}

    def of(self, action: ActionType[G, F, R]) -> ActionClient[G, F, R]:
        """Return the client of the action."""
        client = self._clients.get(action.name)
        if client is None:
            made = ActionClient(self._bus, self._clocks, action, self._owner, self.journal)
            # The table holds clients of all kinds; an action's name fixes its models.
            client = cast("ActionClient[Message, Message, Message]", made)
            self._clients[action.name] = client
        return cast("ActionClient[G, F, R]", client)

    def poll(self) -> bool:
        """Move all goals on; return whether any changed."""
        changes = [client.poll() for client in self._clients.values()]
        return any(changes)

    @property
    def quiet(self) -> bool:
        """Whether no goal is open."""
        return all(client.quiet for client in self._clients.values())

    @property
    def open(self) -> tuple[AnyGoal, ...]:
        """The goals that have not ended."""
        return tuple(handle for client in self._clients.values() for handle in client.open)

    def stuck(self, within_robot: float, within_host: float) -> tuple[AnyGoal, ...]:
        """Return the goals that were told to come to rest and have not in time (``GoalHandle.overdue``)."""
        return tuple(handle for handle in self.open if handle.overdue(within_robot, within_host))

    def drop(self, handles: Iterable[AnyGoal], message: str) -> None:
        """Give goals up that do not end, so that they hold nobody up and reach nobody any more."""
        for handle in handles:
            self._clients[handle.action].drop(handle, message)

    def gone(self) -> tuple[str, ...]:
        """Return the names of the actions used so far that nobody serves now."""
        return tuple(name for name, client in self._clients.items() if not client.alive())

    def close(self) -> None:
        """End all subscriptions."""
        for client in self._clients.values():
            client.close()
