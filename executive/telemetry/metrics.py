"""Metrics for Prometheus, out of what the observer hears. Nothing here is loaded by any other process."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator
from itertools import accumulate
from typing import Final, TypeVar

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, start_http_server
from prometheus_client.core import HistogramMetricFamily
from prometheus_client.registry import Collector

from tandem.skills.ports.action import GoalState, GoalStatus
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.reflex import ReflexState
from tandem.skills.ports.refusals import Refusals
from tandem.skills.ports.tasks import ExecutivePulse, TaskState, TaskStatus, Times, TreeSnapshot

SKILL_BOUNDS: Final = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0, 180.0)
"""Robot seconds: a look takes tenths, a drive through the room up to a minute."""
REMEMBERED: Final = 1000
"""Ids whose end (or beginning) is remembered, so that what is told again is not counted again."""
REFUSED: Final = 4096
"""Processes, keys and reasons of refused messages that are counted; a system whose parts agree has none."""
T = TypeVar("T")
UNENDED: Final = tuple(state for state in TaskState if not state.terminal)


class TickTimes(Collector):
    """The executive's histogram, as it was told last."""

    def __init__(self) -> None:
        self.times: Times | None = None

    def collect(self) -> Iterator[HistogramMetricFamily]:
        """Yield the family; without classes while nothing was told."""
        family = HistogramMetricFamily("tandem_tick_seconds", "Ticks of trees, in seconds of the host.")
        times = self.times
        if times is not None:
            edges = [*(str(bound) for bound in times.bounds), "+Inf"]
            family.add_metric([], list(zip(edges, accumulate(times.counts), strict=True)), times.total)
        yield family


class Metrics:
    """A ``Record``.

    Args:
        registry: where the metrics are collected from.
    """

    def __init__(self, registry: CollectorRegistry) -> None:
        self._open: dict[str, TaskState] = {}
        self._begun: OrderedDict[str, RobotTime | None] = OrderedDict()
        self._over: OrderedDict[str, None] = OrderedDict()
        self._ticks = TickTimes()
        registry.register(self._ticks)
        self._up = Gauge("tandem_up", "1 while a process is announced.", ["process"], registry=registry)
        self._tasks = Gauge(
            "tandem_tasks", "Tasks that have not ended, by state.", ["state"], registry=registry
        )
        self._queue = Gauge("tandem_queue_length", "Tasks that wait for their turn.", registry=registry)
        self._ended = Counter(
            "tandem_tasks_ended", "Tasks that have ended.", ["task", "state"], registry=registry
        )
        self._task_failures = Counter(
            "tandem_task_failures",
            "Tasks that failed, by kind of failure.",
            ["task", "kind"],
            registry=registry,
        )
        self._skill_failures = Counter(
            "tandem_skill_failures", "Goals that failed, by kind.", ["action", "kind"], registry=registry
        )
        self._skills = Histogram(
            "tandem_skill_seconds",
            "Goals of skills, in robot seconds from their start to their end.",
            ["action", "outcome"],
            registry=registry,
            buckets=SKILL_BOUNDS,
        )
        self._reflex_fired = Counter(
            "tandem_reflex_fired",
            "Times that a reflex has taken its resources.",
            ["reflex"],
            registry=registry,
        )
        self._reflex_on = Gauge(
            "tandem_reflex_on", "0 while a reflex is switched off.", ["reflex"], registry=registry
        )
        self._reflex_holds = Gauge(
            "tandem_reflex_holds", "1 while a reflex has its resources.", ["reflex"], registry=registry
        )
        self._fired_before: dict[str, int] = {}
        self._refused = Counter(
            "tandem_messages_refused",
            "Messages that a process heard and did not take in, by key and reason.",
            ["key", "reason"],
            registry=registry,
        )
        self._refused_before: dict[tuple[str, str, str], int] = {}
        self._tell_states()

    def on_task(self, status: TaskStatus) -> None:
        """Count it by state, and once when it ends."""
        if status.task in self._over:
            return
        if not status.state.terminal:
            self._open[status.task] = status.state
        else:
            self._open.pop(status.task, None)
            _remember(self._over, status.task, None)
            self._ended.labels(status.kind, status.state).inc()
            if status.failure is not None:
                self._task_failures.labels(status.kind, status.failure.kind).inc()
        self._tell_states()

    def on_known(self, tasks: tuple[TaskStatus, ...]) -> None:
        """Take over how things stand; what had ended before is not counted."""
        self._open = {
            each.task: each.state for each in tasks if not each.state.terminal and each.task not in self._over
        }
        self._tell_states()

    def on_tree(self, tree: TreeSnapshot) -> None:
        """Trees are not counted."""

    def on_goal(self, action: str, status: GoalStatus) -> None:
        """Measure it from the first status that was heard to the last."""
        if status.goal_id in self._over:
            return
        if not status.state.terminal:
            _remember(self._begun, status.goal_id, self._begun.get(status.goal_id) or status.stamp)
            return
        if status.state in {GoalState.UNKNOWN, GoalState.REJECTED}:
            return
        _remember(self._over, status.goal_id, None)
        seconds = _between(self._begun.pop(status.goal_id, None), status.stamp)
        if seconds is not None:
            self._skills.labels(action, status.state).observe(seconds)
        if status.failure is not None:
            self._skill_failures.labels(action, status.failure.kind).inc()

    def on_reflex(self, reflex: ReflexState) -> None:
        """Count how often it has fired since it was heard first; a process that began anew counts anew."""
        known = self._fired_before.get(reflex.reflex, reflex.fired)
        more = reflex.fired if reflex.fired < known else reflex.fired - known
        self._fired_before[reflex.reflex] = reflex.fired
        self._reflex_fired.labels(reflex.reflex).inc(more)
        self._reflex_on.labels(reflex.reflex).set(reflex.on)
        self._reflex_holds.labels(reflex.reflex).set(reflex.holds)

    def on_pulse(self, pulse: ExecutivePulse) -> None:
        """Take over the queue and the ticks."""
        self._queue.set(pulse.queued)
        self._ticks.times = pulse.ticks

    def on_refused(self, refusals: Refusals) -> None:
        """Count what has come to it since the process told last; one that was started again counts anew."""
        for each in refusals.refused:
            about = (refusals.process, each.key, each.reason)
            known = self._refused_before.get(about, 0)
            if not known and len(self._refused_before) >= REFUSED:
                continue
            more = each.count if each.count < known else each.count - known
            self._refused_before[about] = each.count
            self._refused.labels(each.key, each.reason).inc(more)

    def on_alive(self, names: frozenset[str]) -> None:
        """Say who is up; who was and is gone is 0."""
        known = {sample.labels["process"] for family in self._up.collect() for sample in family.samples}
        up = {name.removeprefix("process/") for name in names if name.startswith("process/")}
        for process in sorted(known | up):
            self._up.labels(process).set(process in up)

    def close(self) -> None:
        """There is nothing to be written."""

    def _tell_states(self) -> None:
        states = list(self._open.values())
        for state in UNENDED:
            self._tasks.labels(state).set(states.count(state))


class Page:
    """Serves a registry over HTTP, in the library's own thread, until it is closed.

    Args:
        host: where to listen, such as 127.0.0.1.
        port: 0 takes a free one.
        registry: what is served.

    Raises:
        OSError: when nothing can listen there.
    """

    def __init__(self, host: str, port: int, registry: CollectorRegistry) -> None:
        self._server, self._thread = start_http_server(port, host, registry)
        self.port = self._server.server_port

    def close(self) -> None:
        """Stop serving."""
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()


def _remember(known: OrderedDict[str, T], name: str, value: T) -> None:
    known[name] = value
    while len(known) > REMEMBERED:
        known.popitem(last=False)


def _between(begun: RobotTime | None, ended: RobotTime | None) -> float | None:
    passed = None if begun is None or ended is None else ended.since(begun)
    return None if passed is None else max(0.0, passed)
