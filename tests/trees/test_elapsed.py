"""How long something has lasted, by a clock that runs, stands still, or starts anew."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.skills.ports.message import RobotTime
from tandem.trees.elapsed import Elapsed


@dataclass
class Hands:
    """Both clocks, set by hand."""

    now: RobotTime | None = None
    host: float = 100.0

    def robot(self) -> RobotTime | None:
        return self.now

    def passed(self) -> float:
        raise NotImplementedError

    def monotonic(self) -> float:
        return self.host

    def utc(self) -> float:
        return 0.0


def test_a_clock_that_starts_anew_counts_on() -> None:
    clocks = Hands(RobotTime(boot="a", seconds=50.0))
    elapsed = Elapsed(clocks)
    for boot, seconds in (("a", 52.0), ("b", 0.5), ("b", 1.5)):
        clocks.now = RobotTime(boot=boot, seconds=seconds)
        elapsed.update()
    assert elapsed.robot == 3.0


def test_what_was_before_the_first_time_heard_does_not_count() -> None:
    clocks = Hands()
    elapsed = Elapsed(clocks)
    clocks.now = RobotTime(boot="a", seconds=50.0)
    elapsed.update()
    assert elapsed.robot == 0.0


def test_a_clock_that_stands_still_is_told_by_the_hosts() -> None:
    clocks = Hands(RobotTime(boot="a", seconds=50.0))
    elapsed = Elapsed(clocks)
    clocks.host = 111.0
    elapsed.update()
    assert elapsed.standing == 11.0
    assert elapsed.beyond(5.0, 10.0)


def test_time_that_does_not_count_is_left_out() -> None:
    clocks = Hands(RobotTime(boot="a", seconds=50.0))
    elapsed = Elapsed(clocks)
    clocks.now = RobotTime(boot="a", seconds=60.0)
    elapsed.update(counts=False)
    clocks.now = RobotTime(boot="a", seconds=61.0)
    elapsed.update()
    assert elapsed.robot == 1.0
