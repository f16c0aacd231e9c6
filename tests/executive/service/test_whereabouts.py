"""What the executive tells the robots of the site of its own."""

from __future__ import annotations

from dataclasses import replace

import pytest
from surroundings import WAIT, Surroundings

from tandem.executive.service.whereabouts import Whereabouts
from tandem.skills.ports.whereabouts import LARGEST, Following, Neighbours
from tandem.skills.testing.mock_description import mock_description

LEADER = Following(robot="r1", distance=1.0)


def told(here: Surroundings, neighbours: Neighbours) -> tuple[str, Following | None]:
    """Return the kind of the robot's task, and whom it follows, as its neighbours hear it."""
    here.step(20)
    neighbours.refresh()
    heard = neighbours.of("robot")
    assert heard is not None
    return heard.told.kind, heard.told.follows


def test_a_robot_tells_whom_its_task_follows_and_only_while_it_does() -> None:
    here = Surroundings(kinds={"wait": replace(WAIT, follows=lambda _: LEADER)})
    neighbours = Neighbours(here.commons, here.clocks, "r1")
    assert told(here, neighbours) == ("", None)
    here.ask({"task": "wait", "item": 1})
    assert told(here, neighbours) == ("wait", LEADER)
    here.world(1)
    assert told(here, neighbours) == ("", None)


def test_a_task_that_follows_nobody_tells_nobody() -> None:
    here = Surroundings()
    neighbours = Neighbours(here.commons, here.clocks, "r1")
    here.ask({"task": "wait", "item": 1})
    assert told(here, neighbours) == ("wait", None)


@pytest.mark.parametrize(
    ("radius", "height", "heard"), [(0.18, 0.62, (0.18, 0.62)), (30.0, 0.62, (LARGEST, 0.62))]
)
def test_a_robot_tells_how_large_it_is(radius: float, height: float, heard: tuple[float, float]) -> None:
    here = Surroundings()
    neighbours = Neighbours(here.commons, here.clocks, "r1")
    description = mock_description().model_copy(update={"footprint_radius": radius, "height": height})
    Whereabouts(here.commons, here.clocks, "robot", "s").step(None, None, description=description)
    neighbours.refresh()
    robot = neighbours.of("robot")
    assert robot is not None
    assert (robot.told.radius, robot.told.height) == heard
