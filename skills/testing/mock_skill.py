"""A skill that does nothing but answer: at once, late, with a failure, or never."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Generic

from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType, Command, F, G, Outcome, R, Run, canceled, failed


@dataclass(frozen=True)
class Fault:
    """What a mocked skill does instead of succeeding.

    It takes ``late`` robot seconds longer, then fails with ``failure``, or succeeds when that is None; with
    ``hangs`` it never ends by itself; with ``refuses`` the goal is rejected at once.
    """

    failure: Failure | None = None
    late: float = 0.0
    hangs: bool = False
    refuses: bool = False


def _none(_: str) -> Fault | None:
    return None


def _nobody(_: str, __: Message) -> None:
    pass


@dataclass(eq=False)
class MockSkill(Generic[G, F, R]):
    """Fulfils an action's contract by ``effect``; meets the same contract suite as a real skill.

    Args:
        action: the contract.
        clocks: robot time.
        idle: the feedback while it runs.
        effect: does what the skill would do to the world, and returns its outcome.
        duration: robot seconds that it takes.
        faults: what to do instead, by the number of the call (1 is the first).
        fault_of: what to do instead, by the goal's id; asked when there is none by the number.
    """

    action: ActionType[G, F, R]
    clocks: Clocks
    idle: F
    effect: Callable[[G], Outcome[R]]
    duration: float = 0.0
    faults: dict[int, Fault] = field(default_factory=dict)
    fault_of: Callable[[str], Fault | None] = _none
    period: float = 0.01
    calls: list[G] = field(default_factory=list)
    began: Callable[[str, G], None] = _nobody
    """Told of each goal that begins, with its id."""
    ended: Callable[[str, G], None] = _nobody
    """Told when it is at rest, however that came."""

    def check(self, goal: G) -> Failure | None:
        """Refuse where a fault says so; a refused call counts."""
        fault = self.faults.get(len(self.calls) + 1)
        if fault is not None and fault.refuses:
            self.calls.append(goal)
            return fault.failure
        return None

    def run(self, goal: G, goal_id: str) -> Run[F, R]:
        """Wait the duration, in which pauses don't count, then answer."""
        self.calls.append(goal)
        self.began(goal_id, goal)
        try:
            return (yield from self._work(goal, goal_id))
        finally:
            self.ended(goal_id, goal)

    def _work(self, goal: G, goal_id: str) -> Run[F, R]:
        fault = self.faults.get(len(self.calls)) or self.fault_of(goal_id) or Fault()
        until = robot_seconds(self.clocks) + self.duration + fault.late
        paused_at: float | None = None
        while fault.hangs or paused_at is not None or robot_seconds(self.clocks) < until:
            command = yield self.idle
            if command is Command.PAUSE and paused_at is None:
                paused_at = robot_seconds(self.clocks)
            elif command is Command.RESUME and paused_at is not None:
                until, paused_at = until + robot_seconds(self.clocks) - paused_at, None
            if command is Command.CANCEL:
                yield self.idle  # a skill takes a moment to come to rest
                return canceled()
        return self.effect(goal) if fault.failure is None else failed(fault.failure)
