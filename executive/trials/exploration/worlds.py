"""Worlds in which a fetch is explored: what is where when it begins, and what happens while it runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from functools import partial
from types import MappingProxyType
from typing import Final

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.action import node_of
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP_STATE
from tandem.skills.ports.message import Message, Vector3
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import HeldItem, ItemFact, Placed
from tandem.skills.site import load
from tandem.skills.testing.mock_arms import STRETCHED, TUCKED
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.tasks.fetch import TASK

ITEM: Final = 29
OTHER: Final = 42
TAG: Final = Pose(position=(0.9, 0.1, 0.74), orientation=from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0)))
DOUBLE: Final = Pose(position=(0.9, 0.9, 0.74), orientation=TAG.orientation)
STEP: Final = 0.05
"""Robot seconds between two ticks: as the executive has them."""
NEVER: Final = 10**6
"""The number of a look that no task comes to."""
AFTER_ONE_SPOT: Final = 28
"""The number of the look that is the second one at the second spot."""

_NO_WAY: Final = Fault(failure=Failure(kind=FailureKind.NO_PATH, message="in this world there is no way"))

_GONE: Final = Fault(failure=Failure(kind=FailureKind.ITEM_GONE, message="in this world it is gone"))

Happening = Callable[[MockRobot], None]
Make = Callable[[], TreeBench]


def fetch_worlds(site: Site | None = None) -> Mapping[str, Make]:
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
            "in the right hand": partial(world, localised=True, begin=partial(hold, ITEM)),
            "in the depot": partial(world, localised=True, begin=_placed),
            "other item in the right hand": partial(world, localised=True, begin=partial(hold, OTHER)),
            "both hands full": partial(world, localised=True, begin=_full),
            "depot full": partial(world, begin=partial(_fill, range(len(slots)))),
            "a slot taken": partial(world, begin=partial(_clutter, slots[:1])),
            "all slots taken": partial(world, begin=partial(_clutter, slots)),
            "two of that number": partial(world, localised=True, begin=_double),
            "stop is set": partial(world, begin=stop),
            "dropped on the way": partial(world, events={"drive to slot": _Once(_drop)}),
            "dropped again and again": partial(world, events={"drive to slot": _drop}),
            "arms knocked out on the way": partial(world, events={"survey item, left arm": _stretch}),
            "arms knocked out with item": partial(world, events={"survey slot, left arm": _stretch}),
            "arms knocked out when placed": partial(world, events={"close empty": _stretch}),
            "arms knocked out at last": partial(world, events={"after place: tuck arm": _Once(_stretch)}),
            "other stands closely seen": partial(world, events={"survey item again, left arm": _move_away}),
            "other stands at the depot": partial(world, events={"survey slot again, left arm": _move_away}),
        }
    )


def fetch_corners(site: Site | None = None) -> Mapping[str, Make]:
    """Return benches whose fetch gets into corners that a failing leaf alone does not lead to."""
    at = load("lab") if site is None else site
    slots = tuple(slot.position for slot in at.depots[0].slots)
    world, other = partial(_world, at), partial(_world, at, localised=True, begin=partial(hold, OTHER))
    tucks = ("get: draw back: tuck arm", "get: draw back: tuck arm then")
    near_stands = partial(world, events={"survey item again, left arm": _stretch_and_move_away})
    slot_stands = partial(world, events={"survey slot again, left arm": _stretch_and_move_away})
    fallen: Mapping[str, Happening] = {"place above": _stretch, "place: home: tuck arm": _drop}
    return MappingProxyType(
        {
            "arm with other item out": partial(
                world, localised=True, begin=_hold_and_stretch, faults=("before search: tuck arm",)
            ),
            "arm with other item knocked out": partial(
                other, events={"survey item, left arm": _stretch_right}, faults=("before item: tuck arm",)
            ),
            "arm with other item knocked out at last": partial(
                other, events={"close empty": _stretch_right}, faults=("after place: tuck arm",)
            ),
            "arm in after pick": partial(world, events={"hand is full?": _tuck}),
            "arm in after place": partial(world, begin=_tuck_once_withdrawn),
            "other stands, arms out": near_stands,
            "other stands, arms stay out": partial(near_stands, faults=("before item again: tuck arm",)),
            "other stands at the depot, arms out": slot_stands,
            "other stands at the depot, arms stay out": partial(
                slot_stands, faults=("before slot again: tuck arm",)
            ),
            "a parcel seen closely": partial(
                world, events={"look closely at slot": partial(_clutter, slots[:1])}
            ),
            "a parcel seen at last": partial(
                world,
                events={
                    "survey slot again, left arm": _stretch_and_move_away,
                    "look once more at slot": partial(_clutter, slots[:1]),
                },
            ),
            "hand stuck before looking": partial(
                world,
                faults=("get: before looking: tuck arm",),
                gone=("look closely at item",),
                events={"look closely at item": _stretch},
            ),
            "hand with other item stuck before looking": partial(
                other,
                faults=("get: before looking: tuck arm",),
                gone=("look closely at item",),
                events={"look closely at item": _stretch_right},
            ),
            "item stuck, arm too": partial(world, faults=("retract", tucks[0])),
            "item stuck, arm always": partial(world, faults=("retract", *tucks, "get: home: tuck arm")),
            "all slots but one full": partial(
                world, begin=partial(_fill_and_clutter, range(1, len(slots)), slots[:1])
            ),
            "dropped before the way home": partial(
                world, faults=("place above", "place: home: tuck arm"), events=fallen
            ),
            "dropped, and the hand stuck": partial(
                world,
                faults=("place above", "place: home: tuck arm", "place: home: open hand"),
                events=fallen,
            ),
            "home is at the depot": partial(
                world, faults=("place above",), events={"place above": _Third(_at_home(at))}
            ),
            **_surveys(world),
        }
    )


_FACES: Final = tuple(f"{side} arm{face}" for face in ("", ", left face", ", right face") for side in PAIR)


def _surveys(world: Callable[..., TreeBench]) -> Mapping[str, Make]:
    """Return the corners in which an arm gets to one face of the item only, or to none."""
    return {
        **{f"only {face}": partial(world, faults=_all_but(face)) for face in _FACES},
        **{
            f"{what} unreachable, {side} arm asked for": partial(
                world,
                faults=tuple(f"survey {what}, {face}" for face in _FACES),
                request={"arm": side},
            )
            for what in ("item", "item again")
            for side in PAIR
        },
    }


def _all_but(face: str) -> tuple[str, ...]:
    """Return the surveys that find nothing when the item can be reached in one way only."""
    return tuple(
        f"survey {what}, {each}" for each in _FACES if each != face for what in ("item", "item again")
    )


def _world(
    site: Site,
    *,
    seen_at_look: int = 1,
    localised: bool = False,
    request: Mapping[str, str] = MappingProxyType({}),
    begin: Happening | None = None,
    events: Mapping[str, Happening] = MappingProxyType({}),
    faults: tuple[str, ...] = (),
    gone: tuple[str, ...] = (),
) -> TreeBench:
    bench = TreeBench(site, items={ITEM: TAG}, seen_at_look=seen_at_look, localised=localised, step=STEP)
    if begin is not None:
        begin(bench.robot)
    bench.events.update({name: copy(event) for name, event in events.items()})
    bench.robot.leaf_faults.update(dict.fromkeys(faults, _NO_WAY) | dict.fromkeys(gone, _GONE))
    bench.start(TASK, {"item": ITEM, **request})
    return bench


def _stretch(robot: MockRobot) -> None:
    robot.put_arms(STRETCHED)


def _tuck(robot: MockRobot) -> None:
    robot.put_arms(TUCKED)


def _tuck_once_withdrawn(robot: MockRobot) -> None:
    """Have the arms be in when the hand has let go: what comes next asks for it at once."""

    def heard(what: str, _: str, goal_id: str, __: Message) -> None:
        if what == "ended" and node_of(goal_id) == "withdraw":
            robot.put_arms(TUCKED)

    robot.watch = heard


def _move_away(robot: MockRobot) -> None:
    robot.out_of_reach = 8  # where it stands comes first, then what is near


def _stretch_and_move_away(robot: MockRobot) -> None:
    _stretch(robot)
    _move_away(robot)


def _stretch_right(robot: MockRobot) -> None:
    robot.put_arms(TUCKED, right=STRETCHED)


class _Once:
    """What happens only the first time."""

    def __init__(self, happening: Happening, number: int = 1) -> None:
        self._happening, self._number, self._count = happening, number, 0

    def __call__(self, robot: MockRobot) -> None:
        self._count += 1
        if self._count == self._number:
            self._happening(robot)


_Third = partial(_Once, number=3)


def _at_home(site: Site) -> Happening:
    def happen(robot: MockRobot) -> None:
        robot.base = site.home
        robot.tell()

    return happen


def _hold_and_stretch(robot: MockRobot) -> None:
    hold(OTHER, robot)
    _stretch_right(robot)


def hold(item: int, robot: MockRobot) -> None:
    """Have an item in the right hand."""
    robot.hands["right"] = item
    robot.believe(held=(HeldItem(side="right", item=item, item_in_tool=IDENTITY),))


def _full(robot: MockRobot) -> None:
    items = {"left": OTHER, "right": 11}
    robot.believe(held=tuple(HeldItem(side=s, item=items[s], item_in_tool=IDENTITY) for s in PAIR))


def _placed(robot: MockRobot) -> None:
    robot.believe(placed=(Placed(item=ITEM, depot="depot", slot=0),))


def _double(robot: MockRobot) -> None:
    one, other = (
        ItemFact(
            item=ITEM,
            size=(0.06, 0.06, 0.06),
            tag_in_map=tag,
            seen=robot.now,
            quality=1.0,
            position_sigma=0.002,
        )
        for tag in (TAG, DOUBLE)
    )
    robot.believe(items=(one,), doubles=(other,))


def _fill(slots: range, robot: MockRobot) -> None:
    robot.believe(placed=tuple(Placed(item=100 + slot, depot="depot", slot=slot) for slot in slots))


def _fill_and_clutter(full: range, slots: tuple[Vector3, ...], robot: MockRobot) -> None:
    _fill(full, robot)
    _clutter(slots, robot)


def _clutter(slots: tuple[Vector3, ...], robot: MockRobot) -> None:
    for number, slot in enumerate(slots):
        robot.put_in(slot, f"clutter_{number}")


def stop(robot: MockRobot) -> None:
    """Have somebody set the hardware's stop."""
    STOP_STATE.publish(robot.bus, StopState(stopped=True, by="an operator", reason="a person in the room"))


def _drop(robot: MockRobot) -> None:
    for side in PAIR:
        robot.drop(side)
