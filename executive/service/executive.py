"""The executive: takes requests, keeps them, runs one at a time, and tells everyone what happens.

What it tells is on disk first. Loads nothing heavy (a test proves it), so that it is back in a blink after a
crash.
"""

from __future__ import annotations

import logging
from collections.abc import Mapping
from functools import cached_property
from typing import Final

from tandem.executive.ledger.memory import MemoryLedger
from tandem.executive.ledger.port import Ledger, LedgerError
from tandem.executive.service.heartbeat import Heartbeat
from tandem.executive.service.intake.client_gateway import cancel_of_own
from tandem.executive.service.intake.kind_schemas import kinds_offered
from tandem.executive.service.intake.request_intake import Intake
from tandem.executive.service.intake.request_parser import Asked
from tandem.executive.service.policy import Policy
from tandem.executive.service.publisher import Publisher
from tandem.executive.service.running.current_task import CurrentTask
from tandem.executive.service.running.endings import Ending
from tandem.executive.service.running.failure_pictures import Album, Tries
from tandem.executive.service.running.orphaned_goals import OrphanedGoals
from tandem.executive.service.running.sent_goals import LedgerJournal
from tandem.executive.service.running.task_builder import TaskBuilder
from tandem.executive.service.running.tree_run import Run
from tandem.executive.service.running.uncollected import uncollected
from tandem.executive.service.tasks.queue_holds import Holds
from tandem.executive.service.tasks.resuming import Comeback, How, take_up
from tandem.executive.service.tasks.task_book import KEPT, TaskBook
from tandem.executive.service.tasks.wall_clock import WallClock
from tandem.executive.service.verbs.task_control import Control
from tandem.executive.service.verbs.task_queries import Questions
from tandem.executive.service.verbs.verb_service import Verbs
from tandem.executive.service.whereabouts import Whereabouts
from tandem.skills.ports.bus import Bus, Commons
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import CancelTask, ExecutiveInfo, TaskState, TaskStatus
from tandem.skills.ports.whereabouts import Neighbours
from tandem.trees.clients import Clients
from tandem.trees.knowledge import Knowledge
from tandem.trees.needs import unable
from tandem.trees.task import TaskType

NAME: Final = "executive"
"""What it is announced as; goals of skills come to rest when this name is gone."""
PRUNE_EVERY: Final = 100
"""Ended tasks after which old ones are looked for."""
DAY: Final = 86_400.0
"""Seconds."""

_LOG = logging.getLogger(__name__)


class Executive:
    """The service, as a node.

    Args:
        bus: where clients and skills are.
        clocks: robot time for trees, UTC for when a request came.
        site: what is known beforehand.
        tasks: the kinds of request, by name (``tandem.trees.registry.discover()``).
        start: part of each task's id (``task_book.start_id``); empty in lockstep.
        host: names this start of the host (``wall_clock.host_start``), for a ledger that lasts.
        version: of this program, told to who asks.
        ledger: what was accepted and what became of it; in memory unless given. Closed with the service.
        policy: how the service treats tasks.
        died: how the executive of before ended, in words; empty when it did not crash, or nobody knows.
        commons: where the robots of the site tell where they are; None: there is no such place.
        robot: the robot's name among them.

    Raises:
        LedgerError: also in ``step``, when the ledger can't be written: nothing may be told then.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        site: Site,
        tasks: Mapping[str, TaskType[Message]],
        *,
        start: str = "",
        host: str = "",
        version: str = "",
        ledger: Ledger | None = None,
        policy: Policy | None = None,
        died: str = "",
        commons: Commons | None = None,
        robot: str = "",
    ) -> None:
        self._ledger: Ledger = MemoryLedger() if ledger is None else ledger
        self._policy = Policy() if policy is None else policy
        self.knowledge = Knowledge(bus, clocks, site, Neighbours(commons, clocks, robot))
        start_here = f"{start}/{clocks.utc():.6f}"
        self._whereabouts = None if commons is None else Whereabouts(commons, clocks, robot, start_here)
        self.clients = Clients(bus, clocks, NAME, LedgerJournal(self._ledger, self._remember))
        self._wall = WallClock(clocks, self._ledger.reading(), host)
        bounds = self._policy.bounds
        self.book = TaskBook(
            self._ledger, self._wall, start, bound=self._policy.waiting, bound_of_one=bounds.open
        )
        self._bus, self._clocks, self._kinds, self._version = bus, clocks, dict(tasks), version
        self._holds = Holds(clocks, self.knowledge, self.clients)
        self.book.hold = lambda kind: self._holds.why_not(self._kinds[kind])
        self._current: CurrentTask | None = None
        self._publisher = Publisher(bus, clocks, self.book, self._ledger)
        self._intake = Intake(
            bus,
            clocks,
            self.book,
            self._kinds,
            site,
            robot=lambda: self.knowledge.description,
            begin=self._begin_at_once,
            bounds=bounds,
        )
        self._control = Control(self.book, clocks, lambda: self._current, self._publisher.tell)
        self._control.changed = self._changed_by_verb
        own = cancel_of_own(self.book.find, self._control.of_client, self._control.cancel)
        self._verbs = Verbs(bus, clocks, self._control.verbs(), self._keep, (own,))
        self._album = Album(bus, clocks)
        self._questions = Questions(
            bus,
            clocks,
            self.book,
            self._ledger,
            info=self._info,
            last=lambda: self._publisher.last,
            tree=lambda: self._publisher.tree(self._current),
            kinds=lambda: self._offered,
            site=site,
            timeline=lambda task: self._publisher.timeline(task, self._current),
        )
        self._tries: list[Tries] = []  # of the running task, and of those before whose picture is under way
        self._heartbeat = Heartbeat(bus, clocks)
        self._builder = TaskBuilder(
            bus,
            clocks,
            self.knowledge,
            self.clients,
            self.book,
            self._ledger,
            self._holds,
            ticked=self._heartbeat.ticked,
        )
        self._orphans = OrphanedGoals(bus, clocks, self.clients, self.knowledge)
        self._ended = 0
        self._closed = False
        self._come_back(died)
        bus.announce(NAME)

    @property
    def name(self) -> str:
        """For logs."""
        return NAME

    @property
    def idle(self) -> bool:
        """Whether no task runs or waits."""
        return self._current is None and not self.book.queue

    @property
    def running(self) -> Run | None:
        """The run of the task under way."""
        return None if self._current is None else self._current.run

    def step(self) -> bool:
        """Answer whoever asks, then move the running task on. Garbage is collected afterwards."""
        with uncollected():
            return self._step()

    def _step(self) -> bool:
        self.book.look_at_the_clock(self._clocks.monotonic())
        self._take_in()
        more = self._verbs.step()
        for late in self.book.expire(self._clocks.robot()):
            self._publisher.tell(late)
        self._move_on()
        self._publisher.tell_first(None if self._current is not None else next(iter(self.book.queue), None))
        self._note_tries()
        more = self._album.step() or more
        more = self._questions.step() or more
        self._heartbeat.step("" if self._current is None else self._current.task, len(self.book.queue))
        if self._whereabouts is not None:
            running = None if self._current is None else self.book.get(self._current.task)
            follows = None if self._current is None else self._current.follows
            self._whereabouts.step(self.knowledge.robot, running, follows, self.knowledge.description)
        next_one = self._current is None and self.book.next() is not None and self._orphans.none
        return self._intake.unread or more or next_one

    def _take_in(self) -> None:
        """Tell what was accepted; build the tree of what begins with that.

        It is ticked after the verbs: who cancels a task in the step that takes it has it do nothing.
        """
        accepted, at_once = self._intake.step(), self.book.take_at_once()
        for task in accepted:
            first = at_once is not None and at_once.begun.task == task
            status = at_once.accepted if at_once is not None and first else self.book.get(task)
            if status is not None and status.state is TaskState.QUEUED:
                self._holds.asked(status.kind)
                self._publisher.tell(status)
        if at_once is not None:
            self._build(at_once.begun, at_once.asked, "go on")

    def close(self) -> None:
        """Stop the tree, whose leaves cancel their goals, and leave. Closing twice is allowed.

        A lasting ledger keeps what waits and what runs: it is taken up after the next start. Without one it
        is cancelled.
        """
        if self._closed:
            return
        self._closed = True
        if not self._ledger.lasting:
            for task in self.book.waiting:
                self._control.cancel(CancelTask(task=task))
            if self._current is not None:
                self._control.cancel(CancelTask(task=self._current.task))
        elif self._current is not None:
            self._current.run.make_room()
            self._note_order(self._current)
        for end in (self._intake, self._verbs, self._album, self._questions):
            end.close()
        self.clients.close()
        self.knowledge.close()
        self._ledger.close()

    def _note_order(self, turn: CurrentTask) -> None:
        """Note that the task is left in order: that it is under way at the next start is no crash."""
        try:
            memory = self.book.entry(turn.task).memory
            self.book.remember(turn.task, memory.model_copy(update={"in_order": True}))
            self.book.keep()
        except LedgerError:
            _LOG.exception("could not record the orderly shutdown in the ledger")

    # After a start.

    def _come_back(self, died: str) -> None:
        found: Comeback = take_up(
            self._ledger,
            self.book,
            self._intake.read,
            self._policy.on_restart,
            self._clocks.robot(),
            died=died,
        )
        self._orphans.adopt(self._ledger.open_goals())
        for status in found.changed:
            self._publisher.tell(status)
        under_way = found.under_way
        if under_way is not None:
            _LOG.info("a task was under way", extra={"task": under_way.task, "taken_up": under_way.how})
            self._begin(under_way.task, under_way.asked, under_way.how)
        self._prune()

    def _prune(self) -> None:
        policy = self._policy
        keep = policy.keep_tasks if self._ledger.lasting else KEPT
        # By their number tasks are forgotten in any case; by their age only on a clock that can tell it.
        old = self._wall.utc() - policy.keep_days * DAY if self._wall.tells_age else 0.0
        if not self._wall.tells_age:
            _LOG.warning("old tasks are not deleted: %s", self._wall.trouble())
        self._ledger.prune(older_than=old, keep=keep)

    # The task under way.

    def _move_on(self) -> None:
        if self._current is None or not self._orphans.settled:
            self._orphans.step()
            if not self._orphans.none:
                return
        if self._current is None:
            turn = self.book.next()
            if turn is None:
                return
            self.book.queue.remove(turn.task)
            self._begin(turn.task, turn.asked, "go on")
        if self._current is not None:
            self._go_on(self._current)

    def _go_on(self, turn: CurrentTask) -> None:
        self._make_room(turn)
        turn.run.step()
        self._publisher.changed(turn)
        if turn.run.ended is None:
            return
        self._current = None
        self._note_tries()
        self._publisher.keep_spans(turn.task)
        self._note_common(turn, turn.run.ended)
        self._publisher.tell(turn.end())
        turn.run.dissolve()
        self._ended += 1
        if self._ended % PRUNE_EVERY == 0:
            self._prune()

    def _note_common(self, turn: CurrentTask, ended: Ending) -> None:
        """Have tasks wait for what failed this one and would fail them; this one too, if it was a try."""
        if ended.state not in {TaskState.SUCCEEDED, TaskState.FAILED}:
            return
        status = self.book.entry(turn.task).status
        waits = self._holds.note(turn.asked.kind.name, turn.task, ended.failure)
        if waits and status.state is TaskState.RUNNING:
            _LOG.warning("task goes back to the queue", extra={"task": turn.task, "why": str(ended.failure)})
            turn.run.ended = Ending(TaskState.QUEUED)

    def _make_room(self, turn: CurrentTask) -> None:
        """Let a task of a higher priority take over where the tree says that it may."""
        run = turn.run
        if not run.context.interruptible or run.state is not TaskState.RUNNING or run.ending is not None:
            return
        waits, status = self.book.next(), self.book.get(turn.task)
        if waits is not None and status is not None and waits.priority > status.priority:
            _LOG.info("task makes room for another", extra={"task": turn.task, "room_for": waits.task})
            run.make_room()

    def _begin_at_once(self) -> None:
        """Begin what has just been accepted, if nothing is in its way."""
        if self._current is None:
            self._orphans.step()
            if self._orphans.none:
                self.book.begin_at_once(self._clocks.robot())

    def _begin(self, task: str, asked: Asked, how: How) -> None:
        self._build(self.book.begin(task, self._clocks.robot()), asked, how)

    def _build(self, begun: TaskStatus, asked: Asked, how: How) -> None:
        """Tell that a task runs, which is on disk before its tree is built: a builder may crash."""
        task = begun.task
        self._publisher.tell(begun)
        built = self._builder.build(task, asked)
        if isinstance(built, Failure):
            self._publisher.tell(self.book.end(task, TaskState.FAILED, self._clocks.robot(), built))
            return
        self._current = built
        self._tries.append(Tries(self._bus, self._clocks, built.run.context, self._album))
        self._publisher.begin(built)
        built.take_up(how)
        self._publisher.changed(built)

    # What is told.

    def _remember(self) -> None:
        """Note what a restart must know of the task under way; on disk with what is kept next."""
        if self._current is not None:
            self._current.remember()

    def _keep(self) -> None:
        """Have all that holds now on disk."""
        self._remember()
        self.book.keep()

    def _changed_by_verb(self, turn: CurrentTask) -> None:
        """Tell what a verb has changed, and have it on disk, whichever key it came by: its answer is next."""
        self._publisher.changed(turn)
        self._keep()

    def _note_tries(self) -> None:
        for tries in self._tries:
            if tries.step():
                # An ended task is told once; who asks for the list later sees the picture that came late.
                status = self.book.tried(tries.context.task, tries.tried)
                if status is not None and not status.state.terminal:
                    self._publisher.tell(status)
        running = None if self._current is None else self._current.run.context
        self._tries = [each for each in self._tries if each.context is running or each.pending]

    def _unable(self) -> dict[str, str]:
        """Return the kinds of task that the robot can't do, and why, as far as it is known."""
        robot = self.knowledge.description
        found = {} if robot is None else {n: unable(n, kind.needs, robot) for n, kind in self._kinds.items()}
        return {name: why for name, why in found.items() if why}

    @cached_property
    def _offered(self) -> bytes:
        """The kinds of task as JSON, made when somebody asks: schemas take some milliseconds."""
        return kinds_offered(self._kinds, self.knowledge.site).model_dump_json().encode()

    def _info(self) -> ExecutiveInfo:
        unable = self._unable()
        return ExecutiveInfo(
            name=NAME,
            version=self._version,
            tasks=tuple(name for name in self._kinds if name not in unable),
            unable=unable,
            running="" if self._current is None else self._current.task,
            queued=len(self.book.queue),
            waits_for=self._publisher.waits_for,
        )
