"""Candidates turned as an arm of fewer than six joints needs them; those of other arms stay as they are."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass

import numpy as np

from tandem.skills.arm.planning.straight import Hand
from tandem.skills.arm.problem import Moment
from tandem.skills.arm.scene import to_base
from tandem.skills.geometry.poses import turned
from tandem.skills.kinematics.ik import IkAnswer
from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.kinematics.turning import Vertical
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.pose import Pose


@dataclass(frozen=True)
class Offer:
    """A candidate, turned by ``turn`` radians, and the joint positions (n,) that bring the hand to it."""

    candidate: Candidate
    answer: IkAnswer
    turn: float = 0.0


def offers(  # noqa: PLR0917 - the problem's parts, in one order everywhere
    hand: Hand, goal: MoveGoal, moment: Moment, candidates: Sequence[Candidate], start: Array, starts: int
) -> Generator[int, None, tuple[tuple[Offer, ...], ...]]:
    """Solve for each candidate, all at once.

    Returns:
        For each candidate at least one offer: where it can be reached in several turns, one for each.
    """
    targets = [to_se3(to_base(each.pose, goal.frame, moment.base_in_map)) for each in candidates]
    vertical = _vertical(hand, goal, moment)
    if vertical is None or goal.turn is None:
        answers = yield from hand.solver.solve(hand.chain, targets, start, starts)
        return tuple((Offer(each, answer),) for each, answer in zip(candidates, answers, strict=True))
    solver = hand.solver.turning(hand.chain, vertical)
    answers = yield from solver.solve(hand.chain, targets, np.append(start, 0.0), starts)
    found: list[tuple[Offer, ...]] = []
    for each, answer in zip(candidates, answers, strict=True):
        there = tuple(
            Offer(
                _turned(each, goal.turn.point, float(q[-1])),
                IkAnswer((q[:-1],), answer.distance),
                float(q[-1]),
            )
            for q in answer.solutions
        )
        found.append(there or (Offer(each, IkAnswer((), answer.distance)),))
    return tuple(found)


def straight_to(
    hand: Hand, goal: MoveGoal, moment: Moment, candidate: Candidate, start: Array
) -> Generator[int, None, tuple[Pose, float]]:
    """Return where in the base a straight motion from ``start`` (n,) ends, and by how much that is turned."""
    pose = to_base(candidate.pose, goal.frame, moment.base_in_map)
    vertical = _vertical(hand, goal, moment)
    if vertical is None:
        return pose, 0.0
    found = yield from nearest(hand, goal, moment, candidate, start)
    return (pose, 0.0) if found is None else (turned(pose, vertical.point, found[1]), found[1])


def nearest(
    hand: Hand, goal: MoveGoal, moment: Moment, candidate: Candidate, start: Array
) -> Generator[int, None, tuple[Array, float] | None]:
    """Return the joints (n,) next to ``start`` (n,) that bring the hand to a candidate, and its turn there.

    None when the way downhill from there does not end at it.
    """
    vertical = _vertical(hand, goal, moment)
    solver = hand.solver if vertical is None else hand.solver.turning(hand.chain, vertical)
    goals = solver.in_root(hand.chain, [to_se3(to_base(candidate.pose, goal.frame, moment.base_in_map))])
    begin = start if vertical is None else np.append(start, 0.0)
    q, metres, radians = yield from solver.descend(begin[None, :], goals)
    if not solver.reached(metres, radians)[0]:
        return None
    return (q[0], 0.0) if vertical is None else (q[0, :-1], float(q[0, -1]))


def _vertical(hand: Hand, goal: MoveGoal, moment: Moment) -> Vertical | None:
    """Return what an arm of few joints may turn the goal's poses about, in the base."""
    if goal.turn is None or hand.solver.exact:
        return None
    at = Pose(position=goal.turn.point, orientation=(0.0, 0.0, 0.0, 1.0))
    return Vertical(to_base(at, goal.frame, moment.base_in_map).position, goal.turn.most)


def _turned(candidate: Candidate, point: tuple[float, float, float], angle: float) -> Candidate:
    return Candidate(
        pose=turned(candidate.pose, point, angle),
        followed_by=tuple(turned(each, point, angle) for each in candidate.followed_by),
    )
