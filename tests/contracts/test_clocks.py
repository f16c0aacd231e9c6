"""What both kinds of clocks keep to: those of lockstep, and those of a process that hears the hardware's."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import pytest

from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK
from tandem.skills.ports.message import RobotTime
from tandem.skills.wire.clocks import ProcessClocks, SteppedClocks
from tandem.skills.wire.memory import MemoryBus


@dataclass
class Heard:
    """A process's clocks, told by hand."""

    bus: MemoryBus = field(default_factory=MemoryBus)
    told: float = 0.0
    boot: str = "first"

    def __post_init__(self) -> None:
        self.clocks = ProcessClocks(self.bus)

    def advance(self, seconds: float) -> None:
        self.told = round(self.told + seconds, 9)
        stamp = RobotTime(boot=self.boot, seconds=self.told)
        CLOCK.publish(self.bus, Clock(stamp=stamp, tick=round(self.told * 100)))
        self.clocks.refresh()


@pytest.fixture(params=["stepped", "heard"])
def watch(request: pytest.FixtureRequest) -> tuple[Clocks, Callable[[float], None]]:
    if request.param == "stepped":
        stepped = SteppedClocks()
        return stepped, stepped.advance
    heard = Heard()
    heard.advance(0.0)
    return heard.clocks, heard.advance


def test_robot_time_passes_as_the_robot_says(watch: tuple[Clocks, Callable[[float], None]]) -> None:
    clocks, advance = watch
    before = robot_seconds(clocks)
    for _ in range(100):
        advance(0.01)
    assert robot_seconds(clocks) == pytest.approx(before + 1.0, abs=1e-9)


def test_robot_time_stands_still_unless_told(watch: tuple[Clocks, Callable[[float], None]]) -> None:
    clocks, _ = watch
    assert [clocks.robot() for _ in range(3)] == [clocks.robot()] * 3


def test_host_times_never_run_backwards(watch: tuple[Clocks, Callable[[float], None]]) -> None:
    clocks, advance = watch
    host, utc = [clocks.monotonic()], [clocks.utc()]
    for _ in range(10):
        advance(0.01)
        host.append(clocks.monotonic())
        utc.append(clocks.utc())
    assert host == sorted(host)
    assert utc == sorted(utc)


def test_a_process_knows_no_robot_time_before_it_has_heard_any() -> None:
    assert Heard().clocks.robot() is None


def test_a_new_start_of_the_hardware_shows_in_the_boot() -> None:
    heard = Heard()
    heard.advance(5.0)
    heard.boot, heard.told = "second", 0.0
    heard.advance(0.01)
    assert heard.clocks.robot() == RobotTime(boot="second", seconds=0.01)


def test_a_timer_counts_on_when_the_hardware_starts_anew() -> None:
    heard = Heard()
    heard.advance(5.0)
    before = robot_seconds(heard.clocks)
    heard.boot, heard.told = "second", 0.0
    heard.advance(0.01)
    heard.advance(2.0)
    assert robot_seconds(heard.clocks) == pytest.approx(before + 2.0)
    stepped = SteppedClocks("first")
    stepped.advance(5.0)
    stepped.reboot("second")
    stepped.advance(2.0)
    assert stepped.robot() == RobotTime(boot="second", seconds=2.0)
    assert robot_seconds(stepped) == 7.0


def test_a_timer_does_not_jump_when_the_hardware_is_first_heard() -> None:
    heard = Heard()
    assert robot_seconds(heard.clocks) == 0.0
    heard.advance(500.0)
    assert robot_seconds(heard.clocks) == 0.0
    heard.advance(1.0)
    assert robot_seconds(heard.clocks) == 1.0


def test_stepped_seconds_do_not_drift() -> None:
    clocks = SteppedClocks()
    for _ in range(100_000):
        clocks.advance(0.01)
    assert clocks.seconds == 1000.0
