"""Which things are in one place: boxes and cylinders, side by side, above each other, turned."""

from __future__ import annotations

import math

import pytest

from tandem.sim.placing import inside
from tandem.sim.scene import SceneBody
from tandem.sim.things import BoxShape, CylinderShape
from tandem.skills.geometry.poses import about
from tandem.skills.ports.pose import Pose

CUBE = BoxShape(size=(0.1, 0.1, 0.1))
MUG = CylinderShape(radius=0.05, height=0.1)


def body(shape: BoxShape | CylinderShape, x: float, y: float, z: float = 0.05, yaw: float = 0.0) -> SceneBody:
    pose = Pose(position=(x, y, z), orientation=about((0, 0, 1), yaw))
    return SceneBody("thing", shape, pose, mass=0.1, friction=0.5, colour=(1, 1, 1))


@pytest.mark.parametrize(
    ("one", "other", "overlap"),
    [
        (body(CUBE, 0, 0), body(CUBE, 0, 0), True),
        (body(CUBE, 0, 0), body(CUBE, 0.1, 0), False),  # they touch
        (body(CUBE, 0, 0), body(CUBE, 0.0992, 0), True),
        (body(CUBE, 0, 0), body(CUBE, 0.12, 0, yaw=math.pi / 4), True),  # a corner reaches in
        (body(CUBE, 0, 0), body(CUBE, 0, 0, 0.15), False),  # one stands on the other
        (body(CUBE, 0, 0), body(CUBE, 0, 0, 0.12), True),
        (body(MUG, 0, 0), body(CUBE, 0.099, 0), True),
        (body(MUG, 0, 0), body(CUBE, 0.09, 0.09), False),  # beside the corner: a box about it would overlap
        (body(MUG, 0, 0), body(MUG, 0.1, 0), False),
        (body(MUG, 0, 0), body(MUG, 0, 0), True),
        (body(BoxShape(size=(1, 1, 0.1)), 0, 0), body(MUG, 0.2, 0.3), True),  # one within the other
    ],
)
def test_what_is_in_one_place(one: SceneBody, other: SceneBody, overlap: bool) -> None:  # noqa: FBT001
    assert inside(one, [other]) == ("thing" if overlap else "")
    assert inside(other, [one]) == ("thing" if overlap else "")
