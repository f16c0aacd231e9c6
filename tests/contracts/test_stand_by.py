"""A server whose client hangs: the skill stands by, and goes on when the client does."""

from __future__ import annotations

from tandem.skills.ports.action import (
    AskResult,
    GoalCommand,
    GoalState,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    result_service,
)
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType, Command, Run, canceled
from tandem.skills.server import ORPHANED_AFTER, ActionServer
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub


class Nothing(Message):
    """Nothing to tell."""


class Patient:
    """Notes each command; ends when it is cancelled."""

    action = ActionType("test/patient", Nothing, Nothing, Nothing, timeout=10.0)
    period = 0.02

    def __init__(self) -> None:
        self.heard: list[Command] = []

    def check(self, goal: Nothing) -> Failure | None:  # noqa: ARG002
        return None

    def run(self, goal: Nothing, goal_id: str) -> Run[Nothing, Nothing]:  # noqa: ARG002
        while True:
            command = yield Nothing()
            if command is not Command.GO_ON:
                self.heard.append(command)
            if command is Command.CANCEL:
                return canceled()


class DrowsyBus(MemoryBus):
    """A bus on which some who are announced don't go on."""

    asleep: frozenset[str] = frozenset()

    def awake(self) -> frozenset[str]:
        return self.alive() - self.asleep


class Desk:
    def __init__(self) -> None:
        hub, self.clocks, self.skill = MemoryHub(), SteppedClocks("test"), Patient()
        self.bus, self.client = DrowsyBus(hub), MemoryBus(hub)
        self.client.announce("executive")
        self.server = ActionServer(self.bus, self.clocks, self.skill)
        goal_service("test/patient").query(
            self.client, SendGoal(goal_id="t/a/1", client="executive", goal={})
        )
        self.step()

    def step(self, seconds: float = 0.1) -> None:
        for _ in range(3):
            self.server.step()
        self.clocks.advance(seconds)

    def sleep(self, *, asleep: bool) -> None:
        self.bus.asleep = frozenset({"executive"} if asleep else ())
        self.step()

    def command(self, command: Command) -> None:
        command_service("test/patient").query(self.client, GoalCommand(goal_id="t/a/1", command=command))
        self.step()

    def state(self) -> GoalState:
        pending = result_service("test/patient").query(self.client, AskResult(goal_id="t/a/1"))
        self.step()
        return GoalStatus.model_validate_json(pending.poll() or b"").state


def test_a_goal_stands_by_while_its_client_hangs() -> None:
    desk = Desk()
    desk.sleep(asleep=True)
    assert desk.state() is GoalState.PAUSED
    desk.step(10.0)
    desk.step()
    assert desk.state() is GoalState.PAUSED  # for as long as it is announced
    desk.sleep(asleep=False)
    assert desk.state() is GoalState.RUNNING
    assert desk.skill.heard == [Command.PAUSE, Command.RESUME]


def test_a_client_that_resumes_it_as_well_does_no_harm() -> None:
    desk = Desk()
    desk.sleep(asleep=True)
    desk.sleep(asleep=False)
    desk.command(Command.RESUME)
    assert desk.skill.heard == [Command.PAUSE, Command.RESUME]


def test_a_goal_that_its_client_had_paused_stays_paused() -> None:
    desk = Desk()
    desk.command(Command.PAUSE)
    desk.sleep(asleep=True)
    desk.sleep(asleep=False)
    assert desk.state() is GoalState.PAUSED
    assert desk.skill.heard == [Command.PAUSE]


def test_a_client_that_is_gone_for_good_has_its_goal_cancelled() -> None:
    desk = Desk()
    desk.client.close()
    desk.step(ORPHANED_AFTER + 0.1)
    desk.step()
    assert desk.skill.heard == [Command.PAUSE, Command.CANCEL]
    assert desk.state() is GoalState.CANCELED
