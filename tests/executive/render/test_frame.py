"""Moving pictures: room and tree side by side, in files that can be read back."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from tandem.executive.config.run_options import FILMS
from tandem.executive.render.frame import TREE_WIDTH, Picture, frame, save
from tandem.skills.ports.tasks import NodeStatus, TreeNode

ROOM = np.full((240, 320, 3), (10, 200, 30), np.uint8)
GREEN, RED = (80, 160, 60), (60, 60, 210)


def png(picture: Picture) -> bytes:
    return bytes(cv2.imencode(".png", picture)[1])


def tree(status: NodeStatus) -> TreeNode:
    return TreeNode(path="root", name="grasp", kind="action", type="Leaf", status=status)


def has(picture: Picture, colour: tuple[int, int, int]) -> bool:
    return bool((picture[:, ROOM.shape[1] :] == colour).all(axis=2).any())


def test_the_room_stands_beside_the_tree() -> None:
    made = frame(png(ROOM), tree(NodeStatus.SUCCESS), "robot time 1.0 s")
    assert made.shape == (240, 320 + TREE_WIDTH, 3)
    assert (made[:, :320] == ROOM).all()


@pytest.mark.parametrize(
    ("status", "green", "red"), [(NodeStatus.SUCCESS, True, False), (NodeStatus.FAILURE, False, True)]
)
def test_a_node_has_its_status_colour(status: NodeStatus, *, green: bool, red: bool) -> None:
    made = frame(png(ROOM), tree(status), "")
    assert (has(made, GREEN), has(made, RED)) == (green, red)


def test_what_is_no_picture_is_refused() -> None:
    with pytest.raises(ValueError, match="expected a PNG of the room, found 3 bytes"):
        frame(b"abc", tree(NodeStatus.SUCCESS), "")


@pytest.mark.parametrize("ending", FILMS)
def test_each_kind_of_file_holds_every_picture(tmp_path: Path, ending: str) -> None:
    frames = [frame(png(ROOM), tree(status), status) for status in NodeStatus]
    path = tmp_path / "new" / f"film{ending}"
    save(path, frames, 0.1)
    read, animation = cv2.imreadanimation(str(path))
    assert read
    assert len(animation.frames) == len(frames)
    assert list(animation.durations) == [100, 100, 100, 1000]
