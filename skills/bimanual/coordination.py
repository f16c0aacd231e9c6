"""The coordination routine: document 002, Algorithm 3, as a state machine without clocks, bus or robot.

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

``eager`` lets the leader go on as soon as its way to its goal is clear of the follower that goes back, and
the follower go on beside the leader as soon as its way has been clear for a while; each time that this
was wrong, the while doubles.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Final, Literal

from skills.ports.actions.bimanual import ArmOrder, Order
from skills.ports.world import SIDES, Side

WORSE: Final = 0.01
"""Metres by which the clearance must have shrunk to be worse."""
CORNERED_AFTER: Final = 2.0
"""Robot seconds without a sample further back after which a follower that is sent back is cornered."""
CLEAR_FOR: Final = 0.2
"""Robot seconds for which the follower's way must have been clear before it goes on (eager)."""

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

    ``way_is_clear``: whether the one that waits could go all its way beside the other: the leader while the
    follower goes back, the follower while the leader leads; asked for in eager mode.
    """

    now: float
    risk: bool
    clearance: float
    left: ArmNow
    right: ArmNow
    way_is_clear: bool = False

    def of(self, side: Side) -> ArmNow:
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
    """Both go on (eager)."""
    GIVEN_UP = "GIVEN_UP"
    """Both are told to give up."""


@dataclass(frozen=True)
class Coordination:
    """The state. ``leader``, ``counter`` and ``recorded`` are those of the open or the last episode."""

    mode: Mode = "eager"
    episode: int = 0
    stage: Stage = Stage.CLEAR
    leader: Side = "left"
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

    @property
    def follower(self) -> Side:
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
        return tuple(
            ArmOrder(side=side, order=leading)
            if side == self.leader
            else ArmOrder(side=side, order=following, sample=self.sample if following is Order.BACK else 0)
            for side in SIDES
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
            return self if self.armed else replace(self, armed=True)
        if not self.armed or not (seen.left.under_way and seen.right.under_way):
            return self
        leader = _leader(seen)
        opened = replace(self, episode=self.episode + 1, leader=leader, counter=0, patience=CLEAR_FOR)
        recorded = seen.of(opened.follower).recorded if seen.of(opened.follower).approaching else 0
        return _sent_back(replace(opened, recorded=recorded, clear_since=None), seen)

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
        return replace(leading, clearance=seen.clearance, clear_since=None)

    def _going(self, seen: Situation) -> Coordination:
        if seen.of(self.leader).back_home:
            return self._closed(seen)
        worse = not self.risky or seen.clearance < self.clearance - WORSE
        if seen.risk and worse:
            return self._again(seen)
        if not seen.risk and self.risky:
            return replace(self, risky=False)
        return self._let_go(seen) if self.mode == "eager" and self.stage is Stage.LEADING else self

    def _again(self, seen: Situation) -> Coordination:
        """A new risk: the follower goes further back, if it can."""
        no_further = self.sample == 0 or self.cornered or not seen.of(self.follower).approaching
        if self.risky and no_further:
            return replace(self, stage=Stage.GIVEN_UP)
        patience = 2.0 * self.patience if self.stage is Stage.SHARING else self.patience
        return _sent_back(replace(self, counter=self.counter + 1, patience=patience), seen)

    def _let_go(self, seen: Situation) -> Coordination:
        if not seen.way_is_clear:
            return self if self.clear_since is None else replace(self, clear_since=None)
        if self.clear_since is None:
            return replace(self, clear_since=seen.now)
        return replace(self, stage=Stage.SHARING) if seen.now - self.clear_since >= self.patience else self

    def _closed(self, seen: Situation) -> Coordination:
        return replace(self, stage=Stage.CLEAR, armed=not seen.risk, clear_since=None)


_ORDERS: Final = {
    Stage.CLEAR: (Order.GO, Order.GO),
    Stage.BACKING: (Order.HOLD, Order.BACK),
    Stage.LEADING: (Order.GO, Order.BACK),
    Stage.SHARING: (Order.GO, Order.GO),
    Stage.GIVEN_UP: (Order.STOP, Order.STOP),
}
"""The leader's order and the follower's."""


def _sent_back(state: Coordination, seen: Situation) -> Coordination:
    at = seen.of(state.follower).at
    return replace(state, stage=Stage.BACKING, at=at, since=seen.now, cornered=False)


def _leader(seen: Situation) -> Side:
    left, right = seen.left, seen.right
    if left.approaching != right.approaching:
        return "right" if left.approaching else "left"
    if left.approaching:
        return "right" if left.distance > right.distance else "left"
    return "right" if left.away > right.away else "left"
