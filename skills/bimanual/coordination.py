"""The coordination routine: two-arm thesis, Algorithm 3, as a state machine without clocks, bus or robot.

What the pseudo-code slips on is mended, its meaning is kept: the records count as they were at an
episode's first stop; the follower goes back to sample ``recorded - 1 - counter``, a sample further at each
new risk and never below 0; who leads is decided at the first stop, and it leads until it is back in its
safe place.

An episode opens with a risk while both arms are under way. Both stop. The arm nearer to its goal leads;
one that follows no field (it grasps, or goes home) has no record to go back on and leads before one that
does; of two such, the one nearer to its safe place leads, and the other stands. Once the follower has gone
back and stands, the leader goes on: if there is still a risk, only after the follower went further back,
as long as there is a further back. From there on the leader goes on nevertheless, as long as it makes
nothing worse: its way out is the only one. What is worse even then ends in STOP for both.

``eager`` looks ahead. Ways that come near each other make one of the two give way before there is a risk:
the leader goes on, the follower too, as far as it does not come into the leader's way; there it stands, and
goes on when the next part of its own way has been clear for a while. After a risk the leader goes on as
soon as its way is clear of the follower that goes back, and the follower as before; each time that this was
wrong, the while doubles. A follower for which the leader stands, as it is in its way, is sent back as at a
risk; one that is before its item sooner than the leader leads from then on.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Final, Literal

from tandem.skills.ports.actions.bimanual import PAIR, ArmOrder, Order
from tandem.skills.ports.message import HandName

WORSE: Final = 0.01
"""Metres by which the clearance must have shrunk to be worse."""
CORNERED_AFTER: Final = 2.0
"""Robot seconds without a sample further back after which a follower that is sent back is cornered."""
CLEAR_FOR: Final = 0.1
"""Robot seconds for which the follower's way must have been clear before it goes on (eager)."""
ROOM: Final = 0.05
"""Metres that the follower keeps from the leader's way where it stops (eager): more than at a risk."""
FIELD_ROOM: Final = 0.12
"""The same while the leader's field runs, which turns aside for an arm that is near, and is slow there."""
IN_THE_WAY: Final = 0.035
"""Metres from its way within which a follower that stands bars the leader."""
BARRED_AFTER: Final = 0.5
"""Robot seconds for which the leader must have stood before the follower is sent back for that."""

Mode = Literal["faithful", "eager"]


@dataclass(frozen=True)
class ArmNow:
    """What an arm does.

    Attributes:
        approaching: whether its field runs; only then do ``distance``, ``recorded`` and ``at`` mean
        something. distance: metres from its goal. recorded: samples of its record. at: the sample at which
        it stands. moving: whether a joint moves. safe: whether it is in its safe place. away: radians from
        its safe place.
    """

    approaching: bool = False
    distance: float = 0.0
    recorded: int = 0
    at: int = 0
    moving: bool = False
    safe: bool = False
    away: float = 0.0

    @property
    def under_way(self) -> bool:
        """Whether it moves or is about to."""
        return self.approaching or self.moving

    @property
    def back_home(self) -> bool:
        """Whether it has done what it was at, and is in its safe place."""
        return self.safe and not self.approaching


@dataclass(frozen=True)
class Situation:
    """What is seen at one moment: robot seconds, the reflex's verdict, metres between the arms, both arms.

    What follows is asked for in eager mode. ``ways_cross``: whether the ways that both have told come near
    each other. ``way_is_clear``: whether the one that waits could go on beside the other: the leader all its
    way while the follower goes back, the follower the next part of its way while the leader leads. ``room``:
    metres between the leader's way and the place where the follower would come to rest.
    """

    now: float
    risk: bool
    clearance: float
    left: ArmNow
    right: ArmNow
    way_is_clear: bool = False
    ways_cross: bool = False
    room: float = math.inf

    def of(self, side: HandName) -> ArmNow:
        """Return the arm of a side."""
        return self.left if side == "left" else self.right


class Stage(StrEnum):
    """Where an episode stands."""

    CLEAR = "CLEAR"
    """No episode is open."""
    BACKING = "BACKING"
    """The leader stands, the follower goes back."""
    LEADING = "LEADING"
    """The leader goes on, the follower stands."""
    SHARING = "SHARING"
    """The leader goes on, and the follower as far as it does not come into its way (eager)."""
    GIVEN_UP = "GIVEN_UP"
    """Both are told to give up."""


@dataclass(frozen=True)
class Coordination:
    """The state. ``leader``, ``counter`` and ``recorded`` are those of the open or the last episode."""

    mode: Mode = "eager"
    episode: int = 0
    stage: Stage = Stage.CLEAR
    leader: HandName = "left"
    recorded: int = 0
    counter: int = 0
    stride: int = 1
    """Samples by which the follower goes further back at each new risk (phi)."""
    armed: bool = True
    """Whether a risk opens an episode: not again before it has passed once."""
    risky: bool = False
    """Whether there was a risk already when the leader went on."""
    clearance: float = 0.0
    """Metres between the arms when the leader went on."""
    clear_since: float | None = None
    patience: float = CLEAR_FOR
    at: int = 0
    """The farthest sample back at which the follower has been since it was sent there."""
    since: float = 0.0
    """Robot seconds: since when."""
    cornered: bool = False
    """Whether the follower could not get back."""
    stopped: bool = False
    """Whether both were stopped in this episode; ways that cross make one give way without that."""
    waits: bool = False
    """Whether the follower stands, as it would come into the leader's way (eager)."""
    stood_since: float | None = None
    """Robot seconds: since when the leader has stood with the follower in its way."""

    @property
    def follower(self) -> HandName:
        """The other one."""
        return "right" if self.leader == "left" else "left"

    @property
    def sample(self) -> int:
        """The sample of its record to which the follower goes back."""
        return max(0, self.recorded - 1 - self.stride * self.counter)

    @property
    def open(self) -> bool:
        """Whether an episode is open."""
        return self.stage is not Stage.CLEAR

    @property
    def orders(self) -> tuple[ArmOrder, ...]:
        """What each arm may do, left first."""
        leading, following = _ORDERS[self.stage]
        following = Order.HOLD if self.stage is Stage.SHARING and self.waits else following
        return tuple(
            ArmOrder(side=side, order=leading)
            if side == self.leader
            else ArmOrder(side=side, order=following, sample=self.sample if following is Order.BACK else 0)
            for side in PAIR
        )

    def after(self, seen: Situation) -> Coordination:
        """Return the state after what is seen."""
        if self.stage is Stage.CLEAR:
            return self._clear(seen)
        if self.stage is Stage.BACKING:
            return self._backing(seen)
        if self.stage is Stage.GIVEN_UP:
            return self if seen.left.under_way or seen.right.under_way else self._closed(seen)
        return self._going(seen)

    def _clear(self, seen: Situation) -> Coordination:
        if not seen.risk:
            if self.mode == "eager" and seen.ways_cross:
                beside = replace(self, leader=_leader(seen), armed=True, patience=CLEAR_FOR, stopped=False)
                return _sharing(replace(beside, risky=False))
            return self if self.armed else replace(self, armed=True)
        if not self.armed or not (seen.left.under_way and seen.right.under_way):
            return self
        return self._stop(replace(self, leader=_leader(seen), patience=CLEAR_FOR), seen)

    @staticmethod
    def _stop(state: Coordination, seen: Situation) -> Coordination:
        """Stop both for the first time; the records count as they are now."""
        follower = seen.of(state.follower)
        opened = replace(state, episode=state.episode + 1, counter=0, clear_since=None, stopped=True)
        return _sent_back(replace(opened, recorded=follower.recorded if follower.approaching else 0), seen)

    def _backing(self, seen: Situation) -> Coordination:
        follower = seen.of(self.follower)
        further = follower.at < self.at
        state = replace(self, at=follower.at, since=seen.now) if further else self
        if seen.of(self.leader).moving:
            return state
        under_way = follower.moving or (follower.approaching and follower.at > self.sample)
        cornered = under_way and follower.approaching and seen.now - state.since > CORNERED_AFTER
        past_it = self.mode == "eager" and seen.way_is_clear and not seen.risk
        if under_way and not cornered and not past_it:
            return state
        if seen.risk and follower.approaching and self.sample > 0 and not cornered:
            return _sent_back(replace(self, counter=self.counter + 1), seen)
        leading = replace(self, stage=Stage.LEADING, risky=seen.risk, cornered=cornered)
        return replace(leading, clearance=seen.clearance, clear_since=None, stood_since=None)

    def _going(self, seen: Situation) -> Coordination:
        if seen.of(self.leader).back_home:
            return self._closed(seen)
        worse = not self.risky or seen.clearance < self.clearance - WORSE
        if seen.risk and worse:
            return self._again(seen)
        if not seen.risk and self.risky:
            return replace(self, risky=False)
        if self.mode == "faithful":
            return self
        return self._share(seen) if self.stage is Stage.SHARING else self._let_go(seen)

    def _share(self, seen: Situation) -> Coordination:
        """Let the follower go as far as it may; one that bars the leader's way goes back.

        One that is before its item sooner, and grasps or goes home, leads from then on: the other one's hand
        may have to wait until it has picked.
        """
        follower = seen.of(self.follower)
        if seen.of(self.leader).approaching and not follower.approaching and not follower.back_home:
            return _sharing(replace(self, leader=self.follower, stopped=False, risky=False))
        if not self.waits:
            room = FIELD_ROOM if seen.of(self.leader).approaching else ROOM
            return self if seen.room >= room else replace(self, waits=True, clear_since=None)
        stands = not seen.of(self.leader).moving and follower.approaching
        if not stands or seen.room >= IN_THE_WAY:
            return self._let_go(seen)
        since = seen.now if self.stood_since is None else self.stood_since
        return self._again(seen) if seen.now - since >= BARRED_AFTER else replace(self, stood_since=since)

    def _again(self, seen: Situation) -> Coordination:
        """A new risk: the follower goes further back, if it can."""
        if not self.stopped:
            return self._stop(self, seen)
        no_further = self.sample == 0 or self.cornered or not seen.of(self.follower).approaching
        if self.risky and no_further:
            return replace(self, stage=Stage.GIVEN_UP)
        patience = 2.0 * self.patience if self.stage is Stage.SHARING else self.patience
        return _sent_back(replace(self, counter=self.counter + 1, patience=patience), seen)

    def _let_go(self, seen: Situation) -> Coordination:
        if not seen.way_is_clear:
            return replace(self, clear_since=None, stood_since=None)
        if self.clear_since is None:
            return replace(self, clear_since=seen.now, stood_since=None)
        return _sharing(self) if seen.now - self.clear_since >= self.patience else self

    def _closed(self, seen: Situation) -> Coordination:
        return replace(self, stage=Stage.CLEAR, armed=not seen.risk, clear_since=None, stopped=False)


_ORDERS: Final = {
    Stage.CLEAR: (Order.GO, Order.GO),
    Stage.BACKING: (Order.HOLD, Order.BACK),
    Stage.LEADING: (Order.GO, Order.BACK),
    Stage.SHARING: (Order.GO, Order.GO),
    Stage.GIVEN_UP: (Order.STOP, Order.STOP),
}
"""The leader's order and the follower's."""


def _sharing(state: Coordination) -> Coordination:
    return replace(state, stage=Stage.SHARING, waits=False, clear_since=None, stood_since=None)


def _sent_back(state: Coordination, seen: Situation) -> Coordination:
    at = seen.of(state.follower).at
    return replace(state, stage=Stage.BACKING, at=at, since=seen.now, cornered=False)


def _leader(seen: Situation) -> HandName:
    left, right = seen.left, seen.right
    if left.approaching != right.approaching:
        return "right" if left.approaching else "left"
    if left.approaching:
        return "right" if left.distance > right.distance else "left"
    return "right" if left.away > right.away else "left"
