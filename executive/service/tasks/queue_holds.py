"""What keeps waiting tasks from beginning: that which would fail every one of them.

A stop that is set, hardware that is silent, a robot that has told too little. And what a task has
just failed by, if the next of its kind would, too: the others then go on waiting until it is over, or it
is time to try one of them; a task that is tried in vain waits again.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from tandem.executive.service.running.time_limits import SILENT_AFTER
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.trees.clients import Clients
from tandem.trees.knowledge import Knowledge
from tandem.trees.task import TaskType

FIRST_TRY: Final = 30.0
"""Host seconds after which one of the waiting tasks is tried: what passes by itself has mostly passed."""
LAST_TRY: Final = 900.0
"""Host seconds between two tries, at the most: each moves the robot."""

_LOG = logging.getLogger(__name__)
Over = Callable[[Knowledge, Clients], bool]


def _unknown(_: Knowledge, __: Clients) -> bool:
    """Say that only a try can tell."""
    return False


def _localised(knowledge: Knowledge, _: Clients) -> bool:
    return knowledge.robot_localised


def _served(_: Knowledge, clients: Clients) -> bool:
    return not clients.gone()


COMMON: Final[Mapping[FailureKind, Over]] = MappingProxyType(
    {
        FailureKind.NOT_LOCALISED: _localised,
        FailureKind.SKILL_LOST: _served,
        FailureKind.LASER_SILENT: _unknown,
        FailureKind.CAMERA_SILENT: _unknown,
        FailureKind.CAMERA_BLIND: _unknown,
    }
)
"""The kinds of failure that the next task would meet as well, and what tells that they are over.

Stopped and lost hardware are not among them: they are seen, without a try.
"""


@dataclass
class _Cause:
    """What failed a task of a kind and would fail the next."""

    task: str
    failure: Failure
    wait: float
    """Host seconds until the next try."""
    since: float

    def left(self, now: float) -> float:
        """Return the host seconds until the next try."""
        return self.wait - (now - self.since)


class Holds:
    """Says whether a task may begin.

    Args:
        clocks: host time, for when to try.
        knowledge: tells of stop, hardware and robot.
        clients: tell which skills are gone.
    """

    def __init__(self, clocks: Clocks, knowledge: Knowledge, clients: Clients) -> None:
        self._clocks, self._knowledge, self._clients = clocks, knowledge, clients
        self._causes: dict[str, _Cause] = {}
        self._raised: dict[str, str] = {}
        """What the ``waits`` of a kind raised last: the log has it once."""

    def why_not(self, kind: TaskType[Message]) -> str:
        """Return what a task of a kind has to wait for, in words after "waits for"; or nothing."""
        return self.robot(kind) or self._cause(kind.name)

    def robot(self, kind: TaskType[Message]) -> str:
        """Return what of it can be seen at the robot."""
        stop, silent = self._knowledge.stopped, self._knowledge.hardware_silent_for
        if stop.stopped:
            why = f" ({stop.reason})" if stop.reason else ""
            return f"the release of the hardware's stop, set by {stop.by or 'somebody'}{why}"
        if silent > SILENT_AFTER:
            return "the hardware, which is silent"
        try:
            return kind.waiting(self._knowledge)
        except Exception as error:  # noqa: BLE001 - a kind's mistake costs its tasks, not the service
            said = f"{error!r}"
            if self._raised.get(kind.name) != said:  # it is asked again and again
                self._raised[kind.name] = said
                _LOG.exception("`waits` of a kind of task raised", extra={"kind": kind.name})
            return f"a corrected {kind.name}: its function `waits` raised {said}; see the executive's log"

    def note(self, kind: str, task: str, failure: Failure | None) -> bool:
        """Note how a task has ended (``failure``: None when well); return whether it had better wait again.

        The first that fails by something common fails: whoever asked is told. What is tried later waits.
        """
        known = self._causes.pop(kind, None)
        if failure is None or failure.reason.kind not in COMMON:
            return False
        now = self._clocks.monotonic()
        same = known is not None and known.failure.reason.kind is failure.reason.kind
        wait = min(2.0 * known.wait, LAST_TRY) if known is not None and same else FIRST_TRY
        self._causes[kind] = _Cause(task, failure, wait, now)
        return same

    def asked(self, kind: str) -> None:
        """Note that somebody asks for a task of a kind: it need not wait long for the next try."""
        cause = self._causes.get(kind)
        if cause is not None:
            cause.wait = min(cause.wait, FIRST_TRY)

    def _cause(self, kind: str) -> str:
        cause = self._causes.get(kind)
        if cause is None:
            return ""
        if COMMON[cause.failure.reason.kind](self._knowledge, self._clients):
            del self._causes[kind]
            return ""
        left = cause.left(self._clocks.monotonic())
        if left <= 0.0:
            return ""
        why = f"{cause.failure.kind}: {cause.failure.message}"
        return f"the cause of the failure of {cause.task} to pass ({why}); retry after {cause.wait:.0f} s"
