"""On its way a base goes round robots that tell where they are, and waits for its follower."""

from __future__ import annotations

import math

import pytest

from tandem.skills.ports.action import GoalState
from tandem.skills.ports.actions.base import GO, GoGoal
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import Following, RobotWhereabouts, whereabouts
from tests.fakes.sonar_rig import SonarRig

BEHIND = Following(robot="rig", distance=1.3)


class Told:
    """A Pioneer that goes along y = 0, and another robot that tells where it stands."""

    def __init__(self, x: float, y: float, follows: Following | None = None) -> None:
        self.rig = SonarRig(pose=FloorPose(x=-1.5, y=0.0, yaw=0.0))
        self.rig.wait(0.3)
        self.other, self.follows, self.sequence = (x, y), follows, 0
        self.nearest, self.aside = math.inf, 0.0

    def wait(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.1)):
            self.tell()
            self.rig.wait(0.1)
            away = math.dist((self.rig.pose.x, self.rig.pose.y), self.other)
            self.nearest, self.aside = min(away, self.nearest), max(abs(self.rig.pose.y), self.aside)

    def tell(self) -> None:
        x, y = self.other
        message = RobotWhereabouts(
            name="other",
            start="s",
            sequence=self.sequence,
            base_in_map=FloorPose(x=x, y=y, yaw=0.0),
            follows=self.follows,
        )
        whereabouts("other").publish(self.rig.commons, message)
        self.sequence += 1

    def goes(self, within: float, x: float = 1.5) -> float | None:
        """Return after how many robot seconds it is there, None: it is not."""
        statuses = self.rig.send(GO.name, GoGoal(x=x, y=0.0, position_tolerance=0.1))
        for tick in range(round(within / 0.1)):
            self.wait(0.1)
            status = statuses.refresh()
            if status is not None and status.state.terminal:
                assert status.state is GoalState.SUCCEEDED, status.failure
                return tick * 0.1
        return None


@pytest.mark.parametrize(
    ("x", "y", "follows", "berth"),
    [
        (0.0, 0.0, None, 0.95),
        (0.0, 0.5, None, 0.95),
        (0.0, -0.1, BEHIND, 1.1),
        (-0.2, 0.0, BEHIND, 1.1),
    ],
    ids=["in the middle", "half in the way", "its follower", "its follower, near"],
)
def test_it_goes_round_a_robot_with_a_berth(
    x: float, y: float, follows: Following | None, berth: float
) -> None:
    told = Told(x, y, follows)
    assert told.goes(within=30.0) is not None
    assert told.nearest > berth - 0.1


def test_it_goes_straight_past_a_robot_beside_its_way() -> None:
    told = Told(0.0, 1.2)
    assert told.goes(within=12.0) is not None
    assert told.aside < 0.05


def test_what_a_robot_told_a_while_ago_does_not_count() -> None:
    told = Told(0.0, 0.0)
    told.tell()
    told.rig.wait(2.0)
    ended = told.rig.until_ended(told.rig.send(GO.name, GoGoal(x=1.5, y=0.0)), within=12.0)
    assert ended.state is GoalState.SUCCEEDED


def test_it_waits_for_a_follower_that_is_held_up() -> None:
    told = Told(-2.3, 0.0, BEHIND)
    assert told.goes(within=15.0) is None
    assert math.dist((told.rig.pose.x, told.rig.pose.y), told.other) < 1.8
    told.other = (0.0, 0.0)
    told.wait(12.0)
    assert told.rig.pose.x > 1.3


@pytest.mark.parametrize("follows", [None, Following(robot="another", distance=1.3)])
def test_it_waits_for_nobody_else(follows: Following | None) -> None:
    assert Told(-2.3, 0.0, follows).goes(within=12.0) is not None


def test_its_patience_with_a_follower_ends() -> None:
    assert Told(-2.3, 0.0, BEHIND).goes(within=60.0) is not None


def test_before_a_robot_that_it_cannot_go_round_it_stands_for_a_while() -> None:
    told = Told(0.9, 1.9, BEHIND)
    told.rig.pose = FloorPose(x=-1.0, y=2.0, yaw=0.0)
    told.rig.send(GO.name, GoGoal(x=2.0, y=2.0))
    told.wait(15.0)
    assert 0.85 < told.nearest < 1.1


def test_it_goes_back_for_a_follower_that_has_lost_it() -> None:
    told = Told(-2.0, 0.5, BEHIND)
    told.rig.pose = FloorPose(x=0.5, y=0.0, yaw=0.0)
    told.rig.send(GO.name, GoGoal(x=1.5, y=0.0))
    told.wait(8.0)
    assert 1.2 < math.dist((told.rig.pose.x, told.rig.pose.y), told.other) < 1.7


def test_it_leads_its_follower_away_from_where_it_is_to_go() -> None:
    told = Told(1.2, 0.0, BEHIND)
    told.rig.pose = FloorPose(x=0.1, y=0.0, yaw=0.0)
    told.rig.send(GO.name, GoGoal(x=1.5, y=0.0))
    for _ in range(60):  # it follows: 1.3 m behind, in line
        x, y = told.rig.pose.x, told.rig.pose.y
        away = math.dist((x, y), told.other)
        told.other = (x + (told.other[0] - x) * 1.3 / away, y + (told.other[1] - y) * 1.3 / away)
        told.wait(0.1)
    assert told.rig.pose.x < -0.3
    assert ("GoTo", "LeadAway") in {each.doing[:2] for each in told.rig.told}
    assert told.nearest > 1.05


def test_it_passes_on_the_side_where_there_is_room_beside_the_other() -> None:
    told = Told(0.0, 1.4)
    told.rig.pose = FloorPose(x=-1.5, y=1.5, yaw=0.0)
    statuses = told.rig.send(GO.name, GoGoal(x=1.5, y=1.5))
    told.wait(5.0)
    assert told.rig.pose.y < 1.2, "to the north the wall is too near"
    told.wait(20.0)
    status = statuses.refresh()
    assert status is not None
    assert status.state is GoalState.SUCCEEDED
    assert told.nearest > 0.85


def test_beside_a_robot_at_the_wall_it_goes_to_a_place_without_going_to_and_fro() -> None:
    told = Told(-0.24, 1.81, BEHIND)
    told.rig.pose = FloorPose(x=-0.5, y=0.74, yaw=2.5)
    statuses = told.rig.send(GO.name, GoGoal(x=-1.2, y=1.2, position_tolerance=0.1))
    told.wait(10.0)
    status = statuses.refresh()
    assert status is not None
    assert status.state is GoalState.SUCCEEDED
