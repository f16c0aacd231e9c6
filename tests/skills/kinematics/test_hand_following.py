"""A hand that follows a moving pose."""

from __future__ import annotations

import numpy as np

from tandem.skills.bimanual.glide import Bounds, glide
from tandem.skills.bimanual.lead import LedArm
from tandem.skills.bimanual.ready import pointing
from tandem.skills.ports.pose import Pose
from tests.skills.reflex.two_arms import positions, robot

LEANING = (0.663, 0.515, 0.985, 1.383, 0.737, -1.192, 0.422)
"""A left arm beside a carton; its wrist's joint 6 is near its limit when the hand points inwards."""


def test_a_joint_that_comes_to_its_limit_makes_no_other_jerk() -> None:
    description, hulls = robot()
    arm = LedArm(description, hulls.robot, "left")
    at = positions(left=LEANING)
    arm.begin(at)
    start = hulls.robot.pose(arm.frame, at)
    inwards = Pose(position=start.position, orientation=pointing(start.orientation, (0.0, -1.0, 0.0)))
    way = glide(start, inwards, Bounds())
    told, times = [arm.q], np.arange(0.01, way.duration + 0.3, 0.01)
    for seconds in times:
        further = arm.ahead(told[-1], way.at(float(seconds)))
        assert max(further.metres, further.radians) < 0.002
        told.append(further.q)
    hardest = np.abs(np.diff(np.array(told), n=2, axis=0)).max() / 0.01**2
    assert hardest < 15.0, "rad/s2: a jump to the limit made it 100 and more"
    assert told[-1][5] < -1.3, "the joint is near its limit indeed"
