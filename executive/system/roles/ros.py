"""The hardware of a robot that speaks ROS 2: `tandem ros` plays it instead of the role ``hardware``."""

from __future__ import annotations

import gc
import time
import uuid
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Final

from tandem.executive.config.extras import ROS
from tandem.executive.security.rights import Rights
from tandem.executive.system.roles.role import Role, Stage, process_rights

if TYPE_CHECKING:
    from tandem.skills.ports.robot_description import RobotDescription
    from tandem.skills.ros.driver import RosHardware
    from tandem.skills.ros.mapping import RosMap
    from tandem.skills.wire.zenoh_bus import ZenohBus

MAP: Final = "map"
"""Argument: the path of the map."""
ROUTER: Final = "router"
"""Argument: the endpoint of ROS's router; empty: Tandem's own."""
IDLE_WAIT: Final = 0.05
"""Host seconds after which a process whose clock is not due looks whether it should end."""


def read_map(path: Path) -> tuple[RosMap, RobotDescription]:
    """Return a map and the description of its robot.

    Raises:
        DocumentError: naming the file, the path and line in it, and what was expected.
    """
    from tandem.sim.robots.registry import robot_model  # noqa: PLC0415
    from tandem.skills.ros.mapping import load_map  # noqa: PLC0415

    return load_map(path, lambda name: robot_model(name).description)


def _play(stage: Stage) -> None:
    from tandem.executive.system.playing import claim_of  # noqa: PLC0415
    from tandem.skills.ros.cdr import Codec  # noqa: PLC0415
    from tandem.skills.ros.driver import RosHardware, Times  # noqa: PLC0415
    from tandem.skills.wire.foreign_session import ForeignSession  # noqa: PLC0415
    from tandem.skills.wire.presence import Presence  # noqa: PLC0415

    settings, bus = stage.settings, stage.bus
    made, robot = read_map(Path(settings.arguments[MAP]))
    presence = Presence(bus, "hardware", claim_of(settings))  # nobody else may be this robot
    presence.settle(stage.stopped)
    session = ForeignSession(settings.arguments.get(ROUTER) or settings.endpoint, bus.waker, bus.strays)
    times = Times(time.monotonic, time.time)
    try:
        codec, boot = Codec(made.distro), uuid.uuid4().hex[:8]
        driver = RosHardware(bus, session, made, robot, codec, boot=boot, times=times)
        bus.announce("process/hardware")
        _run(driver, bus, presence.watch(stage.stopped))
    finally:
        session.close()


def _run(driver: RosHardware, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    gc.collect()
    gc.freeze()  # as in skills/wire/loop.py
    more = False
    try:
        while not stopped():
            if not more:
                bus.waker.wait(min(max(0.0, driver.due), IDLE_WAIT))
            bus.beat()
            more = driver.step()
    finally:
        driver.close()


ROLES = (
    Role(
        name="ros",
        starts=10,
        kind="hardware",
        extra=ROS,
        pictures=True,
        play=_play,
        on_request=True,
        rights=process_rights(
            Rights(
                tells=("hw/**", "beat/**", "refused"),
                hears=("hw/**", "beat/**"),
                serves=("hw/**",),
            )
        ),
    ),
)
