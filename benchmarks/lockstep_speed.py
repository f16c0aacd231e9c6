"""How many times faster than real time lockstep runs: ``python -m benchmarks.lockstep_speed``.

Demo's room, all skills and the executive in one thread. The speed is the robot's seconds over those of the
processor (all threads of the process), which others on the machine disturb least; the wall's are in the note.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final

from pydantic import JsonValue

from benchmarks.rows import Row
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import load_scenario
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import BaseVelocity

SECONDS: Final = 10.0
"""Robot time of each part but the fetch."""
SETTLING: Final = 4.0
"""Robot time before: all rests, all caches are warm."""
FETCH: Final[dict[str, JsonValue]] = {"task": "fetch", "item": 29}
FETCH_WITHIN: Final = 240.0
CURVE: Final = BaseVelocity(linear=0.3, angular=0.6)
"""A circle of half a metre to the left of Demo's start, where nothing stands."""


@dataclass(frozen=True)
class Speed:
    """Robot seconds, and what they took of the processor and of the wall's clock."""

    robot: float
    processor: float
    wall: float

    def row(self, what: str, aim: float, note: str = "") -> Row:
        """Return it as a line of the table."""
        wall = f"{self.robot / self.wall:.1f} by the wall's clock"
        note = f"{wall}; {note}" if note else wall
        return Row(f"lockstep, {what}", self.robot / self.processor, "x real time", aim, True, note)


def measured(system: LockstepSystem, run: Callable[[], None]) -> Speed:
    """Return how fast something ran."""
    robot, processor, wall = system.lockstep.seconds, time.process_time(), time.perf_counter()
    run()
    return Speed(system.lockstep.seconds - robot, time.process_time() - processor, time.perf_counter() - wall)


def stand(system: LockstepSystem, seconds: float = SECONDS) -> None:
    """Let time pass."""
    for _ in range(round(seconds / system.lockstep.period)):
        system.advance()


def drive(system: LockstepSystem, seconds: float = SECONDS) -> None:
    """Drive a circle; commands at 20 Hz."""
    for period in range(round(seconds / system.lockstep.period)):
        if period % 5 == 0:
            keys.BASE_VELOCITY.publish(system.bus, CURVE)
        system.advance()


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure; the short form leaves out the camera and the fetch."""
    system = LockstepSystem(load_scenario("Demo"), 1)
    try:
        stand(system, SETTLING)
        if quick:
            yield measured(system, lambda: stand(system, 1.0)).row("standing, without the camera", 4.0)
            return
        yield measured(system, lambda: stand(system)).row("standing, without the camera", 4.0)
        yield measured(system, lambda: drive(system)).row("driving, without the camera", 4.0)
        pictures = system.bus.subscribe(keys.rgbd("head"), depth=1024)
        stand(system, SETTLING)  # the first picture has the renderer started and the room loaded
        pictures.drain()
        looking = measured(system, lambda: stand(system))
        count = len(pictures.drain())
        pictures.close()
        yield looking.row("a picture taken each time it can be", 2.0, f"{count} pictures in {SECONDS:.0f} s")
        yield _fetch(system)
    finally:
        system.close()


def _fetch(system: LockstepSystem) -> Row:
    caller = Caller(system, lambda _: None)
    states: list[str] = []

    def run() -> None:
        asked = caller.request(FETCH)
        states.append(caller.follow(asked.task, within=FETCH_WITHIN).state.value)

    speed = measured(system, run)
    note = f"{states[0]} after {speed.robot:.0f} robot s; the camera is on while the robot looks"
    return speed.row("a fetch, planning and all", 2.0, note)


def main() -> None:
    """Print the figures."""
    for row in rows():
        print(f"{row.what:50s} {row.value:6.2f} {row.unit}, aim {row.aim:g} or more; {row.note}", flush=True)


if __name__ == "__main__":
    main()
