"""Kill the executive at each point between a verb and its effect, and see whether the verb still holds.

Each case brings a task to where the verb is taken, asks for it, and says what must be so afterwards. A dry
run counts the points that the executive passes from the moment in which it reads the verb; then it is killed
at each of them, or at as many as asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, TypeVar

from pydantic import JsonValue

from tandem.executive.trials.campaigns.crash import TRIES, CrashRun, Reaper, never_reached
from tandem.executive.trials.campaigns.crash_rig import CrashRig, StuckError
from tandem.executive.trials.campaigns.crash_world import DEEDS, ITEM, TRUTH, Truth, deeds, wrong_deeds
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
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
    AskHistory,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    ForceNode,
    NameTask,
    Reprioritise,
    StepTask,
    TaskState,
    TaskStatus,
)

M = TypeVar("M", bound=Message)
S = TaskState
ENDS: Final = tuple(state for state in TaskState if state.terminal)
IN_HAND: Final = "put down"
"""A leaf of the fetch that begins with the item in the hand."""
WITHIN: Final = 60.0
"""Host seconds for each state that is waited for."""
STANDS: Final = 0.5
"""Host seconds for which a task that is to stand is watched: ten ticks of its tree, and a goal every few."""
MOST: Final = 12
"""Places of a verb at which the executive is killed, unless told otherwise."""
BEYOND: Final = 6
"""Points after the answer that belong to a verb whose effect comes at once: one step of the executive."""
REACHED: Final = 0.8
"""Share of the points of a dry run at which others are killed."""
NEVER: Final = 1_000_000
"""Points: more than any run passes."""
FETCH: Final[dict[str, JsonValue]] = {"task": "fetch", "item": ITEM}


@dataclass(eq=False)
class Scene:
    """One run: the rig, and what was asked and found."""

    rig: CrashRig
    reaper: Reaper
    run: str
    wrong: list[str] = field(default_factory=list)
    tasks: list[str] = field(default_factory=list)
    names: int = 0
    """Names of requests that were used up."""
    taken: bool = True
    """Whether the verb was."""

    def ask(self, **more: JsonValue) -> str:
        """Ask for a fetch; return its id."""
        named: dict[str, JsonValue] = {
            **FETCH,
            "id": f"{self.run}-{self.names + len(self.tasks)}"[-60:],
            **more,
        }
        answer = self.rig.request(named, meanwhile=self.reaper.step)
        if not answer.accepted:
            raise StuckError(f"{named} was refused: {answer.problems}")
        self.tasks.append(answer.task)
        return answer.task

    def say(self, service: Service[M, ControlAnswer], message: M) -> ControlAnswer:
        """Ask for a verb until it is answered."""
        return self.rig.ask(service, message, meanwhile=self.reaper.step)

    def must(self, service: Service[M, ControlAnswer], message: M) -> None:
        """Ask for a verb that has to be taken."""
        answer = self.say(service, message)
        if not answer.accepted:
            self.wrong.append(f"{service.key} was refused: {answer.reason}")

    def status(self, task: str) -> TaskStatus:
        """Return how a task stands."""
        found = self.rig.tasks(AskHistory(task=task), meanwhile=self.reaper.step)
        if not found:
            raise StuckError(f"{task} was acknowledged and is lost")
        return found[0]

    def until(self, task: str, *states: TaskState) -> TaskStatus:
        """Wait until a task stands so."""
        end = self.rig.now() + WITHIN
        while self.rig.now() < end:
            found = self.status(task)
            if found.state in states:
                return found
            self.rig.bus.waker.wait(0.02)
            self.reaper.step()
        raise StuckError(f"{task} was expected to be {' or '.join(states)}; it is {self.status(task).state}")

    def expect(self, task: str, *states: TaskState) -> TaskStatus:
        """Wait until a task has ended, and note it if it should have ended otherwise."""
        found = self.until(task, *ENDS, *states)
        if found.state not in states:
            self.wrong.append(f"{task} is {found.state} and should be {' or '.join(states)}: {found.failure}")
        return found

    def running(self, **more: JsonValue) -> str:
        """Return a fetch that runs; one that has ended before that was seen is asked for anew."""
        for _ in range(TRIES):
            task = self.ask(**more)
            if self.until(task, S.RUNNING, *ENDS).state is S.RUNNING:
                return task
            self.begin_anew()
        raise StuckError("each fetch had ended before it was seen to run")

    def paused(self, **more: JsonValue) -> str:
        """Return a fetch that stands somewhere."""
        for _ in range(TRIES):
            task = self.running(**more)
            self.say(TASK_PAUSE, NameTask(task=task))
            if self.until(task, S.PAUSED, *ENDS).state is S.PAUSED:
                return task
            self.begin_anew()
        raise StuckError("each fetch had ended before it could be paused")

    def paused_early(self, **more: JsonValue) -> str:
        """Return a fetch that stands before ``IN_HAND``: a breakpoint there is still to come."""
        for _ in range(TRIES):
            task = self.paused(**more)
            if self.truth().untouched:
                return task
            self.say(TASK_CANCEL, CancelTask(task=task))
            self.until(task, *ENDS)
            self.begin_anew()
        raise StuckError("each fetch had the item in a hand before it could be paused")

    def held(self, **more: JsonValue) -> str:
        """Return a fetch that stands before ``IN_HAND``."""
        task = self.paused_early(**more)
        self.must(TASK_BREAKPOINT, Breakpoint(task=task, node=IN_HAND))
        self.must(TASK_RESUME, NameTask(task=task))
        self.expect(task, S.PAUSED)
        return task

    def begin_anew(self) -> None:
        """Forget the last task, which has ended, and have everything where it was at first."""
        self.tasks.pop()
        self.names += 1
        self.rig.reset()

    def stands(self) -> None:
        """See that the robot begins nothing for a while."""
        before = _begun(self.rig.folder)
        end = self.rig.now() + STANDS
        while self.rig.now() < end:
            self.rig.bus.waker.wait(0.02)
            self.reaper.step()
        begun = _begun(self.rig.folder) - before
        if begun:
            self.wrong.append(f"{begun} goals began although the task is to stand")

    def truth(self) -> Truth:
        """Return what is so in the mocked world."""
        return Truth.model_validate_json((self.rig.folder / TRUTH).read_text("utf-8"))

    def hands(self, *, full: bool) -> None:
        """See whether the item is in a hand."""
        truth = self.truth()
        if (ITEM in {truth.left, truth.right}) is not full:
            self.wrong.append(
                f"the item should {'' if full else 'not '}be in a hand: {truth.left} {truth.right}"
            )


def _begun(folder: Path) -> int:
    if not (folder / DEEDS).exists():
        return 0
    return sum(deed.what == "began" for deed in deeds(folder))


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
    before = _begun(at.rig.folder)
    _cancel(at)
    end = at.rig.now() + WITHIN
    while _begun(at.rig.folder) == before and at.rig.now() < end:
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


def verb_runs(
    folder: Path, endpoint: str, most: int = MOST, verbs: tuple[str, ...] = ()
) -> Iterator[CrashRun]:
    """Yield, for each verb (or those named), a run without a kill and one for each place of a kill.

    Args:
        folder: of ledger, truth and deeds.
        endpoint: where the router listens.
        most: places of a verb at the most, spread over all that there are.
        verbs: their names.
    """
    number = 0
    with CrashRig(folder, endpoint) as rig:
        for case in CASES:
            if verbs and case.verb not in verbs:
                continue
            dry, count = _dry_run(rig, case, number)
            yield dry
            for place in spread(count, most):
                number += 1
                yield verb_run(rig, case, number, place)
            number += 1


def verb_run(rig: CrashRig, case: Case, run: int, place: int, *, tries: int = TRIES) -> CrashRun:
    """Return the first run in which the executive was killed at its place, or the last one of those tried.

    Args:
        rig: the processes.
        case: the verb.
        run: its number.
        place: points after the one at which the executive reads the verb.
        tries: runs at the most.
    """
    point = f"{case.at} +{place}"
    made = CrashRun(run=run, point=point)
    for number in range(tries):
        rig.kill("executive")
        rig.start("executive", crash_at=point)
        made = _one(rig, case, run, point=f"{point}, {case.verb}", name=f"{case.verb}-{run}-{number}")[0]
        if made.kills or made.wrong:
            return made
    return made.model_copy(update={"wrong": (never_reached(point),)})


def _dry_run(rig: CrashRig, case: Case, run: int) -> tuple[CrashRun, int]:
    log = rig.folder / f"{case.verb}.points"
    rig.kill("executive")
    rig.start("executive", crash_at=f"{case.at} +{NEVER}", crash_log=log)
    made, at_answer = _one(
        rig, case, run, point=f"{case.verb}: not killed", name=f"{case.verb}-{run}-dry", log=log
    )
    count = _lines(log) if case.whole else min(_lines(log), at_answer + BEYOND)
    return made, count


def _lines(log: Path) -> int:
    return len(log.read_text("utf-8").splitlines()) if log.exists() else 0


def spread(count: int, most: int) -> tuple[int, ...]:
    """Return places from 0 up to most of ``count``: the last ones depend on what is heard when."""
    last = max(1, round(REACHED * count))
    many = min(most, last)
    return tuple(dict.fromkeys(round(number * last / many) for number in range(many)))


def _one(
    rig: CrashRig, case: Case, run: int, *, point: str, name: str, log: Path | None = None
) -> tuple[CrashRun, int]:
    rig.reset()
    before, began = len(deeds(rig.folder)), rig.now()
    at = Scene(rig, Reaper(rig, [], began), name.replace(" ", "_"))
    at_answer = 0
    try:
        case.before(at)
        case.act(at)
        at_answer = 0 if log is None else _lines(log)
        case.after(at)
    except StuckError as stuck:
        at.wrong.append(str(stuck))
    found = _end_all(at)
    ends = {status.task: status.ended_at for status in found}
    made = CrashRun(
        run=run,
        point=point,
        kills=tuple(at.reaper.done),
        states=tuple(str(each.state) for each in found),
        begun=max((each.begun for each in found), default=0),
        seconds=round(rig.now() - began, 2),
        wrong=(*at.wrong, *wrong_deeds(deeds(rig.folder)[before:], ends.get), *at.reaper.wrong),
    )
    return made, at_answer


def _end_all(at: Scene) -> tuple[TaskStatus, ...]:
    """Leave nothing to the next run; return how all tasks ended."""
    found: list[TaskStatus] = []
    for task in at.tasks:
        try:
            if at.rig.exit_code("mock") is not None:
                at.rig.start("mock")
            if not at.status(task).state.terminal:
                at.say(TASK_CANCEL, CancelTask(task=task))
            found.append(at.until(task, *ENDS))
        except StuckError as stuck:
            at.wrong.append(str(stuck))
    return tuple(found)
