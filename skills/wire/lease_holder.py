"""One process's lease: asked for at the start, and again after each restart of the hardware.

The process's nodes stand still until the lease is settled, so that nothing is commanded, and no request
taken in, by a process that may have been replaced.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from typing import Final

from pydantic import ValidationError

from tandem.skills.ports.bus import Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.keys import LEASE, LEASES, Latest
from tandem.skills.ports.lease import Claim, LeaseAnswer, LeaseRequest, Leases
from tandem.skills.ports.node import Node
from tandem.skills.wire.presence import Presence, RivalError
from tandem.skills.wire.zenoh_bus import ZenohBus

ASK_WITHIN: Final = 0.5
"""Host seconds after which an unanswered question is asked again. The hardware answers once a period (10
ms)."""
ASK_AGAIN: Final = 0.2
"""Host seconds until it is asked again where nobody serves leases."""
AWAY: Final = 3.0
"""Host seconds between two turns of the loop from which on another may have taken over. zenoh needs ten to
drop a process that hangs; well below that, so that nobody goes on who has been replaced."""
BACK_WITHIN: Final = 5.0
"""Host seconds for which a process waits for hardware that is silent, or for a router that it has lost,
before it goes on without a lease; it still asks for one."""

GONE_WITHIN: Final = 10.0
"""Host seconds in which the hardware must notice that a holder is gone which the router no longer knows. Well
above the second for which ``lease.KEPT_UNSEEN`` spares a holder that has just been granted its lease."""

_LOG = logging.getLogger(__name__)


class LeaseHolder:
    """Keeps ``bus.held``. Call ``step`` each turn; the process's nodes wait while it is not ``settled``.

    Args:
        bus: of this process.
        clocks: the hardware's boot; host time.
        presence: the process's claim.
    """

    def __init__(self, bus: ZenohBus, clocks: Clocks, presence: Presence) -> None:
        self._bus, self._clocks, self._presence = bus, clocks, presence
        self._table = Latest(bus, LEASES)
        self._pending: Pending | None = None
        self._asked_at = float("-inf")
        self._turned_at = self._unsettled_since = clocks.monotonic()
        self._away = False
        self._refused_since: float | None = None
        self._told: Leases | None = None
        self.settled = False
        """Whether the process may go on: it holds the lease, or nobody grants any."""

    def acquire(self, stopped: Callable[[], bool]) -> None:
        """Block until the lease is settled: some 10 ms, and with hardware that is silent ``BACK_WITHIN``.

        Raises:
            RivalError: when another process has it.
        """
        while not self.settled and not stopped():
            self.step()
            if not self.settled:
                self._bus.waker.wait(0.005)

    def step(self) -> None:
        """Hear who holds the lease, and ask for it when it must be.

        Raises:
            RivalError: when another process has it.
        """
        now = self._clocks.monotonic()
        if now - self._turned_at > AWAY:
            _LOG.warning(
                "this process was away for %.1f s; does it still play its role?", now - self._turned_at
            )
            self.settled, self._away, self._pending = False, True, None
            self._asked_at, self._unsettled_since = float("-inf"), now
        self._turned_at = now
        for table in self._table.take():
            self._hear(table)
        self._read_answer(now)
        if self._pending is None and now - self._asked_at >= ASK_AGAIN and self._must_ask():
            self._ask(now)

    def close(self) -> None:
        """End the subscription."""
        self._table.close()

    def _must_ask(self) -> bool:
        held, robot = self._bus.held, self._clocks.robot()
        if held is None or not self.settled:
            return True
        if self._told is not None and self._told.boot != held.boot:
            return True
        return robot is not None and robot.boot != held.boot

    def _ask(self, now: float) -> None:
        asked = LeaseRequest(role=self._presence.role, claim=self._presence.claim.text)
        self._asked_at, self._pending = now, LEASE.query(self._bus, asked, timeout=ASK_WITHIN)

    def _read_answer(self, now: float) -> None:
        if self._pending is None:
            return
        answer = self._pending.poll()
        if answer is not None:
            self._pending = None
            self._take(answer)
        elif self._pending.done():
            self._pending = None
            silent = now - self._unsettled_since >= BACK_WITHIN
            unserved = not self._away and now - self._asked_at < ASK_WITHIN / 2
            if not self.settled and (silent or unserved):
                self._go_on_without()

    def _take(self, payload: bytes) -> None:
        try:
            answer: LeaseAnswer = LEASE.decode_answer(payload)
        except ValidationError:
            _LOG.warning("the answer on %s is no lease: %r", LEASE.key, payload[:200])
            return
        if answer.lease is None:
            self._bear(answer)
            return
        if answer.lease != self._bus.held:
            _LOG.info(
                "lease of %s: epoch %d of boot %s", answer.lease.role, answer.lease.epoch, answer.lease.boot
            )
        self._bus.held = answer.lease
        self.settled, self._away, self._refused_since = True, False, None

    def _bear(self, refused: LeaseAnswer) -> None:
        """Ask again when the holder has gone and the hardware has not noticed yet; else give up."""
        now, holder = self._clocks.monotonic(), Claim.read(refused.holder)
        since = now if self._refused_since is None else self._refused_since
        if now - since >= GONE_WITHIN or holder is None or self._presence.shows(holder):
            raise RivalError(self._presence.role, holder, f" ({refused.reason})")
        self._refused_since, self.settled = since, False

    def _go_on_without(self) -> None:
        """Nobody serves leases: no hardware is there yet, or one that grants none."""
        rival = self._presence.rival()
        if rival is not None and rival.beats(self._presence.claim):
            raise RivalError(self._presence.role, rival)
        self.settled, self._away = True, False

    def _hear(self, table: Leases) -> None:
        self._told, held = table, self._bus.held
        mine = table.of(self._presence.role)
        if mine is None or held is None or held.boot != table.boot or mine.epoch <= held.epoch:
            return
        raise RivalError(
            self._presence.role, Claim.read(mine.claim), f" (epoch {mine.epoch}, after {held.epoch})"
        )


class Leasing:
    """The nodes of a process, which go on only while its lease is settled; a ``Node``."""

    def __init__(self, holder: LeaseHolder, nodes: Sequence[Node]) -> None:
        self._holder, self._nodes = holder, tuple(nodes)

    name = "leasing"

    def step(self) -> bool:
        """See to the lease, then step the nodes."""
        self._holder.step()
        if not self._holder.settled:
            return False
        more = False
        for node in self._nodes:
            more = node.step() or more
        return more

    def close(self) -> None:
        """Close the nodes, the last one first."""
        for node in reversed(self._nodes):
            node.close()
        self._holder.close()
