"""Leases on the bus: the hardware's grantor, and the ears of those who are commanded but grant nothing."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Final

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.endpoint import Endpoint, Problems, endpoint
from tandem.skills.ports.keys import LEASE, LEASES, Latest
from tandem.skills.ports.lease import (
    Fence,
    Lease,
    LeaseAnswer,
    LeaseBook,
    Leased,
    LeaseRefusal,
    LeaseRequest,
    Leases,
    present_claims,
)
from tandem.skills.ports.problems import in_words

TOLD_EVERY: Final = 1.0
"""Host seconds between two messages of the table when nothing changes: who starts later learns of it then."""


class Grantor:
    """Grants the leases of a robot. There is one, and it is the hardware's, which serves its endpoints.

    Args:
        bus: where players of roles ask.
        boot: the hardware's boot.
        monotonic: host seconds.
    """

    def __init__(self, bus: Bus, boot: str, monotonic: Callable[[], float] = time.monotonic) -> None:
        self._bus, self._monotonic = bus, monotonic
        self._book = LeaseBook(boot)
        self._told: Leases | None = None
        self._told_at = float("-inf")

    def endpoints(self) -> tuple[Endpoint, ...]:
        """Return what is to be served: requests for leases."""
        return (endpoint(LEASE, lambda call: self._ask(call.document), refuse=_refused),)

    def restart(self, boot: str) -> None:
        """Begin another boot: all leases are void, and are asked for anew."""
        told, self._book = self._told, LeaseBook(boot)
        if told is not None:
            self._tell()

    def refuse(self, command: Leased) -> LeaseRefusal | None:
        """Return why the command must not be obeyed, and count it; None when it may be."""
        return self._book.refuse(command)

    def step(self) -> None:
        """Tell the table when it is due."""
        if self._told is not None and self._monotonic() - self._told_at >= TOLD_EVERY:
            self._tell()

    def _ask(self, asked: LeaseRequest) -> LeaseAnswer:
        present = present_claims(self._bus.alive(), asked.role)
        answer = self._book.ask(asked, present, self._monotonic())
        table = self._book.table()
        if self._told is None or table.held != self._told.held:
            # Told before it is answered: who has been replaced is known for it before the new one can act.
            self._tell()
        return answer

    def _tell(self) -> None:
        self._told, self._told_at = self._book.table(), self._monotonic()
        LEASES.publish(self._bus, self._told)


def _refused(problems: Problems) -> LeaseAnswer:
    return LeaseAnswer(reason=in_words(problems))


class Listening:
    """The fence of one who is commanded by a role: an action server, for instance.

    Args:
        bus: where the table is told.
        role: whose commands are obeyed.
    """

    def __init__(self, bus: Bus, role: str) -> None:
        self._table = Latest(bus, LEASES)
        self._fence = Fence(role)

    @property
    def refused(self) -> int:
        """Commands that were refused for their lease."""
        return self._fence.refused

    def step(self) -> None:
        """Take in what was granted; call it before commands are read."""
        for table in self._table.take():
            self._fence.learn(table)

    def refuse(self, lease: Lease | None) -> LeaseRefusal | None:
        """Return why a command with this lease must not be obeyed; None when it may be."""
        return self._fence.refuse(lease)

    def is_over(self, lease: Lease | None) -> bool:
        """Say whether the owner of what runs under this lease has been replaced."""
        return self._fence.is_over(lease)

    def close(self) -> None:
        """End the subscription."""
        self._table.close()
