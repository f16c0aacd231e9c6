"""Place: what a hand holds goes into a slot; each way in which that can't begin or is done already."""

from __future__ import annotations

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.world import Box, HeldItem, Placed
from tandem.skills.site import load
from tandem.trees.tasks.place import NAME, TASK, PlaceNotes, PlaceRequest
from tests.fakes.occupied import occupied

SITE = load("lab")


def holding(**hands: int) -> TreeBench:
    run = TreeBench(SITE, items={}, localised=True)
    sides: dict[str, HandName] = {"left": "left", "right": "right"}
    held = tuple(HeldItem(side=sides[side], item=item, item_in_tool=IDENTITY) for side, item in hands.items())
    for side, item in hands.items():
        run.robot.hands[sides[side]] = item
    run.robot.believe(held=held)
    return run


@pytest.mark.parametrize(
    ("hands", "request_", "placed"),
    [
        ({"right": 29}, {}, (29, "depot", 0)),
        ({"left": 29, "right": 42}, {}, (29, "depot", 0)),
        ({"left": 29, "right": 42}, {"arm": "right"}, (42, "depot", 0)),
        ({"left": 29}, {"slot": 2}, (29, "depot", 2)),
    ],
)
def test_what_a_hand_holds_is_put_into_a_slot(
    hands: dict[str, int], request_: dict[str, object], placed: tuple[int, str, int]
) -> None:
    run = holding(**hands)
    assert run.run("place", request_) is Status.SUCCESS, run.failure()
    assert run.result() == dict(zip(("item", "depot", "slot"), placed, strict=True))


@pytest.mark.parametrize(
    ("hands", "request_", "kind"),
    [
        ({}, {}, FailureKind.HAND_EMPTY),
        ({"left": 29}, {"arm": "right"}, FailureKind.HAND_EMPTY),
        ({"left": 586}, {}, FailureKind.ITEM_UNKNOWN),
    ],
)
def test_nothing_moves_when_there_is_nothing_to_place(
    hands: dict[str, int], request_: dict[str, object], kind: FailureKind
) -> None:
    run = holding(**hands)
    assert run.run("place", request_) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert (failure.kind, run.result(), run.robot.calls) == (kind, None, [])


@pytest.mark.parametrize(("x", "slot"), [(0.0, 1), (0.3, 0)], ids=["in slot 0", "beside it"])
def test_a_slot_in_which_cells_are_occupied_is_not_used(x: float, slot: int) -> None:
    run = holding(left=29)
    place = SITE.depots[0].slots[0].position
    thing = Box(size=(0.05, 0.05, 0.1), pose=Pose(position=(place[0] + x, place[1], place[2] + 0.1)))
    run.robot.occupied = occupied(run.robot.world.stamp, thing)
    assert run.run("place", {}) is Status.SUCCESS, run.failure()
    result = run.result()
    assert result is not None
    assert result["slot"] == slot


def test_a_slot_that_is_taken_is_not_replaced_by_another() -> None:
    run = holding(left=29)
    run.robot.believe(placed=(Placed(item=42, depot="depot", slot=2),))
    assert run.run("place", {"slot": 2}) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert (failure.kind, failure.message) == (FailureKind.DESTINATION_FULL, "slot 2 of depot is taken")


def test_after_a_restart_what_has_been_placed_is_done() -> None:
    run = holding(right=42)
    run.robot.believe(placed=(Placed(item=29, depot="depot", slot=1),))
    run.start("place", {})
    run.context.notes.keep(NAME, PlaceNotes(item=29, side="left"))
    while run.step() is Status.RUNNING:
        pass
    assert run.result() == {"item": 29, "depot": "depot", "slot": 1}
    assert run.robot.hands["right"] == 42


@pytest.mark.parametrize(
    ("request_", "path"),
    [({}, None), ({"to": "moon"}, "to"), ({"slot": 99}, "slot"), ({"slot": 0}, None)],
)
def test_depot_and_slot_are_checked_against_the_site(request_: dict[str, object], path: str | None) -> None:
    found = TASK.problems(PlaceRequest.model_validate(request_), SITE)
    assert [problem.path for problem in found] == ([] if path is None else [path])
