"""Every branch of the fetch, with mocked skills: these skill results, that path and outcome."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.action import node_of
from tandem.skills.ports.actions.base import RotateGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.world import HeldItem, ItemFact, Placed
from tandem.skills.site import load
from tandem.skills.testing.mock_skill import Fault

SITE = load("lab")
TAG = Pose(position=(0.9, 0.1, 0.74), orientation=from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0)))
LOOKS_AT_A_PLACE = 13
SPOTS = len(SITE.spots)


def failing(kind: FailureKind) -> Fault:
    return Fault(failure=Failure(kind=kind, message=f"as the test asked: {kind}"))


def bench(**options: object) -> TreeBench:
    return TreeBench(SITE, **{"items": {29: TAG}, **options})  # type: ignore[arg-type]


@dataclass(frozen=True)
class Case:
    """Faults by action and call; what the task must end with, and how often actions were run."""

    faults: dict[str, dict[int, Fault]] = field(default_factory=dict)
    seen_at_look: int = 1
    status: Status = Status.SUCCESS
    kind: FailureKind | None = None
    calls: dict[str, int] = field(default_factory=dict)
    last: str = "deliver and go home: verdict"


K = FailureKind
CASES = {
    "item in view": Case(calls={"base/rotate": 0, "perception/look": 3, "base/drive": 3}),
    "seen after two turns": Case(seen_at_look=3, calls={"base/rotate": 2}),
    "seen after a full turn": Case(seen_at_look=13, calls={"base/rotate": 12, "base/drive": 3}),
    "seen from the first spot": Case(seen_at_look=14, calls={"base/rotate": 12, "base/drive": 4}),
    "seen from the second spot, turned once": Case(
        seen_at_look=2 * LOOKS_AT_A_PLACE + 2, calls={"base/rotate": 25, "base/drive": 5}
    ),
    "seen nowhere": Case(
        seen_at_look=10_000,
        status=Status.FAILURE,
        kind=K.ITEM_NOT_FOUND,
        calls={"base/rotate": 12 * (1 + SPOTS), "base/drive": SPOTS + 1, "gripper_left/grip": 0},
    ),
    "the first spot can't be reached": Case(
        faults={"base/drive": {1: failing(K.BASE_NO_PATH)}}, seen_at_look=14, calls={"base/drive": 5}
    ),
    "a turn fails": Case(faults={"base/rotate": {1: failing(K.BASE_BLOCKED)}}, seen_at_look=2),
    "the camera is silent: turning would not help": Case(
        faults={"perception/look": {n: failing(K.CAMERA_SILENT) for n in range(1, 6)}},
        status=Status.FAILURE,
        kind=K.CAMERA_SILENT,
        calls={"base/rotate": 0, "perception/look": 5},
    ),
    "not localised": Case(
        faults={"base/localise": {n: failing(K.NOT_LOCALISED) for n in (1, 2, 3)}},
        status=Status.FAILURE,
        kind=K.NOT_LOCALISED,
        calls={"base/drive": 0},
        last="request: once more: at most 2",
    ),
    "the left arm reaches from nowhere": Case(
        faults={"arm_left/survey": {1: failing(K.ITEM_UNREACHABLE), 2: failing(K.ITEM_UNREACHABLE)}},
        calls={"arm_left/move": 0, "arm_right/move": 8},
    ),
    "only another face can be reached": Case(
        faults={
            "arm_left/survey": {1: failing(K.ITEM_UNREACHABLE)},
            "arm_right/survey": {1: failing(K.ITEM_UNREACHABLE)},
        },
        calls={"arm_right/survey": 1, "arm_left/move": 8},
    ),
    "out of reach, and in reach at a second try": Case(
        faults={
            f"arm_{side}/survey": {n: failing(K.ITEM_UNREACHABLE) for n in (1, 2, 3)}
            for side in ("left", "right")
        },
        calls={"perception/look": 4, "world/edit": 5},
    ),
    "an answer comes late": Case(faults={"base/drive": {1: Fault(late=5.0)}}),
    "a skill hangs once": Case(
        faults={"gripper_left/grip": {1: Fault(hangs=True)}}, calls={"gripper_left/grip": 6}
    ),
    "a skill refuses a goal once": Case(
        faults={"base/drive": {1: Fault(failure=Failure(kind=K.BASE_HELD, message="arm out"), refuses=True)}},
        calls={"base/drive": 4},
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_branch(case: Case) -> None:
    it = bench(seen_at_look=case.seen_at_look)
    for action, faults in case.faults.items():
        it.robot.faults(action).update(faults)

    assert it.run("fetch", {"item": 29}) is case.status

    failure = it.failure()
    if case.kind is not None:
        assert failure is not None
        assert case.kind in {each.kind for each in failure.chain()}
    assert {action: it.robot.calls_of(action) for action in case.calls} == case.calls
    assert it.path()[-1] == case.last


def test_the_robot_goes_home_after_a_failure() -> None:
    it = bench(seen_at_look=10_000)
    it.run("fetch", {"item": 29})
    assert it.robot.base == SITE.home


def test_turns_are_thirty_degrees_clockwise() -> None:
    it = bench(seen_at_look=3)
    it.run("fetch", {"item": 29})
    turns = [goal for _, goal in it.robot.calls if isinstance(goal, RotateGoal)]
    assert [round(turn.angle, 4) for turn in turns] == [-0.5236, -0.5236]


def test_the_steps_of_a_pick_come_in_the_papers_order() -> None:
    it = bench()
    it.run("fetch", {"item": 29})
    steps = ["drive to item", "pre-grasp", "open", "add to scene", "grasp", "close", "attach", "retract"]
    assert [name for name in it.path() if name in steps] == steps


def test_the_steps_of_a_place_come_in_the_papers_order() -> None:
    it = bench()
    it.run("fetch", {"item": 29})
    steps = ["drive to slot", "put down", "let go", "detach", "withdraw", "close empty", "remove from scene"]
    assert [name for name in it.path() if name in steps] == steps


def test_an_item_in_the_hand_is_not_searched_for() -> None:
    it = bench(localised=True)
    it.robot.hands["right"] = 29
    it.robot.believe(held=(HeldItem(side="right", item=29, item_in_tool=IDENTITY),))
    assert it.run("fetch", {"item": 29}) is Status.SUCCESS
    assert "look here" not in it.path()
    assert it.robot.calls_of("arm_right/move") > 0


def test_an_item_in_the_depot_is_left_there() -> None:
    it = bench(localised=True)
    it.robot.believe(placed=(Placed(item=29, depot="depot", slot=0),))
    assert it.run("fetch", {"item": 29}) is Status.SUCCESS
    assert it.robot.calls_of("gripper_left/grip") == 0


def test_a_second_item_gets_another_slot() -> None:
    it = bench(localised=True)
    it.robot.believe(placed=(Placed(item=42, depot="depot", slot=0),))
    it.run("fetch", {"item": 29})
    assert [each.slot for each in it.robot.world.placed if each.item == 29] == [1]


def test_a_full_depot_is_said_before_anything_moves() -> None:
    it = bench(localised=True)
    slots = range(len(SITE.depots[0].slots))
    it.robot.believe(placed=tuple(Placed(item=100 + slot, depot="depot", slot=slot) for slot in slots))
    assert it.run("fetch", {"item": 29}) is Status.FAILURE
    assert [failure.kind for failure in it.context.failures.all] == [K.DESTINATION_FULL]
    assert it.robot.calls == []


def test_full_hands_are_said_before_anything_moves() -> None:
    it = bench(localised=True)
    it.robot.believe(held=(HeldItem(side="left", item=42, item_in_tool=IDENTITY),))
    assert it.run("fetch", {"item": 29, "arm": "left"}) is Status.FAILURE
    assert [failure.kind for failure in it.context.failures.all] == [K.HAND_FULL]
    assert it.robot.calls == []


def test_the_other_arm_is_taken_when_one_is_full() -> None:
    it = bench(localised=True)
    it.robot.believe(held=(HeldItem(side="left", item=42, item_in_tool=IDENTITY),))
    assert it.run("fetch", {"item": 29}) is Status.SUCCESS
    assert it.robot.calls_of("gripper_right/grip") > 0


LEAVES = (
    "localise",
    "look here",
    "drive to item",
    "pre-grasp",
    "close",
    "retract",
    "put down",
    "let go",
    "home: drive",
)


@pytest.mark.parametrize("leaf", LEAVES)
def test_a_cancel_brings_every_skill_to_rest(leaf: str) -> None:
    it = bench(duration=0.05)
    root = it.start("fetch", {"item": 29})
    running = False
    for _ in range(5000):
        it.step()
        running = any(node.name == leaf and node.status is Status.RUNNING for node in root.iterate())
        if running:
            break
    assert running
    assert it.interrupt()
    assert all(node.status is not Status.RUNNING for node in root.iterate())
    assert it.context.resources.holder("base") is None
    assert it.context.resources.holder("arm_left") is None


def test_another_task_may_take_over_while_it_searches_and_at_no_other_time() -> None:
    it = bench(seen_at_look=5, duration=0.05)
    it.start("fetch", {"item": 29})
    open_in = set()
    while it.step() is Status.RUNNING:
        if it.context.interruptible:
            open_in.add(it.context.progress.phase)
    assert open_in == {"search"}


def test_the_hand_that_holds_the_item_puts_it_down() -> None:
    it = bench(localised=True)
    it.robot.hands["right"] = 29
    it.robot.believe(held=(HeldItem(side="right", item=29, item_in_tool=IDENTITY),))
    it.run("fetch", {"item": 29})
    assert it.robot.calls_of("arm_left/survey") == 0
    assert it.robot.calls_of("gripper_right/grip") == 2


def test_progress_never_runs_backwards() -> None:
    it = bench(seen_at_look=20)
    it.start("fetch", {"item": 29})
    fractions = []
    while it.step() is Status.RUNNING:
        fractions.append(it.context.progress.fraction)
    assert fractions == sorted(fractions)
    assert it.context.progress.fraction == 1.0


def test_names_are_unique() -> None:
    it = bench()
    names = [node.name for node in it.start("fetch", {"item": 29}).iterate()]
    assert sorted(names) == sorted(set(names))


def test_an_item_that_has_fallen_over_is_told() -> None:
    run = bench(items={29: Pose(position=TAG.position)})
    assert run.run("fetch", {"item": 29}) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert failure.kind is FailureKind.ITEM_UNREACHABLE
    assert "item 29 (tea) has fallen over" in failure.message


OTHER_PLACE = Pose(position=(0.9, 0.9, 0.74), orientation=TAG.orientation)


def with_two(first: Pose, second: Pose) -> TreeBench:
    it = bench(localised=True)
    one, other = (
        ItemFact(
            item=29,
            size=(0.06, 0.06, 0.06),
            tag_in_map=tag,
            seen=it.robot.now,
            quality=1.0,
            position_sigma=0.002,
        )
        for tag in (first, second)
    )
    it.robot.believe(items=(one,), doubles=(other,))
    return it


def test_which_of_two_is_meant_is_not_guessed() -> None:
    it = with_two(TAG, OTHER_PLACE)
    assert it.run("fetch", {"item": 29}) is Status.FAILURE
    failure = it.failure()
    assert failure is not None
    assert failure.kind is FailureKind.ITEM_AMBIGUOUS
    assert "(0.90, 0.10), (0.90, 0.90)" in failure.message
    assert it.robot.calls_of("gripper_left/grip") == it.robot.calls_of("gripper_right/grip") == 0


def test_the_one_of_two_that_the_request_locates_is_fetched() -> None:
    it = with_two(OTHER_PLACE, TAG)
    assert it.run("fetch", {"item": 29, "near": (0.8, 0.3)}) is Status.SUCCESS
    (left,) = it.robot.world.doubles
    assert left.tag_in_map == OTHER_PLACE


def test_one_that_is_in_view_elsewhere_is_not_the_one_that_is_located() -> None:
    it = bench()
    assert it.run("fetch", {"item": 29, "near": (-1.0, 2.7)}) is Status.FAILURE
    assert it.context.failures.all[0].kind is FailureKind.ITEM_NOT_FOUND
    assert "not within 0.5 m" in it.context.failures.all[0].message
    assert it.robot.calls_of("gripper_left/grip") == 0


BESIDE = (
    ("drive to item", "turn head to item"),
    ("pre-grasp", "open"),
    ("drive to slot", "turn head to slot"),
)


@pytest.mark.parametrize(("long", "short"), [*BESIDE, ("after place: tuck arm", "close empty")])
def test_what_moves_something_else_goes_on_beside(long: str, short: str) -> None:
    it = bench(duration=0.2)
    order: list[tuple[str, str]] = []
    it.robot.watch = lambda what, _, goal_id, __: order.append((what, node_of(goal_id)))
    assert it.run("fetch", {"item": 29}) is Status.SUCCESS
    ends = [order.index(("ended", name)) for name in (long, short)]
    assert max(order.index(("began", name)) for name in (long, short)) < min(ends)


def test_a_head_that_can_not_turn_ahead_costs_nothing_but_the_turn() -> None:
    it = bench()
    it.robot.faults("perception/turn_head").update({n: failing(K.NOT_READY) for n in (1, 2, 3)})
    assert it.run("fetch", {"item": 29}) is Status.SUCCESS
    assert it.robot.calls_of("base/drive") == 3


def test_an_arm_comes_to_its_end_before_a_stuck_gripper_is_dealt_with() -> None:
    it = bench(duration=0.2)
    it.robot.faults("gripper_left/grip")[1] = failing(K.GRIPPER_STUCK)
    ended: list[str] = []
    it.robot.watch = lambda what, _, goal_id, __: ended.append(node_of(goal_id)) if what == "ended" else None
    assert it.run("fetch", {"item": 29}) is Status.SUCCESS
    assert max(ended.index("open"), ended.index("pre-grasp")) < ended.index("get: draw back: tuck arm")
