"""Ways: free, checked, deterministic; and why there is none."""

import math

import numpy as np
import pytest

from tandem.skills.base.floor import FloatArray
from tandem.skills.base.map import build_map
from tandem.skills.base.path import Path
from tandem.skills.base.planner import CHECK_STEP, SLACK, Clearances, Planner
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tests.fakes.planar_robot import describe

LAB = load("lab")
MAP = build_map(LAB, describe())
NEEDED = 0.40
NOTHING: FloatArray = np.empty((0, 2))


def plan(
    start: FloorPose, goal: FloorPose, obstacles: FloatArray = NOTHING, needed: float = NEEDED
) -> Planner:
    planner = Planner(Clearances(MAP.plan, needed, start), obstacles, goal)
    for _ in planner.slices():
        pass
    return planner


SPOTS = [LAB.home, *(spot.pose for spot in LAB.spots)]


@pytest.mark.parametrize("goal", SPOTS)
@pytest.mark.parametrize("start", SPOTS[::3])
def test_every_spot_is_reached_with_room_to_spare(start: FloorPose, goal: FloorPose) -> None:
    path = plan(start, goal).path
    assert path is not None
    assert tuple(path.points[0]) == (start.x, start.y)
    assert tuple(path.points[-1]) == (goal.x, goal.y)
    along = path.sampled(0.0, path.length, CHECK_STEP)[1]
    assert MAP.plan.at(along).min() >= NEEDED - SLACK


def test_the_way_round_the_table_is_not_much_longer_than_it_must_be() -> None:
    path = plan(FloorPose(x=1.0, y=-0.6, yaw=0.0), FloorPose(x=1.0, y=1.6, yaw=0.0)).path
    assert path is not None
    # The taut string: tangents to circles of 0.4 m about two corners of the table, two arcs, one side.
    to_corner = math.hypot(0.62, 0.65)
    arc = math.pi / 2 - math.atan2(0.65, 0.62) + math.asin(NEEDED / to_corner)
    shortest = 2 * math.sqrt(to_corner**2 - NEEDED**2) + 2 * arc * NEEDED + 0.9
    assert shortest - 0.02 < path.length < 1.25 * shortest


def test_an_obstacle_that_no_map_knows_is_gone_round() -> None:
    start, goal = FloorPose(x=-1.0, y=-1.6, yaw=0.0), FloorPose(x=2.0, y=-1.6, yaw=0.0)
    stone = np.array([[0.5, -1.6]])
    path = plan(start, goal, stone).path
    assert path is not None
    along = path.sampled(0.0, path.length, CHECK_STEP)[1]
    assert np.hypot(*(along - stone[0]).T).min() >= NEEDED - SLACK
    assert len(plan(start, goal).path.points) == 2  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("goal", "why"),
    [
        (FloorPose(x=1.0, y=0.5, yaw=0.0), "too close"),
        (FloorPose(x=9.0, y=0.0, yaw=0.0), "too close"),
    ],
)
def test_a_goal_that_is_taken_is_refused_and_the_reason_told(goal: FloorPose, why: str) -> None:
    planner = plan(LAB.home, goal)
    assert planner.path is None
    assert why in planner.problem


def test_a_closed_wall_leaves_no_way() -> None:
    wall = np.stack((np.full(300, 0.0), np.linspace(-3.0, 3.0, 300)), axis=1)
    planner = plan(LAB.home, FloorPose(x=1.0, y=-1.6, yaw=0.0), wall)
    assert planner.path is None
    assert planner.problem == "no way leads there"


def test_a_start_too_close_to_something_may_be_left() -> None:
    start = FloorPose(x=0.06, y=0.5, yaw=0.0)
    assert MAP.plan.at_point(start.x, start.y) < NEEDED
    assert plan(start, FloorPose(x=-1.0, y=-1.5, yaw=0.0)).path is not None


def test_the_same_question_has_the_same_answer() -> None:
    first, second = (plan(SPOTS[1], SPOTS[4]).path for _ in range(2))
    assert first is not None
    assert second is not None
    assert np.array_equal(first.points, second.points)


def test_a_path_knows_where_one_is_on_it() -> None:
    path = Path(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]]))
    assert path.length == pytest.approx(3.0)
    ((at, angle),) = path.corners
    assert (at, angle) == pytest.approx((1.0, math.pi / 2))
    assert path.project(0.6, 0.1, 0.2) == pytest.approx(0.6)
    assert path.project(1.1, 0.5, 0.9) == pytest.approx(1.5)
    assert path.at(3.5) == pytest.approx((1.0, 2.5))


def test_a_base_that_rolls_back_a_little_is_not_at_the_next_corner() -> None:
    path = Path(np.array([[0.0, 0.0], [0.4, 0.0], [0.4, 1.0]]))
    assert path.project(-0.001, 0.0, 0.001) == pytest.approx(0.001)


def test_the_last_piece_is_long_enough_to_arrive_straight() -> None:
    path = plan(FloorPose(x=-0.21, y=0.5, yaw=0.0), FloorPose(x=-1.93, y=-0.98, yaw=math.pi)).path
    assert path is not None
    assert math.dist(path.points[-2], path.points[-1]) > 0.4
