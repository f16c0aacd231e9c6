"""A retreat: the ways by which a hand leaves whatever it is at."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from tandem.skills.arm.planning.straight import Hand, Line
from tandem.skills.geometry.poses import compose, distance
from tandem.skills.kinematics.collision import MAX_RESTING_DEPTH
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.pose import IDENTITY, Pose

UP: Final = 0.10
"""Metres straight up in the map: what is tried after all ways of the goal."""
WORTH: Final = 0.02
"""Metres: a shorter part of a way is not worth going."""
SHORTER: Final = 2
"""Points (a centimetre each) that are left off where the end of a part grazes something."""


def deepest(goal: MoveGoal) -> float:
    """Return how deep (m) a contact may be in which the motion begins: a retreat leads out of any."""
    return float("inf") if goal.retreats else MAX_RESTING_DEPTH


def ways_back(tool_in_base: Pose, goal: MoveGoal) -> tuple[Pose, ...]:
    """Return where the tool ends, in the base's frame: by each displacement, and last straight up."""
    x, y, z = tool_in_base.position
    ways = [compose(tool_in_base, Pose(position=each, orientation=IDENTITY.orientation)) for each in goal.by]
    up = UP if goal.up is None else goal.up
    return (*ways, Pose(position=(x, y, z + up), orientation=tool_in_base.orientation))


def longest_first(hand: Hand, parts: Sequence[tuple[int, Line]]) -> Iterator[tuple[int, Array]]:
    """Return the paths of ways that end early, by how far the tool gets, and each a bit shorter as well."""
    found: list[tuple[float, int, Array]] = []
    for number, line in parts:
        here = hand.chain.pose(line.path[0], hand.frame)
        for last in range(len(line.path), 1, -SHORTER):
            path = line.path[:last]
            metres = distance(here, hand.chain.pose(path[-1], hand.frame))
            if metres >= WORTH:
                found.append((metres, number, path))
    for _, number, path in sorted(found, key=lambda each: (-each[0], each[1])):
        yield number, path
