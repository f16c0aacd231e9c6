"""The robot's named postures, one group each."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.hardware import Posture

ARM_HOME: Final = (-1.1, 1.468, 2.714, 1.7095, -1.5707, 1.37, 0.0)
"""PAL's: the hands hang in front of the shoulders, fingers up, 0.364 m from the base's axis at the most.

Needs the torso at 0.05 m or more: below that the forearms come close to the base.
"""

ARM_CARRY: Final = (0.34, 1.49, 1.70, 2.28, -0.72, -0.78, -1.97)
"""The hand level in front of the torso, 0.72 m high with the torso at 0.15 m, fingers inwards.

The arm reaches 0.395 m from the base's axis, an item in the hand up to 0.40 m. One arm at a time: both hands
would meet. The camera sees the hand neither looking ahead nor at a table.
"""

POSTURES: Final = (
    Posture(name="home", group="arm_left", positions=ARM_HOME),
    Posture(name="home", group="arm_right", positions=ARM_HOME),
    Posture(name="carry", group="arm_left", positions=ARM_CARRY),
    Posture(name="carry", group="arm_right", positions=ARM_CARRY),
    Posture(name="home", group="torso", positions=(0.30,)),
    Posture(name="home", group="head", positions=(0.0, -0.3)),
    Posture(name="ahead", group="head", positions=(0.0, 0.0)),
    Posture(name="table", group="head", positions=(0.0, -0.55)),
)
