"""A trace of each task for OpenTelemetry: a span for the task, for each node that ran, for each skill's goal.

Spans are made of what the observer hears, so that the executive knows nothing of it. Their times are UTC, as
OpenTelemetry wants them: when the observer heard of it. What the robot's clock said stands beside, as
``tandem.robot_seconds``. Needs the extra ``tandem-executive[otel]``.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter
from opentelemetry.sdk.resources import Resource
from opentelemetry.sdk.trace import TracerProvider
from opentelemetry.sdk.trace.export import BatchSpanProcessor, SpanExporter
from opentelemetry.trace import Span, StatusCode, Tracer, set_span_in_context

from tandem.skills.ports.action import GoalState, GoalStatus, node_of, task_of
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.reflex import ReflexState
from tandem.skills.ports.refusals import Refusals
from tandem.skills.ports.tasks import (
    ExecutivePulse,
    NodeStatus,
    TaskState,
    TaskStatus,
    TreeNode,
    TreeSnapshot,
)

SERVICE: Final = "tandem"
TRACES: Final = "/v1/traces"
"""Where a collector takes them, after its address."""


def otlp_exporter(endpoint: str) -> SpanExporter:
    """Return what sends spans to a collector over HTTP; ``endpoint`` such as ``http://127.0.0.1:4318``."""
    address = endpoint.rstrip("/")
    return OTLPSpanExporter(endpoint=address if address.endswith(TRACES) else f"{address}{TRACES}")


def batching_provider(exporter: SpanExporter, robot: str) -> TracerProvider:
    """Return a provider whose spans are sent in batches, in the library's own thread; for no other use."""
    provider = TracerProvider(resource=resource(robot), shutdown_on_exit=False)
    provider.add_span_processor(BatchSpanProcessor(exporter))
    return provider


def resource(robot: str) -> Resource:
    """Return whose spans they are; ``robot`` is ``<site>/<robot>``."""
    return Resource.create({"service.name": SERVICE, "service.instance.id": robot})


@dataclass(frozen=True)
class _Early:
    """A goal that was heard of before its node was seen to run: the two travel on different keys."""

    action: str
    begun: GoalStatus
    at: int


@dataclass
class _Trace:
    """One task's spans that have not ended, and what each node was last."""

    root: Span
    nodes: dict[str, Span] = field(default_factory=dict)
    was: dict[str, NodeStatus] = field(default_factory=dict)
    by_name: dict[str, Span] = field(default_factory=dict)
    """A node's newest span, ended or not: a goal knows its node by name."""
    goals: dict[str, Span] = field(default_factory=dict)
    early: dict[str, _Early] = field(default_factory=dict)


class Traces:
    """A ``Record``.

    Args:
        provider: where spans go; closed with this record.
        clocks: UTC.
    """

    def __init__(self, provider: TracerProvider, clocks: Clocks) -> None:
        self._provider, self._clocks = provider, clocks
        self._tracer: Tracer = provider.get_tracer("tandem")
        self._traces: dict[str, _Trace] = {}

    def on_task(self, status: TaskStatus) -> None:
        """Begin a task's trace when it runs, and end it with the task."""
        trace = self._traces.get(status.task)
        if trace is None:
            if status.state.terminal or status.state is TaskState.QUEUED:
                return
            trace = self._traces[status.task] = self._begin(status)
        if status.state.terminal:
            del self._traces[status.task]
            self._end(trace, status)
        elif status.progress.phase:
            trace.root.set_attribute("tandem.phase", status.progress.phase)

    def on_known(self, tasks: tuple[TaskStatus, ...]) -> None:
        """A task that runs already is traced from now on."""
        for status in tasks:
            self.on_task(status)

    def on_tree(self, tree: TreeSnapshot) -> None:
        """Begin and end spans of the nodes whose status has changed."""
        trace = self._traces.get(tree.task)
        if trace is None:
            return
        now = self._now()
        for node, parent in _nodes(tree.root):
            before = trace.was.get(node.path, NodeStatus.INVALID)
            trace.was[node.path] = node.status
            if node.status is before:
                continue
            span = trace.nodes.get(node.path)
            if span is None and node.status is not NodeStatus.INVALID:
                span = self._open(
                    node.name,
                    trace.nodes.get(parent, trace.root),
                    now,
                    tree.stamp,
                    {"tandem.node": node.path},
                )
                span.set_attribute("tandem.type", node.type)
                trace.nodes[node.path] = trace.by_name[node.name] = span
        running = {node.name for node, _ in _nodes(tree.root) if node.path in trace.nodes}
        for goal_id, early in tuple(trace.early.items()):
            if node_of(goal_id) in running:
                self._open_goal(trace, goal_id, early)
        self._end_nodes(trace, tree, now)

    def on_goal(self, action: str, status: GoalStatus) -> None:
        """Begin and end a goal's span below its node's."""
        trace = self._traces.get(task_of(status.goal_id))
        if trace is None or status.state in {GoalState.UNKNOWN, GoalState.REJECTED}:
            return
        known = status.goal_id in trace.goals or status.goal_id in trace.early
        if not status.state.terminal and not known:
            trace.early[status.goal_id] = _Early(action, status, self._now())
        if status.state.terminal and known:
            early = trace.early.get(status.goal_id)
            if early is not None:
                self._open_goal(trace, status.goal_id, early)
            self._close_span(trace.goals.pop(status.goal_id), str(status.state), status.failure, self._now())

    def on_reflex(self, reflex: ReflexState) -> None:
        """Reflexes have no spans: what they end is told by the goal."""

    def on_pulse(self, pulse: ExecutivePulse) -> None:
        """A pulse is no span."""

    def on_refused(self, refusals: Refusals) -> None:
        """A message that was refused belongs to no task."""

    def on_alive(self, names: frozenset[str]) -> None:
        """Who is there is no span."""

    def close(self) -> None:
        """Send what has ended; what has not is ended as it stands."""
        for trace in self._traces.values():
            self._end_open(trace)
            trace.root.end(self._now())
        self._traces.clear()
        self._provider.shutdown()

    def _open_goal(self, trace: _Trace, goal_id: str, early: _Early) -> None:
        del trace.early[goal_id]
        names = {"tandem.action": early.action, "tandem.goal": goal_id}
        above = trace.by_name.get(node_of(goal_id), trace.root)
        trace.goals[goal_id] = self._open(early.action, above, early.at, early.begun.stamp, names)

    def _begin(self, status: TaskStatus) -> _Trace:
        names = {"tandem.task": status.task, "tandem.kind": status.kind}
        span = self._open(f"task {status.kind}", None, self._now(), status.started, names)
        span.set_attribute("tandem.accepted_at", status.accepted_at)
        return _Trace(span)

    def _end(self, trace: _Trace, status: TaskStatus) -> None:
        self._end_open(trace)
        self._close_span(trace.root, str(status.state), status.failure, self._now())

    def _end_nodes(self, trace: _Trace, tree: TreeSnapshot, now: int) -> None:
        """End what is no longer running, children before parents."""
        for node, _ in reversed(tuple(_nodes(tree.root))):
            span = trace.nodes.get(node.path)
            if span is None or node.status is NodeStatus.RUNNING:
                continue
            del trace.nodes[node.path]
            span.set_attribute("tandem.outcome", str(node.status))
            if node.message:
                span.set_attribute("tandem.message", node.message)
            if node.status is NodeStatus.FAILURE:
                span.set_status(StatusCode.ERROR, node.message)
            span.end(now)

    def _end_open(self, trace: _Trace) -> None:
        now = self._now()
        for span in (*trace.goals.values(), *reversed(tuple(trace.nodes.values()))):
            span.end(now)
        trace.goals.clear()
        trace.nodes.clear()

    def _open(
        self, name: str, above: Span | None, now: int, stamp: RobotTime | None, names: dict[str, str]
    ) -> Span:
        context = None if above is None else set_span_in_context(above)
        span = self._tracer.start_span(name, context=context, start_time=now, attributes=names)
        if stamp is not None:
            span.set_attribute("tandem.robot_seconds", stamp.seconds)
        return span

    def _close_span(self, span: Span, outcome: str, failure: Failure | None, now: int) -> None:
        span.set_attribute("tandem.outcome", outcome)
        if failure is not None:
            span.set_attribute("tandem.failure", str(failure.kind))
            span.set_status(StatusCode.ERROR, failure.message)
        span.end(now)

    def _now(self) -> int:
        return round(self._clocks.utc() * 1e9)


def _nodes(node: TreeNode, above: str = "") -> Iterator[tuple[TreeNode, str]]:
    """Yield each node with its parent's path, parents first."""
    yield node, above
    for child in node.children:
        yield from _nodes(child, node.path)
