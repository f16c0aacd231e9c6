"""Rooms that end with the test that made them."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tandem.skills.ports.pose import FloorPose
from tests.sim.rooms import MakeRoom, Room
from tests.sim.rooms import make_room as make


@pytest.fixture
def make_room() -> Iterator[MakeRoom]:
    """Make rooms (scenario's name, robot's start)."""
    made: list[Room] = []

    def making(name: str = "Demo", start: FloorPose | None = None) -> Room:
        made.append(make(name, start))
        return made[-1]

    yield making
    for each in made:
        each.physics.close()


@pytest.fixture
def room(make_room: MakeRoom) -> Room:
    """The Demo's room."""
    return make_room()
