"""A base with cliff sensors stands at an edge, backs off, plans around it, and is slow when one is deaf."""

from __future__ import annotations

import math

import pytest

from tandem.skills.base.wheels import stopping_speed
from tandem.skills.ports.actions.base import DriveGoal, DriveResult
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex_setting import Excess
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import CliffSensor
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.site import load
from tests.fakes.base_rig import Rig, make_rig
from tests.fakes.planar_robot import URDF, PlanarRobot, describe

LAB = load("lab")
SOUTH = FloorPose(x=-1.0, y=-1.6, yaw=0.0)
HIGH, LEAD, AHEAD = 0.03, 0.05, 0.2
FASTEST = stopping_speed(LEAD, 3.0, 0.02)


def described() -> RobotDescription:
    """The planar fake with one cliff sensor, 0.2 m ahead and 3 cm high."""
    down = f"""<link name="down"/><joint name="down_joint" type="fixed"><parent link="base_footprint"/>
      <child link="down"/><origin xyz="{AHEAD} 0 {HIGH}" rpy="0 {math.pi / 2} 0"/></joint></robot>"""
    plain = describe()
    sensor = CliffSensor(name="front", frame="down", range_max=0.15, lead=LEAD, period=0.02)
    return plain.model_copy(
        update={
            "urdf": URDF.replace("</robot>", down),
            "cliff_sensors": (sensor,),
            "drive": plain.driven.model_copy(update={"braking": 3.0}),
        }
    )


def rig(edge: float = math.inf, depth: float = 0.12) -> Rig:
    """Return a rig that heads east; beyond ``edge`` (m, along x) the floor is lower by ``depth``."""
    made = make_rig(LAB, SOUTH, description=described())

    def floor(robot: PlanarRobot) -> dict[str, float]:
        over = robot.truth.x + AHEAD * math.cos(robot.truth.yaw) > edge
        return {"front": HIGH + (depth if over else 0.0)}

    made.robot.floor = floor
    made.wait(0.2)
    return made


def drive(made: Rig, x: float) -> tuple[Outcome[DriveResult], float]:
    """Drive east to x; return the outcome and the top speed."""
    fastest = 0.0

    def command(_: float) -> Command:
        nonlocal fastest
        fastest = max(fastest, made.robot.linear)
        return Command.GO_ON

    goal = DriveGoal(poses=(FloorPose(x=x, y=-1.6, yaw=0.0),))
    return made.run(made.base.drive.run(goal, "g"), command), fastest


def test_at_an_edge_the_goal_ends_overridden_and_says_which_sensor_saw_it() -> None:
    outcome, _ = drive(rig(edge=0.5), 2.0)
    assert outcome.failure is not None
    assert (outcome.failure.kind, outcome.failure.reason.kind) == (
        FailureKind.OVERRIDDEN,
        FailureKind.BASE_BLOCKED,
    )
    assert outcome.failure.evidence == outcome.failure.evidence | {"reflex": "cliff", "sensor": "front"}
    assert outcome.failure.evidence["drop_m"] == pytest.approx(0.12, abs=1e-3)


def test_it_stands_at_once_and_backs_off_until_its_footprint_is_clear() -> None:
    made, edge = rig(edge=0.5), 0.5
    drive(made, 2.0)
    assert edge - made.robot.truth.x > made.robot.description.footprint_radius


def test_plans_keep_away_from_the_edge_for_a_while() -> None:
    made = rig(edge=0.5)
    drive(made, 2.0)
    edges = made.base.obstacles.points
    assert len(edges) >= 1
    assert min(edges[:, 0]) == pytest.approx(0.5, abs=0.1)
    made.wait(46.0)
    assert len(made.base.obstacles.points) == 0


def test_one_that_sees_no_floor_at_all_has_the_base_go_back_once_and_stand() -> None:
    made = rig()
    made.robot.floor = lambda _: {"front": 0.15}
    made.wait(0.2)
    places = [made.robot.truth.x]
    for _ in range(4):
        outcome, _ = drive(made, 1.0)
        assert outcome.failure is not None
        assert outcome.failure.kind is FailureKind.OVERRIDDEN
        places.append(made.robot.truth.x)
    back = made.robot.description.footprint_radius + 0.06 + AHEAD
    assert -back < places[1] - places[0] < 0.0
    assert places[2:] == pytest.approx([places[1]] * 3, abs=0.03)
    assert "clean the sensor" in outcome.failure.message


def test_a_sill_is_no_edge_and_it_goes_no_faster_than_it_can_stop() -> None:
    outcome, fastest = drive(rig(edge=0.0, depth=0.02), 1.0)
    assert outcome.result is not None
    assert fastest == pytest.approx(FASTEST, abs=0.01)


def test_a_silent_cliff_sensor_makes_it_slow() -> None:
    made = rig()
    made.robot.floor = lambda _: {}
    made.wait(0.2)
    assert made.base.cliffs is not None
    assert made.base.cliffs.deaf == ("front",)
    outcome, fastest = drive(made, -0.2)
    assert outcome.result is not None
    assert 0.0 < fastest < 0.16


def test_one_that_repeats_itself_on_the_way_is_stuck_and_makes_it_slow() -> None:
    made = rig()
    made.robot.stuck = True
    drive(made, 0.0)
    assert made.base.cliffs is not None
    assert made.base.cliffs.deaf == ("front",)
    _, fastest = drive(made, 1.0)
    assert 0.0 < fastest < 0.16


def test_thresholds_that_contradict_each_other_are_refused() -> None:
    with pytest.raises(ValueError, match="expected releases below fires"):
        Excess(fires=0.02, releases=0.03)
