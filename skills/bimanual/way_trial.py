"""A way of both hands, tried on both arms' kinematics before anything moves."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from typing import Final

from tandem.skills.bimanual.lead import LedArm
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import Pose

REACHED: Final = 0.004
"""Metres and radians by which joint positions may miss a hand's pose before it is out of reach."""
QUICK: Final = 0.5
"""Share of the joints' speed limits that a way may take."""
SWING: Final = 0.25
"""Seconds of an arm's full speed between two tried poses beyond which it would have to swing round."""
SAMPLES: Final = 24
"""Poses of a way that are tried."""
SLICE: Final = 4
"""Of them, between two yields: about 1 ms."""


@dataclass(frozen=True)
class OutOfReach:
    """Where a way ends for an arm: metres that its hand is off there, after that share of the way."""

    side: HandName
    metres: float
    share: float


def try_way(
    arms: Sequence[LedArm], way: Callable[[float], tuple[Pose, Pose]], duration: float
) -> Generator[None, None, float | OutOfReach]:
    """Try a whole way from where the arms were told to be; return the seconds that their joints need for it.

    Args:
        arms: left and right. Nothing moves.
        way: both tools' poses in the base after a share of the time.
        duration: seconds that the hands need for it.

    Yields:
        After each slice.
    """
    q, slowest = [arm.q for arm in arms], 0.0
    for k in range(1, SAMPLES + 1):
        share, spent = k / SAMPLES, 0.0
        for number, (arm, pose) in enumerate(zip(arms, way(share), strict=True)):
            there = arm.ahead(q[number], pose)
            seconds = arm.seconds(q[number], there.q)
            if there.metres > REACHED or there.radians > REACHED or seconds > SWING:
                return OutOfReach(arm.side, there.metres, share)
            q[number], spent = there.q, max(spent, seconds)
        slowest = max(slowest, spent * SAMPLES / (QUICK * duration))
        if k % SLICE == 0:
            yield
    return duration * max(1.0, slowest)
