"""The coordination as a node: what is told of arms and reflex goes in, the right of way comes out."""

from __future__ import annotations

import pytest

from tandem.skills.bimanual.coordination import Mode
from tandem.skills.bimanual.coordinator import Coordinator
from tandem.skills.ports.actions.approach import ApproachStatus, approach_status
from tandem.skills.ports.actions.bimanual import CROSSING, PAIR, RIGHT_OF_WAY, Crossing, Order, RightOfWay
from tandem.skills.ports.hardware import CancelMotion
from tandem.skills.ports.keys import JOINT_STATES, Latest, group_cancel
from tandem.skills.ports.message import RobotTime, Vector3
from tandem.skills.wire.memory import MemoryBus
from tests.skills.reflex.two_arms import ASIDE, IN_FRONT, joint_states, positions, robot

PERIOD = 0.01
GO, HOLD, BACK, STOP = Order.GO, Order.HOLD, Order.BACK, Order.STOP
GOALS: dict[str, Vector3] = {"left": (0.6, 0.3, 0.8), "right": (0.6, -0.3, 0.8)}
"""On each arm's own side."""


class Rig:
    """Both arms on their way to their items, as far as one hears; ``risk`` and ``near`` from the reflex."""

    def __init__(self) -> None:
        self.bus, self.seconds = MemoryBus(), 0.0
        description, hulls = robot()
        assert description.arms_crossing is not None
        self.node = Coordinator(self.bus, description, description.arms_crossing, hulls)
        self._heard = Latest(self.bus, RIGHT_OF_WAY)
        self._cancels = {side: self.bus.serve(group_cancel(f"arm_{side}").key) for side in PAIR}
        self.risk = self.near = False
        self.moving, self.approaching = True, True
        self.still: set[str] = set()
        self.done: set[str] = set()
        self.where: dict[str, tuple[float, ...]] = dict.fromkeys(PAIR, ASIDE)
        self.goals = dict(GOALS)
        self.ends: dict[str, tuple[float, ...]] = dict.fromkeys(PAIR, ())
        self.at = {"left": 5, "right": 5}

    def round(self) -> RightOfWay:
        """Tell all once, let the node work, return the last that it told."""
        self.seconds += PERIOD
        stamp = RobotTime(boot="test", seconds=self.seconds)
        speed = 0.5 if self.moving else 0.0
        speeds = {f"arm_{side}_3_joint": 0.0 if side in self.still else speed for side in PAIR}
        crossing = Crossing(
            stamp=stamp, risk=self.risk, distance=0.1, threshold=0.2, clearance=0.03, near=self.near
        )
        CROSSING.publish(self.bus, crossing)
        for side, distance in zip(PAIR, (0.2, 0.4), strict=True):
            status = ApproachStatus(
                stamp=stamp,
                side=side,
                active=self.approaching and side not in self.done,
                distance=distance,
                goal_in_base=self.goals[side],
                goal_positions=self.ends[side],
                recorded=6,
                at=self.at[side],
            )
            approach_status(f"arm_{side}").publish(self.bus, status)
        where = positions(self.where["left"], self.where["right"])
        JOINT_STATES.publish(self.bus, joint_states(self.seconds, where, speeds))
        self.node.step()
        told = self._heard.refresh()
        assert told is not None
        return told

    def braked(self) -> int:
        """Return how many arms the hardware was told to stop."""
        asked = [request for desk in self._cancels.values() for request in desk.drain()]
        return len([CancelMotion.model_validate_json(each.payload) for each in asked])


@pytest.fixture
def rig() -> Rig:
    return Rig()


def orders(told: RightOfWay) -> tuple[Order, ...]:
    return tuple(each.order for each in told.orders)


def test_nobody_coordinates_a_risk_stops_the_hardware_of_both_arms_at_once(rig: Rig) -> None:
    rig.round()
    rig.risk = True
    assert orders(rig.round()) == (STOP, STOP)
    assert rig.braked() == 2
    rig.round()
    assert rig.braked() == 0, "once"


@pytest.mark.parametrize(
    ("mode", "risk", "near", "stops"),
    [("faithful", True, False, True), ("eager", True, False, False), ("eager", True, True, True)],
)
def test_faithful_the_algorithm_stops_the_arms_eager_their_true_distance(
    rig: Rig, mode: Mode, *, risk: bool, near: bool, stops: bool
) -> None:
    rig.node.begin(mode)
    rig.round()
    rig.risk, rig.near = risk, near
    told = rig.round()
    assert orders(told) == ((HOLD, BACK) if stops else (GO, GO))
    assert told.leader == ("left" if stops else None), "the nearer one"
    assert rig.braked() == 0, "the arms brake themselves"


@pytest.mark.parametrize(("phi", "sample"), [(None, 4), (0.4, 3)])
def test_at_a_new_risk_the_follower_goes_further_back_by_phi(
    rig: Rig, phi: float | None, sample: int
) -> None:
    rig.node.begin("faithful", phi)
    rig.risk = True
    rig.round()
    rig.moving = False
    told = rig.round()
    assert told.orders[1].sample == sample


def test_eager_the_follower_goes_on_once_its_way_has_been_clear_for_a_while(rig: Rig) -> None:
    rig.node.begin("eager")
    rig.risk = rig.near = True
    rig.round()
    rig.moving = rig.risk = rig.near = False
    told = [orders(rig.round()) for _ in range(200)]
    assert (GO, BACK) in told
    assert told[-1] == (GO, GO), "each to its own side: they never come near"


@pytest.mark.parametrize(("y", "goes"), [(0.3, True), (-0.5, False)], ids=["own side", "across the other"])
def test_eager_the_leader_goes_on_once_the_follower_is_out_of_its_way(
    rig: Rig, y: float, *, goes: bool
) -> None:
    rig.node.begin("eager")
    rig.risk = rig.near = True
    rig.goals["left"] = (0.6, y, 0.8)
    rig.round()
    rig.risk, rig.near, rig.still = False, False, {"left"}
    told = [orders(rig.round()) for _ in range(60)]
    assert ((GO, BACK) in told) is goes, "the follower is still on its way back"


@pytest.mark.parametrize(
    ("mode", "ends", "leader"),
    [
        ("eager", IN_FRONT, "left"),
        ("eager", ASIDE, None),
        ("eager", (), None),
        ("faithful", IN_FRONT, None),
    ],
    ids=["their ends are near each other", "each on its own side", "no end is known yet", "faithful"],
)
def test_eager_one_gives_way_as_soon_as_both_have_told_ways_that_cross(
    rig: Rig, mode: Mode, ends: tuple[float, ...], leader: str | None
) -> None:
    rig.node.begin(mode)
    rig.ends = dict.fromkeys(PAIR, ends)
    rig.goals = dict.fromkeys(PAIR, (0.6, 0.0, 0.8)) if ends == IN_FRONT else GOALS
    told = [rig.round() for _ in range(40)]
    assert told[-1].leader == leader
    assert {each.episode for each in told} == {0}, "nobody was stopped"


def test_eager_who_gives_way_stands_where_it_would_come_into_the_leaders_way(rig: Rig) -> None:
    rig.node.begin("eager")
    rig.ends = dict.fromkeys(PAIR, IN_FRONT)
    rig.goals = dict.fromkeys(PAIR, (0.6, 0.0, 0.8))
    for _ in range(40):
        rig.round()
    rig.where["right"] = IN_FRONT
    assert (GO, HOLD) in [orders(rig.round()) for _ in range(40)]


@pytest.mark.parametrize(("waits", "goes"), [(True, True), (False, False)])
def test_eager_a_leader_that_waits_holds_nobody_up(rig: Rig, *, waits: bool, goes: bool) -> None:
    """It may wait for the other one, to grasp together."""
    rig.node.begin("eager")
    rig.ends = dict.fromkeys(PAIR, IN_FRONT)
    rig.goals = dict.fromkeys(PAIR, (0.6, 0.0, 0.8))
    for _ in range(40):
        rig.round()
    rig.where["right"], rig.still = IN_FRONT, {"left"}
    if waits:
        rig.done = {"left"}
    told = [orders(rig.round()) for _ in range(300)]
    assert (GO, HOLD) in told
    assert (told[-1] == (GO, GO)) is goes


def test_the_stops_are_counted_on_when_the_coordination_begins_and_ends(rig: Rig) -> None:
    rig.round()
    rig.risk = True
    assert rig.round().episode == 1
    rig.moving = rig.approaching = rig.risk = False
    rig.round()
    rig.node.begin("faithful")
    rig.moving = rig.approaching = rig.risk = True
    assert rig.round().episode == 2
    rig.node.end()
    assert rig.round().episode >= 2


def test_it_rules_once_for_each_message_of_the_joints(rig: Rig) -> None:
    rig.round()
    seen = rig.node.seen
    rig.node.step()
    assert rig.node.seen is seen
