"""Worlds in which the tasks on wheels are explored: what reflexes do to them, and what they know."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Final

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import Happening, Make, stop
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tandem.skills.testing.mock_base import FOR_EVER, MockReflex
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.rounds import NAME, RoundsNotes

_LOST: Final = Fault(failure=Failure(kind=FailureKind.NOT_LOCALISED, message="in this world it is lost"))
PLACE: Final[Mapping[str, float]] = MappingProxyType({"x": -1.2, "y": 0.5})
STEP: Final = 0.1
"""Robot seconds of a period: coarse, since nothing here is quick, and waits are long."""
_HELD_FOR: Final = 100.0
"""Robot seconds for which a reflex has the base in the worlds where it keeps it."""


def go_to_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``go_to``."""
    world = partial(_world, "go_to", {**PLACE, "stay": 2.0})
    return MappingProxyType({"nothing in the way": partial(world)}), MappingProxyType(
        {
            **_corners(world),
            "pushed away": partial(world, events={"stay": _shove}),
            "there already": partial(world, localised=True, begin=_be_there),
        }
    )


def patrol_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``patrol``."""
    world = partial(_world, "patrol", {"corners": [{**PLACE}, {"x": 0.0, "y": 0.0}]})
    return MappingProxyType({"nothing in the way": partial(world)}), MappingProxyType(
        {
            **_corners(world),
            "there already": partial(world, localised=True, begin=_be_there),
            "all visited before a restart": partial(world, localised=True, visited=2),
        }
    )


def follow_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``follow``."""
    world = partial(_world, "follow", {"robot": "other", "seconds": 80.0})
    return MappingProxyType({"nothing in the way": partial(world)}), _corners(world, "follow it", "follow")


def _corners(world: Callable[..., TreeBench], leaf: str = "go", steps: str = "go") -> Mapping[str, Make]:
    """Return what may be in the way; ``steps`` is how the names of its recovery steps begin."""
    anew = dict.fromkeys((leaf, f"{steps}: localise"), _LOST)
    return {
        "known before": partial(world, localised=True),
        "a reflex now and then": partial(world, localised=True, reflex=MockReflex(times=2)),
        "a reflex for ever": partial(world, localised=True, reflex=MockReflex(times=FOR_EVER)),
        "a reflex keeps the base": partial(
            world, localised=True, reflex=MockReflex(times=FOR_EVER, holds=_HELD_FOR)
        ),
        "stop is set": partial(world, begin=stop),
        "lost on the way": partial(world, localised=True, faults=anew, events={leaf: _lose}),
        "lost once": partial(world, localised=True, faults={(leaf, 1): _LOST}, events={leaf: _lose}),
        "without a laser": partial(world, begin=_no_laser),
        "lost without a laser": partial(
            world, localised=True, begin=_no_laser, faults=anew, events={leaf: _lose}
        ),
    }


def _world(
    task: str,
    request: dict[str, object],
    *,
    localised: bool = False,
    reflex: MockReflex | None = None,
    visited: int = 0,
    begin: Happening | None = None,
    events: Mapping[str, Happening] = MappingProxyType({}),
    faults: Mapping[str | tuple[str, int], Fault] = MappingProxyType({}),
) -> TreeBench:
    bench = TreeBench(load("lab"), items={}, localised=localised, step=STEP)
    if reflex is not None:
        bench.robot.wheels.reflex = MockReflex(times=reflex.times, holds=reflex.holds)
    if begin is not None:
        begin(bench.robot)
    bench.robot.leaf_faults.update(faults)
    bench.events.update(events)
    bench.start(task, request)
    if visited:
        bench.context.notes.keep(NAME, RoundsNotes(visited=visited))
    return bench


def _shove(robot: MockRobot) -> None:
    robot.wheels.shove(0.6, 0.0)


def _be_there(robot: MockRobot) -> None:
    robot.base = FloorPose(**PLACE, yaw=0.0)


def _lose(robot: MockRobot) -> None:
    robot.localised = False
    robot.tell()


def _no_laser(robot: MockRobot) -> None:
    robot.description = mock_description().model_copy(update={"lasers": ()})


TRAVEL_WORLDS: Final[Mapping[str, Callable[[], tuple[Mapping[str, Make], Mapping[str, Make]]]]] = (
    MappingProxyType({"go_to": go_to_worlds, "patrol": patrol_worlds, "follow": follow_worlds})
)
"""The worlds and corners of each task on wheels."""
