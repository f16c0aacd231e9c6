"""The life of a goal on the bus: what client and server of an action say to each other.

Keys, for the action ``name``: ``skill/<name>/goal``, ``.../command`` and ``.../result`` are queried,
``.../status`` is published. A goal's id is ``task/node/attempt``; sending the same id twice starts once.
"""

from __future__ import annotations

from enum import StrEnum

from pydantic import JsonValue

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.lease import Leased
from tandem.skills.ports.message import Count, Message, RobotTime
from tandem.skills.ports.skill import Command


class GoalState(StrEnum):
    """State of a goal."""

    REJECTED = "REJECTED"
    UNKNOWN = "UNKNOWN"
    RUNNING = "RUNNING"
    PAUSED = "PAUSED"
    CANCELING = "CANCELING"
    SUCCEEDED = "SUCCEEDED"
    FAILED = "FAILED"
    CANCELED = "CANCELED"

    @property
    def terminal(self) -> bool:
        """Whether nothing comes after it."""
        return self in {
            GoalState.REJECTED,
            GoalState.UNKNOWN,
            GoalState.SUCCEEDED,
            GoalState.FAILED,
            GoalState.CANCELED,
        }


class SendGoal(Leased):
    """Start ``goal`` under this id. ``client`` is the announced name whose end brings the goal to rest."""

    goal_id: str
    client: str
    goal: dict[str, JsonValue]


class GoalCommand(Leased):
    """Cancel, pause or resume the goal.

    A cancel needs no lease: stopping is always allowed.
    """

    goal_id: str
    command: Command


class AskResult(Message):
    """Query how a goal ended; the server keeps it for clients that join late or reconnect."""

    goal_id: str


class GoalStatus(Message):
    """The goal as its server sees it: the answer to every query, and published on each change.

    ``sequence`` rises with each status of the server, so that an older one that arrives later is known.
    """

    goal_id: str
    state: GoalState
    sequence: Count
    stamp: RobotTime | None = None
    feedback: dict[str, JsonValue] | None = None
    result: dict[str, JsonValue] | None = None
    failure: Failure | None = None


def task_of(goal_id: str) -> str:
    """Return the task that a goal belongs to."""
    return goal_id.partition("/")[0]


def node_of(goal_id: str) -> str:
    """Return the name of the node that sent a goal."""
    return goal_id.partition("/")[2].rpartition("/")[0]


def goal_service(action: str) -> Service[SendGoal, GoalStatus]:
    """Return the service that takes goals."""
    return Service(f"skill/{action}/goal", SendGoal, GoalStatus)


def command_service(action: str) -> Service[GoalCommand, GoalStatus]:
    """Return the service that takes cancel, pause and resume."""
    return Service(f"skill/{action}/command", GoalCommand, GoalStatus)


def result_service(action: str) -> Service[AskResult, GoalStatus]:
    """Return the service that tells how a goal stands or ended."""
    return Service(f"skill/{action}/result", AskResult, GoalStatus, reads=True)


def status_topic(action: str) -> Topic[GoalStatus]:
    """Return the topic of the action's status."""
    return Topic(f"skill/{action}/status", GoalStatus)
