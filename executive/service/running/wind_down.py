"""What a task does after a cancel: a tree of its own, begun once, and stopped when it takes too long."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from tandem.executive.ledger.task_memory import Winding
from tandem.executive.service.running.endings import Ending, kept_from_winding_down
from tandem.executive.service.running.time_limits import WIND_DOWN_WITHIN
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext
from tandem.trees.elapsed import Elapsed


class WindDown:
    """How far a task is with what is done after a cancel.

    Args:
        context: what the task's tree was built with; it has the tree of the wind-down.
        clocks: robot time and host time for its limit.
    """

    def __init__(self, context: TreeContext, clocks: Clocks) -> None:
        self.stage: Winding = ""
        """How far it is; a restart remembers it."""
        self._context, self._clocks = context, clocks
        self._since: Elapsed | None = None  # its beginning
        self._before: Failure | None = None  # the last failure then

    def leave(self) -> None:
        """Cancelled once more: what has begun is stopped as well, and does not begin again."""
        if self.stage == "begun":
            self.stage = "left"

    def due(self, ending: Ending) -> Behaviour | None:
        """Return the tree to turn to after the end of a cancelled task, if there is something to do."""
        if self._since is not None or self.stage == "left" or ending.failure is not None:
            return None
        return self._context.wind_down

    def prevented(self, tree: Behaviour) -> Failure | None:
        """Return why nothing may move now: the hardware's stop is set."""
        stop = self._context.knowledge.stopped
        return kept_from_winding_down(tree.name, stop.by) if stop.stopped else None

    def begin(self) -> None:
        """Note that its tree is ticked from now on."""
        self.stage = "begun"
        failures = self._context.failures.all
        self._before = failures[-1] if failures else None
        self._since = Elapsed(self._clocks)

    def overdue(self) -> bool:
        """Say whether its tree has taken too long; to be asked with each step."""
        if self._since is None:
            return False
        self._since.update()
        return self._since.beyond(WIND_DOWN_WITHIN, WIND_DOWN_WITHIN)

    def told(self) -> Failure | None:
        """Return the failure that the tree at work has told; one from before the wind-down is not its own."""
        failures = self._context.failures
        if self._since is None:
            return failures.summary()
        return failures.all[-1] if failures.all and failures.all[-1] is not self._before else None
