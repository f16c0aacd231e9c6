"""Metrics and traces, out of a task that runs over the bus in memory."""

from __future__ import annotations

import urllib.request

import pytest
from opentelemetry.sdk.trace import ReadableSpan, TracerProvider
from opentelemetry.sdk.trace.export import SimpleSpanProcessor
from opentelemetry.sdk.trace.export.in_memory_span_exporter import InMemorySpanExporter
from opentelemetry.trace import StatusCode
from prometheus_client import CollectorRegistry, generate_latest
from surroundings import NUDGE, Skill, Surroundings

from tandem.executive.telemetry.metrics import Metrics, Page
from tandem.executive.telemetry.observer import Observer
from tandem.executive.telemetry.traces import Traces, resource
from tandem.skills.ports.action import GoalState, GoalStatus, status_topic
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.reflex import ReflexState, reflex_state

NUDGING = {"task": "wait", "item": 1, "weight": 2.0}


class Recorded:
    """An executive, a fake skill, and an observer with both records."""

    def __init__(self) -> None:
        self.here = Surroundings()
        self.skill = Skill(self.here)
        self.registry = CollectorRegistry()
        self.spans = InMemorySpanExporter()
        provider = TracerProvider(resource=resource("lab/tiago"), shutdown_on_exit=False)
        provider.add_span_processor(SimpleSpanProcessor(self.spans))
        self.traces = Traces(provider, self.here.clocks)
        bus = self.here.hub.endpoint()
        self.observer = Observer(bus, self.here.clocks, (Metrics(self.registry), self.traces))

    def step(self, times: int = 1, seconds: float = 0.1) -> None:
        for _ in range(times):
            self.here.step(seconds=seconds)
            self.skill.step()
            self.observer.step()

    def goal(self, state: GoalState, failure: Failure | None = None) -> None:
        """Have the skill tell how its goal stands."""
        self.skill.sequence += 1
        status_topic(NUDGE.name).publish(
            self.skill.bus,
            GoalStatus(
                goal_id=self.skill.goal,
                state=state,
                sequence=self.skill.sequence,
                stamp=self.here.clocks.robot(),
                failure=failure,
            ),
        )

    def value(self, name: str, **labels: str) -> float | None:
        return self.registry.get_sample_value(name, labels)

    def span(self, name: str) -> ReadableSpan:
        (found,) = [span for span in self.spans.get_finished_spans() if span.name == name]
        return found


@pytest.fixture
def recorded() -> Recorded:
    return Recorded()


def nudge(recorded: Recorded, state: GoalState, failure: Failure | None = None) -> str:
    """Run a task whose skill takes 2 s and ends so; return the task's id."""
    task = recorded.here.ask(NUDGING).task
    recorded.step(2)
    recorded.goal(GoalState.RUNNING)
    recorded.step(20)
    recorded.goal(state, failure)
    recorded.here.world(1)
    recorded.step(3)
    return task


def test_tasks_are_counted_by_state(recorded: Recorded) -> None:
    recorded.here.ask(NUDGING)
    recorded.here.ask(NUDGING)
    recorded.step(12)
    assert recorded.value("tandem_tasks", state="RUNNING") == 1.0
    assert recorded.value("tandem_tasks", state="QUEUED") == 1.0
    assert recorded.value("tandem_queue_length") == 1.0
    assert recorded.value("tandem_tasks_ended_total", task="wait", state="SUCCEEDED") is None
    recorded.goal(GoalState.SUCCEEDED)
    recorded.here.world(1)
    recorded.step(12)
    assert recorded.value("tandem_tasks_ended_total", task="wait", state="SUCCEEDED") == 1.0
    assert recorded.value("tandem_tasks", state="QUEUED") == 0.0
    assert recorded.value("tandem_queue_length") == 0.0


def test_skills_are_timed_by_outcome_and_failures_counted_by_kind(recorded: Recorded) -> None:
    failure = Failure(kind=FailureKind.GRASP_EMPTY, message="a chair")
    nudge(recorded, GoalState.FAILED, failure)
    labels = {"action": "test/nudge", "outcome": "FAILED"}
    assert recorded.value("tandem_skill_seconds_sum", **labels) == pytest.approx(2.0)
    assert recorded.value("tandem_skill_seconds_bucket", **labels, le="1.0") == 0.0
    assert recorded.value("tandem_skill_seconds_bucket", **labels, le="5.0") == 1.0
    assert recorded.value("tandem_skill_failures_total", action="test/nudge", kind="GRASP_EMPTY") == 1.0


def test_a_failed_task_is_counted_by_kind(recorded: Recorded) -> None:
    recorded.here.ask({"task": "wait", "item": 1})
    recorded.here.world(2)
    recorded.step(3)
    assert recorded.value("tandem_task_failures_total", task="wait", kind="GRASP_EMPTY") == 1.0


def test_ticks_are_those_of_the_executive(recorded: Recorded) -> None:
    nudge(recorded, GoalState.SUCCEEDED)
    recorded.step(12)
    ticks = recorded.value("tandem_tick_seconds_count")
    assert ticks is not None
    assert ticks > 5
    assert recorded.value("tandem_tick_seconds_bucket", le="0.0001") == ticks, "lockstep's ticks take no time"


def test_what_ended_before_it_looked_is_not_counted() -> None:
    here = Surroundings()
    here.world(1)
    here.ask({"task": "wait", "item": 1})
    here.step(2)
    waits = here.ask(NUDGING).task
    registry = CollectorRegistry()
    observer = Observer(here.hub.endpoint(), here.clocks, (Metrics(registry),))
    for _ in range(3):
        observer.step()
        here.step()
    assert waits == "wait-0002"
    assert registry.get_sample_value("tandem_tasks", {"state": "RUNNING"}) == 1.0
    assert b"tandem_tasks_ended_total{" not in generate_latest(registry)


def test_a_page_is_served_on_loopback() -> None:
    registry = CollectorRegistry()
    Metrics(registry)
    page = Page("127.0.0.1", 0, registry)
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{page.port}/metrics", timeout=5.0) as answer:
            text = answer.read().decode()
    finally:
        page.close()
    assert 'tandem_tasks{state="RUNNING"} 0.0' in text


def test_a_trace_has_task_node_and_skill_within_each_other(recorded: Recorded) -> None:
    task = nudge(recorded, GoalState.SUCCEEDED)
    root, node, skill = recorded.span("task wait"), recorded.span("nudge"), recorded.span("test/nudge")
    top = next(
        span for span in recorded.spans.get_finished_spans() if span.context.span_id == node.parent.span_id
    )
    assert (root.parent, top.name, top.parent.span_id) == (None, "wait", root.context.span_id)
    assert skill.parent.span_id == node.context.span_id
    assert {span.context.trace_id for span in recorded.spans.get_finished_spans()} == {root.context.trace_id}
    assert root.attributes["tandem.task"] == task
    assert root.attributes["tandem.outcome"] == "SUCCEEDED"
    assert (skill.end_time - skill.start_time) / 1e9 == pytest.approx(2.0, abs=0.2)
    assert root.start_time <= node.start_time <= skill.start_time


def test_a_failure_is_an_error_in_the_trace(recorded: Recorded) -> None:
    recorded.here.ask({"task": "wait", "item": 1})
    recorded.step()
    recorded.here.world(2)
    recorded.step(3)
    root = next(span for span in recorded.spans.get_finished_spans() if span.parent is None)
    assert root.status.status_code is StatusCode.ERROR
    assert root.attributes["tandem.failure"] == "GRASP_EMPTY"


def test_a_cancelled_task_leaves_no_span_open(recorded: Recorded) -> None:
    task = recorded.here.ask(NUDGING).task
    recorded.step(3)
    recorded.here.cancel(task)
    recorded.goal(GoalState.CANCELED)
    recorded.step(3)
    outcomes = {span.name: span.attributes["tandem.outcome"] for span in recorded.spans.get_finished_spans()}
    assert (outcomes["task wait"], outcomes["nudge"]) == ("CANCELED", "INVALID")
    assert recorded.traces._traces == {}


def test_what_is_open_at_the_end_is_sent_as_it_stands(recorded: Recorded) -> None:
    recorded.here.ask(NUDGING)
    recorded.step(3)
    recorded.observer.close()
    assert "nudge" in {span.name for span in recorded.spans.get_finished_spans()}


@pytest.mark.parametrize(
    ("told", "counted"), [((3, 3), 0.0), ((3, 5), 2.0), ((3, 5, 1), 3.0)], ids=["same", "more", "began anew"]
)
def test_a_reflex_is_counted_from_when_it_was_heard_first(
    recorded: Recorded, told: tuple[int, ...], counted: float
) -> None:
    bus = recorded.here.hub.endpoint()
    for fired in told:
        state = ReflexState(
            reflex="bumper", on=False, resources=("base",), rank=90, holds=True, fired=fired, about="brakes"
        )
        reflex_state("bumper").publish(bus, state)
        recorded.step()
    assert recorded.value("tandem_reflex_fired_total", reflex="bumper") == counted
    assert recorded.value("tandem_reflex_on", reflex="bumper") == 0.0
    assert recorded.value("tandem_reflex_holds", reflex="bumper") == 1.0
