"""The beats that a process hears: of all processes, or of those alone that play the names it asks after.

A beat comes by itself, so that each wakes the thread that receives: with nine processes 90 times a second, in
everybody who has once run somebody's goal and wants to know whether that one goes on. So a process hears
those that it asks after, for as long as it does.
"""

from __future__ import annotations

from typing import Final

import zenoh

from tandem.skills.wire.pulse import Pulse
from tandem.skills.wire.strays import Strays, hear

BEAT: Final = "beat"
"""``beat/<process>``; the payload is a line for each name of the process. ``beat`` alone has those of all
processes, as it always had, for programs of others: it is told only while somebody listens there."""
SELDOM: Final = "seldom"
"""``beat/<process>/seldom``: the same, every ``SELDOM_EVERY``-th time."""
SELDOM_EVERY: Final = 10
"""Beats from one that is told there, too, to the next: a second, for who waits ten until it acts."""
UNASKED: Final = 20
"""Beats of one's own (two seconds) after which what nobody has asked for is no longer heard: longer than from
most goals of a task to the next one at the same skill."""


def key_of(process: str) -> str:
    """Return the key of a process's beats; its name may have several parts."""
    return f"{BEAT}/{process.replace('/', '_')}"


class Beats:
    """Call it from the loop's thread.

    Args:
        session: it ends with its owner.
        prefix: put before every key.
        pulse: notes what is heard.
        strays: counts what is no message.
        seldom: hear all processes, but once a second only.
    """

    def __init__(
        self, session: zenoh.Session, prefix: str, pulse: Pulse, strays: Strays, *, seldom: bool = False
    ) -> None:
        self._session, self._prefix, self._pulse, self._strays = session, prefix, pulse, strays
        self._every = f"{prefix}/{BEAT}/*" + (f"/{SELDOM}" if seldom else "")
        self._heard: dict[str, zenoh.Subscriber[None]] = {}
        self._stays = seldom
        """Whether all are heard for good."""
        self._found: dict[str, str] = {}
        """The key of the process that last beat under a name."""
        self._sought: frozenset[str] = frozenset()
        self._left: dict[str, int] = {}
        """For how many beats of one's own an expression is still heard, unless it is asked for."""

    def hear_all(self) -> None:
        """Hear all processes from now on."""
        self._stays = True
        self._hear(self._every)

    def hear(self, name: str) -> None:
        """Hear the process that plays a name; until it has beaten, all, as one of them is it."""
        if self._stays:
            self._hear(self._every)
            return
        key = self._found.get(name)
        if key is None:
            self._sought |= {name}
            self._ask(self._every)
            return
        if key not in self._heard and self._every not in self._heard:
            # They were not heard until now: none of them is silent for that.
            self._pulse.hear(each for each, where in tuple(self._found.items()) if where == key)
        self._ask(key)  # before all others are no longer heard: nothing is missed
        if self._every in self._heard and not self._sought - self._found.keys():
            for each in self._sought:
                self._ask(self._found.get(each, key))
            self._end(self._every)

    def rest(self) -> None:
        """Hear no longer what nobody asks for; called with each beat of one's own."""
        for expression, left in tuple(self._left.items()):
            self._left[expression] = left - 1
            if left <= 1:
                self._end(expression)

    def forget(self, name: str) -> None:
        """Forget a name that is no longer announced: another process may take it. From any thread."""
        self._found.pop(name, None)
        self._sought -= {name}

    def _ask(self, expression: str) -> None:
        self._hear(expression, afresh=expression == self._every)
        self._left[expression] = UNASKED

    def _end(self, expression: str) -> None:
        if expression == self._every:
            self._sought = frozenset()
        self._left.pop(expression, None)
        self._heard.pop(expression).undeclare()  # type: ignore[no-untyped-call]

    def _hear(self, expression: str, *, afresh: bool = True) -> None:
        """Subscribe, unless it is; ``afresh``: who was not heard until now is not silent."""
        if expression not in self._heard:
            if afresh:
                self._pulse.listen()
            relative = expression[len(self._prefix) + 1 :]
            self._heard[expression] = hear(self._session, expression, self._strays, relative, self._take)

    def _take(self, key: str, sample: zenoh.Sample) -> None:
        # Wakes nobody: who asks for it looks every turn.
        names = sample.payload.to_bytes().decode("utf-8", "replace").split("\n")
        self._pulse.hear(names)
        if not self._stays:
            for name in names:
                self._found[name] = key
