"""Straight lines of the hand: joint positions along them, each step checked."""

from __future__ import annotations

import math
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from tandem.skills.arm.planning.motions import halving
from tandem.skills.geometry.poses import angle_between, distance
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.ik import Solver
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.transforms import Array, interpolate, to_se3
from tandem.skills.ports.pose import Pose

STEP_METRES = 0.01
STEP_RADIANS = 0.06
AT_ONCE = 16
"""Points that are solved together, all from the last one before them: so they lie on one smooth branch."""
JUMP = 0.25
"""Radians: more than this from one step to the next means that the arm would fold over, unless the hand stays
on the line all the way: near a stretched wrist two joints turn fast against each other, the hand hardly."""
BETWEEN = (0.25, 0.5, 0.75)
"""Shares of a step at which that is looked at."""
COARSE = 2.5
"""Times the steps' length where it is only asked whether a line could be followed; checks stay as fine."""
FURTHEST = 1.6
"""Radians: a joint that turns further on a whole line folds over somewhere."""
SLICE = 50
"""States of a line that are checked in one slice."""
ROUGH_METRES, ROUGH_RADIANS = 2e-3, 1e-2
"""Close enough for that."""


class Broken(StrEnum):
    """Why a line can't be followed."""

    OUT_OF_REACH = "OUT_OF_REACH"
    JUMPS = "JUMPS"
    IN_COLLISION = "IN_COLLISION"


@dataclass(frozen=True)
class Line:
    """Joint positions (m, n) along the line as far as it goes; ``broken`` says why it ends early."""

    path: Array
    travelled: float
    """Share of the line, 0 to 1."""
    broken: Broken | None = None
    hit: Array | None = None
    """The joint positions (n,) that are in collision."""


@dataclass(frozen=True)
class Hand:
    """What straight lines need: the solver of a frame, and the joints, the others locked where they stand."""

    solver: Solver
    frame: str
    chain: Chain


def follow(
    hand: Hand, checker: CollisionChecker | None, start: Array, target_in_base: Pose
) -> Generator[int, None, Line]:
    """Follow the straight line from where the hand is at ``start`` (n,) to the target.

    Position and orientation go at constant rates.

    Args:
        hand: what moves.
        checker: says which states are free; without one, all are.
        start: joint positions (n,).
        target_in_base: where the line ends.

    Yields:
        Units of work.
    """
    here = hand.chain.pose(start, hand.frame)
    steps = _steps(here, target_in_base, 1.0)
    poses = [to_se3(interpolate(here, target_in_base, k / steps)) for k in range(1, steps + 1)]
    targets = hand.solver.in_root(hand.chain, poses)
    end, left, angle = yield from hand.solver.descend(start[None, :], targets[-1:])
    path = start[None, :]
    broken: Broken | None = Broken.OUT_OF_REACH
    if hand.solver.reached(left, angle)[0]:
        shares = np.arange(1, steps + 1)[:, None] / steps
        path, broken = yield from _extend(hand, path, start + (end - start) * shares, targets)
    if broken is not None:  # nearer points may lead to another end
        path, broken = start[None, :], None
        while len(path) <= steps and broken is None:
            goals = targets[len(path) - 1 : len(path) - 1 + AT_ONCE]
            path, broken = yield from _extend(hand, path, np.repeat(path[-1:], len(goals), axis=0), goals)
    if checker is not None and (at := (yield from _first_hit(checker, path))) is not None:
        return Line(path[:at], (at - 1) / steps, Broken.IN_COLLISION, path[at])
    return Line(path, (len(path) - 1) / steps, broken)


def _extend(
    hand: Hand, path: Array, begin: Array, targets: Array
) -> Generator[int, None, tuple[Array, Broken | None]]:
    """Return the path with as many of the targets as can be reached, solved for from ``begin`` (m, n)."""
    q, left, angle = yield from hand.solver.descend(begin, targets)
    steady = _steady(path[-1], q, JUMP)
    good, before = hand.solver.reached(left, angle), np.concatenate((path[-1:], q[:-1]))
    for k in np.flatnonzero(good & ~steady):
        steady[k] = _on_the_line(hand, before[k], q[k])
        yield len(BETWEEN)
        if not steady[k]:
            break
    whole, broken = _unbroken(q, good, steady)
    return np.concatenate((path, q[:whole])), broken


def line_ends(
    hand: Hand, starts: Array, targets_in_base: Sequence[Pose]
) -> Generator[int, None, tuple[Array, npt.NDArray[np.bool_]]]:
    """Return where lines through the targets would end, for many starts (k, n) at once.

    Returns:
        The joints at the starts and at each target, (k, t + 1, n), and whether all can be reached (k,).
    """
    ends, good = [starts], np.ones(len(starts), dtype=bool)
    for target in hand.solver.in_root(hand.chain, [to_se3(each) for each in targets_in_base]):
        goals = np.broadcast_to(target, (len(starts), 4, 4))
        q, left, angle = yield from hand.solver.descend(ends[-1], goals)
        good &= hand.solver.reached(left, angle)
        good &= np.max(np.abs(q - ends[-1]), axis=1) <= FURTHEST
        ends.append(q)
    return np.stack(ends, axis=1), good


def foresee(
    hand: Hand, checker: CollisionChecker, ends: Array, targets_in_base: Sequence[Pose]
) -> Generator[int, None, Line]:
    """Say whether the lines through the targets can be followed; ``ends`` (t + 1, n) are from ``line_ends``.

    The joints are solved for at fewer points than ``follow`` does, and checked as finely in between.
    """
    here = hand.chain.pose(ends[0], hand.frame)
    begin, poses, lines = [], [], []
    for a, b, target in zip(ends[:-1], ends[1:], targets_in_base, strict=True):
        steps = _steps(here, target, COARSE)
        begin += [a + (b - a) * k / steps for k in range(1, steps + 1)]
        poses += [to_se3(interpolate(here, target, k / steps)) for k in range(1, steps + 1)]
        lines.append(steps)
        here = target
    q, left, angle = yield from hand.solver.descend(
        np.array(begin), hand.solver.in_root(hand.chain, poses), rough=True
    )
    good = (left <= ROUGH_METRES) & (angle <= ROUGH_RADIANS)
    whole, broken = _unbroken(q, good, _steady(ends[0], q, JUMP * COARSE))
    path = np.concatenate((ends[:1], q[:whole]))
    between = np.arange(0.0, len(path) - 1 + 1e-9, 1.0 / math.ceil(COARSE))
    k = np.minimum(between.astype(int), max(0, len(path) - 2))
    share = (between - k)[:, None]
    dense = path if len(path) == 1 else path[k] * (1.0 - share) + path[k + 1] * share
    if (at := (yield from _first_hit(checker, dense))) is not None:
        return Line(dense[:at], at / (math.ceil(COARSE) * sum(lines)), Broken.IN_COLLISION, dense[at])
    return Line(path, (len(path) - 1) / max(1, sum(lines)), broken)


def _steps(here: Pose, target: Pose, coarse: float) -> int:
    metres, radians = distance(here, target), angle_between(here.orientation, target.orientation)
    return max(1, math.ceil(max(metres / STEP_METRES, radians / STEP_RADIANS) / coarse))


def _steady(before: Array, q: Array, jump: float) -> npt.NDArray[np.bool_]:
    """Return at which points of a line (m, n) no joint has jumped since the one before."""
    steps = np.abs(np.diff(np.concatenate((before[None, :], q)), axis=0))
    return np.asarray(np.max(steps, axis=1) <= jump)


def _on_the_line(hand: Hand, a: Array, b: Array) -> bool:
    """Say whether the hand stays on its line while the joints go straight from a to b (n,)."""
    if np.max(np.abs(b - a)) > FURTHEST:
        return False
    begin, end = hand.chain.pose(a, hand.frame), hand.chain.pose(b, hand.frame)
    for share in BETWEEN:
        there, meant = hand.chain.pose(a + (b - a) * share, hand.frame), interpolate(begin, end, share)
        if distance(there, meant) > ROUGH_METRES:
            return False
        if angle_between(there.orientation, meant.orientation) > ROUGH_RADIANS:
            return False
    return True


def _unbroken(
    q: Array, good: npt.NDArray[np.bool_], steady: npt.NDArray[np.bool_]
) -> tuple[int, Broken | None]:
    """Return how many points of a line (m, n) can be followed, and why no more."""
    bad = np.flatnonzero(~(good & steady))
    if not len(bad):
        return len(q), None
    return int(bad[0]), Broken.JUMPS if good[bad[0]] else Broken.OUT_OF_REACH


def _first_hit(checker: CollisionChecker, path: Array) -> Generator[int, None, int | None]:
    """Return the index of the first state that is not free; the end is looked at first, then the middle."""
    last = len(path) - 1
    if last < 1:
        return None
    order = [last, *halving(last)]
    for begin in range(0, len(order), SLICE):
        numbers, before = order[begin : begin + SLICE], checker.checks
        at = checker.first_contact(path[numbers])
        yield checker.checks - before
        if at is not None:
            before = checker.checks
            first = checker.first_contact(path[1 : numbers[at] + 1])
            yield checker.checks - before
            return numbers[at] if first is None else first + 1
    return None
