"""TWO_HANDS: squeeze, move and let go of what takes both hands (two-arm thesis, eq. 4.2).

Nothing moves before the whole way was tried on both arms' kinematics. What goes wrong while something is
held ends the goal, never the hold: the hands stop where they are and go on squeezing, and the failure
names the arm.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Sequence
from typing import Final, TypeVar

from tandem.skills.bimanual.glide import Bounds, Glide, glide
from tandem.skills.bimanual.hold import TwoArms
from tandem.skills.bimanual.landing import Landing
from tandem.skills.bimanual.object_frame import HandsApartError, tilt
from tandem.skills.bimanual.ready import STRAIGHT, between, ready_tools, swing, ways_back
from tandem.skills.bimanual.squeeze import agree
from tandem.skills.bimanual.supervision import overridden, trouble
from tandem.skills.bimanual.way_trial import SLICE, OutOfReach, try_way
from tandem.skills.geometry.poses import compose, invert, to_pose
from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.actions.bimanual import (
    PAIR,
    TWO_HANDS,
    TwoHands,
    TwoHandsFeedback,
    TwoHandsGoal,
    TwoHandsResult,
)
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Quaternion
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import ActionType, Command, Outcome, Run, Slice, canceled, failed, succeeded
from tandem.skills.ports.world import ROBOT_POSE, WORLD

FORCE: Final = 70.0
"""Newtons of each hand unless a goal says otherwise.

A carton of 0.5 kg held 4 cm off its middle leaned by 1.9 degrees at 40 N after it was lifted, by 0.2 at 70 N.
"""
BEFORE: Final = 0.025
"""Metres between the thing's surface and the tool's origin from which on the hands close in."""
LEANS: Final = tuple(math.radians(degrees) for degrees in (0.0, 7.5, 15.0, 22.5))
"""Radians by which the hands may lean while they press, the best first.

Where a wrist is bent to its limit a hand does not get straight, but nearly so. They come with up to 45
degrees; half of that is well within the cone of friction, and within what counts as pointing at each other.
"""
MISSED: Final = 0.05
"""Metres further than to the surface after which a hand that feels nothing has missed the thing."""
HELD_FOR: Final = 0.3
"""Robot seconds for which both forces must agree."""
WITHIN: Final = 8.0
"""Robot seconds in which the squeeze must stand."""
EASE: Final = 0.4
"""Robot seconds in which the squeeze is taken back before the hands open."""
TRY_COST: Final = 2.5e-4
"""Robot seconds that lockstep charges for a pose that is tried on both arms."""
HEARD_WITHIN: Final = 2.0
"""Robot seconds in which pose, world, joints and both wrists must have been heard."""
BRAKING: Final = 0.25
"""Robot seconds in which a motion on its way comes to rest, on its path."""

T = TypeVar("T")
Steps = Generator[TwoHandsFeedback | Slice, Command, T]


class _StoppedError(Exception):
    """Ends a goal from within: cancelled, or failed for a reason."""

    def __init__(self, failure: Failure | None) -> None:
        super().__init__("" if failure is None else failure.message)
        self.failure = failure


class HoldWithTwo:
    """The skill of both hands at one thing.

    Args:
        bus: the world, the clients.
        clocks: robot time.
        site: says where each item's grasp points are.
        arms: leads both arms, and goes on when the goal has ended.
        bounds: of the motion of what is held.
    """

    def __init__(
        self, bus: Bus, clocks: Clocks, site: Site, arms: TwoArms, *, bounds: Bounds | None = None
    ) -> None:
        self._clocks, self._site, self._arms = clocks, site, arms
        self._bounds = bounds or Bounds()
        self._world, self._robot = Latest(bus, WORLD), Latest(bus, ROBOT_POSE)
        self._item_in_middle: Pose | None = None
        self._came: tuple[Quaternion, Quaternion] = (STRAIGHT, STRAIGHT)
        """By how much each hand was turned when it came, in its own axes: so it turns again when it goes."""
        self._progress = 0.0

    @property
    def action(self) -> ActionType[TwoHandsGoal, TwoHandsFeedback, TwoHandsResult]:
        """The contract."""
        return TWO_HANDS

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.01

    def check(self, goal: TwoHandsGoal) -> Failure | None:
        """Refuse an item that does not take both hands, a MOVE to nowhere, and an arm that a reflex has."""
        if self._arms.taken is not None:
            return overridden(FailureKind.BUSY, self._arms.taken)
        known = self._site.item(goal.item)
        if known is None:
            return self._failure(FailureKind.ITEM_UNKNOWN, f"site {self._site.name} has no item {goal.item}")
        if not known.needs_two:
            return self._failure(
                FailureKind.INVALID_GOAL, f"item {goal.item} has no grasp points for two hands"
            )
        if goal.do is TwoHands.MOVE and goal.to is None:
            return self._failure(FailureKind.INVALID_GOAL, "move: expected 'to'")
        if goal.do is not TwoHands.SQUEEZE and self._arms.span is None:
            return self._failure(FailureKind.NOT_READY, f"{goal.do}: nothing is between the hands")
        return None

    def run(self, goal: TwoHandsGoal, goal_id: str) -> Run[TwoHandsFeedback, TwoHandsResult]:
        """Do one of the three."""
        del goal_id
        self._progress = 0.0
        doing = {TwoHands.SQUEEZE: self._squeeze, TwoHands.MOVE: self._move, TwoHands.RELEASE: self._release}
        try:
            return (yield from doing[goal.do](goal))
        except _StoppedError as stopped:
            return canceled() if stopped.failure is None else failed(stopped.failure)

    def _squeeze(self, goal: TwoHandsGoal) -> Steps[Outcome[TwoHandsResult]]:
        item_in_base = yield from self._believed(goal.item)
        known = self._site.item(goal.item)
        assert known is not None  # check said so
        arms = self._arms
        arms.engage()
        try:
            start = arms.tools()
            ways = [ready_tools(item_in_base, known, start, BEFORE, lean) for lean in LEANS]
            ready = yield from self._first_within_reach(start, ways)
            yield from self._wait(0.1)
            self._embrace()
            assert arms.middle is not None
            self._came = swing(start, ready)
            self._item_in_middle = between(item_in_base, arms.middle)
            arms.wanted = goal.force or FORCE
            yield from self._until_felt(arms.wanted)
        except _StoppedError:
            yield from self._draw_back()
            raise
        return succeeded(self._result())

    def _embrace(self) -> None:
        try:
            self._arms.embrace()
        except HandsApartError as error:
            raise _StoppedError(self._failure(FailureKind.NO_IK, str(error))) from error

    def _until_felt(self, wanted: float) -> Steps[None]:
        """Wait until both hands press as they should, for a while."""
        began = robot_seconds(self._clocks)
        since: float | None = None
        while True:
            now, arms = robot_seconds(self._clocks), self._arms
            for side, felt, inwards in zip(PAIR, arms.grasp.felt, arms.grasp.inwards, strict=True):
                if not felt and inwards > BEFORE + MISSED:
                    raise self._stopped(
                        FailureKind.FORCE_MISSING,
                        f"the {side} hand went {inwards:.3f} m and felt nothing",
                        arm=side,
                        distance_m=round(inwards, 3),
                    )
            if arms.grasp.holds and agree(arms.forces, wanted):
                since = now if since is None else since
                if now - since >= HELD_FOR:
                    return
            else:
                since = None
            if now - began > WITHIN:
                weaker = PAIR[0] if arms.forces[0] < arms.forces[1] else PAIR[1]
                raise self._stopped(
                    FailureKind.FORCE_MISSING,
                    f"the hands press with {arms.forces[0]:.0f} and {arms.forces[1]:.0f} N, "
                    f"{wanted:.0f} N were expected of each",
                    arm=weaker,
                )
            self._watch(holding=False)
            yield from self._tick()

    def _move(self, goal: TwoHandsGoal) -> Steps[Outcome[TwoHandsResult]]:
        arms = self._arms
        assert goal.to is not None  # check said so
        assert self._item_in_middle is not None
        if arms.span is None or arms.middle is None or not arms.grasp.holds:
            return failed(self._failure(FailureKind.GRASP_LOST, "nothing is held between the hands"))
        item = compose(invert(to_pose((yield from self._base()))), goal.to)
        way = glide(arms.middle, compose(item, invert(self._item_in_middle)), self._bounds)
        span, inwards = arms.span, arms.grasp.inwards
        needed = yield from self._tried(
            lambda share: span.tools(way.at(share * way.duration), inwards), way.duration
        )
        way = Glide(way.start, way.end, needed)
        before, landing = span.middle_in_base, Landing(arms.load)
        elapsed, rate, lowers = 0.0, 1.0, way.end.position[2] < way.start.position[2]
        command, at = Command.GO_ON, robot_seconds(self._clocks)
        while elapsed < way.duration:
            now = robot_seconds(self._clocks)
            going = command is not Command.CANCEL and command is not Command.PAUSE
            rate = max(0.0, min(1.0, rate + (now - at) / BRAKING * (1.0 if going else -1.0)))
            elapsed, at = elapsed + rate * (now - at), now
            if rate == 0.0 and command is Command.CANCEL:
                raise _StoppedError(None)
            arms.middle = way.at(elapsed)
            self._progress = min(1.0, elapsed / way.duration)
            self._watch(holding=True, level=before)
            if goal.touch_support and lowers and landing.stands(arms.load, now):
                break
            newer = yield self._feedback()
            command = command if newer is Command.GO_ON or command is Command.CANCEL else newer
        yield from self._wait(0.2)
        self._progress = 1.0
        return succeeded(self._result())

    def _tried(self, way: Callable[[float], tuple[Pose, Pose]], duration: float) -> Steps[float]:
        """Try a whole way before anything moves; return the time that the joints need for it."""
        trial = try_way(self._arms.arms, way, duration)
        while True:
            try:
                next(trial)
            except StopIteration as stop:
                found: float | OutOfReach = stop.value
                break
            if (yield Slice(SLICE * TRY_COST)) is Command.CANCEL:
                raise _StoppedError(None)
        if isinstance(found, OutOfReach):
            raise self._stopped(
                FailureKind.NO_IK,
                f"the {found.side} hand is {found.metres:.3f} m off after {found.share:.0%} of the way",
                arm=found.side,
                distance_m=round(found.metres, 4),
                share=round(found.share, 2),
            )
        return found

    def _together(self, start: tuple[Pose, Pose], end: tuple[Pose, Pose]) -> Steps[None]:
        """Bring both hands straight to poses, at the same time."""
        ways = [glide(a, b, self._bounds) for a, b in zip(start, end, strict=True)]

        def at(share: float) -> tuple[Pose, Pose]:
            left, right = (way.at(share * way.duration) for way in ways)
            return left, right

        duration = yield from self._tried(at, max(way.duration for way in ways))
        began = robot_seconds(self._clocks)
        while (elapsed := robot_seconds(self._clocks) - began) < duration:
            self._arms.aims = at(elapsed / duration)
            self._watch(holding=False)
            yield from self._tick()
        self._arms.aims = at(1.0)

    def _release(self, goal: TwoHandsGoal) -> Steps[Outcome[TwoHandsResult]]:
        arms = self._arms
        if arms.span is None or arms.middle is None:
            return failed(self._failure(FailureKind.GRASP_LOST, "nothing is between the hands"))
        wanted, began = arms.wanted, robot_seconds(self._clocks)
        while (elapsed := robot_seconds(self._clocks) - began) < EASE:
            arms.wanted = max(1e-3, wanted * (1.0 - elapsed / EASE))
            yield self._feedback()  # not to be stopped half-way: a thing half held is worse than one let go
        arms.wanted = 0.0
        start = arms.span.tools(arms.middle, arms.grasp.inwards)
        ends = ways_back(arms.span, arms.middle, arms.grasp.inwards, self._came, goal.apart)
        arms.aims, arms.span, arms.middle, self._item_in_middle = start, None, None, None
        try:
            yield from self._first_within_reach(start, ends)
        finally:
            arms.disengage()
        self._progress = 1.0
        return succeeded(TwoHandsResult(left_force=0.0, right_force=0.0))

    def _first_within_reach(
        self, start: tuple[Pose, Pose], ends: Sequence[tuple[Pose, Pose]]
    ) -> Steps[tuple[Pose, Pose]]:
        """Bring both hands to the first of the ends that both get at, and return it."""
        for k, end in enumerate(ends, start=1):
            try:
                yield from self._together(start, end)
            except _StoppedError as stopped:
                failure = stopped.failure
                if failure is None or failure.kind is not FailureKind.NO_IK or k == len(ends):
                    raise
            else:
                return end
        raise AssertionError("expected at least one end")

    def _draw_back(self) -> Steps[None]:
        """Take the hands off what they did not get hold of, and let go of the arms."""
        arms = self._arms
        if arms.span is not None and arms.middle is not None and not arms.stopped:
            arms.wanted = 0.0
            start = arms.span.tools(arms.middle, arms.grasp.inwards)
            end = arms.span.tools(arms.middle, (0.0, 0.0))
            arms.span, arms.middle = None, None
            ways = [glide(a, b, self._bounds) for a, b in zip(start, end, strict=True)]
            began = robot_seconds(self._clocks)
            while (elapsed := robot_seconds(self._clocks) - began) < max(way.duration for way in ways):
                arms.aims = (ways[0].at(elapsed), ways[1].at(elapsed))
                yield self._feedback()
        arms.disengage()

    def _watch(self, *, holding: bool, level: Pose | None = None) -> None:
        """End the goal when an arm does not follow, the thing is lost, or it leans."""
        found = trouble(self._arms, holding=holding, level=level)
        if found is not None:
            raise _StoppedError(found)

    def _believed(self, item: int) -> Steps[Pose]:
        """Return the item's centre in the base, once all that is needed has been heard."""
        known = self._site.item(item)
        assert known is not None  # check said so
        base = to_pose((yield from self._base()))
        world = self._world.refresh()
        fact = None if world is None else world.item(item)
        if fact is None:
            raise self._stopped(FailureKind.ITEM_GONE, f"item {item} is not believed to be anywhere")
        stands = standing_in_map(fact.tag_in_map, known)
        if stands is None:
            raise self._stopped(FailureKind.ITEM_UNREACHABLE, f"item {item} has fallen over")
        return compose(invert(base), stands)

    def _base(self) -> Steps[FloorPose]:
        until = robot_seconds(self._clocks) + HEARD_WITHIN
        while True:
            robot, world = self._robot.refresh(), self._world.refresh()
            if robot is not None and world is not None and self._arms.ready:
                if not robot.localised:
                    raise self._stopped(FailureKind.NOT_LOCALISED, "a pose in the map needs the robot's own")
                return robot.base_in_map
            if robot_seconds(self._clocks) > until:
                raise self._stopped(
                    FailureKind.NOT_READY, "expected robot pose, world, joints and both wrists"
                )
            yield from self._tick()

    def _wait(self, seconds: float) -> Steps[None]:
        until = robot_seconds(self._clocks) + seconds
        while robot_seconds(self._clocks) < until:
            yield from self._tick()

    def _tick(self) -> Steps[None]:
        """Let a period pass. A pause waits for what is under way, which is short; a cancel ends it."""
        if (yield self._feedback()) is Command.CANCEL:
            raise _StoppedError(None)

    def _result(self) -> TwoHandsResult:
        arms = self._arms
        left, right = arms.forces
        held, robot = arms.held_middle(), self._robot.value
        where = None
        if held is not None and robot is not None and self._item_in_middle is not None:
            where = compose(to_pose(robot.base_in_map), compose(held, self._item_in_middle))
        leaning = 0.0 if held is None or arms.span is None else tilt(arms.span.middle_in_base, held)
        return TwoHandsResult(left_force=left, right_force=right, item_in_map=where, tilt=leaning)

    def _feedback(self) -> TwoHandsFeedback:
        left, right = self._arms.forces
        return TwoHandsFeedback(left_force=left, right_force=right, progress=self._progress)

    def _stopped(self, kind: FailureKind, message: str, **evidence: str | float) -> _StoppedError:
        return _StoppedError(self._failure(kind, message, **evidence))

    def _failure(self, kind: FailureKind, message: str, **evidence: str | float) -> Failure:
        return Failure(kind=kind, message=message, where=TWO_HANDS.name, evidence=evidence)
