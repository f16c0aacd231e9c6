"""Clauses about the stop of a robot at rest. They set it, and release it again, also when they fail."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.bench import ROLE
from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.executive.conformance.harmless import expect_refusal
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Stop, StopRelease

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench

TOLD_WITHIN: Final = 1.5
"""Robot seconds for a state that is told on each change."""


def set_stop(bench: Bench) -> Steps:
    """Set the stop; Broken unless the answer and the topic say so."""
    count = bench.recording.count(keys.STOP_STATE.key)
    state = yield from bench.ask(keys.STOP, Stop(by=ROLE, reason="a clause sets the stop"))
    if not state.stopped:
        raise Broken("the answer that the stop is set", "that it is not")
    yield from _told(bench, count, stopped=True)


def release(bench: Bench) -> Steps:
    """Release the stop; Broken unless the answer and the topic say so."""
    count = bench.recording.count(keys.STOP_STATE.key)
    state = yield from bench.ask(keys.STOP_RELEASE, StopRelease(by=ROLE))
    if state.stopped:
        raise Broken("the answer that the stop is released", "that it is set")
    yield from _told(bench, count, stopped=False)


def _told(bench: Bench, count: int, *, stopped: bool) -> Steps:
    def told() -> bool:
        state = bench.recording.latest(keys.STOP_STATE, count)
        return state is not None and state.stopped is stopped

    if not (yield from bench.until(told, TOLD_WITHIN)):
        word = "set" if stopped else "released"
        raise Broken(f"on {keys.STOP_STATE.key} that the stop is {word}", "nothing of the kind")


def then_released(steps: Callable[[Bench], Steps]) -> Callable[[Bench], Steps]:
    """Return a clause's steps with the stop released at their end, whether they fail or not."""

    def stepping(bench: Bench) -> Steps:
        before = bench.recording.latest(keys.STOP_STATE)
        if before is not None and before.stopped:
            raise Skip(f"the stop is set by {before.by or 'somebody'}; release it first")
        if others := bench.others():
            raise Skip(f"{', '.join(others)} command this robot, and the stop would interrupt them")
        try:
            yield from steps(bench)
        except (Broken, Skip):
            yield from bench.ask(keys.STOP_RELEASE, StopRelease(by=ROLE))
            raise
        yield from release(bench)

    return stepping


def _refuses(bench: Bench) -> Steps:
    yield from set_stop(bench)
    lease = yield from bench.leased()
    yield from expect_refusal(bench, lease, "a command while the stop is set")


def _unreadable(bench: Bench) -> Steps:
    count = bench.recording.count(keys.STOP_STATE.key)
    reply = yield from bench.reply(keys.STOP.key, b"{")
    if reply.nothing:
        raise Broken("an answer to an unreadable stop", "none")
    yield from _told(bench, count, stopped=True)


def _released(bench: Bench) -> Steps:
    yield from set_stop(bench)  # its release follows


CLAUSES: Final = (
    Clause(
        "stop_refuses",
        "While the stop is set, commands are refused.",
        "interface.md#hardware",
        then_released(_refuses),
        interrupts=True,
    ),
    Clause(
        "unreadable_stop_stops",
        "A stop whose document can't be read is set all the same.",
        "interface.md#hardware",
        then_released(_unreadable),
        interrupts=True,
    ),
    Clause(
        "stop_released",
        "hw/stop/release releases the stop.",
        "interface.md#hardware",
        then_released(_released),
        interrupts=True,
    ),
)
