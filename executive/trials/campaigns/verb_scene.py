"""One run of a verb's crash campaign: a mocked robot with its executive, asked and watched over the bus."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, TypeVar

from pydantic import JsonValue

from tandem.executive.trials.campaigns.crash import TRIES, Reaper
from tandem.executive.trials.campaigns.crash_rig import CrashRig, StuckError
from tandem.executive.trials.campaigns.crash_world import DEEDS, ITEM, TRUTH, Truth, deeds
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import (
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_PAUSE,
    TASK_RESUME,
    AskHistory,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    NameTask,
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
RESUMED: Final = "the task is not paused"
"""Why a task that goes on is not resumed."""
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
        """Ask for a verb that has to be taken.

        A task that was resumed by the first of two questions, between which the executive was killed, is not
        paused for the second: what follows shows whether it was resumed.
        """
        killed = len(self.reaper.done)
        answer = self.say(service, message)
        resumed = (
            service.key == TASK_RESUME.key and answer.reason == RESUMED and len(self.reaper.done) > killed
        )
        if not answer.accepted and not resumed:
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
        before = goals_begun(self.rig.folder)
        end = self.rig.now() + STANDS
        while self.rig.now() < end:
            self.rig.bus.waker.wait(0.02)
            self.reaper.step()
        begun = goals_begun(self.rig.folder) - before
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


def goals_begun(folder: Path) -> int:
    """Return how many goals the mocked skills have begun."""
    if not (folder / DEEDS).exists():
        return 0
    return sum(deed.what == "began" for deed in deeds(folder))
