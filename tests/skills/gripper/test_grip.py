"""Opening, closing and grasping, with a gripper that is told what lies between its pads."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest

from tandem.skills.gripper.grip import PATIENCE
from tandem.skills.gripper.process import nodes
from tandem.skills.ports.action import (
    GoalCommand,
    GoalState,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    status_topic,
)
from tandem.skills.ports.actions.gripper import Grip, GripGoal, GripResult
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import Answer, GripperCommand, GripperMotion, GripperState
from tandem.skills.ports.keys import Latest, gripper_command, gripper_state
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import Gripper, RobotDescription
from tandem.skills.ports.skill import Command
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus

ACTION = "gripper_left/grip"
SPEED = 0.05


@dataclass
class Fingers:
    """Pads 5 cm/s fast; ``between`` stops them at its width, ``jammed`` where they are.

    So many answers as ``answers_lost`` says never arrive.
    """

    bus: MemoryBus
    clocks: SteppedClocks
    between: float = 0.0
    jammed: bool = False
    width: float = 0.045
    answers_lost: int = 0
    commands: list[GripperCommand] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._desk = self.bus.serve(gripper_command("left").key)

    def step(self) -> None:
        for request in self._desk.drain():
            self.commands.append(GripperCommand.model_validate_json(request.payload))
            if self.answers_lost:
                self.answers_lost -= 1
                continue
            request.reply(Answer(accepted=True).model_dump_json().encode())
        motion, force, command_id = GripperMotion.IDLE, 0.0, ""
        if self.commands:
            command = self.commands[-1]
            command_id = command.id
            wanted = max(command.width, self.between)
            step = SPEED * 0.02
            if abs(wanted - self.width) > step and not self.jammed:
                self.width += step if wanted > self.width else -step
                motion = GripperMotion.MOVING
            else:
                self.width = self.width if self.jammed else wanted
                stalled = abs(self.width - command.width) > 0.002
                motion = GripperMotion.STALLED if stalled else GripperMotion.AT_WIDTH
                force = command.force if stalled and not self.jammed else 0.0
        state = GripperState(
            stamp=RobotTime(boot="test", seconds=self.clocks.seconds),
            side="left",
            command_id=command_id,
            motion=motion,
            width=self.width,
            force=force,
        )
        gripper_state("left").publish(self.bus, state)


class Rig:
    def __init__(self, closed: float = 0.0) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("test")
        self.fingers = Fingers(self.bus, self.clocks)
        (self.server, self.watch) = nodes(self.bus, self.clocks, closing_to(closed), "left")
        self.status = Latest(self.bus, status_topic(ACTION))

    def rounds(self, count: int) -> None:
        for _ in range(count):
            self.clocks.advance(0.02)
            self.fingers.step()
            self.server.step()

    def send(self, goal: GripGoal) -> Pending:
        sent = SendGoal(goal_id="t/grip/1", client="", goal=goal.model_dump(mode="json"))
        return goal_service(ACTION).query(self.bus, sent)

    def run(self, goal: GripGoal) -> GoalStatus:
        self.send(goal)
        return self.end()

    def end(self) -> GoalStatus:
        for _ in range(500):
            self.rounds(1)
            status = self.status.refresh()
            if status is not None and status.state.terminal:
                return status
        raise AssertionError(self.status.value)


def closing_to(width: float) -> RobotDescription:
    robot = mock_description()
    hands = tuple(
        hand.model_copy(update={"gripper": hand.gripper.model_copy(update={"min_width": width})})
        for hand in robot.end_effectors
    )
    return robot.model_copy(update={"end_effectors": hands})


@pytest.fixture
def rig() -> Rig:
    return Rig()


def result(status: GoalStatus) -> GripResult:
    assert status.result is not None, status.failure
    return GripResult.model_validate(status.result)


def kind(status: GoalStatus) -> FailureKind:
    assert status.failure is not None
    return status.failure.kind


def test_it_opens_all_the_way_and_to_a_width(rig: Rig) -> None:
    assert result(rig.run(GripGoal(grip=Grip.OPEN))).width == pytest.approx(0.09)
    assert rig.fingers.commands[-1].width == pytest.approx(0.09)


def test_a_hand_that_has_opened_is_not_waited_for(rig: Rig) -> None:
    rig.run(GripGoal(grip=Grip.OPEN))
    assert rig.clocks.seconds < (0.09 - 0.045) / SPEED + 0.1


def test_a_command_whose_answer_is_lost_is_sent_again_as_it_was(rig: Rig) -> None:
    rig.fingers.answers_lost = 2
    assert result(rig.run(GripGoal(grip=Grip.OPEN))).width == pytest.approx(0.09)
    assert len(rig.fingers.commands) == 3
    assert len({each.id for each in rig.fingers.commands}) == 1


def test_a_hand_that_never_answers_is_lost(rig: Rig) -> None:
    rig.fingers.answers_lost = 9
    assert kind(rig.run(GripGoal(grip=Grip.OPEN))) is FailureKind.HARDWARE_LOST


def test_it_closes_on_nothing(rig: Rig) -> None:
    closed = result(rig.run(GripGoal(grip=Grip.CLOSE)))
    assert closed.width == pytest.approx(0.0)
    assert not closed.full


def test_a_grasp_of_something_of_the_width_expected_is_full(rig: Rig) -> None:
    rig.fingers.between, rig.fingers.width = 0.06, 0.09
    held = result(rig.run(GripGoal(grip=Grip.GRASP, width=0.06, force=10.0)))
    assert held.full
    assert held.force == pytest.approx(10.0)


@pytest.mark.parametrize(("between", "full"), [(0.0, False), (0.05, True)])
def test_pads_that_do_not_meet_are_empty_when_they_are_closed(between: float, *, full: bool) -> None:
    rig = Rig(closed=0.03)
    rig.fingers.between, rig.fingers.width = between, 0.09
    ended = rig.run(GripGoal(grip=Grip.GRASP, width=0.05, force=10.0))
    assert rig.fingers.commands[-1].width == pytest.approx(0.03)
    if full:
        assert result(ended).full
    else:
        assert kind(ended) is FailureKind.GRASP_EMPTY


def test_a_grasp_of_nothing_is_empty(rig: Rig) -> None:
    assert kind(rig.run(GripGoal(grip=Grip.GRASP, width=0.06))) is FailureKind.GRASP_EMPTY


def test_a_grasp_of_something_else_is_empty(rig: Rig) -> None:
    rig.fingers.between = 0.02
    assert kind(rig.run(GripGoal(grip=Grip.GRASP, width=0.06))) is FailureKind.GRASP_EMPTY


JAMMED = [GripGoal(grip=Grip.OPEN), GripGoal(grip=Grip.CLOSE), GripGoal(grip=Grip.GRASP, width=0.06)]


@pytest.mark.parametrize("goal", JAMMED, ids=lambda goal: goal.grip.value)
def test_pads_that_do_not_move_and_press_on_nothing_are_stuck(rig: Rig, goal: GripGoal) -> None:
    rig.fingers.jammed, rig.fingers.width = True, 0.08
    assert kind(rig.run(goal)) is FailureKind.GRIPPER_STUCK


@pytest.mark.parametrize("goal", JAMMED, ids=lambda goal: goal.grip.value)
def test_pads_that_are_stuck_for_a_while_are_told_again(rig: Rig, goal: GripGoal) -> None:
    rig.fingers.jammed, rig.fingers.width = True, 0.08
    rig.fingers.between = goal.width
    rig.send(goal)
    rig.rounds(round((PATIENCE - 0.5) / 0.02))
    rig.fingers.jammed = False
    assert rig.end().state is GoalState.SUCCEEDED


def test_a_cancel_comes_through_to_stuck_pads(rig: Rig) -> None:
    rig.fingers.jammed = True
    rig.send(GripGoal(grip=Grip.OPEN))
    rig.rounds(50)
    command_service(ACTION).query(rig.bus, GoalCommand(goal_id="t/grip/1", command=Command.CANCEL))
    rig.rounds(5)
    status = rig.status.refresh()
    assert status is not None
    assert status.state is GoalState.CANCELED


def test_a_check_moves_nothing_and_tells_whether_the_hand_is_full(rig: Rig) -> None:
    rig.fingers.between, rig.fingers.width = 0.06, 0.09
    rig.run(GripGoal(grip=Grip.GRASP, width=0.06))
    commands = len(rig.fingers.commands)
    goal = GripGoal(grip=Grip.CHECK, width=0.06)
    goal_service(ACTION).query(
        rig.bus, SendGoal(goal_id="t/check/1", client="", goal=goal.model_dump(mode="json"))
    )
    rig.rounds(5)
    status = rig.status.refresh()
    assert status is not None
    assert result(status).full
    assert len(rig.fingers.commands) == commands


def test_a_cancel_holds_where_the_pads_are(rig: Rig) -> None:
    rig.fingers.width = 0.0
    rig.send(GripGoal(grip=Grip.OPEN))
    rig.rounds(10)
    goal_command = GoalCommand(goal_id="t/grip/1", command=Command.CANCEL)
    command_service(ACTION).query(rig.bus, goal_command)
    assert rig.end().state is GoalState.CANCELED
    assert 0.0 < rig.fingers.width < 0.05


@pytest.mark.parametrize(
    "goal",
    [
        GripGoal(grip=Grip.OPEN, width=0.5),
        GripGoal(grip=Grip.GRASP, width=0.0),
        GripGoal(grip=Grip.GRASP, width=0.05, force=1e4),
    ],
    ids=["too wide", "no width", "too strong"],
)
def test_goals_beyond_the_gripper_are_rejected(rig: Rig, goal: GripGoal) -> None:
    sent = rig.send(goal)
    rig.rounds(1)
    answer = sent.poll()
    assert answer is not None
    assert GoalStatus.model_validate_json(answer).state is GoalState.REJECTED


def test_a_gripper_that_closes_as_wide_as_it_opens_is_refused() -> None:
    with pytest.raises(ValueError, match=r"expected a min_width below max_width, found 0\.08 and 0\.074 m"):
        Gripper(joints=("a", "b"), min_width=0.08, max_width=0.074, speed=0.05, force=5.0)
