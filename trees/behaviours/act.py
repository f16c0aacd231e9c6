"""A leaf that has one skill do one thing; the client adapter owns the goal's life."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Generic, TypeVar

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.action import GoalState
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import BASE, PipelineState
from tandem.skills.ports.skill import ActionType
from tandem.trees.behaviours.give_way import FREE_WITHIN, REFLEX, WAITED
from tandem.trees.client import GoalHandle
from tandem.trees.context import TreeContext
from tandem.trees.recovery_kinds import waiting_helps

G = TypeVar("G", bound=Message)
F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)


BELIEF_WITHIN: Final = 2.0
"""Robot seconds that knowledge has to catch up with a result; then the tree goes on without."""


def at_once(_: Message) -> bool:
    """Wait for nothing."""
    return True


def accept(_: Message) -> Failure | None:
    """Take any result."""
    return None


class Act(Behaviour, Generic[G, F, R]):
    """RUNNING while the skill works, SUCCESS with its result, FAILURE with its failure.

    Args:
        name: unique in the tree and stable for ever.
        context: the task's surroundings.
        action: which skill; or a function that says so when the leaf starts (which arm it is).
        goal: makes the goal when the leaf starts, from what is known then; or says why there is none.
        resources: what the skill moves, or a function that says so; the leaf waits until it has it all, and
            no reflex has any of it. The base is excepted: a drive may have other ways, so what is above waits
            (``trees/subtrees/travel.py``).
        judge: looks at a success and may turn it into a failure; stores what later leaves need.
        believed: says whether what the result means has reached the tree's knowledge; the leaf is RUNNING
            until then, because the next leaf will ask the knowledge and not the result.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        action: ActionType[G, F, R] | Callable[[], ActionType[G, F, R]],
        goal: Callable[[], G | Failure],
        *,
        resources: tuple[str, ...] | Callable[[], tuple[str, ...]] = (),
        judge: Callable[[R], Failure | None] = accept,
        believed: Callable[[R], bool] = at_once,
    ) -> None:
        super().__init__(name)
        self._context, self._goal, self._judge = context, goal, judge
        self._believed = believed
        self._which = action if callable(action) else lambda: action
        self._needs = resources if callable(resources) else lambda: resources
        self._skill = ""
        self._handle: GoalHandle[G, F, R] | None = None
        self._attempt = 0
        self._ended_at: float | None = None
        self._waits_since: float | None = None
        self.failure: Failure | None = None

    @property
    def skill(self) -> str:
        """The action's name, once it has been started."""
        return self._skill

    @property
    def feedback(self) -> F | None:
        """What the skill told last of the goal of this attempt."""
        return None if self._handle is None else self._handle.feedback

    @property
    def holder(self) -> str:
        """The id of the goal of this attempt."""
        return f"{self._context.task}/{self.name}/{self._attempt}"

    def initialise(self) -> None:
        """Begin a new attempt."""
        self._handle, self.failure, self._ended_at, self._waits_since = None, None, None, None
        self._attempt = self._context.notes.next_attempt(self.name)
        self.feedback_message = ""

    def update(self) -> Status:
        """Start the goal, or see how it goes."""
        if self._handle is None:
            return self._start()
        handle = self._handle
        if not handle.ended:
            self.feedback_message = _words(handle)
            return Status.RUNNING
        self._context.resources.release(self.holder)
        if handle.state is GoalState.SUCCEEDED and handle.result is not None:
            if not self._believed(handle.result) and not self._impatient():
                self.feedback_message = "done; waits until it is believed"
                return Status.RUNNING
            refusal = self._judge(handle.result)
            if refusal is None:
                self.feedback_message = "done"
                return Status.SUCCESS
            return self._fail(refusal)
        missing = Failure(
            kind=FailureKind.SKILL_LOST, message="the skill ended without a result or a failure"
        )
        return self._fail(handle.failure or missing)

    def terminate(self, new_status: Status) -> None:
        """Have the skill come to rest when the tree turns to something else."""
        handle, holder, resources = self._handle, self.holder, self._context.resources
        if new_status is not Status.INVALID or handle is None:
            return
        if handle.ended:  # and this leaf has not been ticked since
            resources.release(holder)
        else:
            handle.cancel()
            handle.when_ended(lambda: resources.release(holder))
            self.feedback_message = "cancelled"

    def _impatient(self) -> bool:
        now = self._context.seconds
        self._ended_at = now if self._ended_at is None else self._ended_at
        return now - self._ended_at > BELIEF_WITHIN

    def _start(self) -> Status:
        action, needs = self._which(), self._needs()
        self._skill = action.name
        taken = self._taken(needs)
        if taken is not None:
            return self._wait(taken)
        if not self._context.resources.claim(needs, self.holder):
            self.feedback_message = f"waits for {', '.join(needs)}"
            return Status.RUNNING
        goal = self._goal()
        if isinstance(goal, Failure):
            self._context.resources.release(self.holder)
            return self._fail(goal)
        self._handle = self._context.clients.of(action).start(goal, self.holder)
        self.feedback_message = f"sent to {action.name}"
        return Status.RUNNING

    def _taken(self, needs: tuple[str, ...]) -> PipelineState | None:
        """Return which reflex has something that the skill moves; the base is waited for where it goes."""
        told = (self._context.knowledge.reflex_of(name) for name in needs if name != BASE)
        return next((state for state in told if state is not None), None)

    def _wait(self, taken: PipelineState) -> Status:
        """Wait until the reflex gives it back; after ``FREE_WITHIN`` waiting is not tried again."""
        now, words = self._context.seconds, self._context.knowledge.taken(taken.resource)
        self._waits_since = now if self._waits_since is None else self._waits_since
        self.feedback_message = f"waits: {words}"
        if now - self._waits_since <= FREE_WITHIN:
            return Status.RUNNING
        status = self._fail(
            Failure(
                kind=FailureKind.OVERRIDDEN,
                message=f"waits: {words}",
                evidence={WAITED: FREE_WITHIN, REFLEX: taken.reflex},
                causes=() if taken.why is None else (taken.why,),
            )
        )
        self._context.failures.exhausted = (self._context.failures.last(), frozenset((waiting_helps,)))
        return status

    def _fail(self, failure: Failure) -> Status:
        self.failure = failure.model_copy(update={"where": f"{self.name}: {failure.where or self._skill}"})
        self._context.failures.add(self.failure)
        self.feedback_message = f"{failure.kind}: {failure.message}"
        return Status.FAILURE


class Lasting(Act[G, F, R]):
    """An ``Act`` whose skill goes on until it is stopped: it never is SUCCESS."""


def _words(handle: GoalHandle[G, F, R]) -> str:
    if handle.state is None:
        return "sent"
    if handle.feedback is None:
        return handle.state.lower()
    fields = handle.feedback.model_dump(mode="json")
    doing = [" > ".join(fields.pop("doing"))] if fields.get("doing") else []
    plain = [(name, value) for name, value in fields.items() if not isinstance(value, dict | list)]
    shown = ", ".join(doing + [f"{name} {_short(value)}" for name, value in plain])
    return f"{handle.state.lower()}: {shown}" if shown else handle.state.lower()


def _short(value: object) -> str:
    return f"{value:.2f}" if isinstance(value, float) else str(value)
