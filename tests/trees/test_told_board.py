"""A board in words."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import MOST_ON_BOARD
from tandem.trees.board import FetchBoard
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.two_hands import BothBoard
from tandem.trees.told_board import LONGEST, told_board

STAND = FloorPose(x=1.23456, y=-0.5, yaw=0.0)


def fetch(**fields: object) -> FetchBoard:
    return FetchBoard(item=29, destination="depot", **fields)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("fields", "name", "words"),
    [
        ({}, "item", "29"),
        ({}, "side", None),
        ({}, "putting_back", "no"),
        ({"facing": 0.123456}, "facing", "0.123"),
        ({"near": (1.0, 2.5)}, "near", "(1, 2.5)"),
        ({"sides": ("left", "right")}, "sides", "left; right"),
        ({"stands": (STAND,)}, "stands", "x 1.235, y -0.5, yaw 0"),
        ({"slots_taken": {3, 1}}, "slots_taken", "(1, 3)"),
        ({"pitches_tried": [0.1, 0.2, 0.3, 0.4, 0.5]}, "pitches_tried", "(0.1, 0.2, 0.3, 0.4) and 1 more"),
    ],
)
def test_what_is_set_is_told(fields: dict[str, object], name: str, words: str | None) -> None:
    assert told_board(fetch(**fields)).get(name) == words


def test_boards_within_boards_are_told_by_their_names() -> None:
    both = told_board(BothBoard(HandBoard("left", 1), HandBoard("right", 2)))
    assert (both["left.item"], both["right.item"]) == ("1", "2")
    two = told_board((HandBoard("left", 3), HandBoard("right", 4)))
    assert (two["left.item"], two["right.item"]) == ("3", "4")


@pytest.mark.parametrize("board", [None, "words", 3, FetchBoard])
def test_what_is_no_board_tells_nothing(board: object) -> None:
    assert told_board(board) == {}


def test_a_board_is_bounded() -> None:
    @dataclass
    class Large:
        text: str = "x" * 1000
        thing: object = object()

    assert told_board(Large()) == {"text": f"{'x' * (LONGEST - 1)}…", "thing": "object"}
    assert len(told_board(tuple(fetch() for _ in range(50)))) == MOST_ON_BOARD
