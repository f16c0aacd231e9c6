"""TWO_HANDS against a carton that is only a spring: arms that follow to the letter, wrists that feel it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import pytest

from tandem.skills.bimanual.hold import TwoArms
from tandem.skills.bimanual.two_hands import HoldWithTwo
from tandem.skills.geometry.poses import conjugate, from_axes, rotate
from tandem.skills.ports.actions.bimanual import (
    PAIR,
    TwoHands,
    TwoHandsFeedback,
    TwoHandsGoal,
    TwoHandsResult,
)
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import Wrench
from tandem.skills.ports.keys import JOINT_STATES, Latest, group_setpoint, wrench
from tandem.skills.ports.message import Quaternion, RobotTime, Vector3
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.reflex import PipelineState, pipeline_state
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.ports.world import ROBOT_POSE, WORLD, ItemFact, WorldState
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.robot_pose import localised
from tests.skills.reflex.two_arms import joint_states, positions, robot

SITE = load("bimanual")
STIFF, HALF = 20_000.0, 0.2
"""N/m of each side of the carton; half its width in m."""
TIP = 0.015
"""Metres from the tool's origin to the fingertips."""
BESIDE = (0.35, 0.95, 1.6, 1.75, -0.75, 0.0, 0.0)
SQUEEZE = TwoHandsGoal(do=TwoHands.SQUEEZE, item=0)


@dataclass
class Rig:
    """Arms, wrists and beliefs; the carton's centre is at ``y`` = 0 of the base, 0.55 m ahead."""

    stuck: str = ""
    soft: frozenset[str] = frozenset()
    """Sides on which there is nothing to feel."""
    bus: MemoryBus = field(default_factory=MemoryBus)
    clocks: SteppedClocks = field(default_factory=lambda: SteppedClocks("test"))

    def __post_init__(self) -> None:
        self.description, self.hulls = robot()
        self.arms = TwoArms(self.bus, self.clocks, self.description, self.hulls)
        self.skill = HoldWithTwo(self.bus, self.clocks, SITE, self.arms)
        self.at = positions()
        self._points = {side: Latest(self.bus, group_setpoint(f"arm_{side}")) for side in PAIR}
        self.carton = Pose(position=(0.55, 0.0, 0.91))
        self.believe(from_axes((0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (-1.0, 0.0, 0.0)))
        stamp = RobotTime(boot="test", seconds=0.0)
        ROBOT_POSE.publish(self.bus, localised(stamp))
        self._place_hands()
        self.period()

    def believe(self, orientation: Quaternion) -> None:
        """Have the carton's tag be believed before it, turned like that."""
        stamp = RobotTime(boot="test", seconds=0.0)
        tag = Pose(position=(0.40, 0.0, 0.91), orientation=orientation)
        fact = ItemFact(
            item=0, size=(0.3, 0.4, 0.4), tag_in_map=tag, seen=stamp, quality=1.0, position_sigma=0.001
        )
        WORLD.publish(self.bus, WorldState(stamp=stamp, version=1, items=(fact,)))

    def _place_hands(self) -> None:
        """Put both hands 8 cm from the carton, fingers inwards, by the arms' own kinematics."""
        for arm, sign in zip(self.arms.arms, (1.0, -1.0), strict=True):
            self.at |= dict(zip(arm.joints, BESIDE, strict=True))
            arm.begin(self.at)
            q, inwards = arm.q, (0.0, -sign, 0.0)
            tool = Pose(
                position=(0.51, sign * 0.28, 0.95),
                orientation=from_axes(inwards, (sign, 0.0, 0.0), (0.0, 0.0, 1.0)),
            )
            for _ in range(200):
                q = arm.ahead(q, tool).q
            assert arm.ahead(q, tool).metres < 1e-3
            self.at |= dict(zip(arm.joints, map(float, q), strict=True))

    def period(self) -> None:
        """Let 10 ms pass."""
        self.clocks.advance(0.01)
        for side in PAIR:
            point = self._points[side].refresh()
            joints = self.description.group(f"arm_{side}").joints
            if point is not None and side != self.stuck:
                self.at |= dict(zip(joints, point.positions, strict=True))
        now = self.clocks.seconds
        JOINT_STATES.publish(self.bus, joint_states(now, self.at))
        tools = self.hulls.robot.poses([arm.frame for arm in self.arms.arms], self.at)
        for side, tool in zip(PAIR, tools, strict=True):
            told = Wrench(
                stamp=RobotTime(boot="test", seconds=now),
                side=side,
                force=self._feels(side, tool),
                torque=(0, 0, 0),
            )
            wrench(side).publish(self.bus, told)
        self.arms.step()

    def _feels(self, side: str, tool: Pose) -> Vector3:
        """Return what the carton's side presses on a wrist, in its own axes."""
        outwards = 1.0 if side == "left" else -1.0
        deep = HALF + TIP - outwards * tool.position[1]
        newtons = 0.0 if side in self.soft else STIFF * max(0.0, deep)
        return rotate(conjugate(tool.orientation), (0.0, outwards * newtons, 0.0))

    def run(
        self, goal: TwoHandsGoal, *, seconds: float = 15.0, cancel_at: float = math.inf
    ) -> Outcome[TwoHandsResult]:
        """Run a goal to its end."""
        steps = self.skill.run(goal, "t/two/1")
        began, command = self.clocks.seconds, Command.GO_ON
        next(steps)
        while self.clocks.seconds - began < seconds:
            self.period()
            if self.clocks.seconds - began >= cancel_at and command is Command.GO_ON:
                command = Command.CANCEL
            try:
                told = steps.send(command)
            except StopIteration as stop:
                ended: Outcome[TwoHandsResult] = stop.value
                return ended
            assert isinstance(told, TwoHandsFeedback) or told.cost <= 0.005
        raise AssertionError("it does not end")


def held() -> Rig:
    """Return a rig with the carton between its hands."""
    rig = Rig()
    outcome = rig.run(SQUEEZE)
    assert outcome.result is not None, outcome.failure
    return rig


def up(metres: float) -> TwoHandsGoal:
    return TwoHandsGoal(
        do=TwoHands.MOVE, item=0, to=Pose(position=(0.55, 0.0, 0.91 + metres), orientation=(0, 0, 1, 0))
    )


def test_a_squeeze_ends_when_both_wrists_agree_and_is_kept() -> None:
    rig = held()
    for _ in range(100):
        rig.period()
    assert rig.arms.forces == pytest.approx((70.0, 70.0), abs=3.0)


def test_both_hands_move_as_one() -> None:
    rig = held()
    before = rig.arms.tools()
    outcome = rig.run(up(0.08))
    assert outcome.result is not None, outcome.failure
    assert outcome.result.tilt < 0.005
    for was, now in zip(before, rig.arms.tools(), strict=True):
        rise = [b - a for a, b in zip(was.position, now.position, strict=True)]
        assert rise == pytest.approx([0.0, 0.0, 0.08], abs=0.003)


def test_letting_go_draws_both_hands_back() -> None:
    rig = held()
    assert rig.run(TwoHandsGoal(do=TwoHands.RELEASE, item=0, apart=0.05)).result is not None
    left, right = rig.arms.tools()
    assert left.position[1] == pytest.approx(0.265, abs=0.005)
    assert right.position[1] == pytest.approx(-0.265, abs=0.005)
    assert not rig.arms.leading


@pytest.mark.parametrize("side", PAIR)
def test_a_hand_that_feels_nothing_is_named(side: str) -> None:
    rig = Rig(soft=frozenset((side,)))
    failure = rig.run(SQUEEZE).failure
    assert failure is not None
    assert (failure.kind, failure.evidence["arm"]) == (FailureKind.FORCE_MISSING, side)
    assert not rig.arms.leading


@pytest.mark.parametrize("side", PAIR)
def test_an_arm_that_fails_is_named_and_the_other_goes_on_holding(side: str) -> None:
    rig = held()
    rig.stuck = side
    failure = rig.run(up(0.10)).failure
    assert failure is not None
    assert failure.evidence["arm"] == side
    assert failure.kind in {FailureKind.ARM_STOPPED, FailureKind.GRASP_LOST}
    assert rig.arms.leading


def test_a_cancel_on_the_way_stops_and_holds() -> None:
    rig = held()
    outcome = rig.run(up(0.10), cancel_at=0.6)
    assert outcome.canceled
    there = rig.arms.tools()[0].position
    for _ in range(50):
        rig.period()
    assert rig.arms.tools()[0].position == pytest.approx(there, abs=0.002)
    assert min(rig.arms.forces) > 30.0


def test_a_way_that_an_arm_does_not_get_along_moves_nothing() -> None:
    rig = held()
    before = rig.arms.tools()[0].position
    failure = rig.run(up(0.9)).failure
    assert failure is not None
    assert failure.kind is FailureKind.NO_IK
    assert rig.arms.tools()[0].position == pytest.approx(before, abs=0.002)


def test_what_does_not_need_two_hands_is_refused() -> None:
    refused = Rig().skill.check(TwoHandsGoal(do=TwoHands.SQUEEZE, item=29))
    assert refused is not None
    assert refused.kind is FailureKind.INVALID_GOAL


def test_a_carton_that_has_fallen_over_is_not_squeezed() -> None:
    rig = Rig()
    rig.believe(IDENTITY.orientation)
    with pytest.raises(StopIteration) as at_once:
        next(rig.skill.run(TwoHandsGoal(do=TwoHands.SQUEEZE, item=0), "t/two/1"))
    outcome: Outcome[TwoHandsResult] = at_once.value.value
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.ITEM_UNREACHABLE
    assert not rig.arms.leading


def taken(rig: Rig, side: str, reflex: str = "yields") -> None:
    """Have the owner of an arm tell that a reflex has it; "" that none has."""
    why = Failure(kind=FailureKind.HARDWARE_LOST, message="nobody sees it") if reflex else None
    stamp = RobotTime(boot="test", seconds=rig.clocks.seconds)
    state = PipelineState(stamp=stamp, resource=f"arm_{side}", reflex=reflex, why=why)
    pipeline_state(f"arm_{side}").publish(rig.bus, state)


@pytest.mark.parametrize("side", PAIR)
def test_a_reflex_that_takes_an_arm_has_both_let_go_and_the_goal_says_so(side: str) -> None:
    rig = held()
    run = rig.skill.run(up(0.10), "t/two/2")
    next(run)
    for _ in range(30):
        rig.period()
        run.send(Command.GO_ON)
    taken(rig, side)
    rig.period()
    assert not rig.arms.leading
    with pytest.raises(StopIteration) as ended:
        run.send(Command.GO_ON)
    outcome: Outcome[TwoHandsResult] = ended.value.value
    assert outcome.failure is not None
    assert (outcome.failure.kind, outcome.failure.reason.kind) == (
        FailureKind.OVERRIDDEN,
        FailureKind.HARDWARE_LOST,
    )


def test_while_a_reflex_has_an_arm_both_hands_begin_nothing() -> None:
    rig = Rig()
    taken(rig, "left")
    rig.period()
    refused = rig.skill.check(SQUEEZE)
    assert refused is not None
    assert (refused.kind, refused.evidence) == (FailureKind.BUSY, {"reflex": "yields"})
    taken(rig, "left", "")
    rig.period()
    assert rig.skill.check(SQUEEZE) is None
