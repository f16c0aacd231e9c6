"""The retreat of a hand from whatever it is at."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from tandem.skills.geometry.poses import compose, distance, from_rpy, invert
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.action import GoalState, GoalStatus
from tandem.skills.ports.actions.arm import Candidate, MoveGoal, MoveResult
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box, SceneObject
from tests.fakes.arm_rig import ArmRig, box, panda

AT = (0.45, 0.2, 0.4)
BACK = ((0.0, 0.0, -0.10), (0.0, 0.0, -0.06), (0.0, 0.0, 0.1))
"""The tool's z points out of this hand."""


@pytest.fixture
def rig(hulls: RobotHulls) -> ArmRig:
    made = ArmRig(panda(), "arm", hulls=hulls)
    made.hardware.positions |= {"panda_finger_joint1": 0.03, "panda_finger_joint2": 0.03}
    down = Candidate(pose=Pose(position=AT, orientation=from_rpy(3.14159, 0.0, 0.0)))
    assert made.run(MoveGoal(candidates=(down,)), "there").state is GoalState.SUCCEEDED
    return made


def tool(rig: ArmRig) -> Pose:
    return rig.hulls.robot.pose("panda_hand_tcp", rig.hardware.positions)


def went(rig: ArmRig, before: Pose) -> Vector3:
    return compose(invert(before), tool(rig)).position


def retreat(rig: ArmRig, by: tuple[Vector3, ...] = BACK) -> GoalStatus:
    return rig.run(MoveGoal(by=by), "back")


def result(rig: ArmRig, status: GoalStatus) -> MoveResult:
    return rig.result(status)


def around() -> SceneObject:
    """Return an item between the open fingers, so thick that plans see them touch it."""
    return box("item_29", (0.05, 0.05, 0.1), AT, item=29)


def test_a_hand_around_an_item_retreats_where_a_posture_can_not_be_planned(rig: ArmRig) -> None:
    rig.set_scene(around(), version=2)
    assert rig.run(MoveGoal(posture="home"), "home").state is GoalState.FAILED
    before = tool(rig)
    done = result(rig, retreat(rig))
    assert done.candidate == 0
    assert done.error < 1e-3
    assert went(rig, before) == pytest.approx((0.0, 0.0, -0.10), abs=2e-3)
    assert rig.run(MoveGoal(posture="home"), "home again").state is GoalState.SUCCEEDED


def test_the_next_way_is_taken_where_the_first_is_blocked(rig: ArmRig) -> None:
    rig.set_scene(box("post", (0.02, 0.3, 0.8), (0.45 + 0.16, 0.2, 0.4)), version=2)
    before = tool(rig)
    done = result(rig, retreat(rig, ((0.1, 0.0, 0.0), (0.0, 0.0, -0.06))))
    assert done.candidate == 1
    assert went(rig, before) == pytest.approx((0.0, 0.0, -0.06), abs=2e-3)


def test_straight_up_in_the_map_comes_after_all_ways(rig: ArmRig) -> None:
    before = tool(rig)
    done = result(rig, retreat(rig, ((0.0, 0.0, 3.0),)))
    assert done.candidate == 1
    up = tuple(b - a for a, b in zip(before.position, tool(rig).position, strict=True))
    assert up == pytest.approx((0.0, 0.0, 0.10), abs=2e-3)


def test_a_hand_rises_straight_up_in_the_map_by_as_much_as_it_is_told(rig: ArmRig) -> None:
    before = tool(rig)
    assert result(rig, rig.run(MoveGoal(up=0.07), "up")).candidate == 0
    up = tuple(b - a for a, b in zip(before.position, tool(rig).position, strict=True))
    assert up == pytest.approx((0.0, 0.0, 0.07), abs=2e-3)


def test_a_hand_rises_from_among_items_whatever_it_touches(rig: ArmRig) -> None:
    rig.set_scene(around(), version=2)
    assert rig.run(MoveGoal(up=0.07), "up").state is GoalState.SUCCEEDED


@pytest.mark.parametrize("also", [{"by": BACK}, {"posture": "home"}])
def test_a_goal_says_one_thing_only(also: dict[str, object]) -> None:
    with pytest.raises(ValidationError, match="exactly one"):
        MoveGoal.model_validate({"up": 0.1, **also})


def test_the_longest_part_is_taken_where_no_way_is_whole(rig: ArmRig) -> None:
    roof = box("roof", (0.8, 0.8, 0.02), (0.45, 0.2, 0.4 + 0.72))
    low = rig.hulls.robot.pose("panda_hand", rig.hardware.positions).position[2]
    rig.set_scene(roof.model_copy(update={"box": _above(low + 0.30)}), version=2)
    before = tool(rig)
    done = result(rig, retreat(rig, ((0.0, 0.0, -0.30),)))
    assert done.error < 1e-3
    assert 0.02 <= distance(before, tool(rig)) < 0.30


def _above(z: float) -> Box:
    return Box(size=(0.2, 0.2, 0.02), pose=Pose(position=(AT[0], AT[1], z)))


def test_a_deep_contact_is_left_if_the_way_leads_out_of_it(rig: ArmRig) -> None:
    x, y, z = tool(rig).position
    floor = box("floor", (0.3, 0.3, 0.1), (x, y, z - 0.05 + 0.025))
    rig.set_scene(floor, version=2)
    stands = rig.run(MoveGoal(posture="home"), "home")
    assert stands.failure is not None
    assert stands.failure.evidence["at_start"] is True
    assert retreat(rig).state is GoalState.SUCCEEDED
    assert tool(rig).position[2] == pytest.approx(z + 0.10, abs=2e-3)


def test_a_way_that_leads_deeper_is_not_gone(rig: ArmRig) -> None:
    x, y, z = tool(rig).position
    rig.set_scene(box("floor", (0.3, 0.3, 0.1), (x, y, z - 0.05 + 0.005)), version=2)
    done = result(rig, retreat(rig, ((0.0, 0.0, 0.08),)))
    assert done.candidate == 1, "up, away from the floor"
    assert tool(rig).position[2] > z


def test_what_is_held_is_lifted_from_where_it_stands(rig: ArmRig) -> None:
    x, y, z = tool(rig).position
    held = box("item_29", (0.05, 0.05, 0.1), (0.0, 0.0, 0.0), item=29).model_copy(
        update={"attached_to": "right"}
    )
    table = box("table", (0.5, 0.5, 0.1), (x, y, z - 0.05 - 0.05))
    rig.set_scene(held, table, version=2)
    before = z
    assert retreat(rig, BACK).state is GoalState.SUCCEEDED
    assert tool(rig).position[2] == pytest.approx(before + 0.10, abs=2e-3)


def test_a_group_without_a_hand_is_refused_a_retreat(hulls: RobotHulls) -> None:
    handless = panda().model_copy(update={"end_effectors": ()})
    rig = ArmRig(handless, "arm", hulls=hulls)
    sent = rig.send(MoveGoal(by=BACK), "again")
    rig.rounds(1)
    answer = sent.poll()
    assert answer is not None
    assert GoalStatus.model_validate_json(answer).state is GoalState.REJECTED
