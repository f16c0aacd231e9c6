"""When a process's loop is woken by the clock; of its bus a few stand-ins."""

from __future__ import annotations

from typing import Any, cast

import pytest

from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.message import RobotTime
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.loop import CALM, run
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.skills.wire.zenoh_bus import ZenohBus
from tandem.skills.wire.zenoh_ends import Waker


class Bus(MemoryBus):
    """A bus with the ends of a process."""

    def __init__(self) -> None:
        super().__init__(MemoryHub())
        self.waker = Waker()
        self.waker.wake()

    def beat(self) -> None:
        """Nobody listens."""


class Mover:
    """A node that begins to move in its step."""

    name, moves = "mover", False

    def step(self) -> bool:
        self.moves = True
        return False

    def close(self) -> None:
        """Nothing to end."""


@pytest.mark.parametrize(
    ("waits", "calm", "expected"), [(False, True, CALM), (True, True, 0.0), (False, False, 0.0)]
)
def test_a_process_that_moves_nothing_turns_calmly_unless_the_hardware_waits_for_it(
    *, waits: bool, calm: bool, expected: float
) -> None:
    bus, clock = Bus(), Clock(stamp=RobotTime(boot="a", seconds=1.0), tick=1, waits=waits)
    clocks: Any = type("Clocks", (), {"refresh": lambda _: clock})()
    turns = iter((False, True))
    run("x", cast("ZenohBus", bus), cast("ProcessClocks", clocks), [], lambda: next(turns), calm=lambda: calm)
    assert bus.waker.calm == expected


def test_what_begins_to_move_in_a_turn_is_woken_by_the_next_tick() -> None:
    bus, mover, turns = Bus(), Mover(), iter((False, True))
    clocks: Any = type("Clocks", (), {"refresh": lambda _: None})()
    given = cast("ZenohBus", bus), cast("ProcessClocks", clocks)
    run("x", *given, [mover], lambda: next(turns), calm=lambda: not mover.moves)
    assert bus.waker.calm == 0.0
