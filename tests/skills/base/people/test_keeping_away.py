"""Where people will be, what it costs to be there, and how the base keeps away from it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.base.field import DistanceField
from tandem.skills.base.headway import STUCK_AFTER, Headway
from tandem.skills.base.journey_context import Progress
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.people.cost import costs
from tandem.skills.base.people.forecast import Forecast, forecast
from tandem.skills.base.people.person_track import Track
from tandem.skills.base.people.segments import Candidate
from tandem.skills.base.wheels_run import PATIENCE
from tandem.skills.ports.actions.base import DriveGoal, DriveResult
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import SiteBox
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.site import load
from tests.fakes.base_rig import Rig, make_rig
from tests.skills.base.people.test_tracker import LAB, SOUTH, legs

OPEN = DistanceField(-10.0, -10.0, 20.0, np.full((2, 2), 9.0))


def track(x: float, y: float, vx: float, vy: float) -> Track:
    made = Track.of(1, Candidate(x, y, 0.05, paired=True, parts=()))
    made.state[2:] = vx, vy
    made.walked = True
    return made


def ahead(*people: Track, walls: DistanceField = OPEN) -> Forecast:
    return forecast(people, walls)


def test_somebody_alone_goes_straight_on() -> None:
    places, _ = ahead(track(0.0, 0.0, 1.0, 0.0)).at(np.array([2.0]))
    assert places[0, 0] == pytest.approx((2.0, 0.0), abs=0.01)


def test_two_who_meet_swerve_and_a_wall_is_not_walked_through() -> None:
    seen = ahead(track(0.0, 0.05, 1.0, 0.0), track(3.0, -0.05, -1.0, 0.0))
    (one, other), _ = seen.at(np.array([1.5]))
    assert one[0, 1] > 0.07 > -0.07 > other[0, 1]
    slope = np.repeat(np.linspace(20.0, 0.0, 201)[None, :], 201, axis=0)
    wall = DistanceField(-10.0, -10.0, 0.1, slope)
    places, _ = ahead(track(8.5, 0.0, 0.5, 0.0), walls=wall).at(np.array([4.0]))
    assert places[0, 0, 0] < 10.0


def test_it_costs_more_in_front_of_somebody_than_behind_and_more_when_they_are_fast() -> None:
    def cost(x: float, y: float, speed: float) -> float:
        return float(costs(np.array([[x, y]]), np.zeros(1), ahead(track(0.0, 0.0, speed, 0.0)))[0])

    assert cost(0.8, 0.0, 1.0) > 2 * cost(-0.8, 0.0, 1.0)
    assert cost(0.8, 0.0, 1.4) > cost(0.8, 0.0, 0.4) > cost(0.8, 0.0, 0.0)
    assert cost(0.0, 0.5, 1.0) == pytest.approx(cost(0.0, -0.5, 1.0))
    assert cost(0.0, 0.0, 1.0) == pytest.approx(1.0)


def test_a_base_that_waits_for_people_is_not_stuck_until_its_patience_ends() -> None:
    headway = Headway(0.0)
    assert not headway.look(1.0, 0.0, excused=False, waits=False)
    assert not headway.look(1.0, STUCK_AFTER + 1.0, excused=False, waits=True)
    assert headway.look(1.0, PATIENCE + 1.0, excused=False, waits=True)
    assert headway.tired
    other = Headway(0.0)
    other.look(1.0, 0.0, excused=False, waits=False)
    assert other.look(1.0, STUCK_AFTER + 0.1, excused=False, waits=False)
    assert not other.tired


def drive(
    rig: Rig, goal: FloorPose, who: list[tuple[float, float, float]]
) -> tuple[Outcome[DriveResult], float]:
    """Drive with somebody about; return how it ended, and how near the moving base came to them (m).

    Args:
        rig: the base.
        goal: where to.
        who: (seconds, x, y) of one person, who walks from place to place.
    """
    room, nearest = list(rig.robot.boxes), [math.inf]
    times, xs, ys = zip(*who, strict=True)

    def command(seconds: float) -> Command:
        x, y = float(np.interp(seconds, times, xs)), float(np.interp(seconds, times, ys))
        rig.robot.boxes = [*room, *legs(x, y)]
        if rig.robot.linear > 0.02:
            nearest[0] = min(nearest[0], math.dist((x, y), (rig.robot.truth.x, rig.robot.truth.y)))
        return Command.GO_ON

    made = rig.base.drive.run(DriveGoal(poses=(goal,)), "g")
    return rig.run(made, command), nearest[0]


def test_who_walks_across_is_let_pass() -> None:
    rig = make_rig(LAB, SOUTH)
    across = [(0.0, 0.6, -2.3), (0.8, 0.6, -2.3), (3.8, 0.6, -0.5), (60.0, 0.6, -0.5)]
    outcome, nearest = drive(rig, FloorPose(x=2.0, y=-1.6, yaw=0.0), across)
    assert outcome.result is not None, outcome.failure
    assert outcome.result.replans == 0
    assert nearest > 0.3 + 0.25


def test_who_stands_in_the_only_way_for_good_ends_the_drive_and_is_named() -> None:
    rig = make_rig(LAB, FloorPose(x=0.0, y=-2.1, yaw=0.0))
    # Between this and the wall in the south lies the only way to the goal, 1.05 m wide.
    rig.robot.boxes.append(SiteBox(size=(1.9, 0.3, 0.5), centre=(1.9, -1.5, 0.25)))
    who = [(0.0, 1.6, -2.6), (0.6, 1.6, -2.6), (1.4, 1.6, -2.05), (99.0, 1.6, -2.05)]
    outcome, _ = drive(rig, FloorPose(x=2.25, y=-2.1, yaw=0.0), who)
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.BASE_BLOCKED
    assert outcome.failure.evidence["person_x_m"] == pytest.approx(1.6, abs=0.15)
    assert outcome.failure.evidence["person_y_m"] == pytest.approx(-2.05, abs=0.15)
    assert rig.robot.linear == 0.0


def test_a_drive_begins_once_who_stands_in_the_only_way_has_left() -> None:
    rig = make_rig(LAB, FloorPose(x=0.0, y=-2.1, yaw=0.0))
    rig.robot.boxes.append(SiteBox(size=(1.9, 0.3, 0.5), centre=(1.9, -1.5, 0.25)))
    room = list(rig.robot.boxes)
    comes = [(0.0, 1.6, -2.6), (0.6, 1.6, -2.6), (1.4, 1.6, -2.05), (99.0, 1.6, -2.05)]
    assert drive(rig, FloorPose(x=0.1, y=-2.1, yaw=1.5), comes)[0].result is not None
    rig.robot.boxes = room
    leaves = [(0.0, 1.6, -2.05), (3.0, 1.6, -2.05), (5.0, 0.8, -1.2), (99.0, 0.8, -1.2)]
    outcome, _ = drive(rig, FloorPose(x=2.25, y=-2.1, yaw=0.0), leaves)
    assert outcome.result is not None, outcome.failure
    assert outcome.result.replans >= 1


def test_a_way_passes_who_stands_at_a_distance_where_there_is_room() -> None:
    rig, somebody = make_rig(LAB, SOUTH), track(0.4, -2.4, 0.0, 0.0)
    somebody.stood = 5.0
    assert rig.base.people is not None
    rig.base.people._tracks.append(somebody)
    ways = []

    def command(_: float) -> Command:
        ways.append(math.dist((rig.robot.truth.x, rig.robot.truth.y), somebody.place))
        return Command.GO_ON

    goal = DriveGoal(poses=(FloorPose(x=2.0, y=-1.6, yaw=0.0),))
    assert rig.run(rig.base.drive.run(goal, "g"), command).result is not None
    assert min(ways) > 0.95, "straight on it would be 0.8 m"


def test_the_base_brakes_for_people_as_hard_as_it_may(monkeypatch: pytest.MonkeyPatch) -> None:
    rig = make_rig(LAB, SOUTH)
    monkeypatch.setattr(Caution, "safe", lambda *_: False)
    ride = rig.base.drive._ride(Progress())
    ride.wheels.drive = ride.wheels.drive.model_copy(update={"braking": 3.0})
    ride.wheels.linear = 0.5
    rig.wait(0.1)
    next(ride.cycle(0.5, 0.0))
    assert ride.halted
    assert ride.wheels.linear == pytest.approx(0.5 - 3.0 * 0.1)


def test_alone_the_setting_changes_nothing() -> None:
    lasted = []
    for site in (LAB, LAB.model_copy(update={"local_planner": "band"}), load("lab")):
        rig = make_rig(site, SOUTH)
        start = rig.now
        assert rig.run(rig.base.drive.run(DriveGoal(poses=(site.spots[2].pose,)), "g")).result is not None
        lasted.append(rig.now - start)
    assert lasted[:2] == pytest.approx([lasted[2]] * 2)
