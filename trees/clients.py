"""The action clients that the trees of one executive share, one for each action."""

from __future__ import annotations

from typing import TypeVar, cast

from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.message import Message
from skills.ports.skill import ActionType
from trees.client import ActionClient

G = TypeVar("G", bound=Message)
F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)


class Clients:
    """Makes a client for an action when it is first used, and moves all of them on."""

    def __init__(self, bus: Bus, clocks: Clocks, owner: str) -> None:
        """``owner``: the announced name of this process."""
        self._bus, self._clocks, self._owner = bus, clocks, owner
        self._clients: dict[str, ActionClient[Message, Message, Message]] = {}

    def of(self, action: ActionType[G, F, R]) -> ActionClient[G, F, R]:
        """Return the client of the action."""
        client = self._clients.get(action.name)
        if client is None:
            made = ActionClient(self._bus, self._clocks, action, self._owner)
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

    def close(self) -> None:
        """End all subscriptions."""
        for client in self._clients.values():
            client.close()
