"""What goes wrong in the runs of the recovery campaign: drawn, and named, with what it must end in.

A fault that waits for an event waits for one that no fetch can do without; a run in which it does not strike
shows nothing, and counts as not right.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from numpy.random import Generator

from tandem.sim.draw import OutOfReach, why_not
from tandem.sim.faults import (
    ArmMoving,
    BaseAtRest,
    BaseMoving,
    BumperPressed,
    CameraDark,
    CameraFrozen,
    CameraSilent,
    CameraUsed,
    DepotTaken,
    Event,
    Fault,
    GripperClosed,
    GripperStuck,
    HandOpens,
    HardwareSilent,
    ItemGone,
    ItemLifted,
    ItemMoves,
    JointStall,
    LaserSilent,
    ObstacleAppears,
    OdometryJump,
    StopSet,
)
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.things import BoxShape
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.testing.faulty_bus import BusFaults

MOST_FAULTS: Final = 3
"""Of one run."""
PERSON: Final = BoxShape(size=(0.35, 0.35, 1.2))
"""Metres: trunk and legs of whoever stands in the way, as one box."""
BAD_NETWORK: Final = BusFaults(delay=0.05, drop=0.03, double=0.05, reorder=0.05)
"""Seconds at the most, and shares of all messages."""


@dataclass(frozen=True)
class Trouble:
    """What goes wrong in one run. ``ends_in``: kinds of which the task fails; none: it succeeds anyway."""

    name: str
    faults: tuple[Fault, ...] = ()
    bus: BusFaults | None = None
    ends_in: frozenset[FailureKind] = frozenset()


@dataclass(frozen=True)
class Case:
    """What a trouble is drawn from: chance, the item asked for, site and robot, where all stands at first.

    ``out_of_reach`` judges places to which the item is moved, as those at which it is drawn are judged.
    """

    rng: Generator
    item: int
    site: Site
    robot: RobotDescription
    scenario: Scenario
    out_of_reach: OutOfReach

    def number(self, low: float, high: float) -> float:
        """Draw one, to the hundredth."""
        return round(float(self.rng.uniform(low, high)), 2)

    def nth(self, most: int) -> int:
        """Draw which time of an event it is."""
        return int(self.rng.integers(1, most + 1))


# How often an event happens in a fetch at the least, as the tree of an item in view has it
# (tests/trees/test_fetch.py): it looks for the item, closely at it and at the slot; it drives to the item, to
# the depot and home. An arm goes before the item, and to it.
LOOKS: Final = 3
DRIVES: Final = 3
MOTIONS: Final = 2
MOVE_DRAWS: Final = 1000
"""After which there is taken to be no free place near by."""

Draw = Callable[[Case], tuple[Fault, ...]]


def _way_blocked(case: Case) -> tuple[Fault, ...]:
    when = BaseMoving(nth=case.nth(DRIVES), after=case.number(0.3, 1.0))
    return (
        ObstacleAppears(
            shape=PERSON, ahead=case.number(0.8, 1.2), lasts=case.number(3.0, 10.0), when=when, waits=True
        ),
    )


def _moved_on_the_way(case: Case) -> tuple[Fault, ...]:
    return (_a_little(case, BaseAtRest(nth=1)),)


def _moved_before_the_grasp(case: Case) -> tuple[Fault, ...]:
    return (_a_little(case, ArmMoving(nth=1, after=case.number(0.1, 0.8))),)


def _a_little(case: Case, when: Event) -> ItemMoves:
    """Draw a step to a place where the item could have been drawn, too: clear, and in an arm's reach."""
    stands = case.scenario.item(case.item)
    for _ in range(MOVE_DRAWS):
        dx, dy, dyaw = case.number(-0.05, 0.05), case.number(-0.05, 0.05), case.number(-0.6, 0.6)
        place = stands.model_copy(
            update={"x": stands.x + dx, "y": stands.y + dy, "yaw": wrap(stands.yaw + dyaw)}
        )
        if why_not(case.site, case.scenario, place) is not None:
            continue
        if case.out_of_reach(case.scenario.with_item(place), case.item) is None:
            return ItemMoves(item=case.item, dx=dx, dy=dy, dyaw=dyaw, when=when)
    raise ScenarioError(f"{case.scenario.name}: no free place within 5 cm of item {case.item}")


def _stall(case: Case) -> tuple[Fault, ...]:
    """Draw a joint of the arm that moves, whichever that is."""
    when = ArmMoving(nth=case.nth(MOTIONS), after=case.number(0.1, 0.6))
    joints = min(len(case.robot.group(arm).joints) for arm in _arms(case))
    return (JointStall(joint=int(case.rng.integers(joints)), lasts=case.number(1, 4), when=when),)


def _arms(case: Case) -> tuple[str, ...]:
    return tuple(hand.group for hand in case.robot.end_effectors)


RECOVERABLE: Final[Mapping[str, Draw]] = MappingProxyType(
    {
        "camera dark": lambda c: (CameraDark(lasts=c.number(2, 6), when=CameraUsed(nth=c.nth(LOOKS))),),
        "camera frozen": lambda c: (CameraFrozen(lasts=c.number(2, 6), when=CameraUsed(nth=c.nth(LOOKS))),),
        "camera silent": lambda c: (CameraSilent(lasts=c.number(2, 6), when=CameraUsed(nth=c.nth(LOOKS))),),
        "laser silent": lambda c: (
            LaserSilent(lasts=c.number(1, 5), when=BaseMoving(nth=c.nth(DRIVES), after=0.5)),
        ),
        "odometry jumps": lambda c: (
            OdometryJump(
                dx=c.number(-0.3, 0.3),
                dy=c.number(-0.3, 0.3),
                dyaw=c.number(-0.5, 0.5),
                when=BaseMoving(nth=c.nth(DRIVES), after=c.number(0.2, 1.5)),
            ),
        ),
        "joint stalls": _stall,
        "gripper stuck": lambda c: (
            GripperStuck(lasts=c.number(3, 8), when=ArmMoving(nth=c.nth(MOTIONS), after=0.3)),
        ),
        "dropped when lifted": lambda c: (HandOpens(when=ItemLifted(item=c.item, after=c.number(0.0, 0.2))),),
        "squeezed, then lost": lambda c: (HandOpens(when=GripperClosed(after=c.number(0.1, 0.6))),),
        "hardware silent": lambda c: (HardwareSilent(lasts=c.number(1, 5), at=c.number(3, 40)),),
        "bumper": lambda c: (
            BumperPressed(
                lasts=c.number(0.5, 2), when=BaseMoving(nth=c.nth(DRIVES), after=c.number(0.3, 1.5))
            ),
        ),
        "item moved on the way": _moved_on_the_way,
        "item moved before the grasp": _moved_before_the_grasp,
        "way blocked for a while": _way_blocked,
        "slot taken": lambda _: (DepotTaken(slot=0),),
    }
)
"""Each leaves a way to the item and to the depot, sooner or later."""
NETWORK: Final = "bad network"

_K: Final = FailureKind


def _all_slots(case: Case) -> tuple[Fault, ...]:
    return tuple(DepotTaken(slot=slot) for slot in range(len(case.site.depots[0].slots)))


HOPELESS: Final[Mapping[str, tuple[Draw, frozenset[FailureKind]]]] = MappingProxyType(
    {
        "item gone": (lambda c: (ItemGone(item=c.item, at=0.0),), frozenset((_K.ITEM_NOT_FOUND,))),
        "depot full": (_all_slots, frozenset((_K.DESTINATION_FULL,))),
        "stop pressed": (
            lambda c: (StopSet(when=ArmMoving(nth=c.nth(MOTIONS), after=0.3)),),
            frozenset((_K.HARDWARE_STOPPED,)),
        ),
        "camera dark for good": (lambda _: (CameraDark(at=0.0),), frozenset((_K.CAMERA_BLIND,))),
        "camera silent for good": (
            lambda c: (CameraSilent(when=CameraUsed(nth=c.nth(LOOKS))),),
            frozenset((_K.CAMERA_SILENT,)),
        ),
        "laser silent for good": (
            lambda _: (LaserSilent(when=BaseMoving(nth=1, after=0.5)),),
            frozenset((_K.LASER_SILENT, _K.NOT_LOCALISED)),
        ),
        "grippers stuck for good": (lambda _: (GripperStuck(at=0.0),), frozenset((_K.GRIPPER_STUCK,))),
        "hardware silent for good": (
            lambda c: (HardwareSilent(at=c.number(5, 30)),),
            frozenset((_K.HARDWARE_LOST,)),
        ),
        "arms stall for good": (
            # All with the first motion of any arm: a task whose one arm is stuck may never move the other.
            lambda c: tuple(JointStall(group=arm, when=ArmMoving(nth=1, after=0.3)) for arm in _arms(c)),
            frozenset((_K.ITEM_UNREACHABLE,)),
        ),
    }
)
"""Nothing on board helps; the kinds of which one must be told."""


def draw_recoverable(case: Case) -> Trouble:
    """Draw one to three different faults that can be recovered from; now and then on a bad network too."""
    count = int(case.rng.integers(1, MOST_FAULTS + 1))
    names = [*RECOVERABLE, NETWORK]
    chosen = sorted(str(name) for name in case.rng.choice(names, size=count, replace=False))
    faults = tuple(fault for name in chosen if name != NETWORK for fault in RECOVERABLE[name](case))
    return Trouble(", ".join(chosen), faults, BAD_NETWORK if NETWORK in chosen else None)


def draw_hopeless(case: Case, run: int) -> Trouble:
    """Return the fault of this run, all of them in turn."""
    names = tuple(HOPELESS)
    name = names[run % len(names)]
    draw, ends_in = HOPELESS[name]
    return Trouble(name, draw(case), None, ends_in)
