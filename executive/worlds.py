"""Worlds in which a fetch is explored: what is where when it begins, and what happens while it runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Final

from executive.testing import TreeBench
from skills.ports.geometry import IDENTITY, Pose, from_axes
from skills.ports.hardware import StopState
from skills.ports.keys import STOP_STATE
from skills.ports.message import Vector3
from skills.ports.site import Site
from skills.ports.world import SIDES, HeldItem, Placed
from skills.site import load
from skills.testing.mock_robot import MockRobot

ITEM: Final = 29
OTHER: Final = 42
TAG: Final = Pose(position=(0.9, 0.1, 0.74), orientation=from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0)))
STEP: Final = 0.05
NEVER: Final = 10**6
AFTER_ONE_SPOT: Final = 28
"""The number of the look that is the second one at the second spot."""

Happening = Callable[[MockRobot], None]


def fetch_worlds(site: Site | None = None) -> Mapping[str, Callable[[], TreeBench]]:
    """Return benches with a fetch of item 29 started, by name."""
    at = load("lab") if site is None else site
    slots = tuple(slot.position for slot in at.depots[0].slots)
    world = partial(_world, at)
    return MappingProxyType(
        {
            "in view": partial(world),
            "known before": partial(world, localised=True),
            "at the second spot": partial(world, seen_at_look=AFTER_ONE_SPOT),
            "nowhere": partial(world, seen_at_look=NEVER),
            "arms out": partial(world, begin=_stretch),
            "left arm asked for": partial(world, request={"arm": "left"}),
            "right arm asked for": partial(world, request={"arm": "right"}),
            "in the right hand": partial(world, localised=True, begin=partial(_hold, ITEM)),
            "in the depot": partial(world, localised=True, begin=_placed),
            "other item in the right hand": partial(world, localised=True, begin=partial(_hold, OTHER)),
            "both hands full": partial(world, localised=True, begin=_full),
            "depot full": partial(world, begin=partial(_fill, len(slots))),
            "a slot taken": partial(world, begin=partial(_clutter, slots[:1])),
            "all slots taken": partial(world, begin=partial(_clutter, slots)),
            "stop is set": partial(world, begin=_stop),
            "dropped on the way": partial(world, events={"drive to slot": _drop}),
            "dropped again and again": partial(
                world, events=dict.fromkeys(("drive to slot", "place above", "put down"), _drop)
            ),
            "arms knocked out on the way": partial(world, events={"survey item, left arm": _stretch}),
            "arms knocked out near": partial(world, events={"survey item again, left arm": _stretch}),
            "arms knocked out with item": partial(world, events={"survey slot, left arm": _stretch}),
            "arms knocked out at the depot": partial(world, events={"survey slot again, left arm": _stretch}),
            "arms knocked out when placed": partial(world, events={"remove from scene": _stretch}),
            "arms knocked out at last": partial(world, events={"after place: tuck arm": _stretch}),
        }
    )


def _world(
    site: Site,
    *,
    seen_at_look: int = 1,
    localised: bool = False,
    request: Mapping[str, str] = MappingProxyType({}),
    begin: Happening | None = None,
    events: Mapping[str, Happening] = MappingProxyType({}),
) -> TreeBench:
    bench = TreeBench(site, items={ITEM: TAG}, seen_at_look=seen_at_look, localised=localised, step=STEP)
    if begin is not None:
        begin(bench.robot)
    bench.events.update(events)
    bench.start("fetch", {"item": ITEM, **request})
    return bench


def _stretch(robot: MockRobot) -> None:
    for side in SIDES:
        robot.stretch(side)


def _hold(item: int, robot: MockRobot) -> None:
    robot.hands["right"] = item
    robot.believe(held=(HeldItem(side="right", item=item, item_in_tool=IDENTITY),))


def _full(robot: MockRobot) -> None:
    items = {"left": OTHER, "right": 11}
    robot.believe(held=tuple(HeldItem(side=s, item=items[s], item_in_tool=IDENTITY) for s in SIDES))


def _placed(robot: MockRobot) -> None:
    robot.believe(placed=(Placed(item=ITEM, depot="depot", slot=0),))


def _fill(slots: int, robot: MockRobot) -> None:
    robot.believe(placed=tuple(Placed(item=100 + slot, depot="depot", slot=slot) for slot in range(slots)))


def _clutter(slots: tuple[Vector3, ...], robot: MockRobot) -> None:
    for number, slot in enumerate(slots):
        robot.put_in(slot, f"clutter_{number}")


def _stop(robot: MockRobot) -> None:
    STOP_STATE.publish(robot.bus, StopState(stopped=True, by="an operator", reason="a person in the room"))


def _drop(robot: MockRobot) -> None:
    for side in SIDES:
        robot.drop(side)
