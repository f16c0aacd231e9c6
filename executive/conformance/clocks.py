"""Clauses about the clock, and about the stamps of all messages."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.bench import SILENT_AFTER
from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.executive.conformance.recording import topics
from tandem.skills.ports import keys
from tandem.skills.ports.hearing import stamp_of

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.hardware import Clock
    from tandem.skills.ports.robot_description import RobotDescription

LOST: Final = 0.1
"""Share of messages that the way here may lose: small ones are dropped rather than waited for."""
JITTER: Final = 0.1
"""Share by which a period may be off on average: beyond it, timers that count periods are wrong."""
AHEAD: Final = 0.1
"""Robot seconds by which a stamp may be ahead of the clock when both are read: on a busy host the clock's
message has been overtaken by 0.04 s. Skills call a message old after 0.5 s."""
FEWEST: Final = 10
"""Ticks from which on a rate can be told."""


def _ticks(bench: Bench) -> Steps:
    began = bench.host_seconds
    while bench.recording.count(keys.CLOCK.key) < FEWEST:
        if bench.host_seconds - began > SILENT_AFTER:
            raise Broken(
                "a clock once a period", f"{bench.recording.count(keys.CLOCK.key)} in 3 host seconds"
            )
        yield
    clocks = bench.recording.messages(keys.CLOCK)
    for before, after in pairwise(clocks):
        if after.tick <= before.tick:
            raise Broken("a tick that rises", f"{after.tick} after {before.tick}")
        if after.stamp.is_after(before.stamp) is False:
            words = f"{after.stamp.seconds:.4f} s after {before.stamp.seconds:.4f} s"
            raise Broken("a stamp that rises", words)
    _judge_rate(clocks, bench.robot)


def _judge_rate(clocks: list[Clock], robot: RobotDescription) -> None:
    first, last, period = clocks[0], clocks[-1], robot.period
    ticks = last.tick - first.tick
    expected = round(ticks * period / (robot.resting_period or period))
    if len(clocks) < (1.0 - LOST) * expected:
        raise Broken(f"{expected} clocks for {ticks} ticks", f"{len(clocks) - 1}")
    took = last.stamp.since(first.stamp)
    if took is not None and abs(took / ticks - period) > JITTER * period:
        raise Broken(f"{period:g} s from tick to tick, as described", f"{took / ticks:.4f} s")


def _one_boot(bench: Bench) -> Steps:
    clock = bench.recording.clock
    if clock is None:
        raise Skip(f"{keys.CLOCK.key} is silent")
    for topic in topics(bench.robot):
        for message in bench.recording.messages(topic):
            stamp = stamp_of(message)
            if stamp is not None and stamp.boot != clock.stamp.boot:
                raise Broken(f"boot {clock.stamp.boot} on {topic.key}", f"boot {stamp.boot}")
    table = bench.recording.latest(keys.LEASES)
    if table is not None and table.boot != clock.stamp.boot:
        raise Broken(f"boot {clock.stamp.boot} on {keys.LEASES.key}", f"boot {table.boot}")
    yield


def _not_in_the_future(bench: Bench) -> Steps:
    # What is told of a tick may come before its clock; of a robot that rests, the last one is older then.
    allowed = AHEAD + (bench.robot.resting_period or 0.0)
    for topic in topics(bench.robot):
        for told in bench.recording.told(topic.key):
            try:
                stamp = stamp_of(topic.decode(told.payload))
            except ValueError:
                continue
            ahead = None if stamp is None or told.clock is None else stamp.since(told.clock)
            if ahead is not None and ahead > allowed:
                raise Broken(
                    f"stamps on {topic.key} that are not after the clock", f"one {ahead:.3f} s after it"
                )
    yield


CLAUSES: Final = (
    Clause(
        "clock_ticks",
        "The clock comes once a period; its tick and its stamp rise together.",
        "interface.md#clock",
        _ticks,
    ),
    Clause(
        "one_boot",
        "All stamps are of the clock's boot.",
        "conventions.md",
        _one_boot,
    ),
    Clause(
        "stamps_not_in_future",
        "No stamp is later than the clock of the tick in which it is told.",
        "extending.md#a-robot",
        _not_in_the_future,
    ),
)
