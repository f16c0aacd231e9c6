"""What every skill behind the action server keeps to: the mocked one and real ones run the same suite."""

from __future__ import annotations

import pytest

from tandem.skills.ports.action import GoalState, GoalStatus, goal_service, status_topic
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.skill import Command
from tandem.skills.wire.memory import MemoryBus
from tests.contracts import stages
from tests.contracts.stages import Stage

MAKERS = (stages.mock, stages.edit, stages.gripper, stages.rotate, stages.arm)


@pytest.fixture(params=MAKERS, ids=lambda maker: maker.__name__)
def stage(request: pytest.FixtureRequest) -> Stage:
    made: Stage = request.param()
    return made


@pytest.fixture(
    params=[maker for maker in MAKERS if maker is not stages.edit], ids=lambda maker: maker.__name__
)
def slow(request: pytest.FixtureRequest) -> Stage:
    made: Stage = request.param()
    return made


@pytest.fixture
def mocked() -> Stage:
    return stages.mock()


def kind(status: GoalStatus) -> FailureKind | None:
    return None if status.failure is None else status.failure.kind


def test_a_goal_is_taken_at_once_and_ends_well(stage: Stage) -> None:
    assert stage.send().state is GoalState.RUNNING
    ended = stage.until_ended()
    assert ended.state is GoalState.SUCCEEDED, ended
    assert ended.result is not None
    assert stage.at_rest()


def test_the_result_is_kept(stage: Stage) -> None:
    stage.send()
    ended = stage.until_ended()
    for _ in range(50):
        stage.step()
    assert stage.ask() == ended
    assert stage.send() == ended, "a client that sends again is told how it ended"


def test_the_same_id_starts_once(stage: Stage) -> None:
    first, again = stage.send(), stage.send()
    assert first.state is GoalState.RUNNING
    assert again.state in {GoalState.RUNNING, GoalState.SUCCEEDED}
    stage.until_ended()
    stage.send()
    assert stage.starts() == 1


def test_a_goal_that_does_not_fit_is_rejected_and_moves_nothing(stage: Stage) -> None:
    status = stage.send(stage.misfit)
    assert status.state is GoalState.REJECTED
    assert kind(status) is FailureKind.INVALID_GOAL
    assert stage.starts() == 0
    assert stage.send(goal_id="task/node/2").state is GoalState.RUNNING


def test_a_goal_that_can_not_be_done_is_refused_with_the_reason(stage: Stage) -> None:
    if stage.wrong is None:
        pytest.skip("every goal that fits the model can be taken")
    status = stage.send(stage.wrong)
    if status.state is GoalState.RUNNING:
        status = stage.until_ended()
    assert status.state in {GoalState.REJECTED, GoalState.FAILED}
    assert status.failure is not None
    assert status.failure.message
    assert stage.at_rest()


@pytest.mark.parametrize("garbage", [b"", b"{", b"\xff\xfe", b"[]", b'{"goal_id": 1}', b"null"])
def test_garbage_is_rejected(stage: Stage, garbage: bytes) -> None:
    status = stage.answer(stage.bus.query(goal_service(stage.action).key, garbage))
    assert status.state is GoalState.REJECTED
    assert kind(status) is FailureKind.INVALID_GOAL
    assert stage.starts() == 0


def test_an_unknown_goal_is_unknown(stage: Stage) -> None:
    assert stage.ask("nobody/sent/1").state is GoalState.UNKNOWN
    assert stage.command(Command.CANCEL, "nobody/sent/1").state is GoalState.UNKNOWN


def test_the_status_is_published_on_each_change_with_a_rising_sequence(stage: Stage) -> None:
    inbox = MemoryBus(stage.bus.hub).subscribe(status_topic(stage.action).key)
    stage.send()
    stage.until_ended()
    told = [GoalStatus.model_validate_json(sample.payload) for sample in inbox.drain()]
    assert told[0].state is GoalState.RUNNING
    assert told[-1].state is GoalState.SUCCEEDED
    assert [status.state.terminal for status in told].count(True) == 1
    sequence = [status.sequence for status in told]
    assert sequence == sorted(set(sequence))


def test_a_second_goal_finds_the_server_busy(slow: Stage) -> None:
    slow.send()
    status = slow.send(goal_id="task/node/2")
    assert status.state is GoalState.REJECTED
    assert kind(status) is FailureKind.BUSY
    assert slow.ask().state is GoalState.RUNNING
    assert slow.ask("task/node/2").state is GoalState.REJECTED


def test_a_goal_refused_as_busy_stays_refused_when_it_arrives_again(slow: Stage) -> None:
    slow.send()
    assert kind(slow.send(goal_id="task/node/2")) is FailureKind.BUSY
    slow.command(Command.CANCEL)
    slow.until_ended(steps=300)
    again = slow.send(goal_id="task/node/2")
    assert again.state is GoalState.REJECTED, "it would run for nobody: its client has given up"
    assert slow.ask().state is GoalState.CANCELED


@pytest.mark.parametrize("steps", [0, 1, 20])
def test_a_cancelled_goal_ends_canceled_and_at_rest(slow: Stage, steps: int) -> None:
    slow.send()
    for _ in range(steps):
        slow.step()
    assert slow.command(Command.CANCEL).state in {GoalState.CANCELING, GoalState.CANCELED}
    ended = slow.until_ended(steps=300)
    assert ended.state is GoalState.CANCELED, ended
    assert slow.at_rest()
    assert slow.send(goal_id="task/node/2").state is GoalState.RUNNING, "the next goal is taken"


@pytest.mark.parametrize("steps", [0, 20])
def test_a_paused_goal_rests_and_ends_well_once_it_is_resumed(slow: Stage, steps: int) -> None:
    slow.send()
    for _ in range(steps):
        slow.step()
    assert slow.command(Command.PAUSE).state is GoalState.PAUSED
    for _ in range(150):
        slow.step()
    assert slow.at_rest()
    assert slow.ask().state is GoalState.PAUSED
    assert slow.command(Command.RESUME).state is GoalState.RUNNING
    ended = slow.until_ended()
    assert ended.state is GoalState.SUCCEEDED, ended
    assert slow.at_rest()


def test_a_paused_goal_can_be_cancelled(slow: Stage) -> None:
    slow.send()
    for _ in range(20):
        slow.step()
    slow.command(Command.PAUSE)
    for _ in range(20):
        slow.step()
    slow.command(Command.CANCEL)
    assert slow.until_ended(steps=300).state is GoalState.CANCELED
    assert slow.at_rest()


def test_a_late_command_for_an_old_goal_does_not_touch_the_new_one(slow: Stage) -> None:
    slow.send()
    slow.command(Command.CANCEL)
    slow.until_ended(steps=300)
    slow.send(goal_id="task/node/2")
    slow.step()
    assert slow.command(Command.CANCEL).state is GoalState.CANCELED, "of the old one"
    assert slow.ask("task/node/2").state is GoalState.RUNNING
    assert slow.until_ended("task/node/2").state is GoalState.SUCCEEDED


def test_a_cancel_after_the_end_changes_nothing(stage: Stage) -> None:
    stage.send()
    ended = stage.until_ended()
    assert stage.command(Command.CANCEL) == ended


def test_a_client_that_is_gone_has_its_goal_cancelled(slow: Stage) -> None:
    client = MemoryBus(slow.bus.hub)
    client.announce("client/1")
    slow.send(client="client/1")
    slow.step()
    client.close()
    assert slow.until_ended(steps=300).state is GoalState.CANCELED
    assert slow.at_rest()


def test_a_client_that_is_there_keeps_its_goal(stage: Stage) -> None:
    client = MemoryBus(stage.bus.hub)
    client.announce("client/1")
    stage.send(client="client/1")
    assert stage.until_ended().state is GoalState.SUCCEEDED


def test_a_skill_that_fails_says_why(mocked: Stage) -> None:
    mocked.send({"number": 2})
    ended = mocked.until_ended()
    assert ended.state is GoalState.FAILED
    assert kind(ended) is FailureKind.NO_PATH


def test_a_skill_that_crashes_costs_its_goal_and_no_more(mocked: Stage) -> None:
    mocked.send({"number": 13})
    ended = mocked.until_ended()
    assert ended.state is GoalState.FAILED
    assert kind(ended) is FailureKind.SKILL_CRASHED
    assert ended.failure is not None
    assert "a mistake in the skill" in ended.failure.message
    mocked.send(goal_id="task/node/2")
    assert mocked.until_ended("task/node/2").state is GoalState.SUCCEEDED
