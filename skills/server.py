"""The one server adapter: turns any skill into an action over the bus.

A goal is answered at once: accepted, or rejected and why. ``goal_statuses`` publishes how it stands on each
change and, while feedback comes, ten times a second; how it ended is kept, so that a late or reconnecting
client can ask.
The same id sent twice starts once, and one that was rejected stays so. A client that is gone has its goal
cancelled.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Generic

from pydantic import ValidationError

from tandem.skills.goal_journal import GoalJournal
from tandem.skills.goal_statuses import GoalStatuses
from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.action import (
    AskResult,
    GoalCommand,
    GoalState,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    result_service,
    task_of,
)
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.endpoint import answering, endpoint
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.fencing import Listening
from tandem.skills.ports.lease import Lease, Leased
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.problems import Problem, in_words, problems_of
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.skill import Command, F, G, Outcome, R, Run, Skill, Slice

log = logging.getLogger(__name__)

COMMANDER: Final = "executive"
"""The role whose commands the servers obey."""
ORPHANED_AFTER: Final = 1.0
"""Host seconds for which a client's name must be gone before its goal is cancelled."""


@dataclass
class _Current(Generic[F, R]):
    """The goal that runs."""

    goal_id: str
    client: str
    run: Run[F, R]
    begun: RobotTime | None
    command: Command = Command.GO_ON
    ready_at: float = 0.0
    started: bool = False
    client_gone_since: float | None = None
    stands_by: bool = False
    """Whether it was paused because its client does not go on."""
    lease: Lease | None = None
    """Under which it was sent."""
    marks: tuple[int, ...] = ()
    """Of the pipelines when it began."""
    overridden: Failure | None = None
    """A reflex has taken what it moves: it ends when that is given back."""


class ActionServer(Generic[G, F, R]):
    """Serves one skill; a ``Node``.

    Args:
        bus: where clients are.
        clocks: robot time for feedback, host time for the clients' liveliness.
        skill: what to run; one goal at a time.
        charge: make a computation's slices cost their declared robot time (lockstep).
        pipelines: of the resources that the skill commands: a goal ends when a reflex takes one of them.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        skill: Skill[G, F, R],
        *,
        charge: bool = False,
        pipelines: Sequence[Pipeline] = (),
    ) -> None:
        name = skill.action.name
        self._pipelines = tuple(pipelines)
        self._bus, self._clocks, self._skill, self._charge = bus, clocks, skill, charge
        self._endpoints = Endpoints(
            bus,
            clocks.monotonic,
            (
                endpoint(goal_service(name), lambda call: self._on_goal(call.document), refuse=self._reject),
                endpoint(
                    command_service(name), lambda call: self._on_command(call.document), refuse=self._reject
                ),
                answering(result_service(name), self._on_question),
            ),
        )
        self._statuses = GoalStatuses(bus, clocks, name)
        self._fence = Listening(bus, COMMANDER)
        self._current: _Current[F, R] | None = None
        self._journal: GoalJournal | None = None
        bus.announce(f"skill/{name}")

    @property
    def name(self) -> str:
        """The action's name."""
        return self._skill.action.name

    @property
    def busy(self) -> bool:
        """Whether a goal runs."""
        return self._current is not None

    def keep(self, journal: GoalJournal) -> None:
        """Write each goal down before it starts; one that was accepted before is not started again."""
        self._journal = journal

    def step(self) -> bool:
        """Answer who asks, then resume the skill."""
        self._fence.step()
        self._watch_hardware()
        self._watch_pipelines()
        waiting = self._endpoints.step()
        self._watch_client()
        return self._resume() or waiting

    def close(self) -> None:
        """End what runs; the skill's last act is to send a stop."""
        if self._current is not None:
            self._watch_hardware()
        if self._current is not None:
            self._current.run.close()
            self._end(
                GoalState.FAILED, failure=self._failure(FailureKind.SKILL_LOST, "the skill's process ended")
            )
        self._endpoints.close()
        self._fence.close()

    def _on_goal(self, sent: SendGoal) -> GoalStatus:
        known = self._fenced(sent, sent.goal_id) or self._statuses.find(sent.goal_id)
        if known is not None:
            return known
        before = self._current
        try:
            off = self._statuses.ended.is_called_off(sent.goal_id)
            status = self._statuses.of(sent.goal_id, GoalState.CANCELED) if off else self._start(sent)
        except Exception as error:
            log.exception("a goal's check raised", extra=self._about(sent.goal_id))
            self._current = before
            crashed = self._failure(FailureKind.SKILL_CRASHED, repr(error))
            status = self._statuses.of(sent.goal_id, GoalState.REJECTED, failure=crashed)
        if status.state.terminal:
            self._statuses.ended.rejected(sent.goal_id, status)
        return status

    def _reject(self, problems: tuple[Problem, ...]) -> GoalStatus:
        failure = self._failure(FailureKind.INVALID_GOAL, in_words(problems))
        return self._statuses.of("", GoalState.REJECTED, failure=failure)

    def _start(self, sent: SendGoal) -> GoalStatus:
        try:
            goal = self._skill.action.goal.model_validate(sent.goal)
        except ValidationError as error:
            failure = self._failure(FailureKind.INVALID_GOAL, in_words(problems_of(error)))
            return self._statuses.of(sent.goal_id, GoalState.REJECTED, failure=failure)
        if self._journal is not None and sent.goal_id in self._journal.before:
            text = (
                f"{sent.goal_id} was accepted before this process was started anew; how it ended is not known"
            )
            lost = self._failure(FailureKind.SKILL_LOST, text)
            return self._statuses.of(sent.goal_id, GoalState.FAILED, failure=lost)
        if self._current is not None:
            busy = self._failure(FailureKind.BUSY, f"{self.name} is at goal {self._current.goal_id}")
            return self._statuses.of(sent.goal_id, GoalState.REJECTED, failure=busy)
        refusal = self._skill.check(goal)
        if refusal is not None:
            return self._statuses.of(sent.goal_id, GoalState.REJECTED, failure=refusal)
        unstored = self._store(sent.goal_id)
        if unstored is not None:
            return self._statuses.of(sent.goal_id, GoalState.REJECTED, failure=unstored)
        log.info("goal begins", extra=self._about(sent.goal_id))
        run = self._skill.run(goal, sent.goal_id)
        begun = self._clocks.robot()
        marks = tuple(pipeline.mark() for pipeline in self._pipelines)
        self._current = _Current(sent.goal_id, sent.client, run, begun, lease=sent.lease, marks=marks)
        return self._statuses.change(sent.goal_id, GoalState.RUNNING)

    def _store(self, goal_id: str) -> Failure | None:
        """Write the id down; a failure when the disk is full: a goal that may start twice is not started."""
        if self._journal is None:
            return None
        try:
            self._journal.accept(goal_id)
        except OSError as error:
            log.exception("a goal could not be written down", extra=self._about(goal_id))
            return self._failure(FailureKind.NOT_STORED, f"{goal_id} could not be written down: {error}")
        return None

    def _on_command(self, asked: GoalCommand) -> GoalStatus:
        # Coming to rest is always allowed.
        refused = None if asked.command is Command.CANCEL else self._fenced(asked, asked.goal_id)
        if refused is not None:
            return refused
        if self._current is not None and self._current.goal_id == asked.goal_id:
            self._command(self._current, asked.command)
        found = self._statuses.find(asked.goal_id)
        if found is None and asked.command is Command.CANCEL:
            self._statuses.ended.call_off(asked.goal_id)
        return found or self._statuses.of(asked.goal_id, GoalState.UNKNOWN)

    def _fenced(self, command: Leased, goal_id: str) -> GoalStatus | None:
        """Return the refusal of a command whose sender has no lease, or has been replaced; None: obey it."""
        refusal = self._fence.refuse(command.lease)
        if refusal is None:
            return None
        log.warning("%s: refused goal %s: %s", self.name, goal_id, refusal.reason)
        kind = FailureKind.SUPERSEDED if refusal.over else FailureKind.NOT_READY
        return self._statuses.of(goal_id, GoalState.REJECTED, failure=self._failure(kind, refusal.reason))

    def _command(self, current: _Current[F, R], command: Command) -> None:
        state = self._statuses.state
        if state is GoalState.CANCELING or command is Command.GO_ON:
            return
        if command is Command.RESUME and state is not GoalState.PAUSED:
            return  # it goes on already: its client and its server may both have said so
        current.command = command
        current.ready_at = 0.0
        after = {
            Command.CANCEL: GoalState.CANCELING,
            Command.PAUSE: GoalState.PAUSED,
            Command.RESUME: GoalState.RUNNING,
        }
        self._statuses.change(current.goal_id, after[command])

    def _on_question(self, asked: AskResult) -> GoalStatus:
        return self._statuses.find(asked.goal_id) or self._statuses.of(asked.goal_id, GoalState.UNKNOWN)

    def _watch_client(self) -> None:
        current = self._current
        if current is not None and self._fence.is_over(current.lease):
            # Its name may be there again, played by another: that one knows nothing of this goal.
            self._command(current, Command.CANCEL)
            return
        if current is None or not current.client:
            return
        now = self._clocks.monotonic()
        self._stand_by(current, awake=self._bus.goes_on(current.client))
        if current.client in self._bus.alive():
            current.client_gone_since = None
        elif current.client_gone_since is None:
            current.client_gone_since = now
        elif now - current.client_gone_since > ORPHANED_AFTER:
            log.warning("a client is gone, its goal is cancelled", extra=self._about(current.goal_id))
            self._command(current, Command.CANCEL)

    def _watch_hardware(self) -> None:
        """End a goal whose hardware has started anew: nothing that it has sent or measured holds any more."""
        current, now = self._current, self._clocks.robot()
        if current is None or current.begun is None or now is None or now.since(current.begun) is not None:
            return
        current.run.close()
        text = f"the hardware was started anew (boot {now.boot}, before: {current.begun.boot})"
        self._end(GoalState.FAILED, failure=self._failure(FailureKind.HARDWARE_LOST, text))

    def _watch_pipelines(self) -> None:
        """Have done with a goal of which a reflex has taken what it moves.

        Its run ends at once, and what it would still send goes nowhere. The goal ends when the reflex gives
        back what it took: until then the robot moves, and a goal that has ended says that nothing does.
        """
        current = self._current
        if current is None:
            return
        for pipeline, mark in zip(self._pipelines, current.marks, strict=True):
            overridden = pipeline.taken_since(mark, self.name)
            if overridden is not None and current.overridden is None:
                current.overridden = overridden
                current.run.close()
        if current.overridden is None or any(each.override is not None for each in self._pipelines):
            return
        if self._statuses.state is GoalState.CANCELING:
            self._end(GoalState.CANCELED)
        else:
            self._end(GoalState.FAILED, failure=current.overridden)

    def _stand_by(self, current: _Current[F, R], *, awake: bool) -> None:
        """Come to rest while the client does not go on, and go on when it does."""
        state = self._statuses.state
        if not awake and not current.stands_by and state is GoalState.RUNNING:
            log.warning(
                "%s: client %s is silent, goal %s stands by", self.name, current.client, current.goal_id
            )
            current.stands_by = True
            self._command(current, Command.PAUSE)
        elif awake and current.stands_by:
            current.stands_by = False
            if state is GoalState.PAUSED:
                log.warning(
                    "%s: client %s goes on, and so does %s", self.name, current.client, current.goal_id
                )
                self._command(current, Command.RESUME)

    def _resume(self) -> bool:
        while (current := self._current) is not None and current.overridden is None:
            now = robot_seconds(self._clocks)
            if self._charge and current.ready_at > now:
                return False
            command, current.command = current.command, Command.GO_ON
            try:
                if current.started:
                    yielded = current.run.send(command)
                else:
                    current.started = True
                    yielded = next(current.run)
                    current.command = command
            except StopIteration as stop:
                self._finish(stop.value)
                return False
            except Exception as error:
                log.exception("a goal crashed", extra=self._about(current.goal_id))
                self._end(GoalState.FAILED, failure=self._failure(FailureKind.SKILL_CRASHED, repr(error)))
                return False
            if not isinstance(yielded, Slice):
                self._statuses.feed_back(current.goal_id, yielded)
                return current.command is not Command.GO_ON
            if not self._charge:
                return True
            current.ready_at = max(current.ready_at, now - self._skill.period) + yielded.cost
        return False

    def _finish(self, outcome: Outcome[R]) -> None:
        if outcome.result is not None:
            self._end(GoalState.SUCCEEDED, result=outcome.result)
        elif outcome.failure is not None:
            self._end(GoalState.FAILED, failure=outcome.failure)
        else:
            self._end(GoalState.CANCELED)

    def _end(
        self, state: GoalState, *, result: Message | None = None, failure: Failure | None = None
    ) -> None:
        if self._current is None:
            return
        goal_id, self._current = self._current.goal_id, None
        kind = "" if failure is None else str(failure.kind)
        log.info("goal ended", extra={**self._about(goal_id), "state": str(state), "kind": kind})
        self._statuses.change(goal_id, state, result=result, failure=failure)

    def _about(self, goal_id: str) -> dict[str, str]:
        """Return what a line of the log is about."""
        return {"task": task_of(goal_id), "action": self.name, "goal": goal_id}

    def _failure(self, kind: FailureKind, message: str) -> Failure:
        return Failure(kind=kind, message=message, where=self.name)
