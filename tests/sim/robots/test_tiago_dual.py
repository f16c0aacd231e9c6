"""The robot's description is one that others can load, and the physics agrees with it."""

from __future__ import annotations

import numpy as np
import pinocchio
import pytest

from benchmarks.rig import Rig
from tandem.sim.robots.registry import robot_model

MODEL = robot_model("tiago_dual")


def test_pinocchio_and_pybullet_agree_where_the_hand_is() -> None:
    rig = Rig(friction=None)
    rig.ticks(50)
    description = MODEL.description
    model = pinocchio.buildModelFromXML(description.urdf)
    data = model.createData()
    q = pinocchio.neutral(model)
    for group in description.groups:
        for joint, value in zip(group.joints, rig.positions(group.name), strict=True):
            q[model.joints[model.getJointId(joint)].idx_q] = value
    pinocchio.framesForwardKinematics(model, data, q)
    base = rig.body.frame_matrix("base_footprint")
    for frame in ("gripper_left_grasping_frame", "gripper_right_grasping_frame", "xtion_rgb_optical_frame"):
        here = base @ data.oMf[model.getFrameId(frame)].homogeneous
        assert np.allclose(rig.body.frame_matrix(frame), here, atol=1e-4), frame
    rig.close()


def test_nothing_of_the_hands_is_left_and_no_path_of_this_machine() -> None:
    urdf = MODEL.description.urdf
    assert "hand_" not in urdf
    assert 'filename="/' not in urdf


def test_every_posture_is_within_the_limits() -> None:
    for posture in MODEL.description.postures:
        group = MODEL.description.group(posture.group)
        for limit, value in zip(group.limits, posture.positions, strict=True):
            assert limit.lower <= value <= limit.upper, (posture.name, limit.joint)


@pytest.mark.parametrize("arm", ["home", "carry"])
def test_a_posture_collides_with_nothing_and_stays_on_its_circle(arm: str) -> None:
    posture = MODEL.description.posture("arm_left", arm)
    rig = Rig(friction=None, start={"arm_left": posture.positions, "torso": (0.15,)})
    rig.ticks(5)
    touching = rig.physics.contacts(rig.body.body, rig.body.body)
    assert not [contact for contact in touching if contact.force > 0.0]
    radius = {"home": MODEL.description.footprint_radius, "carry": 0.42}[arm]
    for hand in MODEL.hands:
        x, y = rig.body.frame_matrix(f"gripper_{hand.side}_grasping_frame")[:2, 3]
        assert np.hypot(x, y) < radius
    rig.close()


@pytest.mark.parametrize("side", ["left", "right"])
def test_an_item_is_carried_as_upright_as_it_was_taken(side: str) -> None:
    posture = MODEL.description.posture(f"arm_{side}", "carry")
    rig = Rig(friction=None, start={f"arm_{side}": posture.positions})
    up = rig.body.frame_matrix(f"gripper_{side}_grasping_frame")[2, 2]
    rig.close()
    assert up > 0.95  # a grasp's z points upwards: skills/grasping/tag_grasps.py


def test_an_unknown_frame_is_named() -> None:
    rig = Rig(friction=None)
    with pytest.raises(KeyError, match="no frame 'tail'"):
        rig.body.frame_matrix("tail")
    rig.close()
