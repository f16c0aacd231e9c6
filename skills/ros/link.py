"""The port to zenoh as ROS uses it: whole keys, attachments, tokens."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol


class RosSample(Protocol):
    """One message that came."""

    @property
    def key(self) -> str:
        """The whole key."""
        ...

    @property
    def payload(self) -> bytes:
        """What was put."""
        ...


class RosInbox(Protocol):
    """What a subscription received and nobody has read yet."""

    def drain(self) -> Sequence[RosSample]:
        """Take all of it, oldest first."""
        ...


class Link(Protocol):
    """A session: ``skills.wire.foreign_session`` is one."""

    @property
    def zid(self) -> str:
        """The session's id, in hexadecimal."""
        ...

    def putter(self, key: str) -> Callable[[bytes, bytes], None]:
        """Return what puts a payload with its attachment on a key."""
        ...

    def hear(self, expression: str, depth: int) -> RosInbox:
        """Receive what is put on a key expression; of each key ``depth`` are kept."""
        ...

    def show(self, token: str) -> None:
        """Show a liveliness token until the session ends."""
        ...

    def watch(self, expression: str) -> Mapping[str, None]:
        """Return the tokens of others, kept up to date."""
        ...
