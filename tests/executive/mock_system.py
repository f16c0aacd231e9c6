"""Router, mocked robot and executive in one process: ``mock_system.py PORT SECONDS_A_SKILL PARTS``."""

from __future__ import annotations

import sys
import time

from tandem.executive.service.executive import Executive
from tandem.executive.service.tasks.task_book import start_id
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.hardware import Clock, Stop, StopRelease, StopState
from tandem.skills.ports.keys import CLOCK, STOP, STOP_RELEASE, STOP_STATE
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.serving import Endpoints
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.configs import router_config
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tandem.trees.registry import discover


class MockStop:
    """The stop of a hardware that never moves; it tells its state now and then, as hardware has to."""

    def __init__(self, bus: ZenohBus) -> None:
        self._bus, self._state = bus, StopState(stopped=False)
        served = (answering(STOP, self._told), answering(STOP_RELEASE, self._told))
        self._endpoints = Endpoints(bus, time.monotonic, served)

    def step(self) -> bool:
        """Answer what was asked."""
        return self._endpoints.step()

    def tell(self) -> None:
        """Tell the state to who has come since it changed."""
        STOP_STATE.publish(self._bus, self._state)

    def _told(self, asked: Stop | StopRelease) -> StopState:
        self._state = StopState(stopped=isinstance(asked, Stop), by=asked.by, reason=asked.reason)
        self.tell()
        return self._state


def main(port: str, duration: str, parts: str) -> None:
    """Run until killed; prints "ready" when all is there."""
    endpoint = f"tcp/127.0.0.1:{port}"
    router = open_session(router_config(endpoint), endpoint)  # noqa: F841 - lives as long as we do
    site = load("lab")
    bus, robot_bus = ZenohBus(endpoint, "lab/tiago"), ZenohBus(endpoint, "lab/tiago")
    clocks, robot_clocks = ProcessClocks(bus), ProcessClocks(robot_bus)
    began, tick = time.monotonic(), 0
    nodes = []
    if "robot" in parts:
        items = {
            29: Pose(position=(0.5, 0.5, 0.74), orientation=from_axes((0, -1, 0), (0, 0, 1), (-1, 0, 0)))
        }
        stop = MockStop(robot_bus)
        nodes.append(MockRobot(robot_bus, robot_clocks, site, items=items, duration=float(duration)))
    if "executive" in parts:
        nodes.append(Executive(bus, clocks, site, discover(), start=start_id(), version="test"))
    sys.stdout.write("ready\n")
    sys.stdout.flush()
    while True:
        tick += 1
        if "robot" in parts:
            stamp = RobotTime(boot="mock", seconds=time.monotonic() - began)
            CLOCK.publish(robot_bus, Clock(stamp=stamp, tick=tick))
        clocks.refresh()
        robot_clocks.refresh()
        more = [node.step() for node in nodes]
        if "robot" in parts:
            more.append(stop.step())
        if not any(more):
            bus.waker.wait(0.005)
        if tick % 100 == 0 and "robot" in parts:
            nodes[0].tell()
            stop.tell()


if __name__ == "__main__":
    main(*sys.argv[1:])
