"""What one hand's leaves hand to each other."""

from __future__ import annotations

import pytest

from tandem.executive.trials.exploration.hand_worlds import ITEMS, LEFT
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.geometry.poses import angle_between, distance
from tandem.skills.grasping.item_frames import face, item_in_map
from tandem.skills.ports.failure import Failure
from tandem.skills.site import load
from tandem.trees.hand_board import HandBoard

SIZE = 0.07


@pytest.mark.parametrize("quarters", range(4))
def test_a_grasp_is_told_in_the_same_frame_whichever_face_was_seen_last(quarters: int) -> None:
    seen = face(ITEMS[LEFT], SIZE, quarters)
    bench = TreeBench(load("bimanual"), items={LEFT: seen}, seen_at_look=1)
    bench.start("pick", {"item": LEFT})
    while bench.context.knowledge.world is None or bench.context.knowledge.world.item(LEFT) is None:
        bench.step()
    board = HandBoard("left", LEFT, frame=item_in_map(ITEMS[LEFT], SIZE))
    stands = board.standing(bench.context)
    assert not isinstance(stands, Failure)
    assert board.frame is not None
    assert angle_between(stands.orientation, board.frame.orientation) < 1e-6


def test_what_was_tried_in_vain_is_offered_last() -> None:
    bench = TreeBench(load("bimanual"), items=dict(ITEMS), seen_at_look=1)
    bench.start("pick", {"item": LEFT})
    while bench.context.knowledge.world is None or bench.context.knowledge.world.item(LEFT) is None:
        bench.step()
    board = HandBoard("left", LEFT)
    board.offer(bench.context)
    before = board.ways
    board.choose(0, 0.0)
    board.give_up_way()
    board.offer(bench.context)
    assert board.ways == (*before[1:], before[0])


def test_an_item_taken_in_a_turned_way_is_held_as_if_nothing_had_been_turned() -> None:
    bench = TreeBench(load("bimanual"), items=dict(ITEMS), seen_at_look=1)
    bench.start("pick", {"item": LEFT})
    while bench.context.knowledge.world is None or bench.context.knowledge.world.item(LEFT) is None:
        bench.step()
    board = HandBoard("left", LEFT)
    board.offer(bench.context)
    item = board.standing(bench.context)
    assert not isinstance(item, Failure)
    board.choose(0, 0.0)
    straight, held = board.tool_at(item), board.item_in_tool()
    board.choose(0, 0.1)
    tool = board.tool_at(item)
    assert board.item_in_tool() == held
    assert distance(tool, item) == pytest.approx(distance(straight, item))
    assert angle_between(tool.orientation, straight.orientation) == pytest.approx(0.1)
