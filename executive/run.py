"""One task under way: its tree is ticked when there is a reason to, and its end is awaited at rest."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from executive.halt import Halt
from executive.tree_view import TreeView
from skills.ports.clocks import Clocks
from skills.ports.failure import Failure, FailureKind
from skills.ports.message import RobotTime
from skills.ports.tasks import NodeStatus, Progress, TaskState, TreeNode, TreeSnapshot
from trees.context import TreeContext
from trees.snapshot import snapshot

TICK_PERIOD: Final = 0.05
"""Robot seconds after which the tree is ticked although nothing was heard: its timers."""
SILENT_PERIOD: Final = 0.25
"""Host seconds after which it is ticked although the robot's clock stands still."""
REST_WITHIN: Final = 5.0
"""Robot seconds in which all goals must have ended after the tree has; then the hardware is stopped."""
SILENCE_ALLOWED: Final = 10.0
"""Host seconds that this is waited for while the robot's clock stands still."""

_LOG = logging.getLogger(__name__)


@dataclass(frozen=True)
class Ending:
    """How a task ends, once its goals have."""

    state: TaskState
    failure: Failure | None = None


class Run:
    """One task, from its first tick until the robot is at rest.

    Args:
        context: what the tree was built with.
        root: the tree.
        kind: the kind of task.
        clocks: robot time for timers, host time for when the robot's stands still.
        halt: stops the hardware, when goals don't come to rest.
    """

    def __init__(
        self, context: TreeContext, root: Behaviour, kind: str, *, clocks: Clocks, halt: Halt
    ) -> None:
        self.context = context
        self.ended: Ending | None = None
        self.ticks = 0
        self._root, self._kind, self._clocks, self._halt = root, kind, clocks, halt
        self._ending: Ending | None = None
        self._ticked_at: RobotTime | None = None
        self._ticked_on_host = clocks.monotonic()
        self._progress = Progress()
        self._view = TreeView(root)
        self._shown: TreeNode | None = None
        self._touched = False  # a tree changes only when it is ticked or stopped
        self._ending_since = 0.0
        self._ending_on_host = 0.0
        self._halting = False

    @property
    def canceling(self) -> bool:
        """Whether it has been cancelled and is not yet at rest."""
        return self._ending is not None and self._ending.state is TaskState.CANCELED

    @property
    def ending(self) -> Ending | None:
        """How it is going to end, once that is known."""
        return self._ending

    @property
    def progress(self) -> Progress:
        """Phase and fraction; the fraction never falls."""
        return self._progress

    def step(self) -> None:
        """Take in what has arrived; tick, or wait for rest."""
        if self.ended is not None:
            return
        heard = self._poll()
        if self._ending is None and (heard or self._due()):
            self._tick()
        if self._ending is not None:
            self._await_rest(self._ending)
        self._note_progress()

    def cancel(self) -> None:
        """Stop the tree: its leaves cancel their goals. ``ended`` is set when all have come to rest."""
        if self._ending is None:
            self._stop_tree()
            self._end_with(Ending(TaskState.CANCELED))

    def changed_tree(self) -> TreeSnapshot | None:
        """Return the tree if a status or message in it is another than at the last call."""
        if not self._touched:
            return None
        self._touched = False
        now = self._view.look()
        if now is self._shown:
            return None
        self._shown = now
        return self.tree()

    def tree(self) -> TreeSnapshot:
        """Return the tree as it is."""
        return TreeSnapshot(
            task=self.context.task,
            kind=self._kind,
            tick=self.ticks,
            stamp=self._clocks.robot(),
            root=self._view.look(),
        )

    def _poll(self) -> bool:
        try:
            return self.context.poll()
        except Exception as error:  # noqa: BLE001 - a tree's mistake costs its task, not the service
            self._crash(error)
            return False

    def _due(self) -> bool:
        if self.ticks == 0:
            return True
        now = self._clocks.robot()
        if self._clocks.monotonic() - self._ticked_on_host >= SILENT_PERIOD:
            return True
        if now is None or self._ticked_at is None:
            return now is not None
        return now.boot != self._ticked_at.boot or now.seconds - self._ticked_at.seconds >= TICK_PERIOD

    def _tick(self) -> None:
        self._ticked_at, self._ticked_on_host = self._clocks.robot(), self._clocks.monotonic()
        self.ticks += 1
        self._touched = True
        try:
            self._root.tick_once()
        except Exception as error:  # noqa: BLE001 - a tree's mistake costs its task, not the service
            self._crash(error)
            return
        status = NodeStatus(self._root.status.name)
        if status is NodeStatus.SUCCESS:
            self._end_with(Ending(TaskState.SUCCEEDED))
        elif status is not NodeStatus.RUNNING:
            self._end_with(Ending(TaskState.FAILED, self.context.failure() or self._unsaid()))

    def _crash(self, error: Exception) -> None:
        """End a tree that raised: a mistake in the program, which must cost this task and nothing else."""
        _LOG.error("%s: its tree raised", self.context.task, exc_info=error)
        if self._ending is None:
            self._stop_tree()
            text = f"the tree raised {type(error).__name__}: {error}; the executive's log has the trace"
            failure = Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=self._root.name)
            self._end_with(Ending(TaskState.FAILED, failure))

    def _stop_tree(self) -> None:
        self._touched = True
        try:
            self._root.stop(Status.INVALID)
        except Exception:  # noqa: BLE001 - the tree is given up anyway
            _LOG.exception("%s: its tree raised while it was stopped", self.context.task)

    def _end_with(self, ending: Ending) -> None:
        self._ending = ending
        self._begin_waiting()

    def _begin_waiting(self) -> None:
        now = self._clocks.robot()
        self._ending_since = 0.0 if now is None else now.seconds
        self._ending_on_host = self._clocks.monotonic()

    def _await_rest(self, ending: Ending) -> None:
        if self.context.quiet and not self._halting:
            self.ended = ending
        elif self._halting:
            if self._halt.step():
                self.ended = Ending(TaskState.FAILED, self._not_at_rest(ending))
        elif self._overdue():
            self._halting = True
            self._halt.set(f"the goals of {self.context.task} did not come to rest")

    def _overdue(self) -> bool:
        now = self._clocks.robot()
        seconds = 0.0 if now is None else now.seconds - self._ending_since
        if not 0.0 <= seconds <= REST_WITHIN:
            return True
        return seconds == 0.0 and self._clocks.monotonic() - self._ending_on_host > SILENCE_ALLOWED

    def _not_at_rest(self, ending: Ending) -> Failure:
        set_ = "was set" if self._halt.confirmed else "was asked for and not confirmed"
        before = ending.failure
        return Failure(
            kind=FailureKind.HARDWARE_STOPPED,
            message=(
                f"after the task's end as {ending.state}, goals of skills did not come to rest within"
                f" {REST_WITHIN:.0f} s; the hardware's stop {set_}"
            ),
            where=self._root.name,
            evidence={"within_s": REST_WITHIN, "stop_confirmed": self._halt.confirmed},
            causes=() if before is None else (before,),
        )

    def _note_progress(self) -> None:
        told = self.context.progress
        done = self._ending is not None and self._ending.state is TaskState.SUCCEEDED
        fraction = 1.0 if done else max(told.fraction, self._progress.fraction)
        self._progress = Progress(phase=told.phase or self._progress.phase, fraction=fraction)

    def _unsaid(self) -> Failure:
        node = _deepest_failure(snapshot(self._root))
        said = f": {node.message}" if node.message else ""
        text = f"the tree failed without a reason, at {node.path}{said}"
        return Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=node.path)


def _deepest_failure(node: TreeNode) -> TreeNode:
    failed = [child for child in node.children if child.status is NodeStatus.FAILURE]
    return _deepest_failure(failed[-1]) if failed else node
