"""The wall clock against the ledger: what a jump decides, what a start makes of it, when it is believed."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from tandem.executive.ledger.port import Reading
from tandem.executive.service.tasks.wall_clock import DOUBT, FAR, NEAR, SETTLES, WallClock
from tandem.skills.ports.message import RobotTime

NOON = 1_800_000_000.0
HOUR = 3600.0
YEAR = 365 * 86_400.0


@dataclass
class HandClocks:
    """A host whose wall clock can be set."""

    seconds: float = 100.0
    ahead: float = NOON

    def robot(self) -> RobotTime | None:
        return None

    def monotonic(self) -> float:
        return self.seconds

    def utc(self) -> float:
        return self.ahead + self.seconds


@pytest.fixture
def clocks() -> HandClocks:
    return HandClocks()


def look(clock: WallClock, clocks: HandClocks, seconds: float) -> None:
    for _ in range(10):
        clocks.seconds += seconds / 10
        clock.look()


def bounds(clock: WallClock, clocks: HandClocks) -> tuple[float, float]:
    """Return both bounds, as seconds from what a clock that never jumped would say."""
    at = NOON + clocks.seconds
    return round(clock.earliest - at), round(clock.latest - at)


def test_a_clock_that_goes_right_is_followed(clocks: HandClocks) -> None:
    clock = WallClock(clocks, None)
    for _ in range(100):
        clocks.ahead += 0.5 * NEAR
        look(clock, clocks, 1.0)
    assert clock.utc() == clocks.utc() == clock.earliest == clock.latest
    assert (clock.tells_age, clock.trouble()) == (True, "")


@pytest.mark.parametrize("jump", [HOUR, -HOUR, YEAR, -YEAR])
def test_what_depends_on_a_jump_is_left_undecided_until_the_clock_is_back(
    clocks: HandClocks, jump: float
) -> None:
    clock = WallClock(clocks, None)
    clocks.ahead += jump
    look(clock, clocks, 1.0)
    assert bounds(clock, clocks) == (min(0, jump), max(0, jump))
    assert clock.utc() == NOON + clocks.seconds
    assert not clock.tells_age
    assert "wait until the clock is right" in clock.trouble()
    clocks.ahead -= jump
    look(clock, clocks, 1.0)
    assert bounds(clock, clocks) == (0, 0)
    assert clock.tells_age


@pytest.mark.parametrize(("jump", "doubted"), [(HOUR, False), (2 * FAR, True), (-2 * FAR, True)])
def test_a_jump_is_believed_once_the_clock_has_run_steadily(
    clocks: HandClocks, jump: float, *, doubted: bool
) -> None:
    clock = WallClock(clocks, None)
    clocks.ahead += jump
    look(clock, clocks, SETTLES * 0.9)
    assert clock.utc() == NOON + clocks.seconds
    look(clock, clocks, SETTLES * 0.3)
    assert clock.utc() == clocks.utc() == clock.earliest == clock.latest
    assert clock.tells_age is not doubted
    look(clock, clocks, DOUBT)
    assert clock.tells_age


def test_a_clock_that_jumps_about_is_not_believed(clocks: HandClocks) -> None:
    clock = WallClock(clocks, None)
    for number in range(20):
        clocks.ahead += HOUR * (-1) ** (number % 3)
        look(clock, clocks, SETTLES * 0.5)
    assert abs(clock.utc() - NOON - clocks.seconds) < NEAR


@pytest.mark.parametrize("off", [10.0, HOUR, 20 * 86_400.0])
def test_a_start_after_a_time_switched_off_follows_the_clock(clocks: HandClocks, off: float) -> None:
    last = Reading(utc=clocks.utc() - off, host="yesterday", monotonic=9e9)
    clock = WallClock(clocks, last, "today")
    assert clock.earliest == clock.latest == clocks.utc()
    assert clock.tells_age


@pytest.mark.parametrize("off", [YEAR, -HOUR, -YEAR])
def test_a_start_with_a_clock_far_from_the_ledger_decides_nothing_by_it(
    clocks: HandClocks, off: float
) -> None:
    last = Reading(utc=clocks.utc() - off, host="yesterday", monotonic=9e9)
    clock = WallClock(clocks, last, "today")
    assert clock.utc() == last.utc
    assert (clock.earliest, clock.latest) == (min(last.utc, clocks.utc()), max(last.utc, clocks.utc()))
    assert not clock.tells_age
    again = WallClock(clocks, clock.reading(), "today")
    assert not again.tells_age


def test_within_a_start_of_the_host_a_restart_needs_no_wall_clock(clocks: HandClocks) -> None:
    last = WallClock(clocks, None, "today").reading()
    clocks.seconds += HOUR
    clocks.ahead += 0.6 * HOUR
    clock = WallClock(clocks, last, "today")
    assert bounds(clock, clocks) == (0, round(0.6 * HOUR))


def test_doubt_outlives_a_restart(clocks: HandClocks) -> None:
    clock = WallClock(clocks, None, "today")
    clocks.ahead += YEAR
    look(clock, clocks, 2 * SETTLES)
    clock = WallClock(clocks, clock.reading(), "today")
    assert clock.utc() == clocks.utc()
    assert not clock.tells_age
    assert "far from the ledger" in clock.trouble()
