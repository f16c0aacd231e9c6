"""A module's name means one thing. Where two rooms have a module of one name, it is the same thing twice."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).parents[2]
ROOMS: Final = ("executive", "skills", "sim", "trees")
LAYERS: Final = frozenset(
    (
        "executive/system/roles",
        "skills/ports",
        "skills/ports/actions",
        "trees/leaves",
        "trees/leaves/hand",
        "trees/subtrees",
        "trees/tasks",
    )
)
"""Rooms through which a thing keeps its name: ``grip`` is the skill, its contract and its leaf."""
TRIALS: Final = "executive/trials"
"""Each experiment has a ``run``, ``settings`` and a ``summary``."""
SIM: Final = "sim"
"""Has the physical side of what the rest has: ``gripper``, ``camera``."""
SAME: Final = {
    "approach": "the approach of a hand, and the reflex of this name that steers to a place",
    "camera": "the camera as perception and as the page have it",
    "clocks": "robot time, and the clauses about it",
    "clutter": "what was seen of it, and what is believed of it",
    "described": "what is taken out of a description, and the clauses about it",
    "errors": "those of the command line, and of the client",
    "layout": "where things are drawn, and a data set's files",
    "limits": "of a group's joints, of the band, of messages",
    "logs": "they are written in one room and shown in the other",
    "memory": "ledger and bus in memory",
    "motions": "clauses about motions, and the motions that a planner checks",
    "node": "what a process steps",
    "observer": "hears the bus for records, and for the coordination",
    "occupied": "occupied space, for the page, the beliefs and the base",
    "pages": "of answers, and of the docs",
    "path": "an arm's and a base's",
    "pictures": "as they are kept, and as ROS has them",
    "poses": "and as ROS has them",
    "process": "how a room's part is put together as a process",
    "recording": "what is recorded of a run",
    "registry": "what is found by being there",
    "settings": "of planners",
    "snapshot": "of a camera, and of a tree",
    "status": "what an arm and the base tell of themselves",
    "tables": "of documents",
    "wheels": "the base's, and as ROS has them",
    "whereabouts": "where a robot tells that it is",
    "zones": "of two hands, and how they are drawn",
}
"""Names in several rooms that are no layers of each other, and what they mean in each."""


def _several() -> dict[str, list[str]]:
    found: dict[str, list[str]] = defaultdict(list)
    for room in ROOMS:
        for file in (ROOT / room).rglob("*.py"):
            if not file.stem.startswith("__"):
                found[file.stem].append(file.parent.relative_to(ROOT).as_posix())
    return {name: rooms for name, rooms in found.items() if len(rooms) > 1}


def test_two_modules_of_a_name_are_of_one_thing() -> None:
    def stands_alone(room: str) -> bool:
        return room not in LAYERS and not room.startswith(TRIALS) and room.split("/", maxsplit=1)[0] != SIM

    unclear = {name for name, rooms in _several().items() if sum(map(stands_alone, rooms)) > 1}
    assert unclear - SAME.keys() == set(), "name one of them otherwise, or say what is the same"
    assert SAME.keys() - unclear == set(), "is no longer in several rooms"
