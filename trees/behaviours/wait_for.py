"""Wait, in robot time, until something holds."""

from __future__ import annotations

from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext


class WaitFor(Behaviour):
    """RUNNING until ``holds``, at most ``patience`` robot seconds; then FAILURE with ``otherwise``.

    It takes ``at_least`` so many robot seconds. What waits for a process waits for the host: with
    ``for_a_process`` as many seconds of the host's clock must have passed as well, since a simulation that
    is faster than real time lets the robot's pass while a process starts.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        holds: Callable[[], bool],
        otherwise: Callable[[], Failure],
        *,
        patience: float,
        at_least: float = 0.0,
        for_a_process: bool = False,
    ) -> None:
        """See the class."""
        super().__init__(name)
        self._context, self._holds, self._otherwise, self._patience = context, holds, otherwise, patience
        self._since, self._at_least = 0.0, at_least
        self._host_since, self._for_a_process = 0.0, for_a_process
        self.failure: Failure | None = None

    def initialise(self) -> None:
        """Note the time."""
        self._since, self._host_since = self._context.seconds, self._context.clocks.monotonic()

    def update(self) -> Status:
        """Ask, and watch the time."""
        waited = self._context.seconds - self._since
        if waited >= self._at_least and self._holds():
            self.feedback_message = "yes"
            return Status.SUCCESS
        self.failure = self._otherwise()
        self.feedback_message = self.failure.message
        if waited < max(self._patience, self._at_least) or self._host_may_be_late():
            return Status.RUNNING
        self._context.failures.add(self.failure)
        return Status.FAILURE

    def _host_may_be_late(self) -> bool:
        host_waited = self._context.clocks.monotonic() - self._host_since
        return self._for_a_process and host_waited < self._patience
