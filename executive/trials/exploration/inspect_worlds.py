"""Worlds in which an inspection is explored: a room with two spots, so that each run is short."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Final

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import ITEM, OTHER, STEP, TAG, Happening, Make, hold, stop
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.site import Site
from tandem.skills.site import load
from tandem.skills.testing.mock_arms import STRETCHED
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.inspection import NAME, InspectNotes

SPOTS: Final = 2
"""The least with which there is a next spot; each more only makes the worlds longer."""
_NO_WAY: Final = Fault(
    failure=Failure(kind=FailureKind.BASE_NO_PATH, message="in this world there is no way")
)
_LOST: Final = Fault(failure=Failure(kind=FailureKind.NOT_LOCALISED, message="in this world it is lost"))
_STUCK: Final = Fault(failure=Failure(kind=FailureKind.NO_PATH, message="in this world the arm is stuck"))


def inspect_site() -> Site:
    """Return the lab with its first two spots."""
    site = load("lab")
    return site.model_copy(update={"spots": site.spots[:SPOTS]})


def inspect_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``inspect``."""
    world = partial(_world, inspect_site())
    return MappingProxyType({"an item in view": partial(world)}), MappingProxyType(
        {
            "known before": partial(world, localised=True),
            "at the spot": partial(world, at_spot=True),
            "stop is set": partial(world, begin=stop),
            "nothing to see": partial(world, seen_at_look=10**6),
            "no way to a spot": partial(world, faults={"drive to spot": _NO_WAY}),
            "all was visited before a restart": partial(world, visited=True),
            "all was visited, and it is at home": partial(world, at_home=True, visited=True),
            "arms out": partial(world, begin=_stretch),
            **{
                f"arms out, {name}": partial(world, begin=begin, faults=_stuck("before inspecting", leaves))
                for name, begin, leaves in _OUT
            },
            **{
                f"arms knocked out on the way, {name}": partial(
                    world, begin=begin, events={"look on": _stretch}, faults=_stuck("home", leaves)
                )
                for name, begin, leaves in _OUT
            },
            **{
                f"lost at {leaf}": partial(world, faults={leaf: _LOST, anew: _LOST})
                for leaf, anew in (
                    ("drive to spot", "spot: localise anew"),
                    ("home: drive", "home: localise anew"),
                )
            },
        }
    )


def _world(
    site: Site,
    *,
    seen_at_look: int = 1,
    localised: bool = False,
    at_spot: bool = False,
    visited: bool = False,
    at_home: bool = False,
    begin: Happening | None = None,
    events: Mapping[str, Happening] = MappingProxyType({}),
    faults: Mapping[str, Fault] = MappingProxyType({}),
) -> TreeBench:
    bench = TreeBench(
        site,
        items={ITEM: TAG},
        seen_at_look=seen_at_look,
        localised=localised or at_spot or at_home,
        step=STEP,
    )
    if at_spot or at_home:
        bench.robot.base = site.home if at_home else site.spots[0].pose
    if begin is not None:
        begin(bench.robot)
    bench.robot.leaf_faults.update(faults)
    bench.events.update(events)
    bench.start("inspect", {})
    if visited:
        done = InspectNotes(done=tuple(spot.name for spot in site.spots))
        bench.context.notes.keep(NAME, done)
    return bench


def _stuck(where: str, leaves: tuple[str, ...]) -> Mapping[str, Fault]:
    return {f"{where}: {leaf}": _STUCK for leaf in leaves}


def _stretch(robot: MockRobot) -> None:
    robot.put_arms(STRETCHED)


def _hold_and_stretch(robot: MockRobot) -> None:
    hold(OTHER, robot)
    _stretch(robot)


_OUT: Final[tuple[tuple[str, Happening, tuple[str, ...]], ...]] = (
    ("and one can't come in at once", _stretch, ("tuck arm",)),
    ("and a hand is full", _hold_and_stretch, ("tuck arm",)),
    ("and fingers are stuck", _stretch, ("tuck arm", "open hand")),
    ("and can't draw back", _stretch, ("tuck arm", "draw hand back")),
    ("and stay", _stretch, ("tuck arm", "tuck arm then")),
)
"""What may befall an arm that is out: the leaves that fail, of those that bring it in."""
