"""One task under way: its tree is ticked when there is a reason to, and its end is awaited at rest.

It looks after what no tree can: goals that don't come to rest, hardware that is silent, pause and step.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from pydantic import JsonValue

from tandem.executive.ledger.port import LedgerError
from tandem.executive.service.running.emergency_stop import EmergencyStop
from tandem.executive.service.running.endings import (
    Ending,
    abandoned,
    hardware_lost,
    not_at_rest,
    not_wound_down,
    raised,
    unsaid,
)
from tandem.executive.service.running.pausing import Pausing, Step
from tandem.executive.service.running.shown_tree import ShownTree
from tandem.executive.service.running.tick_timer import TickTimer
from tandem.executive.service.running.time_limits import (
    LOST_AFTER,
    REST_WITHIN,
    SILENCE_ALLOWED,
    SILENT_AFTER,
    WIND_DOWN_WITHIN,
)
from tandem.executive.service.running.tree_view import SeenNode
from tandem.executive.service.running.wind_down import WindDown
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import NodeStatus, Progress, TaskState, TreeNode, TreeSnapshot
from tandem.trees.breakpoints import Breakpoints
from tandem.trees.clients import AnyGoal
from tandem.trees.context import TreeContext
from tandem.trees.dissolve import dissolve
from tandem.trees.elapsed import Elapsed
from tandem.trees.task import TaskType
from tandem.trees.told_board import told_board

WAITS: Final = "waiting for the hardware"
NO_NODE: Final = TreeNode(path="idle", name="idle", kind="action", type="Nothing")
"""What is told as the tree before the first task."""

_LOG = logging.getLogger(__name__)


def _nobody(_: float) -> None:
    """Nobody asks how long a tick took."""


def _for_nothing() -> str:
    return ""


class Run:
    """One task, from its first tick until the robot is at rest.

    Args:
        context: what the tree was built with.
        root: the tree.
        kind: the kind of task.
        clocks: robot time for timers, host time for when the robot's stands still.
        halt: stops the hardware, when goals don't come to rest.
        ticked: told how many seconds of the host each tick took.
        waits: returns what it has to wait for before its first tick, or nothing; asked until then.
    """

    def __init__(
        self,
        context: TreeContext,
        root: Behaviour,
        kind: TaskType[Message],
        *,
        clocks: Clocks,
        halt: EmergencyStop,
        ticked: Callable[[float], None] = _nobody,
        waits: Callable[[], str] = _for_nothing,
    ) -> None:
        self.context = context
        self.ended: Ending | None = None
        self.ticks = 0
        self.canceling = False
        """Whether it has been cancelled."""
        self.wind_down = WindDown(context, clocks)
        """What is done after a cancel."""
        self.told_to_go_on = False
        """Whether an operator had it go on after a restart."""
        self._root, self._kind, self._clocks, self._halt = root, kind, clocks, halt
        self._first = root  # the wind-down's may come after it
        self.result: dict[str, JsonValue] | None = None
        """What the task tells at its end."""
        self._ticked, self._waits_for, self._kept = ticked, waits, ""
        self._pausing = Pausing(context, clocks)
        self._ending: Ending | None = None
        self._resting = Elapsed(clocks)  # since the tree's end
        self._halted: tuple[AnyGoal, ...] | None = None  # the goals for whose sake the hardware is stopped
        self._waits = False
        self._timer = TickTimer(clocks)
        self._progress = context.progress  # a task that is taken up again does not fall back
        self._shown = ShownTree(root)
        self.gates = Breakpoints(root, context)
        """Breakpoints and forced nodes."""
        self.yielding = False
        """Whether it makes room for another task."""
        self.running: tuple[str, ...] = ()
        """The leaves that run, by their names."""

    @property
    def ending(self) -> Ending | None:
        """How it is going to end, once that is known."""
        return self._ending

    @property
    def state(self) -> TaskState:
        """Where it stands, until it has ended."""
        return TaskState.CANCELING if self.canceling else self._pausing.state

    @property
    def progress(self) -> Progress:
        """Phase and fraction; the fraction never falls."""
        waits = WAITS if self._waits else f"waiting for {self._kept}" if self._kept else ""
        return self._progress.model_copy(update={"phase": waits}) if waits else self._progress

    def step(self) -> None:
        """Take in what has arrived; tick, or wait for rest."""
        if self.ended is not None:
            return
        heard = self._poll()
        silent = self.context.knowledge.hardware_silent_for
        self._waits = silent > SILENT_AFTER
        if self._halted is not None:
            self._go_on_halting(self._halted)
        elif silent > LOST_AFTER:
            self._lose_hardware(silent)
        elif not self._waits:
            self._go_on(heard=heard)
        self._note_progress()

    def cancel(self) -> None:
        """Stop the tree: its leaves cancel their goals. ``ended`` is set when all have come to rest.

        What is to be done after a cancel is done then; cancelled once more, that is stopped as well.
        """
        if self.canceling:
            self.wind_down.leave()
        if self._ending is None or self.yielding:
            self.canceling, self.yielding = True, False
            self._pausing.resume()
            self._stop_tree()
            self._end_with(Ending(TaskState.CANCELED))

    def dissolve(self) -> None:
        """Free the trees of a run that has ended; they are neither ticked nor shown again."""
        context = self.context
        for root in (self._first, self._root, context.wind_down):
            if root is not None:
                dissolve(root)
        context.wind_down = context.closing = None

    def make_room(self) -> None:
        """Stop the tree for another task's sake: it ends as QUEUED when all is at rest."""
        if self._ending is None:
            self.yielding = True
            self._stop_tree()
            self._end_with(Ending(TaskState.QUEUED))

    def step_on(self, step: Step) -> None:
        """Go on, just built, until one more leaf has ended or by one tick, and pause then."""
        self._pausing.resume(step)

    @property
    def stepping(self) -> Step:
        """How far it goes on before it is paused again."""
        return self._pausing.stepping

    def interrupt(self, failure: Failure) -> None:
        """Stop the tree: the task ends as INTERRUPTED when all is at rest."""
        self._pausing.resume()
        self._stop_tree()
        self._end_with(Ending(TaskState.INTERRUPTED, failure))

    def look_again(self) -> None:
        """Tick with the next step, whatever the timers say: something has changed."""
        self._timer.look_again()

    def abandon(self) -> str:
        """Give it up although not all is at rest; return why not, or nothing."""
        if not self.canceling:
            return "only a cancelled task can be abandoned"
        silent = self.context.knowledge.hardware_silent_for
        self._resting.update()
        if silent <= SILENT_AFTER and self._halted is None:
            return "the hardware answers, and the skills are coming to rest"
        skills = (handle.action for handle in self.context.clients.open)
        self._conclude(Ending(TaskState.INTERRUPTED, abandoned(self._root.name, skills, silent)))
        return ""

    def pause(self) -> str:
        """Have all come to rest and the tree stay where it is; return why not, or nothing."""
        why = self.held_up_by()
        if not why:
            self._pausing.pause()
        return why

    def resume(self) -> str:
        """Go on after a pause; return why not, or nothing."""
        why = self.held_up_by()
        if not why and self._pausing.free:
            why = "the task is not paused"
        return why or self._leave_pause("")

    def step_by(self, step: Step) -> str:
        """Go on until one more leaf has ended or by one tick, and pause again; return why not, or nothing."""
        why = self.held_up_by()
        if not why and self._pausing.state is not TaskState.PAUSED:
            pausing = self._pausing.state is TaskState.PAUSING
            why = "the skills are still coming to rest" if pausing else "the task is not paused"
        return why or self._leave_pause(step)

    def _leave_pause(self, step: Step) -> str:
        if self.context.dialogue.question is not None and self.ticks == 0:
            return "the task asks whether to continue; answer the question first"
        self.gates.release()
        self.look_again()
        self._pausing.resume(step)
        return ""

    def changed_tree(self) -> bytes | None:
        """Return the tree, as ``tree`` does, if it is to be shown: see ``ShownTree.changed``."""
        return self.tree() if self._shown.changed(self.gates, self._clocks.monotonic()) else None

    def take_changed(self) -> tuple[SeenNode, ...]:
        """Return the nodes that have changed in the trees that were returned since they were taken last."""
        return self._shown.view.take_changed()

    def tree(self) -> bytes:
        """Return the tree as it is, a ``TreeSnapshot`` in JSON; with its gates while it may come to them."""
        gates = None if self.held_up_by() else self.gates
        beside = TreeSnapshot(
            task=self.context.task,
            kind=self._kind.name,
            tick=self.ticks,
            stamp=self._clocks.robot(),
            root=NO_NODE,
            board=told_board(self.context.board),
            breakpoints={} if gates is None else gates.breakpoints(),
            forced={} if gates is None else gates.forced(),
        ).model_dump_json(exclude={"root"})
        return f'{beside[:-1]},"root":{self._shown.written()}}}'.encode()

    def held_up_by(self) -> str:
        """Return why its tree is not to be held or changed any more, or nothing."""
        if self.canceling:
            return "the task is being cancelled"
        if self.yielding:
            return "the task is making room for another one"
        return "" if self._ending is None else f"the task is about to end: {self._ending.state}"

    def _poll(self) -> bool:
        try:
            return self.context.poll()
        except Exception as error:  # noqa: BLE001 - a tree's mistake costs its task, not the service
            self._crash(error)
            return False

    def _go_on(self, *, heard: bool) -> None:
        stuck = self.context.clients.stuck(REST_WITHIN, SILENCE_ALLOWED)
        if stuck:
            self._stop_hardware(stuck)
            return
        self._pausing.step()
        self._kept = self._waits_for() if self.ticks == 0 and self._ending is None else ""
        if (
            self._ending is None
            and self._pausing.free
            and not self._kept
            and (heard or self.ticks == 0 or self._timer.due)
        ):
            self._tick()
        if self.wind_down.overdue() and self._ending is None:
            self._stop_tree()
            self._end_with(self._as_failed(not_wound_down(self._root.name, WIND_DOWN_WITHIN)))
        if self._ending is not None:
            self._await_rest(self._ending)

    # The tree.

    def _tick(self) -> None:
        self._timer.begin()
        self.ticks += 1
        self._shown.touched = True
        try:
            ticked = tuple(self._shown.view.heed(self._root.tick()))
            self._judge(ticked)
            # Last, and so also when the tree has ended: nothing of it runs any more.
            self.running = tuple(n.name for n in ticked if not n.children and n.status is Status.RUNNING)
        except LedgerError:
            raise  # no goal may be sent that is not written down
        except Exception as error:  # noqa: BLE001 - a tree's mistake costs its task, not the service
            self._crash(error)
        self._ticked(self._timer.since_begun)

    def _judge(self, ticked: tuple[Behaviour, ...]) -> None:
        status = NodeStatus(self._root.status.name)
        if status is NodeStatus.RUNNING:
            self._pausing.after_tick(ticked)
            if self.gates.hit:
                self._pausing.pause()
        elif status is NodeStatus.SUCCESS:
            # Raises for what the kind does not declare: then the task has not succeeded.
            self.result = self._kind.result_of(self.context, succeeded=not self.canceling)
            self._end_with(Ending(TaskState.CANCELED if self.canceling else TaskState.SUCCEEDED))
        else:
            self._end_with(self._as_failed(self.wind_down.told() or unsaid(self._root)))

    def _as_failed(self, failure: Failure) -> Ending:
        state = TaskState.CANCELED if self.canceling else TaskState.FAILED
        return Ending(state, self._with_places(failure))

    def _crash(self, error: Exception) -> None:
        """End a tree that raised: a mistake in the program, which must cost this task and nothing else."""
        _LOG.error("a tree raised", extra={"task": self.context.task}, exc_info=error)
        if self._ending is None:
            self._stop_tree()
            self._end_with(self._as_failed(raised(self._root, error)))

    def _stop_tree(self) -> None:
        self._shown.touched = True
        self.running = ()
        try:
            self._root.stop(Status.INVALID)
        except Exception:  # noqa: BLE001 - the tree is given up anyway
            _LOG.exception("a tree raised while it was being stopped", extra={"task": self.context.task})

    # The end.

    def _end_with(self, ending: Ending) -> None:
        self._ending, self._resting = ending, Elapsed(self._clocks)

    def _conclude(self, ending: Ending) -> None:
        """End now. What did not succeed tells what it has; a mistake in that changes no ending."""
        self.ended = self._ending = ending
        if self.result is None and ending.state not in {TaskState.SUCCEEDED, TaskState.QUEUED}:
            try:
                self.result = self._kind.result_of(self.context, succeeded=False)
            except Exception:  # noqa: BLE001 - the task has failed for another reason already
                _LOG.exception("could not tell the result", extra={"task": self.context.task})

    def _await_rest(self, ending: Ending) -> None:
        self._resting.update()
        if self.context.quiet:
            if not self._begins_winding(ending):
                self._conclude(self._ending or ending)  # another one, where winding down is kept from it
        elif self._resting.beyond(REST_WITHIN, SILENCE_ALLOWED):
            self._stop_hardware(self.context.clients.open)

    def _begins_winding(self, ending: Ending) -> bool:
        """Turn to what is to be done after a cancel, once; return whether there is something to do."""
        tree = self.wind_down.due(ending) if self.canceling else None
        if tree is None:
            return False
        prevented = self.wind_down.prevented(tree)
        if prevented is not None:
            self._end_with(Ending(ending.state, prevented))
            return False
        self.wind_down.begin()
        self._root, self._ending = tree, None
        self._shown.turn_to(tree)
        self.gates = Breakpoints(tree, self.context)
        self._timer.look_again()
        return True

    def _stop_hardware(self, stuck: tuple[AnyGoal, ...]) -> None:
        if self._ending is None:
            self._stop_tree()
        self._halted = stuck
        self._halt.set(f"the goals of {self.context.task} did not come to rest")

    def _go_on_halting(self, stuck: tuple[AnyGoal, ...]) -> None:
        if not self._halt.step():
            return
        if self._halt.confirmed:
            self.context.clients.drop(stuck, "it did not come to rest; the hardware was stopped")
        skills = (handle.action for handle in stuck)
        confirmed, before = self._halt.confirmed, self._last_failure()
        failure = not_at_rest(self._root.name, skills, REST_WITHIN, confirmed=confirmed, before=before)
        self._conclude(Ending(TaskState.FAILED, self._with_places(failure)))

    def _lose_hardware(self, silent: float) -> None:
        if self._ending is None:
            self._stop_tree()
        failure = hardware_lost(self._root.name, silent, before=self._last_failure())
        self._conclude(Ending(TaskState.FAILED, self._with_places(failure)))

    def _with_places(self, failure: Failure) -> Failure:
        """Add where everything is, as the task's builder tells it."""
        try:
            return self.context.with_places(failure)
        except Exception:  # noqa: BLE001 - the end is told in any case
            _LOG.exception("could not describe where everything is", extra={"task": self.context.task})
            return failure

    def _last_failure(self) -> Failure | None:
        return self.context.failures.summary() if self._ending is None else self._ending.failure

    def _note_progress(self) -> None:
        told = self.context.progress
        done = self._ending is not None and self._ending.state is TaskState.SUCCEEDED
        fraction = 1.0 if done else max(told.fraction, self._progress.fraction)
        self._progress = Progress(phase=told.phase or self._progress.phase, fraction=fraction)
