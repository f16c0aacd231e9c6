"""The one client adapter: owns start, poll, cancel and time-out of a goal, so that a leaf holds none of it.

An unanswered query is asked again with the same id (the server starts it once). A server that is gone, or
that has forgotten the goal, fails it as SKILL_LOST. A late result of an old goal never reaches a new one:
each handle listens for its own id only.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Generic, Protocol

from pydantic import JsonValue, ValidationError

from tandem.skills.ports.action import (
    AskResult,
    GoalCommand,
    GoalState,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    result_service,
    status_topic,
)
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.skill import ActionType, Command, F, G, R
from tandem.trees.elapsed import Elapsed

RETRY_PERIOD: Final = 0.1
"""Host seconds before an unanswered query is asked again."""
UNSURE_AFTER: Final = 1.0
"""Host seconds without a word after which a running goal is asked about: a status may have been lost."""
ANSWER_WITHIN: Final = 3.0
"""Host seconds within which a server must answer, or be listed as alive."""


class GoalHandle(Generic[G, F, R]):
    """One goal, from sending to its end."""

    def __init__(
        self, client: ActionClient[G, F, R], goal: G, goal_id: str, timeout: float, *, known: bool = False
    ) -> None:
        """Send the goal, or with ``known`` ask after one that was sent. ``timeout``: robot seconds."""
        self.goal_id = goal_id
        self.state: GoalState | None = GoalState.RUNNING if known else None
        self.feedback: F | None = None
        self.result: R | None = None
        self.failure: Failure | None = None
        self._client = client
        self._document: dict[str, JsonValue] = goal.model_dump(mode="json")
        self._age, self._timeout = Elapsed(client.clocks), timeout
        self._settling: Elapsed | None = None  # since it was told to come to rest
        self._sequence = -1
        self._timed_out = False
        self._canceling = self._pausing = False
        self._pending: Pending | None = None
        self._question: Pending | None = None  # the last that asked after a goal that the server had known
        self._command_pending: Pending | None = None
        self._asked_at = float("-inf")
        self._heard_at = self._told_at = client.clocks.monotonic()
        self._when_ended: Callable[[], None] | None = None
        self._ask()

    @property
    def ended(self) -> bool:
        """Whether the goal has reached its end."""
        return self.state is not None and self.state.terminal

    @property
    def action(self) -> str:
        """The name of its action."""
        return self._client.action.name

    @property
    def paused(self) -> bool:
        """Whether its server has said that it is paused."""
        return self.state is GoalState.PAUSED

    def cancel(self) -> None:
        """Have the skill come to rest; the handle ends when it has."""
        if not self.ended:
            if not self._canceling:
                self._settling = Elapsed(self._client.clocks)
            self._canceling = True
            self._push(Command.CANCEL)

    def pause(self) -> None:
        """Have the skill come to rest and wait; asked for again until the server says that it is so."""
        if not self.ended and not self._canceling and not self._pausing:
            self._pausing, self._settling = True, Elapsed(self._client.clocks)

    def resume(self) -> None:
        """Have the skill go on. The time in which it was paused is not of its time-out."""
        if self._pausing and not self._canceling:
            self._settling = None
        self._pausing = False

    def overdue(self, within_robot: float, within_host: float) -> bool:
        """Say whether it was told to come to rest and has not in time.

        ``within_robot``: robot seconds; ``within_host``: host seconds for which the robot's clock stands.
        A goal whose server is gone is not overdue but about to be lost, after ``ANSWER_WITHIN`` of the host's
        clock, however far the robot's has run meanwhile.
        """
        settling = None if self.ended else self._settling
        if settling is None or not self._client.awake():
            return False
        return settling.beyond(within_robot, within_host)

    def drop(self, message: str) -> None:
        """Give it up: it has failed, and nothing that its server says later is heard."""
        if not self.ended:
            self.state = GoalState.FAILED
            self.failure = self._fail(FailureKind.TIMED_OUT, message)

    def when_ended(self, call: Callable[[], None]) -> None:
        """Have ``call`` made once the goal has ended, for those who have stopped polling it."""
        self._when_ended = call

    def conclude(self) -> None:
        """Make the call asked for by ``when_ended``, once."""
        if self.ended and self._when_ended is not None:
            call, self._when_ended = self._when_ended, None
            call()

    def poll(self) -> None:
        """Take in what has arrived, ask again where nothing did, and watch the time."""
        if self.ended:
            return
        if self._read_answers():
            return
        now = self._client.clocks.monotonic()
        if self._client.awake():
            self._heard_at = max(self._heard_at, now) if self.state is not None else self._heard_at
        if now - self._heard_at > ANSWER_WITHIN:
            self._push(Command.CANCEL)  # one that only hung must not go on with it once it is back
            self._lose(f"no answer from {self._client.action.name} for {ANSWER_WITHIN:.0f} s")
            return
        unsure = self.state is None or not self._client.awake() or now - self._told_at > UNSURE_AFTER
        unsent = self.state is None and self._canceling  # and is not sent again: its server may be a new one
        if unsure and not unsent and self._pending is None and now - self._asked_at > RETRY_PERIOD:
            self._ask()
        self._watch_time()
        self._command()

    def take(self, status: GoalStatus) -> None:
        """Take in one status of the server, unless it is older than what is known or of another goal."""
        if status.goal_id != self.goal_id or self.ended or status.sequence <= self._sequence:
            return
        if status.state is GoalState.UNKNOWN:
            if self.state is not None:
                self._forgotten()
            elif self._canceling:  # the answer to that: its server never had it, and won't begin it
                self._cancel_ends()
            return
        self._sequence, self.state = status.sequence, status.state
        self._heard_at = self._told_at = self._client.clocks.monotonic()
        action = self._client.action
        if status.feedback is not None:
            self.feedback = action.feedback.model_validate(status.feedback)
        if status.result is not None:
            self.result = action.result.model_validate(status.result)
        self.failure = status.failure
        if status.state is GoalState.CANCELED:
            self._cancel_ends()

    def _cancel_ends(self) -> None:
        """Have it end as one that was cancelled, or did not end in time."""
        self.state = GoalState.CANCELED
        if self._timed_out:
            self.state = GoalState.FAILED
            self.failure = self._fail(
                FailureKind.TIMED_OUT, f"{self._client.action.name} did not end in time"
            )

    def _watch_time(self) -> None:
        self._age.update(counts=not self._pausing)
        if not self._timed_out and self._age.robot > self._timeout:
            self._timed_out = True
            self.cancel()
        if self._settling is not None:
            self._settling.update()
            if self.paused and not self._canceling:
                self._settling = None

    def _command(self) -> None:
        """Say what is wanted for as long as the server's state is another."""
        if self._command_pending is not None:
            return
        if self._canceling:
            if self.state is not GoalState.CANCELING:
                self._push(Command.CANCEL)
        elif self._pausing and self.state is GoalState.RUNNING:
            self._push(Command.PAUSE)
        elif not self._pausing and self.paused:
            self._push(Command.RESUME)

    def _read_answers(self) -> bool:
        for pending in (self._pending, self._command_pending):
            answer = None if pending is None else pending.poll()
            if answer is None:
                continue
            self._told_at = self._client.clocks.monotonic()
            try:
                status = GoalStatus.model_validate_json(answer)
                # A server that was started anew counts its statuses anew. It was asked after it had known the
                # goal, so that it is no old answer either.
                if status.state is GoalState.UNKNOWN and pending is self._question and not self.ended:
                    self._forgotten()
                self.take(status)
            except ValidationError as error:
                self._lose(f"{self._client.action.name} sent an invalid status: {error}")
        if self._pending is not None and self._pending.done():
            self._pending = None
        if self._command_pending is not None and self._command_pending.done():
            self._command_pending = None
        return self.ended

    def _ask(self) -> None:
        client = self._client
        self._asked_at = client.clocks.monotonic()
        if self.state is None:
            # The document was dumped from a model; checking it again, value by value, takes long.
            sent = SendGoal.model_construct(goal_id=self.goal_id, client=client.owner, goal=self._document)
            self._pending = goal_service(client.action.name).query(client.bus, sent)
        else:
            asked = AskResult(goal_id=self.goal_id)
            self._pending = self._question = result_service(client.action.name).query(client.bus, asked)

    def _push(self, command: Command) -> None:
        asked = GoalCommand(goal_id=self.goal_id, command=command)
        self._command_pending = command_service(self._client.action.name).query(self._client.bus, asked)

    def _forgotten(self) -> None:
        self._lose(f"{self._client.action.name} has lost goal {self.goal_id}: it was restarted")

    def _lose(self, message: str) -> None:
        self.state = GoalState.FAILED
        self.failure = self._fail(FailureKind.SKILL_LOST, message)

    def _fail(self, kind: FailureKind, message: str) -> Failure:
        return Failure(kind=kind, message=message, where=self._client.action.name)


class GoalJournal(Protocol):
    """Is told of each goal before it is sent, and when it has ended."""

    def sending(self, goal_id: str, action: str) -> None:
        """Write it down: a goal that is not known of is not sent."""
        ...

    def ended(self, goal_id: str, how: str) -> None:
        """Write down how it ended."""
        ...


class NoJournal:
    """Writes nothing down."""

    def sending(self, goal_id: str, action: str) -> None:
        """Do nothing."""

    def ended(self, goal_id: str, how: str) -> None:
        """Do nothing."""


class ActionClient(Generic[G, F, R]):
    """Starts goals of one action and keeps their handles until they have ended.

    Args:
        bus: where the server is.
        clocks: robot time for time-outs, host time for lost answers.
        action: the contract.
        owner: the announced name of this process; when it is gone, the server cancels its goals.
        journal: is told of each goal before it is sent.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        action: ActionType[G, F, R],
        owner: str,
        journal: GoalJournal | None = None,
    ) -> None:
        self.bus, self.clocks, self.action, self.owner = bus, clocks, action, owner
        self._journal: GoalJournal = NoJournal() if journal is None else journal
        self._statuses = Latest(bus, status_topic(action.name), depth=256)
        self._open: dict[str, GoalHandle[G, F, R]] = {}

    def start(self, goal: G, goal_id: str, *, timeout: float | None = None) -> GoalHandle[G, F, R]:
        """Send a goal under a new id; ``timeout`` in robot seconds (the action's own unless given)."""
        self._journal.sending(goal_id, self.action.name)
        handle = GoalHandle(self, goal, goal_id, self.action.timeout if timeout is None else timeout)
        self._open[goal_id] = handle
        return handle

    def adopt(self, goal_id: str, goal: G) -> GoalHandle[G, F, R]:
        """Bring a goal to rest that was sent before a restart; one that its server never had is none."""
        handle = GoalHandle(self, goal, goal_id, self.action.timeout, known=True)
        self._open[goal_id] = handle
        handle.cancel()
        return handle

    def poll(self) -> bool:
        """Move all open goals on; return whether any of them changed."""
        before = {goal_id: (handle.state, handle.feedback) for goal_id, handle in self._open.items()}
        for status in self._statuses.take():
            handle = self._open.get(status.goal_id)
            if handle is not None:
                handle.take(status)
        for handle in self._open.values():
            handle.poll()
        changed = any((h.state, h.feedback) != before[goal_id] for goal_id, h in self._open.items())
        for handle in self._open.values():
            if handle.ended:
                self._journal.ended(handle.goal_id, str(handle.state))
            handle.conclude()
        self._open = {goal_id: handle for goal_id, handle in self._open.items() if not handle.ended}
        return changed

    @property
    def quiet(self) -> bool:
        """Whether no goal is open."""
        return not self._open

    @property
    def open(self) -> tuple[GoalHandle[G, F, R], ...]:
        """The goals that have not ended, in the order in which they were started."""
        return tuple(self._open.values())

    def drop(self, handle: GoalHandle[G, F, R], message: str) -> None:
        """Give a goal up that does not end: it has failed, and nothing more is heard of it."""
        handle.drop(message)
        self._journal.ended(handle.goal_id, "given up")
        handle.conclude()
        self._open.pop(handle.goal_id, None)

    def alive(self) -> bool:
        """Whether a server of this action is announced."""
        return f"skill/{self.action.name}" in self.bus.alive()

    def awake(self) -> bool:
        """Whether that server's process goes on."""
        return self.bus.goes_on(f"skill/{self.action.name}")

    def close(self) -> None:
        """End the subscription."""
        self._statuses.close()
