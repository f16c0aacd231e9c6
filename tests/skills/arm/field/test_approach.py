"""The approach of an arm of TIAGo++ before a table, its joints following as the sim's controllers do."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tandem.sim.robots.registry import robot_model
from tandem.skills.arm.field.approach_steps import Why
from tandem.skills.arm.field.episode import Episode
from tandem.skills.geometry.poses import compose, distance
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.proximity import Proximity
from tandem.skills.ports.action import GoalState, GoalStatus
from tandem.skills.ports.actions.approach import ApproachPhase, ApproachResult
from tandem.skills.ports.actions.bimanual import Order
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import SetPoint
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.skill import Command
from tests.fakes.field_rig import FieldRig, block, goal

Phase = ApproachPhase
ITEM = 29


@pytest.fixture(scope="module")
def robot() -> RobotDescription:
    return robot_model("tiago_dual").description


@pytest.fixture(scope="module")
def hulls(robot: RobotDescription) -> RobotHulls:
    return load_hulls(robot)


@pytest.fixture
def rig(robot: RobotDescription, hulls: RobotHulls) -> FieldRig:
    rig = FieldRig(robot, hulls)
    rig.put(ITEM, 0.65, 0.12)
    rig.rounds(3)
    return rig


def arrived(rig: FieldRig, status: GoalStatus) -> ApproachResult:
    """Return the result, and check that the hand is at the proximity pose of where the item is now."""
    assert status.state is GoalState.SUCCEEDED, status.failure
    result = ApproachResult.model_validate(status.result)
    grasp = compose(rig.items[ITEM], goal(ITEM).grasps[result.grasp])
    assert distance(rig.tool(), compose(grasp, Pose(position=(-0.10, 0.0, 0.0)))) < 0.01
    return result


def run(rig: FieldRig, each: Callable[[int], None]) -> GoalStatus:
    """Run an approach to its end; ``each`` is told the number of each round before it."""
    rig.send(goal(ITEM))
    for number in range(3000):
        each(number)
        rig.rounds(1)
        status = rig.status()
        if status is not None and status.state not in {
            GoalState.RUNNING,
            GoalState.CANCELING,
            GoalState.PAUSED,
        }:
            return status
    raise AssertionError("it does not end")


def test_it_reaches_an_item_that_stands_soon_and_within_all_limits(rig: FieldRig) -> None:
    began = rig.clocks.seconds
    result = arrived(rig, run(rig, lambda _: None))
    assert result.planned == 0
    assert rig.clocks.seconds - began < 4.0
    assert_within_limits(rig, rig.hardware.sent["arm_left"])


def assert_within_limits(rig: FieldRig, sent: list[SetPoint]) -> None:
    limits = rig.description.group("arm_left").limits
    times = np.array([each.stamp.seconds for each in sent])
    q, v = (np.array([getattr(each, what) for each in sent]) for what in ("positions", "velocities"))
    assert np.allclose(np.diff(times), 0.01), "100 Hz without a gap"
    assert (q >= [each.lower for each in limits]).all()
    assert (q <= [each.upper for each in limits]).all()
    assert (np.abs(v) <= [each.velocity + 1e-6 for each in limits]).all()
    a = np.diff(v, axis=0) / 0.01
    assert (np.abs(a) <= [each.acceleration + 1e-3 for each in limits]).all()
    assert (np.abs(np.diff(a, axis=0)) / 0.01 <= [1.05 * each.jerk for each in limits]).all()
    assert np.allclose(np.diff(q, axis=0), 0.5 * (v[1:] + v[:-1]) * 0.01, atol=1e-4)


@pytest.mark.parametrize("late", [5, 9, 12, 20, 50])
def test_a_process_that_was_late_goes_on_from_where_the_hardware_has_braked(rig: FieldRig, late: int) -> None:
    turned: list[float] = []

    def stalls(number: int) -> None:
        if number in range(60, 200, 35):
            before = rig.hardware.positions.copy()
            rig.stall(late)
            there = rig.hardware.positions.copy()
            rig.rounds(1)
            ahead = np.array([there[name] - at for name, at in before.items()])
            then = np.array([rig.hardware.positions[name] - at for name, at in there.items()])
            turned.append(float(np.min(then * np.sign(ahead))))

    arrived(rig, run(rig, stalls))
    assert min(turned) > -2e-3, "no joint is pulled back"


@pytest.mark.parametrize(("at", "to"), [(60, (0.55, 0.02)), (150, (0.56, 0.25)), (190, (0.62, 0.02))])
def test_it_follows_an_item_that_is_moved_on_the_way(rig: FieldRig, at: int, to: tuple[float, float]) -> None:
    def move(number: int) -> None:
        if number == at:
            rig.put(ITEM, *to)

    arrived(rig, run(rig, move))


def test_it_escapes_around_an_obstacle_and_keeps_clear_of_it(rig: FieldRig, hulls: RobotHulls) -> None:
    rig.others = (*rig.others, block("post", (0.06, 0.06, 0.13), (0.43, 0.16, 0.775)))
    rig.tell()
    result = arrived(rig, run(rig, lambda _: None))
    assert result.escapes > 0
    assert Phase.ESCAPING in rig.phases["arm_left"]
    near = Proximity(hulls, rig.description.group("arm_left").joints, (), rig.obstacles())
    for sent in rig.hardware.sent["arm_left"][::4]:
        positions = {**rig.hardware.positions, **rig.named("arm_left", sent.positions)}
        assert near.hits(hulls.robot.configuration(positions), np.zeros(near.pairs)) is None


@pytest.mark.parametrize(
    ("x", "y", "plans"),
    [(0.7, 0.3, 1), (0.65, 0.12, 2)],
    ids=["and followed", "again where braking would graze"],
)
def test_a_stuck_field_is_given_to_the_planner(
    rig: FieldRig, monkeypatch: pytest.MonkeyPatch, x: float, y: float, plans: int
) -> None:
    rig.put(ITEM, x, y)
    seek, times = Episode._seek, [0]

    def stuck_at_first(self: Episode):  # type: ignore[no-untyped-def]  # noqa: ANN202 - a generator of the skill's
        times[0] += 1
        if times[0] == 1:
            yield from self._ride.next(Phase.FIELD)
            return Why.STUCK
        return (yield from seek(self))

    monkeypatch.setattr(Episode, "_seek", stuck_at_first)
    assert arrived(rig, run(rig, lambda _: None)).planned == plans
    assert Phase.PLANNED in rig.phases["arm_left"]


def test_an_order_holds_sends_back_and_lets_go_on(rig: FieldRig) -> None:
    stood: dict[str, tuple[float, ...]] = {}

    def order(number: int) -> None:
        if 80 <= number < 160 and number % 5 == 0:
            rig.order("left", Order.HOLD)
        if 160 <= number < 400 and number % 5 == 0:
            rig.order("left", Order.BACK, 1)
        if number in {120, 159, 350, 399}:
            stood[str(number)] = rig.tool().position
            if number == 399:
                assert (rig.told().phase, rig.told().at) == (Phase.HELD, 1)
        if number == 400:
            rig.order("left", Order.GO, opened=False)

    start = rig.tool().position
    result = arrived(rig, run(rig, order))
    assert result.stops == 1
    assert np.allclose(stood["120"], stood["159"], atol=2e-3)
    assert np.allclose(stood["350"], stood["399"], atol=1e-4)
    assert np.linalg.norm(np.subtract(stood["399"], start)) < np.linalg.norm(np.subtract(stood["120"], start))
    assert rig.phases["arm_left"][:4] == [Phase.FIELD, Phase.HELD, Phase.BACK, Phase.HELD]


def test_an_open_episode_of_which_nothing_is_heard_any_more_holds(rig: FieldRig) -> None:
    def once(number: int) -> None:
        if number == 60:
            rig.order("left", Order.GO)
        if number == 160:
            assert rig.told().phase is Phase.HELD
            rig.order("left", Order.GO, opened=False)

    arrived(rig, run(rig, once))


@pytest.mark.parametrize("sent_back", [False, True])
def test_told_to_stop_it_comes_to_rest_and_gives_up(rig: FieldRig, *, sent_back: bool) -> None:
    def order(number: int) -> None:
        if number >= 80 and number % 5 == 0:
            back = sent_back and number < 250
            rig.order("left", Order.BACK if back else Order.STOP, 1 if back else 0)

    status = run(rig, order)
    assert status.failure is not None
    assert status.failure.kind is FailureKind.ARMS_CROSSING
    stood = rig.tool()
    rig.rounds(30)
    assert distance(stood, rig.tool()) < 1e-5


def test_a_cancel_ends_at_rest(rig: FieldRig) -> None:
    status = run(rig, lambda number: rig.command(Command.CANCEL) if number == 80 else None)
    assert status.state is GoalState.CANCELED
    stood = rig.tool()
    rig.rounds(30)
    assert distance(stood, rig.tool()) < 1e-5


def test_a_pause_stands_and_a_resume_gets_there(rig: FieldRig) -> None:
    stood: list[Pose] = []

    def pause(number: int) -> None:
        if number == 80:
            rig.command(Command.PAUSE)
        if number in {150, 199}:  # the hardware has closed in on the last set-point by then
            stood.append(rig.tool())
        if number == 200:
            rig.command(Command.RESUME)

    arrived(rig, run(rig, pause))
    assert distance(*stood) < 1e-4


def test_a_cube_that_is_knocked_over_on_the_way_is_approached_as_it_lies(rig: FieldRig) -> None:
    status = run(rig, lambda number: rig.topple(ITEM) if number == 80 else None)
    assert status.state is GoalState.SUCCEEDED


@pytest.mark.parametrize(
    ("event", "kind"),
    [
        (lambda rig: rig.forget(), FailureKind.ITEM_GONE),
        (lambda rig: rig.hold_fast(), FailureKind.ARM_STOPPED),
        (lambda rig: rig.stop(), FailureKind.HARDWARE_STOPPED),
        (lambda rig: rig.put(ITEM, 1.4, 0.1), FailureKind.NO_IK),
    ],
)
def test_what_goes_wrong_on_the_way_has_its_kind(
    rig: FieldRig, event: Callable[[FieldRig], None], kind: FailureKind
) -> None:
    status = run(rig, lambda number: event(rig) if number == 80 else None)
    assert status.failure is not None
    assert status.failure.kind is kind
    assert not rig.told().active


def test_an_item_that_is_not_seen_for_a_moment_is_approached_where_it_is_seen_again(rig: FieldRig) -> None:
    def carried_elsewhere(number: int) -> None:
        if number == 60:
            rig.forget()
        if number == 160:
            rig.put(ITEM, 0.62, 0.22)

    arrived(rig, run(rig, carried_elsewhere))


def test_an_item_out_of_reach_is_no_ik_before_anything_moves(rig: FieldRig) -> None:
    rig.put(ITEM, 1.4, 0.1)
    stood = rig.tool()
    status = run(rig, lambda _: None)
    assert status.failure is not None
    assert status.failure.kind is FailureKind.NO_IK
    assert distance(stood, rig.tool()) < 1e-6


def test_the_same_goal_gives_the_same_set_points(robot: RobotDescription, hulls: RobotHulls) -> None:
    runs = []
    for _ in range(2):
        again = FieldRig(robot, hulls)
        again.put(ITEM, 0.6, 0.2)
        again.rounds(3)
        run(again, lambda _: None)
        runs.append([each.model_dump_json() for each in again.hardware.sent["arm_left"]])
    assert runs[0] == runs[1]


def test_an_approach_that_nobody_sees_ends_as_overridden_with_the_arm_at_rest(rig: FieldRig) -> None:
    rig.send(goal(ITEM))
    rig.until(GoalState.RUNNING)
    rig.rounds(60)
    rig.hardware.silent = True
    status = rig.ended()
    failure = status.failure
    assert failure is not None
    assert (failure.kind, failure.reason.kind) == (FailureKind.OVERRIDDEN, FailureKind.HARDWARE_LOST)
    sent, stood = len(rig.hardware.sent["arm_left"]), dict(rig.hardware.positions)
    rig.rounds(50)
    assert len(rig.hardware.sent["arm_left"]) == sent, "nothing of the approach is sent any more"
    assert rig.hardware.positions == stood
