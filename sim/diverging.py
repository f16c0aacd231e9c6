"""When the physics of a robot diverges: what did, and what of its file to look at.

Bullet never says so. A link of 1e300 kg makes every number NaN; one of 1e15 kg presses the robot through the
floor; numbers that are no numbers then raise somewhere else, far from the file that is to blame.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import pybullet

from tandem.skills.ports.sources import DocumentError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tandem.sim.body import JointReading, RobotBody

DEEPEST: Final = 10.0
"""Metres below the floor: a robot that falls over a scenario's edge (`Drop`, at most 2 m) stays above it."""
FARTHEST: Final = 1000.0
"""Metres from the origin: no room is as wide, and nobody drives there in a day's run."""


class DivergedError(DocumentError):
    """The physics of a robot has no meaning any more, by what its file says of it."""


def require_sound(body: RobotBody, joints: Sequence[str], readings: Sequence[JointReading]) -> None:
    """Raise DivergedError when a joint's reading is no number, or the robot is where no robot can be.

    Args:
        body: the robot, after a step.
        joints: names of its joints.
        readings: theirs, in this order.
    """
    at = body.base_pose()[0]
    wrong = next(
        (
            f"joint {name} stands at {each.position:g} and turns at {each.velocity:g} a second"
            for name, each in zip(joints, readings, strict=True)
            if not math.isfinite(each.position + each.velocity)
        ),
        "",
    )
    if not wrong and not (at[2] > -DEEPEST and max(map(abs, at)) < FARTHEST):
        wrong = f"its base is at ({at[0]:.6g}, {at[1]:.6g}, {at[2]:.6g}) m"
    if wrong:
        raise DivergedError(
            f"the simulation of {body.model.description.name} diverged: {wrong}. Look at the masses and "
            f"inertias of its URDF: {_masses(body)}. Bullet needs neighbours within a factor of some "
            "hundred, and moments that fit the masses"
        )


def _masses(body: RobotBody) -> str:
    """Return the heaviest and the lightest link that weighs anything, as the physics has them."""
    found = sorted(
        (pybullet.getDynamicsInfo(body.body, index, physicsClientId=body.physics.client)[0], link)
        for link, index in body.link_index.items()
    )
    weighing = [each for each in found if each[0] > 0.0] or found
    (least, light), (most, heavy) = weighing[0], weighing[-1]
    return f"{light} weighs {least:.3g} kg and {heavy} {most:.3g} kg"
