"""Presence: a process that wants to play a role announces its claim first and then looks who else claims it.

Whoever looks first and announces then sees nobody and is seen by nobody, as long as another does the same at
the same moment. The other way round, of two who start together at least one sees the other: the router takes
in both claims before it answers the second look.

1. Claim ``claim/<role>/<claim>/new``. 2. Look. A player that has settled wins; of two newcomers the lower
claim wins, and the other withdraws. A winner waits until the loser has withdrawn, or finds that it has
settled after all. 3. With nobody left, claim ``.../in``, look once more, and announce
``role/<role>/<claim>`` for everybody.

Claims stand beside ``alive/**``: zenoh answers a look at keys that a session subscribes to out of that
session's memory, which is empty at first (1.10; 93 of 100 new sessions saw nobody). A look at other keys
asks the router.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Literal

from tandem.skills.ports.lease import Claim, claim_name, present_claims
from tandem.skills.wire.zenoh_bus import ZenohBus

CLAIMS: Final = "claim"
LOOK_WITHIN: Final = 2.0
"""Host seconds in which the router must answer a look; it takes 1 ms, on a busy machine 100."""
LOOK_AGAIN: Final = 0.02
"""Host seconds between two looks while a newcomer that must withdraw is still there."""
GIVES_WAY_WITHIN: Final = 10.0
"""Host seconds in which a newcomer that must withdraw has done so. zenoh drops a process that hangs after
ten."""

Stage = Literal["new", "in"]


class RivalError(RuntimeError):
    """Another process plays the role; the message names it."""

    def __init__(self, role: str, rival: Claim | None, why: str = "") -> None:
        """``rival``: the other's claim, where it is known."""
        self.role, self.rival = role, rival
        other = "another process" if rival is None else rival.describe()
        super().__init__(f"{role}: {other} plays this role already{why}")


@dataclass(frozen=True)
class _Seen:
    """One claim that a look found."""

    claim: Claim
    stage: Stage


class Presence:
    """One process's claim to a role.

    Args:
        bus: of this process.
        role: what it wants to play.
        claim: what it claims it with.
    """

    def __init__(self, bus: ZenohBus, role: str, claim: Claim) -> None:
        self._bus, self.role, self.claim = bus, role, claim

    def settle(self, stopped: Callable[[], bool]) -> None:
        """Become the one player of the role. Returns as well when told to stop.

        Raises:
            RivalError: another one plays it, or is about to and goes first; nothing is claimed any more then.
        """
        new, settled = self._key("new"), self._key("in")
        self._bus.claim(new)
        try:
            self._await_free(stopped)
            self._bus.claim(settled)
            self._give_way([seen for seen in self._look() if seen.stage == "in"])
        except RivalError:
            self._bus.withdraw(new)
            self._bus.withdraw(settled)
            raise
        self._bus.announce(claim_name(self.role, self.claim))

    def shows(self, claim: Claim | None) -> bool:
        """Ask the router whether another's claim is there; blocks for at most ``LOOK_WITHIN``."""
        return claim is not None and any(seen.claim == claim for seen in self._look())

    def rival(self) -> Claim | None:
        """Return another player that is announced, of another parent, or a later one of the same."""
        for text in sorted(present_claims(self._bus.alive(), self.role)):
            claim = Claim.read(text)
            if claim is not None and claim != self.claim and not self._replaces(claim):
                return claim
        return None

    def watch(self, stopped: Callable[[], bool]) -> Callable[[], bool]:
        """Return a ``stopped`` that also sees to it that one of two settled players leaves, by their claims.

        For roles without a lease: two of them can be settled when a network was cut and is whole again.
        The returned callable raises RivalError in the one that must leave.
        """

        def look() -> bool:
            rival = self.rival()
            if rival is not None and rival.beats(self.claim):
                raise RivalError(self.role, rival)
            return stopped()

        return look

    def _await_free(self, stopped: Callable[[], bool]) -> None:
        deadline = time.monotonic() + GIVES_WAY_WITHIN
        while not stopped() and time.monotonic() < deadline:
            seen = self._look()
            self._give_way(seen)
            if not seen:
                return
            self._bus.waker.wait(LOOK_AGAIN)

    def _give_way(self, seen: list[_Seen]) -> None:
        for other in seen:
            if other.stage == "in" or other.claim.beats(self.claim):
                raise RivalError(self.role, other.claim)

    def _look(self) -> list[_Seen]:
        found = []
        for key in sorted(self._bus.claims(f"{CLAIMS}/{self.role}/**", timeout=LOOK_WITHIN)):
            text, _, stage = key.removeprefix(f"{CLAIMS}/{self.role}/").partition("/")
            claim = Claim.read(text)
            if claim is not None and claim != self.claim and not self._replaces(claim):
                found.append(_Seen(claim, "in" if stage == "in" else "new"))
        return found

    def _replaces(self, other: Claim) -> bool:
        """Say whether the other is an earlier one of the same parent, whose end the parent has seen."""
        return other.lineage == self.claim.lineage and self.claim.beats(other)

    def _key(self, stage: Stage) -> str:
        return f"{CLAIMS}/{self.role}/{self.claim.text}/{stage}"
