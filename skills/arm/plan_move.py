"""From a goal to a checked motion, or to what stands in the way."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from tandem.skills.arm.curve import through
from tandem.skills.arm.far_path import FarJob, FarProblem, elsewhere
from tandem.skills.arm.planning.motions import Motions, Space, halving
from tandem.skills.arm.planning.path import find_path
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.planning.straight import Broken, Hand, Line, follow, foresee, line_ends
from tandem.skills.arm.problem import Arm, Moment, Plan, words
from tandem.skills.arm.retreat import deepest, longest_first, ways_back
from tandem.skills.arm.scene import to_base
from tandem.skills.arm.timing import time_curve, time_path
from tandem.skills.arm.trajectory import Trajectory
from tandem.skills.arm.turned import offers, straight_to
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.ik import IkAnswer
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.pose import Pose

Steps = Generator[int, None, Plan | Failure]
"""Yields units of work (a collision check each, about), 0 while a worker is waited for."""

LOOKS = (6, 40)
"""Starts of inverse kinematics: first few at every candidate, then, if none will do, many."""
FINER = (1.0, 0.5, 0.25)
"""Shares of the step; the next is taken when the motion that was found turns out to graze something."""
ENOUGH = 1
"""Solutions of a candidate that are carried on to the planner."""
BLENDS = (1.0, 0.6, 0.3, 0.0)
"""How much of the corners is cut, most first; at 0 the motion stops in each waypoint, as it was planned."""
FINE_STEP = 0.012
"""Metres (weighed) between two states of the last check of a whole motion."""
CHECKS_AT_ONCE = 60
CURVE = 20
"""Units of timing one."""


class MovePlanner:
    """Plans the moves of one group.

    Args:
        arm: the group.
        settings: the planner and its bounds.
        where: the action's name, for failures.
        compute: where planning is done that can't be sliced; without one, in place.
    """

    def __init__(
        self, arm: Arm, settings: PlannerSettings, where: str, compute: Compute | None = None
    ) -> None:
        self._arm, self._settings, self._where, self._compute = arm, settings, where, compute

    def plan(self, goal: MoveGoal, moment: Moment, rng: np.random.Generator) -> Steps:
        """Plan the goal from where the group stands at that moment."""
        checker = self._arm.checker(moment, goal)
        yield CHECKS_AT_ONCE  # making the checker took about as long
        start = self._arm.start(moment)
        # Only a straight approach or a retreat may touch items; on the way to where it begins, nothing may.
        checker.touch(allowed=goal.straight or goal.retreats)
        stuck = checker.let_rest(start, deepest=deepest(goal))
        yield CHECKS_AT_ONCE
        if stuck:
            worst = stuck[0]
            return self._failure(
                FailureKind.NO_PATH,
                f"the group stands in collision: {words(worst)}",
                contact=words(worst),
                depth_m=worst.depth,
                at_start=True,
            )
        motions = self._motions(checker)
        if goal.retreats:
            return (yield from self._retreat(goal, motions, start))
        if goal.candidates and goal.straight:
            return (yield from self._straight(goal, moment, motions, start))
        if goal.candidates:
            return (yield from self._candidates(goal, moment, motions, start, rng))
        return (yield from self._joints(goal, moment, motions, start, rng))

    def reaches(
        self,
        goal: MoveGoal,
        moment: Moment,
        rng: np.random.Generator,  # noqa: ARG002 - nothing is drawn any more
    ) -> Generator[int, None, bool]:
        """Say whether one of the goal's candidates has joint positions, with all that follows it."""
        checker = self._arm.checker(moment, goal)
        yield CHECKS_AT_ONCE
        start, motions, hand = self._arm.start(moment), self._motions(checker), self._hand(checker)
        offered = yield from offers(hand, goal, moment, goal.candidates, start, LOOKS[0])
        for offer in chain.from_iterable(offered):
            ends = yield from self._ends(goal, moment, motions, offer.candidate, offer.answer)
            if not isinstance(ends, _Refusal):
                return True
        return False

    def reach(self, goal: MoveGoal, moment: Moment) -> Generator[int, None, Reached | Failure]:
        """Return the first candidate that has joint positions, with all that follows it.

        How the group gets there is not asked.
        """
        checker = self._arm.checker(moment, goal)
        yield CHECKS_AT_ONCE
        start, motions, hand = self._arm.start(moment), self._motions(checker), self._hand(checker)
        refused: list[_Refusal] = []
        for starts in LOOKS:
            refused = []
            for number, candidate in enumerate(goal.candidates):
                (turns,) = yield from offers(hand, goal, moment, (candidate,), start, starts)
                for offer in turns:
                    ends = yield from self._ends(goal, moment, motions, offer.candidate, offer.answer)
                    if not isinstance(ends, _Refusal):
                        return Reached(number, ends[0], offer.turn)
                    refused.append(ends)
        failures = [self._explain(each, checker) for each in refused]
        return failures[0].model_copy(update={"causes": tuple(failures)})

    def goes_on(self, goal: MoveGoal, moment: Moment, number: int, q: Array) -> Generator[int, None, bool]:
        """Say whether all that follows candidate ``number`` can be reached from the joints (n,) at it."""
        checker = self._arm.checker(moment, goal)
        yield CHECKS_AT_ONCE
        ends = yield from self._ends(
            goal, moment, self._motions(checker), goal.candidates[number], IkAnswer((q,), 0.0)
        )
        return not isinstance(ends, _Refusal)

    def recheck(
        self,
        trajectory: Trajectory,
        goal: MoveGoal,
        moment: Moment,
        *,
        after: float = 0.0,
        padded: bool = True,
    ) -> Generator[int, None, Failure | None]:
        """Check a motion, from ``after`` seconds on, against another moment's world."""
        checker = self._arm.checker(moment, goal, padded=padded)
        yield CHECKS_AT_ONCE
        checker.touch(allowed=goal.straight or goal.retreats)
        checker.let_rest(trajectory.positions[0], deepest=deepest(goal))
        if goal.touch_support or goal.retreats:
            checker.let_rest(trajectory.positions[-1], carried_only=True)
        yield CHECKS_AT_ONCE
        graze = yield from self._check(self._motions(checker), trajectory, after)
        return None if graze is None else self._grazed(graze, checker)

    def _motions(self, checker: CollisionChecker) -> Motions:
        return Motions(checker, Space(self._arm.limits, self._arm.weights))

    def _joints(
        self, goal: MoveGoal, moment: Moment, motions: Motions, start: Array, rng: np.random.Generator
    ) -> Steps:
        named = goal.joints
        if named is None:
            named = self._arm.description.posture(self._arm.group.name, goal.posture or "").positions
        end = np.clip(np.array(named), self._arm.limits.lower, self._arm.limits.upper)
        if not motions.checker.free(end):
            contact = next(iter(motions.checker.contacts(end)), None)
            return self._failure(
                FailureKind.NO_IK, f"in collision there: {words(contact)}", contact=words(contact)
            )
        return (yield from self._way(goal, moment, motions, start, [end], rng, 0, None))

    def _candidates(
        self, goal: MoveGoal, moment: Moment, motions: Motions, start: Array, rng: np.random.Generator
    ) -> Steps:
        hand = self._hand(motions.checker)
        refused: list[_Refusal | Failure] = []
        for starts in LOOKS:
            refused = []
            # The first is often the one: the others are solved together, and only if it was not.
            for first, some in ((0, goal.candidates[:1]), (1, goal.candidates[1:])):
                if not some:
                    continue
                offered = yield from offers(hand, goal, moment, some, start, starts)
                for number, offer in ((first + k, each) for k, those in enumerate(offered) for each in those):
                    ends = yield from self._ends(goal, moment, motions, offer.candidate, offer.answer)
                    if isinstance(ends, _Refusal):
                        refused.append(ends)
                        continue
                    target = to_base(offer.candidate.pose, goal.frame, moment.base_in_map)
                    plan = yield from self._way(goal, moment, motions, start, ends, rng, number, target)
                    if isinstance(plan, Plan):
                        return replace(plan, turned=offer.turn)
                    refused.append(plan)
        failures: list[Failure] = []
        for each in refused:
            failures.append(each if isinstance(each, Failure) else self._explain(each, motions.checker))
            yield CHECKS_AT_ONCE
        planned = next((each for each in failures if each.kind is not FailureKind.NO_IK), failures[0])
        return planned.model_copy(update={"causes": tuple(failures)})

    def _ends(
        self, goal: MoveGoal, moment: Moment, motions: Motions, candidate: Candidate, answer: IkAnswer
    ) -> Generator[int, None, list[Array] | _Refusal]:
        """Return joint positions for the candidate from which all that follows can be reached."""
        checker, hand = motions.checker, self._hand(motions.checker)
        free = [q for q in answer.solutions if checker.free(q)]
        yield len(answer.solutions)
        if not free:
            return _Refusal(answer.distance, answer.solutions, None)
        if not candidate.followed_by:
            return free[:ENOUGH]
        then = [to_base(pose, goal.frame, moment.base_in_map) for pose in candidate.followed_by]
        lines, good = yield from line_ends(hand, np.array(free), then)
        found: list[Array] = []
        broken: Line | None = None
        checker.touch(allowed=True)
        for k in np.flatnonzero(good):
            if goal.touch_support:
                checker.let_rest(lines[k, -1], carried_only=True)
            line = yield from foresee(hand, checker, lines[k], then)
            if line.broken is None:
                found.append(free[k])
            else:
                broken = line
            if len(found) >= ENOUGH:
                break
        checker.touch(allowed=False)
        return found or _Refusal(0.0, (), broken or Line(np.array(free[:1]), 0.0, Broken.OUT_OF_REACH))

    def _way(  # noqa: PLR0917 - the problem's parts, in one order everywhere
        self,
        goal: MoveGoal,
        moment: Moment,
        motions: Motions,
        start: Array,
        ends: list[Array],
        rng: np.random.Generator,
        candidate: int,
        target: Pose | None,
    ) -> Steps:
        """Find a path, time it, check it; where the check finds that it grazes, look again in finer steps."""
        for end in ends:  # the straight motion needs no planner
            direct = yield from self._timed(goal, motions, np.array([start, end]), candidate, target)
            if isinstance(direct, Plan):
                return direct
        wrong: _Graze | None = None
        for share in FINER:
            finer = Motions(motions.checker, motions.space, motions.step * share)
            if self._compute is not None and self._settings.planner is PlannerName.AORRTC:
                far = FarProblem(self._arm.description, self._arm.group.name, moment, goal, share)
                job = FarJob(far, start, tuple(ends), self._settings, int(rng.integers(2**31)))
                path = yield from elsewhere(self._compute, job)
            else:
                path = yield from find_path(finer, start, ends, rng, self._settings)
            if path is None:
                break
            timed = self._curved if self._settings.planner.optimises else self._timed
            plan = yield from timed(goal, finer, path, candidate, target)
            if isinstance(plan, Plan):
                return plan
            wrong = plan
        return self._no_path(len(ends)) if wrong is None else self._grazed(wrong, motions.checker)

    def _straight(self, goal: MoveGoal, moment: Moment, motions: Motions, start: Array) -> Steps:
        failures: list[Failure] = []
        for number, candidate in enumerate(goal.candidates):
            target, turn = yield from straight_to(self._hand(motions.checker), goal, moment, candidate, start)
            if goal.touch_support:
                yield from self._permit_support(motions.checker, start, target)
            line = yield from follow(self._hand(motions.checker), motions.checker, start, target)
            if line.broken is not None:
                failures.append(self._broken(line, FailureKind.NO_PATH, motions.checker))
                continue
            trajectory = time_curve(through(line.path), self._arm.motion_limits.scaled(goal.speed))
            wrong = yield from self._check(motions, trajectory)
            if wrong is None:
                return Plan(trajectory, number, target, turn)
            failures.append(self._grazed(wrong, motions.checker))
        return failures[0].model_copy(update={"causes": tuple(failures[1:])})

    def _retreat(self, goal: MoveGoal, motions: Motions, start: Array) -> Steps:
        """Take the first way back that is whole, else the longest part of one."""
        hand = self._hand(motions.checker)
        parts: list[tuple[int, Line]] = []
        failures: list[Failure] = []
        for number, target in enumerate(ways_back(hand.chain.pose(start, hand.frame), goal)):
            yield from self._permit_support(motions.checker, start, target)
            line = yield from follow(hand, motions.checker, start, target)
            wrong = self._broken(line, FailureKind.NO_PATH, motions.checker)
            if line.broken is None:
                plan = yield from self._along(goal, motions, line.path, number)
                if isinstance(plan, Plan):
                    return plan
                wrong = self._grazed(plan, motions.checker)
            failures.append(wrong)
            parts.append((number, line))
        for number, path in longest_first(hand, parts):
            plan = yield from self._along(goal, motions, path, number)
            if isinstance(plan, Plan):
                return plan
        return failures[0].model_copy(update={"causes": tuple(failures[1:])})

    def _along(
        self, goal: MoveGoal, motions: Motions, path: Array, number: int
    ) -> Generator[int, None, Plan | _Graze]:
        """Time and check a retreat along a path; it ends where the path does."""
        hand = self._hand(motions.checker)
        trajectory = time_curve(through(path), self._arm.motion_limits.scaled(goal.speed))
        yield CURVE
        wrong = yield from self._check(motions, trajectory)
        return wrong or Plan(trajectory, number, hand.chain.pose(path[-1], hand.frame))

    def _permit_support(
        self, checker: CollisionChecker, start: Array, target: Pose
    ) -> Generator[int, None, None]:
        """Let what is carried rest at the target as it would there, if not too deep."""
        line = yield from follow(self._hand(checker), None, start, target)
        if line.broken is None:
            checker.let_rest(line.path[-1], carried_only=True)

    def _timed(
        self, goal: MoveGoal, motions: Motions, path: Array, candidate: int, target: Pose | None
    ) -> Generator[int, None, Plan | _Graze]:
        wrong: _Graze | None = None
        for blend in BLENDS if len(path) > 2 else BLENDS[-1:]:  # noqa: PLR2004
            trajectory = time_path(path, self._arm.motion_limits.scaled(goal.speed), blend)
            yield 20
            wrong = yield from self._check(motions, trajectory)
            if wrong is None:
                return Plan(trajectory, candidate, target)
        assert wrong is not None
        return wrong

    def _curved(
        self, goal: MoveGoal, motions: Motions, path: Array, candidate: int, target: Pose | None
    ) -> Generator[int, None, Plan | _Graze]:
        """Time and check a path of many points as one curve."""
        trajectory = time_curve(through(path), self._arm.motion_limits.scaled(goal.speed))
        yield CURVE
        wrong = yield from self._check(motions, trajectory)
        return wrong or Plan(trajectory, candidate, target)

    def _check(
        self, motions: Motions, trajectory: Trajectory, after: float = 0.0
    ) -> Generator[int, None, _Graze | None]:
        """Check the motion as the hardware will interpolate it, in fine steps."""
        states = _fine(motions, trajectory, after)
        checker = motions.checker
        order = [len(states) - 1, *halving(len(states) - 1)]  # what is blocked is found early
        for first in range(0, len(order), CHECKS_AT_ONCE):
            numbers, before = order[first : first + CHECKS_AT_ONCE], checker.checks
            at = checker.first_contact(states[numbers])
            yield checker.checks - before
            if at is not None:
                k = numbers[at]
                return _Graze(states[k], round(k / len(states), 3))
        return None

    def _hand(self, checker: CollisionChecker) -> Hand:
        hand, solver = self._arm.hand, self._arm.solver
        # ``check`` of the skill refuses poses for a group without a hand.
        assert hand is not None
        assert solver is not None
        return Hand(solver, hand.frame, checker.chain)

    def _grazed(self, graze: _Graze, checker: CollisionChecker) -> Failure:
        contact = self._contact(checker, graze.q)
        return self._failure(
            FailureKind.PATH_IN_COLLISION, f"{contact} would touch", contact=contact, share=graze.share
        )

    def _no_path(self, goals: int) -> Failure:
        return self._failure(
            FailureKind.NO_PATH, "the planner found no way", goals=goals, planner=self._settings.planner.value
        )

    def _explain(self, refusal: _Refusal, checker: CollisionChecker) -> Failure:
        if refusal.broken is not None:
            return self._broken(refusal.broken, FailureKind.NO_IK, checker)
        contact = self._contact(checker, refusal.blocked[0] if refusal.blocked else None)
        return self._failure(
            FailureKind.NO_IK,
            "all joint positions for it collide" if refusal.blocked else "out of reach",
            contact=contact,
            blocked=len(refusal.blocked),
            distance_m=round(refusal.distance, 4),
        )

    def _broken(self, line: Line, kind: FailureKind, checker: CollisionChecker) -> Failure:
        return self._failure(
            kind,
            f"the straight line ends early: {line.broken}",
            broken=str(line.broken),
            contact=self._contact(checker, line.hit),
            travelled=round(line.travelled, 3),
        )

    @staticmethod
    def _contact(checker: CollisionChecker, q: Array | None) -> str:
        return "" if q is None else words(next(iter(checker.contacts(q)), None))

    def _failure(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> Failure:
        known = {name: value for name, value in evidence.items() if value != ""}
        return Failure(kind=kind, message=message, where=self._where, evidence=known)


@dataclass(frozen=True)
class Reached:
    """A candidate (its number), joint positions (n,) at it, and the radians by which it was turned."""

    candidate: int
    q: Array
    turned: float = 0.0


@dataclass(frozen=True)
class _Refusal:
    """Why a candidate is none; put into words only when no other one is found."""

    distance: float
    blocked: tuple[Array, ...]
    broken: Line | None


@dataclass(frozen=True)
class _Graze:
    """Joint positions (n,) of a motion that are in collision, and at what share of it they come."""

    q: Array
    share: float


def _fine(motions: Motions, trajectory: Trajectory, after: float) -> Array:
    """Return states (m, n) of the motion from ``after`` seconds on, no farther apart than FINE_STEP."""
    weights = motions.space.weights
    seconds = trajectory.duration - after
    dense = trajectory.sample(np.linspace(after, trajectory.duration, max(2, int(seconds / 0.004))))
    ways = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(dense, axis=0) * weights, axis=1))))
    count = max(2, int(np.ceil(ways[-1] / FINE_STEP)) + 1)
    marks = np.searchsorted(ways, np.linspace(0.0, ways[-1], count))
    return dense[np.minimum(marks, len(dense) - 1)]
