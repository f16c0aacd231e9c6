"""Every branch of the tasks of two arms, with mocked skills: these skill results, that order and outcome."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.hand_worlds import CARTON, CROSSED, FAR, ITEMS, LEFT, RIGHT, drop
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.actions.bimanual import TwoHands, TwoHandsGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import HeldItem
from tandem.skills.site import load
from tandem.skills.testing.mock_arms import STRETCHED
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.registry import discover

K = FailureKind
SITE: Site = load("bimanual")
TWO: dict[str, object] = {"left": LEFT, "right": RIGHT}


def failing(kind: FailureKind) -> Fault:
    return Fault(failure=Failure(kind=kind, message=f"as the test asked: {kind}"))


def bench(items: dict[int, Pose] | None = None) -> TreeBench:
    return TreeBench(SITE, items=dict(ITEMS) if items is None else items, step=0.05)


GRASPS = ("left arm: grasp", "right arm: grasp")
LATE = Fault(late=1.0)
SHOWS = "show the item"


@dataclass(frozen=True)
class Case:
    """What is asked, what goes wrong at which leaf, and what must come of it."""

    request: dict[str, object] = field(default_factory=dict)
    faults: dict[str | tuple[str, int], Fault] = field(default_factory=dict)
    status: Status = Status.SUCCESS
    kind: FailureKind | None = None
    failed: str = ""
    """Which arms the failure names."""
    held: tuple[int, ...] = (LEFT, RIGHT)
    first: str = ""
    """The leaf that must have ended before all others of ``after``."""
    after: tuple[str, ...] = ()


CASES = {
    "left first": Case(
        faults={"right arm: approach": LATE}, first="left arm: hand is full?", after=("right arm: grasp",)
    ),
    "right first": Case(
        faults={"left arm: approach": LATE}, first="right arm: hand is full?", after=("left arm: grasp",)
    ),
    "both at once": Case(first="left arm: hand is full?", after=("right arm: grasp",)),
    "faithful: the other waits till the first is safe": Case(
        request={"mode": "faithful"}, first="left arm: to safety", after=("right arm: grasp",)
    ),
    "together: who is first waits": Case(
        request={"parallel_pick": True},
        faults={"left arm: approach": LATE},
        first="left arm: approach",
        after=GRASPS,
    ),
    "one after the other": Case(
        request={"sequential": True}, first="left arm: to safety", after=("right arm: approach",)
    ),
    "crossing once: held, and gone on": Case(faults={("left arm: approach", 1): Fault(late=5.0)}),
    "crossing till home: the other is long safe": Case(
        faults={("left arm: approach", 1): Fault(late=30.0)},
        first="right arm: to safety",
        after=("left arm: grasp",),
    ),
    "nobody ruled: stopped twice, then on": Case(
        faults={("left arm: approach", n): failing(K.ARMS_CROSSING) for n in (1, 2)}
    ),
    "the item moves at the grasp": Case(faults={("left arm: grasp", 1): failing(K.ITEM_GONE)}),
    "it moves at each grasp": Case(
        faults={"left arm: grasp": failing(K.ITEM_GONE)},
        status=Status.FAILURE,
        kind=K.ITEM_GONE,
        failed="left arm",
        held=(RIGHT,),
    ),
    "the hand closes on nothing once": Case(faults={("right arm: close", 1): failing(K.GRASP_EMPTY)}),
    "the left arm fails on its way": Case(
        faults={"left arm: approach": failing(K.INVALID_GOAL)},
        status=Status.FAILURE,
        kind=K.INVALID_GOAL,
        failed="left arm",
        held=(RIGHT,),
    ),
    "together: the left arm fails before": Case(
        request={"parallel_pick": True},
        faults={"left arm: approach": failing(K.INVALID_GOAL)},
        status=Status.FAILURE,
        kind=K.INVALID_GOAL,
        failed="left arm and right arm",
        held=(),
    ),
    "together: the right arm fails after": Case(
        request={"parallel_pick": True},
        faults={"right arm: close": failing(K.INVALID_GOAL)},
        status=Status.FAILURE,
        kind=K.INVALID_GOAL,
        failed="right arm",
        held=(LEFT,),
    ),
    "planned once: a moved item is missed": Case(
        request={"method": "rrtconnect"},
        faults={"left arm: close": failing(K.GRASP_EMPTY)},
        status=Status.FAILURE,
        kind=K.GRASP_EMPTY,
        failed="left arm",
        held=(RIGHT,),
    ),
    "planned again: a moved item is followed": Case(
        request={"method": "rrtconnect_replan"}, faults={("left arm: grasp", 1): failing(K.ITEM_GONE)}
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_each_branch(case: Case) -> None:
    run = bench()
    run.robot.leaf_faults.update(case.faults)
    assert run.run("pick_two", {**TWO, **case.request}) is case.status
    assert sorted(hand.item for hand in run.robot.world.held) == sorted(case.held)
    failure = run.failure()
    if case.kind is not None:
        assert failure is not None
        assert (failure.kind, failure.evidence["failed"]) == (case.kind, case.failed)
    if case.first:
        path = run.path()
        assert all(path.index(case.first) < path.index(leaf) for leaf in case.after)
    assert run.robot.busy == ()
    assert run.context.quiet


def test_crossed_items_are_in_reach_and_far_ones_are_refused_before_an_arm_moves() -> None:
    assert bench(dict(CROSSED)).run("pick_two", TWO) is Status.SUCCESS
    run = bench(dict(FAR))
    assert run.run("pick_two", TWO) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert (failure.kind, failure.evidence["item"], failure.evidence["zone"]) == (
        K.ITEM_UNREACHABLE,
        LEFT,
        "U",
    )
    assert not [goal for _, goal in run.robot.calls if isinstance(goal, MoveGoal)]


def test_an_arm_that_hides_the_items_comes_in_before_it_is_said_that_they_are_not_there() -> None:
    run = TreeBench(SITE, items=dict(ITEMS), step=0.05, seen_at_look=4)
    run.robot.put_arms(STRETCHED)
    assert run.run("pick_two", TWO) is Status.SUCCESS
    path = run.path()
    assert path.index("look: tuck arm") < path.index("left arm: approach")


def test_a_hand_that_is_full_is_found_before_an_arm_moves() -> None:
    run = bench()
    run.robot.believe(held=(HeldItem(side="right", item=LEFT, item_in_tool=IDENTITY),))
    assert run.run("pick_two", TWO) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert failure.kind is K.HAND_FULL
    assert run.robot.calls_of("arm_left/approach") == 0


@pytest.mark.parametrize(
    ("leaf", "held"),
    [
        ("left arm: approach", (RIGHT,)),
        ("left arm: grasp", ()),
        ("left arm: lift", (LEFT,)),
        ("right arm: grasp", (LEFT,)),
        ("right arm: lift", (LEFT, RIGHT)),
    ],
)
def test_a_cancel_brings_all_to_rest_and_what_is_held_stays(leaf: str, held: tuple[int, ...]) -> None:
    run = bench()
    run.robot.leaf_faults[leaf] = Fault(hangs=True)
    run.start("pick_two", {**TWO, "mode": "faithful"})
    for _ in range(400):
        run.step()
        if any(node.name == leaf for node in run.running_leaves()) and run.robot.busy:
            break
    for _ in range(20):
        run.step()
    assert run.interrupt()
    assert sorted(hand.item for hand in run.robot.world.held) == sorted(held)
    assert run.robot.busy == ()
    assert [run.context.resources.holder(name) for name in ("arm_left", "arm_right", "head")] == [None] * 3


@pytest.mark.parametrize(
    ("task", "request_", "path"),
    [
        ("pick_two", {"left": RIGHT, "right": LEFT}, "left"),
        ("pick_two", {"left": LEFT, "right": LEFT}, "right"),
        ("pick_two", {"left": CARTON, "right": RIGHT}, "left"),
        ("pick_two", {"left": 7, "right": RIGHT}, "left"),
        ("pick_two", {**TWO, "parallel_pick": True, "sequential": True}, "parallel_pick"),
        ("pick", {"item": LEFT, "arm": "right"}, "arm"),
        ("pick", {"item": CARTON}, "item"),
        ("pick_both_hands", {"item": LEFT}, "item"),
        ("pick_both_hands", {"item": 7}, "item"),
        ("pick_both_hands", {"item": CARTON, "parallel_pick": False}, "parallel_pick"),
    ],
)
def test_contradictions_are_answered_with_their_path(
    task: str, request_: dict[str, object], path: str
) -> None:
    kind = discover()[task]
    assert path in [each.path for each in kind.problems(kind.request.model_validate(request_), SITE)]


@pytest.mark.parametrize(("item", "y", "side"), [(3, 0.2, "left"), (3, -0.2, "right"), (3, 0.02, "left")])
def test_of_two_hands_the_nearer_one_picks(item: int, y: float, side: str) -> None:
    both = SITE.items[0].model_copy(update={"item": item, "hands": ("left", "right")})
    site = SITE.model_copy(update={"items": (*SITE.items, both)})
    near = ITEMS[LEFT].model_copy(update={"position": (0.565, y, 0.745)})
    run = TreeBench(site, items={item: near}, step=0.05)
    assert run.run("pick", {"item": item}) is Status.SUCCESS
    assert [hand.side for hand in run.robot.world.held] == [side]


def test_both_hands_lift_hold_put_down_and_let_go() -> None:
    run = bench()
    assert run.run("pick_both_hands", {"item": CARTON, "hold": 1.0}) is Status.SUCCESS
    goals = [goal for _, goal in run.robot.calls if isinstance(goal, TwoHandsGoal)]
    assert [goal.do for goal in goals] == [TwoHands.SQUEEZE, TwoHands.MOVE, TwoHands.MOVE, TwoHands.RELEASE]
    up, down = (goal.to for goal in goals if goal.to is not None)
    assert math.isclose(up.position[2] - down.position[2], 0.10)
    assert "hold it" in run.path()


@pytest.mark.parametrize(
    ("leaf", "kind", "puts_down"),
    [
        ("left arm: approach", K.INVALID_GOAL, False),
        ("both hands: squeeze", K.INVALID_GOAL, False),
        ("both hands: lift together", K.TILTED, True),
        ("both hands: put down", K.INVALID_GOAL, True),
    ],
)
def test_what_is_between_two_hands_is_not_dropped(leaf: str, kind: FailureKind, *, puts_down: bool) -> None:
    run = bench()
    run.robot.leaf_faults[leaf] = failing(kind)
    assert run.run("pick_both_hands", {"item": CARTON}) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert failure.kind is kind
    assert ("both hands: at last: put down" in run.path()) is puts_down
    assert ("both hands: at last: let go" in run.path()) is puts_down


def falls_out(run: TreeBench, side: HandName, *, at: str) -> None:
    """Have a hand lose its item, once, when a leaf begins; it falls back to where it stood."""

    def happens(robot: MockRobot) -> None:
        del run.events[at]
        drop(side, robot)

    run.events[at] = happens


def test_what_falls_out_on_the_way_to_safety_is_picked_again() -> None:
    run = bench()
    falls_out(run, "left", at="left arm: to safety")
    assert run.run("pick_two", TWO) is Status.SUCCESS
    assert sorted(hand.item for hand in run.robot.world.held) == [LEFT, RIGHT]
    assert run.path().count("left arm: close") == 2


def test_what_falls_out_while_the_other_arm_picks_is_told() -> None:
    run = bench()
    run.robot.leaf_faults["right arm: approach"] = LATE
    falls_out(run, "left", at="right arm: to safety")
    assert run.run("pick_two", TWO) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert failure.kind is K.GRASP_LOST
    assert failure.where == "left arm: in hand at the end?"
    assert [hand.item for hand in run.robot.world.held] == [RIGHT]


@pytest.mark.parametrize("up", [True, False], ids=["it can", "it can not"])
def test_a_hand_rises_before_it_goes_when_its_item_is_out_of_sight(*, up: bool) -> None:
    """What is gone may stand beside the hand; no way up is no reason to stay."""
    run = bench()
    run.robot.leaf_faults["left arm: grasp", 1] = failing(K.ITEM_GONE)
    run.events["left arm: grasp"] = lambda robot: robot.believe(items=())
    if not up:
        run.robot.leaf_faults["left arm: show the item: rise"] = failing(K.NO_PATH)
    run.run("pick_two", TWO)
    path = run.path()
    grasp, rises, shows = (
        path.index(f"left arm: {leaf}") for leaf in ("grasp", "show the item: rise", SHOWS)
    )
    assert grasp < rises < shows


def test_what_fails_as_a_hand_is_brought_home_is_not_why_its_pick_failed() -> None:
    run = bench()
    run.robot.leaf_faults["left arm: approach"] = failing(K.INVALID_GOAL)
    run.robot.leaf_faults["left arm: at last: rise"] = failing(K.NO_PATH)
    run.events["left arm: approach"] = lambda robot: robot.believe(items=())
    assert run.run("pick_two", TWO) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert (failure.kind, failure.where) == (K.INVALID_GOAL, "left arm: approach: arm_left/approach")
    assert "left arm: at last: rise" in run.path()


def test_an_item_that_is_found_on_the_way_out_and_bars_it_is_picked_from_there() -> None:
    run = bench()
    run.robot.leaf_faults["left arm: grasp", 1] = failing(K.ITEM_GONE)
    run.robot.leaf_faults["left arm: show the item"] = failing(K.PATH_IN_COLLISION)
    known = run.robot.world.items

    def lose(robot: MockRobot) -> None:
        nonlocal known
        del run.events["left arm: grasp"]
        known = robot.world.items
        robot.believe(items=())

    run.events["left arm: grasp"] = lose
    run.events["left arm: show the item"] = lambda robot: robot.believe(items=known)
    assert run.run("pick_two", TWO) is Status.SUCCESS


def test_a_hand_whose_item_is_in_sight_goes_straight_to_safety() -> None:
    run = bench()
    run.robot.leaf_faults["left arm: approach", 1] = failing(K.NO_PATH)
    assert run.run("pick_two", TWO) is Status.SUCCESS
    assert not [leaf for leaf in run.path() if leaf.endswith("rise")]


def test_a_cube_that_was_knocked_over_is_picked_as_it_lies() -> None:
    x, y, z = ITEMS[LEFT].position
    run = bench({**ITEMS, LEFT: Pose(position=(x, y, z + 0.035), orientation=IDENTITY.orientation)})
    assert run.run("pick_two", TWO) is Status.SUCCESS
    assert {hand.item for hand in run.robot.world.held} == {LEFT, RIGHT}
