"""How soon a reflex commands: from a sensor's message to the first velocity that the reflex sends.

A Pioneer is standing still when a sonar reports something close by, and ``avoid_collision`` turns it away. In
one process, the base's nodes are stepped once over a bus in memory: the time of the computation alone. Across
processes, the base runs in a process of its own and this one plays the hardware over zenoh, as on a robot.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np

from benchmarks.machine import frozen
from benchmarks.processes import PREFIX, playing, running
from benchmarks.rows import Row, spread
from tandem.sim.robots.registry import robot_model
from tandem.skills.base.process import build
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.hardware import BaseVelocity, Clock, Odometry
from tandem.skills.ports.keys import (
    BASE_VELOCITY,
    CLOCK,
    DESCRIPTION,
    ODOMETRY,
    POSE_READING,
    RANGES,
    Latest,
)
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import pipeline_state
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import PoseReading, RangeReading, Ranges
from tandem.skills.ports.serving import Endpoints
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.wire.zenoh_bus import ZenohBus

ROBOT: Final = "p3dx"
SITE: Final = "rocs"
NEAR: Final = {"sonar_3": 0.18}
"""Metres: nearer than a base that stands lets anything come."""
TRIALS: Final = 100
PERIOD: Final = 0.02
PATIENCE: Final = 20.0
"""Seconds for which a reflex, or its end, is waited for."""
IN_ONE: Final = (10.0, 25.0)
ACROSS: Final = (25.0, 50.0)
"""Milliseconds, median and p99, that are aimed at."""


@dataclass
class Face:
    """The hardware's side: a base that obeys at once, and sonars that tell what they are told to."""

    bus: Bus
    description: RobotDescription
    pose: FloorPose = field(default_factory=lambda: FloorPose(x=0.0, y=0.0, yaw=0.0))
    speed: BaseVelocity = field(default_factory=lambda: BaseVelocity(linear=0.0, angular=0.0))

    def __post_init__(self) -> None:
        """Listen to commands."""
        self.commands = Latest(self.bus, BASE_VELOCITY, depth=256)

    def obey(self) -> tuple[BaseVelocity, ...]:
        """Take what was commanded."""
        sent = tuple(self.commands.take())
        self.speed = sent[-1] if sent else self.speed
        return sent

    def move(self, now: RobotTime) -> None:
        """Move on for a period, and tell time, odometry and pose."""
        turned = self.pose.yaw + self.speed.angular * PERIOD
        way = self.speed.linear * PERIOD
        self.pose = FloorPose(
            x=self.pose.x + way * float(np.cos(turned)),
            y=self.pose.y + way * float(np.sin(turned)),
            yaw=turned,
        )
        CLOCK.publish(self.bus, Clock(stamp=now, tick=round(now.seconds / PERIOD)))
        ODOMETRY.publish(
            self.bus,
            Odometry(stamp=now, base_in_odom=self.pose, linear=self.speed.linear, angular=self.speed.angular),
        )
        sensor = self.description.pose_sensors[0].name
        POSE_READING.publish(self.bus, PoseReading(stamp=now, sensor=sensor, base_in_map=self.pose))

    def see(self, now: RobotTime, near: Mapping[str, float]) -> None:
        """Tell what the sonars see: nothing, but for those that are named (m)."""
        readings = tuple(
            RangeReading(sensor=each.name, distance=near.get(each.name, each.range_max))
            for each in self.description.range_sensors
        )
        RANGES.publish(self.bus, Ranges(stamp=now, readings=readings))


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    count = 4 if quick else TRIALS
    yield from _rows("in one process", in_one_process(count), IN_ONE)
    yield from _rows("across processes", across_processes(count), ACROSS)


def _rows(where: str, seconds: list[float], aims: tuple[float, float]) -> Iterator[Row]:
    name = f"from a sonar's message to the reflex's command, {where}"
    for row, aim in zip(spread(name, seconds), aims, strict=True):
        yield replace(row, aim=aim)


def in_one_process(count: int) -> list[float]:
    """Return the seconds from message to command when the nodes are stepped at once."""
    found = []
    for _ in range(count):
        bus, clocks = MemoryBus(), SteppedClocks("bench")
        face = Face(bus, robot_model(ROBOT).description)
        nodes = build(bus, clocks, face.description, load(SITE))
        for tick in range(1, 21):
            clocks.advance(PERIOD)
            now = RobotTime(boot=clocks.boot, seconds=round(tick * PERIOD, 9))
            face.move(now)
            face.see(now, {})
            for node in nodes:
                node.step()
        face.obey()
        began = time.perf_counter()
        face.see(now, NEAR)
        for node in nodes:
            node.step()
        found.append(time.perf_counter() - began)
        assert face.obey(), "the reflex did not fire"
    return found


def across_processes(count: int, *, seed: int = 1) -> list[float]:
    """Return the seconds from message to command when the base is a process of its own."""
    rng = np.random.default_rng(seed)
    with running([]) as (endpoint, _):
        bus = ZenohBus(endpoint, PREFIX)
        try:
            hardware = Hardware(bus)
            with playing("base", endpoint, SITE), frozen():
                hardware.until(lambda: hardware.free)
                return [hardware.trial(float(rng.uniform(0.2, 0.4))) for _ in range(count)]
        finally:
            bus.close()


class Hardware:
    """Plays the hardware in real time, and measures.

    Args:
        bus: to the base's process.
    """

    def __init__(self, bus: ZenohBus) -> None:
        self._bus, self._began = bus, time.monotonic()
        self._face = Face(bus, robot_model(ROBOT).description)
        self._states = Latest(bus, pipeline_state("base"), depth=256)
        self._endpoints = Endpoints(
            bus, time.monotonic, (answering(DESCRIPTION, lambda _: self._face.description),)
        )
        self._near: Mapping[str, float] = {}
        self._at, self._ticks = 0.0, 0

    @property
    def free(self) -> bool:
        """Whether the base's process has told that no reflex has the base."""
        state = self._states.refresh()
        return state is not None and not state.reflex

    def until(self, holds: Callable[[], bool], within: float = PATIENCE) -> None:
        """Go on until it holds.

        Raises:
            TimeoutError: when it does not.
        """
        end = time.monotonic() + within
        while not holds():
            if time.monotonic() > end:
                raise TimeoutError(f"not within {within:.0f} s")
            self._step()

    def trial(self, rest: float) -> float:
        """Rest for so many seconds, have something come near, and return the seconds to the first command."""
        end = time.monotonic() + rest
        self.until(lambda: time.monotonic() >= end)
        self._face.obey()
        began = time.perf_counter()
        self._near = NEAR
        self._face.see(self._now(), NEAR)
        while not self._face.obey():  # a base that stands is sent nothing
            self._bus.waker.wait(0.005)
            if time.perf_counter() - began > PATIENCE:
                raise TimeoutError(f"no command within {PATIENCE:.0f} s")
        took = time.perf_counter() - began
        self._near = {}
        self.until(lambda: not self.free)
        self.until(lambda: self.free)
        return took

    def _now(self) -> RobotTime:
        return RobotTime(boot="bench", seconds=time.monotonic() - self._began)

    def _step(self) -> None:
        self._endpoints.step()
        self._face.obey()
        self._bus.waker.wait(PERIOD / 2.0)
        now = self._now()
        if now.seconds - self._at >= PERIOD:
            self._at, self._ticks = now.seconds, self._ticks + 1
            self._face.move(now)
            if self._ticks % 5 == 0:
                self._face.see(now, self._near)
