"""The verbs whose effect must outlive a crash: what is so before each, and what must be so afterwards."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from tandem.executive.trials.campaigns.crash import TRIES
from tandem.executive.trials.campaigns.crash_rig import StuckError
from tandem.executive.trials.campaigns.verb_scene import IN_HAND, STANDS, WITHIN, S, Scene, goals_begun
from tandem.skills.ports.tasks import (
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_PAUSE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_STEP,
    AnswerQuestion,
    Breakpoint,
    CancelTask,
    ForceNode,
    NameTask,
    Reprioritise,
    StepTask,
)


@dataclass(frozen=True)
class Case:
    """A verb, and what must be so before and after it."""

    verb: str
    key: str
    before: Callable[[Scene], None]
    act: Callable[[Scene], None]
    after: Callable[[Scene], None]
    whole: bool = False
    """Whether all that follows belongs to the verb: its effect takes time."""
    time: int = 1
    """Which of the verbs of this key in a run it is."""

    @property
    def at(self) -> str:
        """The point at which the executive reads it."""
        return f"asked {self.key}" + (f" #{self.time}" if self.time > 1 else "")


def _cancel_before(at: Scene) -> None:
    at.held(on_cancel="put_down")


def _cancel(at: Scene) -> None:
    at.say(TASK_CANCEL, CancelTask(task=at.tasks[0]))


def _canceled(at: Scene) -> None:
    ended = at.expect(at.tasks[0], S.CANCELED)
    if ended.failure is not None:
        at.wrong.append(f"it was not wound down: {ended.failure}")
    at.hands(full=False)


def _second_before(at: Scene) -> None:
    _cancel_before(at)
    before = goals_begun(at.rig.folder)
    _cancel(at)
    end = at.rig.now() + WITHIN
    while goals_begun(at.rig.folder) == before and at.rig.now() < end:
        at.rig.bus.waker.wait(0.005)


def _second_after(at: Scene) -> None:
    if at.status(at.tasks[0]).state is S.CANCELING:
        at.stands()
    at.expect(at.tasks[0], S.CANCELED)


def _pause_before(at: Scene) -> None:
    at.running()


def _pause(at: Scene) -> None:
    at.taken = at.say(TASK_PAUSE, NameTask(task=at.tasks[0])).accepted


def _pause_after(at: Scene) -> None:
    if at.taken:  # else it had ended before
        at.expect(at.tasks[0], S.PAUSED)
        at.stands()
        at.must(TASK_RESUME, NameTask(task=at.tasks[0]))
    at.expect(at.tasks[0], S.SUCCEEDED)


def _paused(at: Scene) -> None:
    at.paused()


def _resume(at: Scene) -> None:
    at.say(TASK_RESUME, NameTask(task=at.tasks[0]))


def _succeeds(at: Scene) -> None:
    at.expect(at.tasks[0], S.SUCCEEDED)


def _step(at: Scene) -> None:
    at.say(TASK_STEP, StepTask(task=at.tasks[0]))


def _step_after(at: Scene) -> None:
    # One that was asked for again, because no answer came, may have been taken twice: that is two steps.
    at.expect(at.tasks[0], S.PAUSED)
    at.rig.pass_seconds(STANDS, at.reaper.step)
    if at.expect(at.tasks[0], S.PAUSED).state is S.PAUSED:
        at.must(TASK_RESUME, NameTask(task=at.tasks[0]))
        at.expect(at.tasks[0], S.SUCCEEDED)


def _paused_early(at: Scene) -> None:
    at.paused_early()


def _break(at: Scene) -> None:
    at.must(TASK_BREAKPOINT, Breakpoint(task=at.tasks[0], node=IN_HAND))


def _break_after(at: Scene) -> None:
    task = at.tasks[0]
    at.must(TASK_RESUME, NameTask(task=task))
    if at.expect(task, S.PAUSED).state is S.PAUSED:
        at.hands(full=True)
        at.must(TASK_BREAKPOINT, Breakpoint(task=task, node=IN_HAND, on=False))
        at.must(TASK_RESUME, NameTask(task=task))
        at.expect(task, S.SUCCEEDED)


def _test_run(at: Scene) -> None:
    at.paused(test_run=True)


def _force(at: Scene) -> None:
    at.must(TASK_FORCE, ForceNode(task=at.tasks[0], node="home: drive", status="FAILURE"))


def _force_after(at: Scene) -> None:
    at.must(TASK_RESUME, NameTask(task=at.tasks[0]))
    ended = at.expect(at.tasks[0], S.FAILED)
    if ended.failure is None or "forced" not in ended.failure.message:
        at.wrong.append(f"it was not the forced node: {ended.failure}")


def _three(at: Scene) -> None:
    _paused(at)
    at.ask()
    at.ask()


def _rank(at: Scene) -> None:
    at.must(TASK_REPRIORITISE, Reprioritise(task=at.tasks[2], priority=5))


def _rank_after(at: Scene) -> None:
    at.must(TASK_RESUME, NameTask(task=at.tasks[0]))
    _, second, third = (at.expect(task, S.SUCCEEDED) for task in at.tasks)
    if (third.ended_at or 0.0) > (second.ended_at or 0.0):
        at.wrong.append("the one of the higher priority ran last")


def _asked(at: Scene) -> None:
    at.running(on_restart="ask")
    at.rig.kill("executive")
    at.rig.start("executive", crash_at=at.rig.crash_at)
    at.expect(at.tasks[0], S.PAUSED)


def _answer(at: Scene) -> None:
    at.say(TASK_ANSWER, AnswerQuestion(task=at.tasks[0], answer="interrupt"))


def _answered(at: Scene) -> None:
    at.expect(at.tasks[0], S.INTERRUPTED)


def _silent(at: Scene) -> None:
    for _ in range(TRIES):
        task = at.running()
        at.rig.kill("mock")
        at.rig.pass_seconds(1.0, at.reaper.step)
        if at.say(TASK_CANCEL, CancelTask(task=task)).accepted:
            return
        at.rig.start("mock")
        at.begin_anew()
    raise StuckError("each fetch had ended before the hardware was silent")


def _abandon(at: Scene) -> None:
    at.say(TASK_ABANDON, NameTask(task=at.tasks[0]))


def _abandoned(at: Scene) -> None:
    at.rig.start("mock")
    at.expect(at.tasks[0], S.INTERRUPTED, S.CANCELED, S.FAILED)
    at.expect(at.ask(), S.SUCCEEDED)


CASES: Final = (
    Case("cancel", TASK_CANCEL.key, _cancel_before, _cancel, _canceled, whole=True),
    Case("second cancel", TASK_CANCEL.key, _second_before, _cancel, _second_after, time=2),
    Case("pause", TASK_PAUSE.key, _pause_before, _pause, _pause_after),
    Case("resume", TASK_RESUME.key, _paused, _resume, _succeeds),
    Case("step", TASK_STEP.key, _paused, _step, _step_after),
    Case("breakpoint", TASK_BREAKPOINT.key, _paused_early, _break, _break_after),
    Case("force", TASK_FORCE.key, _test_run, _force, _force_after),
    Case("reprioritise", TASK_REPRIORITISE.key, _three, _rank, _rank_after),
    Case("answer", TASK_ANSWER.key, _asked, _answer, _answered),
    Case("abandon", TASK_ABANDON.key, _silent, _abandon, _abandoned),
)
