"""What the campaigns call right: each rule of it, broken alone, is told."""

from __future__ import annotations

import pytest

from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.campaigns.oracle import Oracle, Verdict, bumped, misplaced
from tandem.executive.trials.campaigns.recovery import unstruck, wrong_in
from tandem.sim.controls import MOVE, MoveRequest
from tandem.sim.faults import BaseMoving, CameraDark, DepotTaken, Fault, FaultEvent, JointStall
from tandem.sim.scenario import load_scenario
from tandem.sim.truth import TrueBody, TrueContact, TrueTouch, Truth
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import BaseVelocity
from tandem.skills.ports.keys import BASE_VELOCITY
from tandem.skills.ports.message import RobotTime, Vector3
from tandem.skills.ports.pose import IDENTITY, FloorPose, Pose
from tandem.skills.ports.world import WORLD, Placed, WorldState
from tandem.skills.site import load

SITE = load("lab")
SLOT = SITE.depots[0].slots[1].position
STAMP = RobotTime(boot="test", seconds=1.0)


def truth(at: Vector3, *touches: str) -> Truth:
    body = TrueBody(name="item_29", pose=Pose(position=at), item=29)
    contacts = tuple(TrueContact(first="item_29", second=each, force=1.0) for each in touches)
    return Truth(stamp=STAMP, base_in_map=IDENTITY, bodies=(body,), contacts=contacts)


def lying(dx: float = 0.0, dy: float = 0.0, dz: float = 0.0) -> Vector3:
    return (SLOT[0] + dx, SLOT[1] + dy, SLOT[2] + 0.03 + dz)


@pytest.mark.parametrize(
    ("found", "slot", "expected"),
    [
        (truth(lying()), 1, ""),
        (truth(lying(dx=0.04)), 1, ""),
        (truth(lying()), 0, "0.200 m from slot 0, which was reported, and next to slot 1"),
        (truth(lying(dx=0.07)), 1, "0.070 m from slot 1"),
        (truth(lying()), None, "no slot was reported"),
        (truth(lying()), 99, "no slot was reported"),
        (truth(lying(dz=0.1)), 1, "does not lie in the depot"),
        (truth(lying(), "robot/gripper_left_palm_link"), 1, "does not lie in the depot"),
    ],
    ids=[
        "in it",
        "off by 4 cm",
        "in another",
        "beside it",
        "unreported",
        "no such",
        "in the air",
        "in a hand",
    ],
)
def test_an_item_is_right_only_in_the_slot_that_was_reported(
    found: Truth, slot: int | None, expected: str
) -> None:
    told = misplaced(found, SITE, 29, "depot", slot)
    assert len(told) == bool(expected)
    assert expected in "".join(told)


def test_an_item_that_is_gone_is_told() -> None:
    assert misplaced(truth(lying()), SITE, 42, "depot", 1) == ("there is no item 42",)


class Creeping:
    """A node that has the base creep on."""

    name = "creeping"

    def __init__(self, bus: Bus) -> None:
        self._bus = bus

    def step(self) -> bool:
        BASE_VELOCITY.publish(self._bus, BaseVelocity(linear=0.05, angular=0.0))
        return False

    def close(self) -> None:
        """Nothing is held."""


@pytest.mark.lockstep
def test_the_robot_must_be_at_rest_at_home_and_have_pushed_nothing() -> None:
    """The whole system, asked for nothing: somebody puts a parcel into it, and one arm hangs limp."""
    limp = JointStall(group="arm_left", limp=True, at=0.0)
    start = FloorPose(x=-0.15, y=-1.0, yaw=0.0)
    system = LockstepSystem(load_scenario("Demo").starting_at(start).with_faults((limp,)), 1)
    try:
        MOVE.query(system.bus, MoveRequest(name="left_parcel", pose=Pose(position=(-0.15, -1.3, 0.2))))
        system.advance()
        oracle = Oracle(system, SITE, 29, "depot")
        placed = (Placed(item=29, depot="depot", slot=3),)
        WORLD.publish(system.bus, WorldState(stamp=STAMP, version=1, placed=placed))
        assert oracle.slot() == 3
        still = oracle.verdict()
        system.lockstep.nodes.insert(0, Creeping(system.bus))
        creeping = oracle.verdict()
    finally:
        system.close()
    assert "does not lie in the depot" in still.misplaced[0]
    assert "left_parcel falls over" in still.moved[0]
    assert still.untouched == ()
    assert "the base is 2.29 m" in still.not_home[0]
    assert "arm_left is" in still.not_home[1]
    assert len(still.not_home) == 2, "the right arm is where it belongs"
    assert not any("the base" in each for each in still.restless)
    assert "the base moves by 0.0" in creeping.restless[0]
    assert still.wrong == still.misplaced + still.moved + still.touched + still.not_home + still.restless


@pytest.mark.parametrize(
    ("stood", "told"),
    [
        (0.0, "robot touches anna at 3.00 s, when it moved"),
        (0.4, "when it had stood for 0.40 s"),
        (1.0, ""),
    ],
)
def test_who_is_touched_counts_unless_the_base_has_stood(stood: float, told: str) -> None:
    touch = TrueTouch(at=3.0, person="anna", robot="robot", stood=stood)
    said = bumped(truth(lying()).model_copy(update={"touches": (touch,)}))
    assert told in said[0] if told else said == ()


def event(number: int, phase: str) -> FaultEvent:
    return FaultEvent.model_validate(
        {"stamp": STAMP, "number": number, "kind": "camera_dark", "phase": phase, "words": ""}
    )


FAULTS: tuple[Fault, ...] = (CameraDark(at=3.0), CameraDark(when=BaseMoving(nth=9)), DepotTaken())


@pytest.mark.parametrize(
    ("told", "missed"),
    [
        ([(0, "began"), (1, "began"), (2, "began"), (0, "ended")], []),
        ([(0, "began"), (2, "began")], ["camera_dark (base_moving, time 9, 0 s after it)"]),
        ([(0, "began"), (1, "began"), (2, "refused")], ["depot_taken (at 0 s)"]),
        (
            [],
            [
                "camera_dark (at 3 s)",
                "camera_dark (base_moving, time 9, 0 s after it)",
                "depot_taken (at 0 s)",
            ],
        ),
    ],
    ids=["all", "an event that never came", "refused", "none"],
)
def test_a_fault_that_never_began_has_not_struck(told: list[tuple[int, str]], missed: list[str]) -> None:
    assert list(unstruck(FAULTS, [event(*each) for each in told])) == missed


def test_what_a_fault_did_to_the_room_is_not_the_robots_doing() -> None:
    verdict = Verdict(("a",), ("fell", "swept"), ("fell",), ("leg",), ("anna",), ("away",), ("moves",))
    assert wrong_in(verdict, hopeless=False) == ("a", "swept", "leg", "anna", "away", "moves")
    assert wrong_in(verdict, hopeless=True) == ("swept", "leg", "anna", "moves")
    assert verdict.wrong == ("a", "fell", "swept", "leg", "anna", "away", "moves")
