"""The action server, where its skill fails it."""

from __future__ import annotations

import gc
from pathlib import Path

from tandem.skills.goal_journal import KEPT, GoalJournal
from tandem.skills.pipeline import Override, Pipeline, take_all
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
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import LEASES
from tandem.skills.ports.lease import Claim, Held, Lease, Leases
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType, Command, Run
from tandem.skills.server import ActionServer
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus


class Nothing(Message):
    """Nothing to tell."""


class Clumsy:
    """Goes on until it is cancelled, which it stumbles over; notes whether it sent a stop at the last."""

    action = ActionType("test/clumsy", Nothing, Nothing, Nothing, timeout=10.0)
    period = 0.02

    def __init__(self) -> None:
        self.stopped = 0

    def check(self, goal: Nothing) -> Failure | None:  # noqa: ARG002
        return None

    def run(self, goal: Nothing, goal_id: str) -> Run[Nothing, Nothing]:  # noqa: ARG002
        try:
            while (yield Nothing()) is not Command.CANCEL:
                pass
            raise RuntimeError("stumbled over the cancel")
        finally:
            self.stopped += 1


class Desk:
    def __init__(self) -> None:
        self.bus, self.skill = MemoryBus(), Clumsy()
        self.start()

    def start(self) -> None:
        self.pipeline = Pipeline("base")
        self.server = ActionServer(self.bus, SteppedClocks("test"), self.skill, pipelines=(self.pipeline,))

    def send(self, goal_id: str) -> None:
        goal_service("test/clumsy").query(self.bus, SendGoal(goal_id=goal_id, client="", goal={}))
        self.server.step()

    def cancel(self, goal_id: str) -> None:
        command_service("test/clumsy").query(self.bus, GoalCommand(goal_id=goal_id, command=Command.CANCEL))
        self.server.step()

    def ask(self, goal_id: str) -> GoalStatus:
        pending = result_service("test/clumsy").query(self.bus, AskResult(goal_id=goal_id))
        self.server.step()
        return GoalStatus.model_validate_json(pending.poll() or b"")


def test_an_error_while_it_is_cancelled_ends_the_goal_all_the_same() -> None:
    desk = Desk()
    desk.send("t/a/1")
    desk.cancel("t/a/1")
    status = desk.ask("t/a/1")
    assert status.state is GoalState.FAILED
    assert status.failure is not None
    assert status.failure.kind is FailureKind.SKILL_CRASHED
    assert desk.skill.stopped == 1
    desk.send("t/a/2")
    assert desk.ask("t/a/2").state is GoalState.RUNNING


def test_a_goal_whose_cancel_arrives_before_it_never_begins() -> None:
    desk = Desk()
    desk.cancel("t/a/1")
    assert desk.ask("t/a/1").state is GoalState.UNKNOWN
    desk.send("t/a/1")
    assert desk.ask("t/a/1").state is GoalState.CANCELED
    assert not desk.server.busy


WALL = Failure(kind=FailureKind.BASE_BLOCKED, message="a wall")


def test_a_run_ends_with_the_step_in_which_a_reflex_takes_over_and_its_goal_with_the_release() -> None:
    desk = Desk()
    desk.send("t/a/1")
    take_all((desk.pipeline,), Override("avoid", 50, WALL))
    desk.server.step()
    assert desk.skill.stopped == 1
    assert desk.ask("t/a/1").state is GoalState.RUNNING, "the robot still moves"
    desk.pipeline.let_go("avoid")
    status = desk.ask("t/a/1")
    assert status.state is GoalState.FAILED
    assert status.failure is not None
    assert (status.failure.kind, status.failure.causes) == (FailureKind.OVERRIDDEN, (WALL,))
    desk.send("t/a/2")
    assert desk.ask("t/a/2").state is GoalState.RUNNING


def test_a_goal_that_is_cancelled_while_a_reflex_acts_ends_cancelled_with_the_release() -> None:
    desk = Desk()
    desk.send("t/a/1")
    take_all((desk.pipeline,), Override("avoid", 50, WALL))
    desk.server.step()
    desk.cancel("t/a/1")
    assert desk.ask("t/a/1").state is GoalState.CANCELING
    desk.pipeline.let_go("avoid")
    assert desk.ask("t/a/1").state is GoalState.CANCELED


def test_closing_has_the_skill_send_its_stop() -> None:
    desk = Desk()
    desk.send("t/a/1")
    desk.server.close()
    assert desk.skill.stopped == 1


def test_a_server_that_starts_again_does_not_know_the_goals_of_before() -> None:
    desk = Desk()
    desk.send("t/a/1")
    desk.server.close()
    desk.start()
    assert desk.ask("t/a/1").state is GoalState.UNKNOWN


def test_a_goal_that_was_journalled_before_a_restart_is_not_started_again(tmp_path: Path) -> None:
    desk, path = Desk(), tmp_path / "clumsy.goals"
    desk.server.keep(GoalJournal(path))
    desk.send("t/a/1")
    desk.server.close()
    with path.open("a") as torn:
        torn.write("t/a/2")  # without its end of line: it was being written when the process died
    desk.start()
    desk.server.keep(GoalJournal(path))
    again = goal_service("test/clumsy").query(desk.bus, SendGoal(goal_id="t/a/1", client="", goal={}))
    desk.server.step()
    status = GoalStatus.model_validate_json(again.poll() or b"")
    assert (status.state, status.failure and status.failure.kind) == (
        GoalState.FAILED,
        FailureKind.SKILL_LOST,
    )
    assert not desk.server.busy
    desk.send("t/a/2")
    assert desk.server.busy


def held(epoch: int) -> Leases:
    """Return the table after the executive was replaced so often."""
    claim = Claim("aa", epoch, 7, "there").text
    return Leases(boot="boot", held=(Held(role="executive", epoch=epoch, claim=claim),))


def test_goals_of_an_executive_that_was_replaced_are_refused_and_what_it_began_comes_to_rest() -> None:
    desk = Desk()
    LEASES.publish(desk.bus, held(1))
    desk.bus.held = Lease(role="executive", boot="boot", epoch=1)
    desk.send("t/a/1")
    assert desk.server.busy
    LEASES.publish(desk.bus, held(2))
    desk.server.step()
    assert not desk.server.busy, "its goal was cancelled"
    late = goal_service("test/clumsy").query(desk.bus, SendGoal(goal_id="t/b/1", client="", goal={}))
    desk.server.step()
    status = GoalStatus.model_validate_json(late.poll() or b"")
    assert status.state is GoalState.REJECTED
    assert status.failure is not None
    assert status.failure.kind is FailureKind.SUPERSEDED
    assert "process 7 on there" in status.failure.message
    assert not desk.server.busy

    desk.bus.held = Lease(role="executive", boot="boot", epoch=2)
    desk.send("u/a/1")
    assert desk.server.busy
    desk.bus.held = Lease(role="executive", boot="boot", epoch=1)
    pause = GoalCommand(goal_id="u/a/1", command=Command.PAUSE)
    refused = command_service("test/clumsy").query(desk.bus, pause)
    desk.server.step()
    assert GoalStatus.model_validate_json(refused.poll() or b"").state is GoalState.REJECTED
    assert desk.ask("u/a/1").state is GoalState.RUNNING
    desk.cancel("u/a/1")
    assert not desk.server.busy, "coming to rest is always allowed"


def test_a_goal_journal_that_grows_is_rewritten_with_the_newest_ids(tmp_path: Path) -> None:
    path = tmp_path / "many.goals"
    journal = GoalJournal(path)
    for number in range(KEPT + 10):
        journal.accept(f"t/a/{number}")
    journal.close()
    found = GoalJournal(path).before
    assert len(found) == KEPT + 10
    assert len(path.read_text().splitlines()) == KEPT
    assert f"t/a/{KEPT + 9}" in path.read_text()


def test_of_ended_goals_the_answers_are_kept_packed() -> None:
    """As objects, 256 of one skill take 0.5 to 0.7 MB, and those of a rare skill fill up over weeks."""
    desk = Desk()
    for number in range(3):
        desk.send(f"t/packed/{number}")
        desk.cancel(f"t/packed/{number}")
    gc.collect()
    kept = [each for each in gc.get_objects() if isinstance(each, GoalStatus) and "packed" in each.goal_id]
    assert kept == []
    assert desk.ask("t/packed/0").state is GoalState.FAILED
