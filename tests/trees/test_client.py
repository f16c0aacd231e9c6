"""The client adapter against a server that answers late, twice, in the wrong order, anew, or never."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tandem.skills.ports.action import (
    GoalCommand,
    GoalState,
    GoalStatus,
    command_service,
    goal_service,
    result_service,
    status_topic,
)
from tandem.skills.ports.actions.base import ROTATE, RotateGoal, RotateResult
from tandem.skills.ports.bus import Desk
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.skill import Command
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.trees.client import ANSWER_WITHIN, UNSURE_AFTER, ActionClient, GoalHandle

RESULT = RotateResult(turned=1.0).model_dump(mode="json")


class Rig:
    """A client, and a server whose every word the test says."""

    def __init__(self) -> None:
        self.clocks = SteppedClocks()
        hub = MemoryHub()
        self.bus = MemoryBus(hub)
        self.bus.announce(f"skill/{ROTATE.name}")
        self.goals: Desk = self.bus.serve(goal_service(ROTATE.name).key)
        self.questions: Desk = self.bus.serve(result_service(ROTATE.name).key)
        self.commands: Desk = self.bus.serve(command_service(ROTATE.name).key)
        self.client = ActionClient(MemoryBus(hub), self.clocks, ROTATE, "me")
        self.handle = self.client.start(RotateGoal(angle=1.0), "t/turn/1")

    def say(self, state: GoalState, sequence: int, goal_id: str = "t/turn/1") -> GoalStatus:
        result = RESULT if state is GoalState.SUCCEEDED else None
        return GoalStatus(goal_id=goal_id, state=state, sequence=sequence, result=result)

    def publish(self, state: GoalState, sequence: int, goal_id: str = "t/turn/1") -> None:
        status_topic(ROTATE.name).publish(self.bus, self.say(state, sequence, goal_id))

    def answer(self, desk: Desk, status: GoalStatus) -> int:
        asked = desk.drain()
        for request in asked:
            request.reply(status.model_dump_json().encode())
        return len(asked)

    def commanded(self) -> list[Command]:
        """What was commanded since the last call; nothing is answered."""
        asked = [GoalCommand.model_validate_json(each.payload) for each in self.commands.drain()]
        return [each.command for each in asked]

    def obey(self, sequence: int, *states: GoalState) -> None:
        """Answer the commands so far, each with the next of these states."""
        for number, (request, state) in enumerate(zip(self.commands.drain(), states, strict=True)):
            request.reply(self.say(state, sequence + number).model_dump_json().encode())

    def wait(self, seconds: float, each: Callable[[], object] = lambda: None) -> GoalHandle:  # type: ignore[type-arg]
        for _ in range(round(seconds / 0.05)):
            self.clocks.advance(0.05)
            each()
            self.client.poll()
        return self.handle


@pytest.fixture
def rig() -> Rig:
    return Rig()


def test_a_published_end_is_taken(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.publish(GoalState.SUCCEEDED, 2)
    assert rig.wait(0.05).result == RotateResult(turned=1.0)


def test_an_older_status_that_comes_later_is_ignored(rig: Rig) -> None:
    rig.publish(GoalState.SUCCEEDED, 2)
    rig.publish(GoalState.RUNNING, 1)
    assert rig.wait(0.05).state is GoalState.SUCCEEDED


def test_a_late_result_of_an_old_goal_never_reaches_a_new_one(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.publish(GoalState.SUCCEEDED, 2, goal_id="t/turn/0")
    assert rig.wait(0.05).state is GoalState.RUNNING


def test_an_end_that_got_lost_is_asked_for(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    handle = rig.wait(UNSURE_AFTER + 0.3, lambda: rig.answer(rig.questions, rig.say(GoalState.SUCCEEDED, 2)))
    assert handle.state is GoalState.SUCCEEDED


def test_a_server_that_has_forgotten_the_goal_fails_it(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    handle = rig.wait(UNSURE_AFTER + 0.3, lambda: rig.answer(rig.questions, rig.say(GoalState.UNKNOWN, 3)))
    assert handle.failure is not None
    assert handle.failure.kind is FailureKind.SKILL_LOST


def test_nobody_there_fails_the_goal_in_time(rig: Rig) -> None:
    rig.goals.close()
    rig.bus.close()
    handle = rig.wait(ANSWER_WITHIN + 0.5)
    assert handle.failure is not None
    assert handle.failure.kind is FailureKind.SKILL_LOST


def test_an_unanswered_goal_is_sent_again_under_its_own_id(rig: Rig) -> None:
    rig.goals.close()
    goals = rig.bus.serve(goal_service(ROTATE.name).key)
    assert rig.wait(0.5, lambda: rig.answer(goals, rig.say(GoalState.RUNNING, 1))).state is GoalState.RUNNING


def test_a_cancelled_goal_that_nobody_has_taken_is_not_sent_again(rig: Rig) -> None:
    """It began in a server that was started anew, after its task had been abandoned."""
    rig.goals.close()
    rig.handle.cancel()
    goals = rig.bus.serve(goal_service(ROTATE.name).key)
    rig.wait(0.5)
    assert goals.drain() == []
    assert rig.commanded()
    rig.wait(0.1)
    rig.obey(1, GoalState.UNKNOWN)
    assert rig.wait(0.1).state is GoalState.CANCELED


def test_a_goal_that_takes_too_long_is_cancelled_and_fails(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(ROTATE.timeout + 0.1, lambda: rig.answer(rig.questions, rig.say(GoalState.RUNNING, 1)))
    rig.publish(GoalState.CANCELED, 5)
    handle = rig.wait(0.1)
    assert handle.failure is not None
    assert handle.failure.kind is FailureKind.TIMED_OUT


def test_a_server_started_anew_has_forgotten_the_goal_whatever_its_count(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 40))
    handle = rig.wait(UNSURE_AFTER + 0.3, lambda: rig.answer(rig.questions, rig.say(GoalState.UNKNOWN, 1)))
    assert handle.failure is not None
    assert handle.failure.kind is FailureKind.SKILL_LOST


def test_a_cancelled_goal_that_does_not_end_is_overdue_by_the_robots_clock(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(20.0, lambda: rig.answer(rig.questions, rig.say(GoalState.RUNNING, 1)))
    assert not rig.handle.overdue(5.0, 10.0), "nobody has told it to end"
    rig.handle.cancel()
    rig.wait(4.9, lambda: rig.answer(rig.questions, rig.say(GoalState.CANCELING, 2)))
    assert not rig.handle.overdue(5.0, 10.0)
    rig.wait(0.2)
    assert rig.handle.overdue(5.0, 10.0)


def test_a_cancelled_goal_whose_server_is_gone_is_lost_and_not_overdue(
    rig: Rig, monkeypatch: pytest.MonkeyPatch
) -> None:
    rig.publish(GoalState.RUNNING, 1)
    rig.wait(0.1)
    rig.handle.cancel()
    monkeypatch.setattr(rig.client, "awake", lambda: False)
    monkeypatch.setattr(rig.clocks, "monotonic", lambda: rig.clocks.seconds / 10)  # faster than real time
    rig.wait(20.0)
    assert not rig.handle.ended
    assert not rig.handle.overdue(5.0, 10.0)
    rig.wait(20.0)
    assert rig.handle.failure is not None
    assert rig.handle.failure.kind is FailureKind.SKILL_LOST


def test_a_goal_that_took_too_long_and_ignores_its_cancel_is_overdue(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(ROTATE.timeout + 5.2, lambda: rig.answer(rig.questions, rig.say(GoalState.RUNNING, 1)))
    assert rig.handle.overdue(5.0, 10.0)


def test_what_is_dropped_has_failed_and_a_late_result_of_it_is_not_heard(rig: Rig) -> None:
    ends: list[str] = []
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(0.05)
    rig.handle.when_ended(lambda: ends.append("ended"))
    rig.client.drop(rig.handle, "it did not come to rest")
    rig.publish(GoalState.SUCCEEDED, 2)
    rig.wait(0.05)
    assert (rig.handle.state, rig.handle.result, ends) == (GoalState.FAILED, None, ["ended"])
    assert rig.client.quiet


def test_a_pause_is_asked_for_until_the_server_says_so(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(0.05)
    rig.handle.pause()
    rig.wait(0.05)
    rig.obey(2, GoalState.RUNNING)  # lost on its way, as it were
    rig.wait(0.1)
    rig.obey(3, GoalState.PAUSED)
    assert rig.wait(0.1).paused
    assert rig.commanded() == []
    rig.handle.resume()
    rig.wait(0.05)
    assert rig.commanded() == [Command.RESUME]


def test_a_goal_sent_before_the_pause_is_paused_once_it_is_taken(rig: Rig) -> None:
    rig.handle.pause()
    rig.wait(0.05)
    assert rig.commanded() == []
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(0.05)
    assert rig.commanded() == [Command.PAUSE]


def test_the_time_paused_is_not_of_the_time_out(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.wait(0.05)
    rig.handle.pause()
    rig.wait(0.05)
    rig.obey(2, GoalState.PAUSED)
    rig.wait(2.0 * ROTATE.timeout, lambda: rig.answer(rig.questions, rig.say(GoalState.PAUSED, 2)))
    rig.handle.resume()
    rig.wait(0.05)
    rig.obey(3, GoalState.RUNNING)
    rig.wait(ROTATE.timeout - 1.0, lambda: rig.answer(rig.questions, rig.say(GoalState.RUNNING, 3)))
    assert rig.commanded() == []
    rig.wait(1.5, lambda: rig.answer(rig.questions, rig.say(GoalState.RUNNING, 3)))
    assert rig.commanded() == [Command.CANCEL]


def test_a_pause_that_is_not_obeyed_is_overdue(rig: Rig) -> None:
    rig.answer(rig.goals, rig.say(GoalState.RUNNING, 1))
    rig.handle.pause()
    rig.wait(5.2, lambda: rig.answer(rig.questions, rig.say(GoalState.RUNNING, 1)))
    assert rig.handle.overdue(5.0, 10.0)
