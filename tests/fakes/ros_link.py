"""ROS's side of zenoh in memory: what is put reaches who hears it at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from tandem.skills.ports.match import matches
from tandem.skills.ros.link import RosInbox


@dataclass(frozen=True)
class Put:
    """A message with its attachment."""

    key: str
    payload: bytes
    attachment: bytes


@dataclass(eq=False)
class Waiting:
    """An inbox."""

    expression: str
    depth: int
    items: list[Put] = field(default_factory=list)

    def drain(self) -> Sequence[Put]:
        taken, self.items = self.items, []
        return taken


@dataclass(eq=False)
class MemoryNet:
    """What all sessions share."""

    inboxes: list[Waiting] = field(default_factory=list)
    tokens: dict[str, None] = field(default_factory=dict)
    puts: list[Put] = field(default_factory=list)

    def put(self, key: str, payload: bytes, attachment: bytes = b"") -> None:
        made = Put(key, payload, attachment)
        self.puts.append(made)
        for inbox in self.inboxes:
            if matches(inbox.expression, key):
                inbox.items = [*inbox.items, made][-inbox.depth :]


@dataclass(eq=False)
class MemoryLink:
    """One session."""

    net: MemoryNet
    zid: str = "a1"

    def putter(self, key: str) -> Callable[[bytes, bytes], None]:
        return lambda payload, attachment: self.net.put(key, payload, attachment)

    def hear(self, expression: str, depth: int) -> RosInbox:
        self.net.inboxes.append(Waiting(expression, depth))
        return self.net.inboxes[-1]

    def show(self, token: str) -> None:
        self.net.tokens[token] = None

    def watch(self, expression: str) -> Mapping[str, None]:  # noqa: ARG002 - all of them
        return self.net.tokens
