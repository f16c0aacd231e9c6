"""Worlds in which the tasks of two arms are explored: what is where, and what happens while they run."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Final

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import Make, stop
from tandem.skills.geometry.poses import about
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.ports.actions.bimanual import COORDINATE, PAIR
from tandem.skills.ports.actions.perception import TRACK
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.world import HeldItem, ItemFact
from tandem.skills.site import load
from tandem.skills.testing.mock_arms import STRETCHED
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault

LEFT: Final = 29
RIGHT: Final = 42
CARTON: Final = 0
OTHER: Final = 7
STEP: Final = 0.2
"""Robot seconds of a period. A larger one would pass over what is short; a smaller one takes more steps for
the same states."""

_WHERE: Final = ("draw back", "at last")
Happening = Callable[[MockRobot], None]

_BUSY: Final = Fault(failure=Failure(kind=FailureKind.BUSY, message="in this world it is busy once"))
_GONE: Final = Fault(failure=Failure(kind=FailureKind.ITEM_GONE, message="in this world it has moved"))
_SLOW: Final = {f"{side} arm: approach": Fault(late=20.0) for side in PAIR}
_SLOWER: Final = {f"{side} arm: approach": Fault(late=50.0) for side in PAIR}
_BLIND: Final = {
    leaf: Fault(failure=Failure(kind=FailureKind.CAMERA_SILENT, message="in this world nothing is seen"))
    for leaf in ("track", "coordinate")
}
_FORBIDDEN: Final = Fault(
    failure=Failure(kind=FailureKind.INVALID_GOAL, message="in this world that is not to be")
)
_NO_WAY: Final = Fault(failure=Failure(kind=FailureKind.NO_PATH, message="in this world there is no way"))


def tag_at(x: float, y: float, size: float = 0.07, z: float = 0.745) -> Pose:
    """Return the tag of an item on the table that faces the robot; m, in the map."""
    item = Pose(position=(x, y, z), orientation=about((0.0, 0.0, 1.0), math.pi))
    return tag_of_item(item, size)


ITEMS: Final = MappingProxyType(
    {LEFT: tag_at(0.6, 0.2), RIGHT: tag_at(0.6, -0.2), CARTON: tag_at(0.62, 0.0, 0.30, 0.91)}
)
CROSSED: Final = MappingProxyType({LEFT: tag_at(0.6, -0.1), RIGHT: tag_at(0.6, 0.1)})
FAR: Final = MappingProxyType({LEFT: tag_at(1.2, 0.2), RIGHT: tag_at(0.6, -0.5)})


def pick_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``pick``."""
    world = partial(_world, "pick", {"item": LEFT})
    worlds = {
        "left hand": partial(world),
        "right hand": partial(_world, "pick", {"item": RIGHT}),
    }
    return MappingProxyType(worlds), MappingProxyType(
        {
            **_common(world),
            **_of_hand(world, "left"),
            **_of_hand(partial(_world, "pick", {"item": RIGHT}), "right"),
            "hand is full": partial(world, begin=partial(_hold, "left", RIGHT)),
            "held already": partial(world, begin=partial(_hold, "left", LEFT)),
            "out of reach": partial(world, items=FAR),
        }
    )


def pick_two_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``pick_two``."""
    world = partial(_world, "pick_two", {"left": LEFT, "right": RIGHT})
    together = partial(_world, "pick_two", {"left": LEFT, "right": RIGHT, "parallel_pick": True})
    corners: dict[str, Make] = {**_common(world)}
    for side in PAIR:
        corners |= _of_hand(world, side)
    return MappingProxyType({"in turns": partial(world), "together": partial(together)}), MappingProxyType(
        {
            **corners,
            "crossed": partial(world, items=CROSSED),
            "faithful": partial(
                _world, "pick_two", {"left": LEFT, "right": RIGHT, "mode": "faithful"}, faults={}
            ),
            "right hand is full": partial(world, begin=partial(_hold, "right", LEFT)),
            "left held already": partial(world, begin=partial(_hold, "left", LEFT)),
            "left held already, together": partial(together, begin=partial(_hold, "left", LEFT)),
            **{
                f"{side} hand late, together": partial(
                    together, faults={f"{side} arm: approach": Fault(late=2.0)}
                )
                for side in PAIR
            },
            **{
                f"{side} hand fails before, together": partial(
                    together, faults={f"{side} arm: approach": _FORBIDDEN}
                )
                for side in PAIR
            },
            # The first is back long before the second, which then takes the last steps alone.
            "left item falls out while the right is picked": partial(
                world, events={"right arm: to safety": partial(drop, "left")}
            ),
            "right item falls out while the left is picked": partial(
                world,
                faults={"left arm: approach": Fault(late=2.0)},
                events={"left arm: to safety": partial(drop, "right")},
            ),
            "out of reach": partial(world, items=FAR),
        }
    )


def pick_both_hands_worlds() -> tuple[Mapping[str, Make], Mapping[str, Make]]:
    """Return the worlds and corners of ``pick_both_hands``."""
    world = partial(_world, "pick_both_hands", {"item": CARTON})
    fails = partial(_always, world)
    return MappingProxyType({"in view": partial(world)}), MappingProxyType(
        {
            **_common(world),
            "never felt": fails("both hands: squeeze"),
            **{
                f"no way up, and the item in sight {where}": partial(
                    world,
                    faults={"both hands: lift together": _NO_WAY},
                    events=dict.fromkeys(
                        (f"both hands: {where}: let go", f"left arm: {where}: to safety"), _see
                    ),
                )
                for where in _WHERE
            },
            "no way up": fails("both hands: lift together"),
            "no way up or down": fails("both hands: lift together", "both hands: draw back: put down"),
            "stuck in the hands": fails(
                "both hands: lift together", "both hands: draw back: let go", "both hands: at last: let go"
            ),
            "item moves and is lost": partial(
                world, faults={("left arm: grasp", 1): _GONE}, events={"right arm: grasp": _lose}
            ),
            **{
                f"{side} hand: {name}": fails(
                    "both hands: squeeze",
                    *(f"{side} arm: {where}: {leaf}" for where in _WHERE for leaf in leaves),
                )
                for side in PAIR
                for name, leaves in {
                    "a long way back": ("to safety",),
                    "can't draw back": ("to safety", "draw back"),
                    "can't rise": ("to safety", "rise"),
                    "no way back": ("to safety", "to safety then"),
                }.items()
            },
            "left hand is full": partial(world, begin=partial(_hold, "left", LEFT)),
            "out of reach": partial(world, items={CARTON: tag_at(1.4, 0.0, 0.30, 0.91)}),
        }
    )


HAND_WORLDS: Final[Mapping[str, Callable[[], tuple[Mapping[str, Make], Mapping[str, Make]]]]] = (
    MappingProxyType(
        {"pick": pick_worlds, "pick_two": pick_two_worlds, "pick_both_hands": pick_both_hands_worlds}
    )
)


def _common(world: Callable[..., TreeBench]) -> dict[str, Make]:
    fails_out = partial(_always, partial(world, seen_at_look=4, begin=_stretch))
    return {
        "known before": partial(world, localised=True),
        "nowhere": partial(world, seen_at_look=10**6),
        "no zones": partial(world, zones=False),
        "stop is set": partial(world, begin=stop),
        "arms hide all": partial(world, seen_at_look=4, begin=_stretch),
        "arms hide all, one is stuck": fails_out("look: tuck arm"),
        "arms hide all, and have something": partial(
            world,
            seen_at_look=4,
            begin=_stretch,
            events={"look at table": partial(_hold, "left", OTHER)},
            faults={"look: tuck arm": _NO_WAY},
        ),
        "arms hide all, fingers stuck": fails_out("look: tuck arm", "look: open hand"),
        "arms hide all, and can't draw back": fails_out("look: tuck arm", "look: draw hand back"),
        "arms hide all, and stay": fails_out("look: tuck arm", "look: tuck arm then"),
        "nobody sees or rules": partial(world, faults={**_BLIND, **_SLOW}),
        "nobody is there to see or rule": partial(world, begin=_alone, faults=_SLOWER),
    }


def _of_hand(world: Callable[..., TreeBench], side: HandName) -> dict[str, Make]:
    """Return what befalls one arm: its item moves, its way is barred, it can't get back."""
    who = f"{side} arm"
    fails = partial(_always, world)
    stuck, at_last = ("close", "draw back: to safety"), ("at last: to safety",)
    late = partial(_always, partial(world, faults={(f"{who}: lift", 1): _BUSY}))
    return {
        f"{who}: item moves at the grasp": partial(world, faults={(f"{who}: grasp", 1): _GONE}),
        f"{who}: item moves at each grasp": partial(world, faults={f"{who}: grasp": _GONE}),
        f"{who}: item moves and is lost": partial(
            world, faults={(f"{who}: grasp", 1): _GONE}, events={f"{who}: grasp": _lose}
        ),
        f"{who}: item moves and is found": partial(
            world,
            faults={(f"{who}: grasp", 1): _GONE},
            events={f"{who}: grasp": _lose, f"{who}: show the item": _find},
        ),
        f"{who}: item is lost, and no way back": partial(
            world,
            faults={(f"{who}: grasp", 1): _GONE, f"{who}: show the item": _NO_WAY},
            events={f"{who}: grasp": _lose},
        ),
        f"{who}: falls out on the way to safety": partial(
            world, events={f"{who}: to safety": partial(drop, side)}
        ),
        f"{who}: has it, and it falls out": partial(
            world,
            faults={(f"{who}: lift", 1): _BUSY},
            events={f"{who}: has it: to safety": partial(drop, side)},
        ),
        f"{who}: nothing to grasp": fails(f"{who}: close"),
        f"{who}: item is found on the way out, and bars it": partial(
            world,
            faults={(f"{who}: grasp", 1): _GONE, f"{who}: show the item": _NO_WAY},
            events={f"{who}: grasp": _lose, f"{who}: show the item": _find},
        ),
        f"{who}: item gone, and no way up": partial(
            world,
            faults={(f"{who}: grasp", 1): _GONE, f"{who}: show the item: rise": _NO_WAY},
            events={f"{who}: grasp": _lose},
        ),
        f"{who}: no way to the item": fails(f"{who}: approach"),
        **{
            f"{who}: {name}": fails(*(f"{who}: {leaf}" for leaf in leaves))
            for name, leaves in {
                "comes back the long way": stuck,
                "hand stuck": (*stuck, "draw back: let go"),
                "can't draw back": (*stuck, "draw back: draw back"),
                "no way back": (*stuck, "draw back: to safety then"),
                "full and comes back the long way": ("lift", "draw back: to safety"),
                "comes back the long way at last": ("close", *stuck, "draw back: let go", *at_last),
                "stuck at last": ("close", *stuck, "draw back: let go", *at_last, "at last: let go"),
                "can't rise": (*stuck, "draw back: rise", "draw back: let go", *at_last, "at last: rise"),
                "no way back ever": (
                    *stuck,
                    "draw back: to safety then",
                    *at_last,
                    "at last: to safety then",
                ),
            }.items()
        },
        f"{who}: has it, and a long way back": late(f"{who}: has it: to safety"),
        f"{who}: has it, and can't draw back": late(f"{who}: has it: to safety", f"{who}: has it: draw back"),
        f"{who}: has it, and no way back": late(
            f"{who}: has it: to safety", f"{who}: has it: to safety then"
        ),
    }


def _always(world: Callable[..., TreeBench], *leaves: str) -> Make:
    """Return the world in which these leaves always fail, besides what is wrong there already."""
    before = world.keywords.get("faults", {}) if isinstance(world, partial) else {}
    return partial(world, faults={**before, **dict.fromkeys(leaves, _NO_WAY)})


def _world(
    task: str,
    request: Mapping[str, object],
    *,
    items: Mapping[int, Pose] = ITEMS,
    seen_at_look: int = 1,
    localised: bool = False,
    zones: bool = True,
    begin: Happening | None = None,
    faults: Mapping[str | tuple[str, int], Fault] = MappingProxyType({}),
    events: Mapping[str, Happening] = MappingProxyType({}),
) -> TreeBench:
    bench = TreeBench(
        load("bimanual"), items=dict(items), seen_at_look=seen_at_look, localised=localised, step=STEP
    )
    bench.robot.knows_zones = zones
    if begin is not None:
        begin(bench.robot)
    bench.robot.leaf_faults.update(faults)
    bench.events.update(events)
    bench.start(task, dict(request))
    return bench


def _stretch(robot: MockRobot) -> None:
    robot.put_arms(STRETCHED)


def _alone(robot: MockRobot) -> None:
    for action in (TRACK.name, COORDINATE.name):
        robot.lose(action)


def _lose(robot: MockRobot) -> None:
    robot.believe(items=())


def _find(robot: MockRobot) -> None:
    facts = [
        ItemFact(
            item=item,
            size=(0.07, 0.07, 0.07),
            tag_in_map=ITEMS[item],
            seen=robot.now,
            quality=1.0,
            position_sigma=0.002,
        )
        for item in (LEFT, RIGHT)
    ]
    robot.believe(items=tuple(facts))


def _see(robot: MockRobot) -> None:
    facts = [each.model_copy(update={"seen": robot.now}) for each in robot.world.items]
    robot.believe(items=tuple(facts))


def drop(side: HandName, robot: MockRobot) -> None:
    """Let what a hand holds fall back to where it stood."""
    robot.hands[side] = None
    robot.believe(held=tuple(each for each in robot.world.held if each.side != side))


def _hold(side: HandName, item: int, robot: MockRobot) -> None:
    robot.hands[side] = item
    robot.believe(held=(HeldItem(side=side, item=item, item_in_tool=IDENTITY),))
