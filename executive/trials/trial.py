"""One task in a whole system, from the request to its end: what campaigns and experiments judge."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from pydantic import JsonValue

from tandem.executive.system.systems import System, SystemFailure
from tandem.executive.trials.demo import Caller
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.node import Node
from tandem.skills.ports.tasks import TaskState, TaskStatus

WARM_UP: Final = 0.3
"""Robot seconds before the request: the first messages of every node have been heard by then (30 periods)."""


@dataclass(frozen=True)
class Trial:
    """How it went."""

    task: str
    status: TaskStatus | None
    """The last one; None when the task has not ended in time."""
    stuck: str
    """Why it has no last status."""
    lasted: float
    """Robot seconds from the request to the end."""

    @property
    def state(self) -> str:
        """The state in which it ended, or what it is stuck at."""
        return f"STUCK: {self.stuck}" if self.status is None else self.status.state.value

    @property
    def succeeded(self) -> bool:
        """Whether it ended well, by its own account."""
        return self.state == TaskState.SUCCEEDED.value

    @property
    def failure(self) -> Failure | None:
        """Why it failed."""
        return None if self.status is None else self.status.failure


def warm_up(system: System, seconds: float = WARM_UP) -> None:
    """Let the system run for some robot seconds."""
    until = robot_seconds(system.clocks) + seconds
    while robot_seconds(system.clocks) < until:
        system.advance()


def trial(system: System, request: dict[str, JsonValue], *, within: float, also: Node | None = None) -> Trial:
    """Send a request and follow its task to the end.

    Args:
        system: what carries it out.
        request: the document.
        within: robot seconds after which it counts as stuck.
        also: a node that is stepped along.

    Raises:
        SystemFailure: nobody answers, or the request is refused.
    """
    caller = Caller(system, _quiet, also=also)
    began = robot_seconds(system.clocks)
    answer = caller.request(request)
    if not answer.accepted:
        raise SystemFailure(f"{request} was refused: {answer.problems}")
    status, stuck = None, ""
    try:
        status = caller.follow(answer.task, within=within)
    except SystemFailure as error:
        stuck = str(error)
    return Trial(answer.task, status, stuck, round(robot_seconds(system.clocks) - began, 2))


def _quiet(_: str) -> None:
    """Tell nobody."""
