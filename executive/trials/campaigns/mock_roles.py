"""The roles of the campaigns of crashes: a mocked robot, and an executive that is killed at chosen points.

``played_by`` of a process's settings names them; what ships for robots does not know them.
"""

from __future__ import annotations

import uuid
from pathlib import Path
from typing import Final

from tandem.executive.system.roles import executive
from tandem.executive.system.roles.role import Role, Stage
from tandem.executive.trials.campaigns.crash_points import CrashBus, CrashLedger, CrashPoints
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.node import Node

MOCKED: Final = f"{__name__}:MOCK"
"""What plays the role ``mock``, for ``played_by``."""
CRASHING: Final = f"{__name__}:CRASHING_EXECUTIVE"
"""What plays the role ``executive`` such that it is killed."""
CRASH_AT: Final = "crash_at"
"""Argument: kill this process at a point by its name."""
CRASH_LOG: Final = "crash_log"
"""Argument: file to which each point is written when it is first passed."""


def _play_mock(stage: Stage) -> None:
    from tandem.executive.trials.campaigns.crash_world import TICK, LastingRobot  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415
    from tandem.skills.wire.clocks import ProcessClocks  # noqa: PLC0415

    settings, bus = stage.settings, stage.bus
    stopped = stage.presence.watch(stage.stopped)
    assert settings.data is not None, "the mock keeps its truth in a folder"
    boot = uuid.uuid4().hex[:8]
    clocks = ProcessClocks(bus)
    robot = LastingRobot(bus, clocks, load(settings.site), Path(settings.data), boot)
    bus.announce("process/mock")
    more = False
    try:
        while not stopped():
            if not more:
                bus.waker.wait(TICK)
            clocks.refresh()
            more = robot.step()
    finally:
        robot.close()


def _play_crashing(stage: Stage) -> None:
    from tandem.executive.system.leased_loop import run_leased  # noqa: PLC0415

    told = stage.settings.arguments
    log = told.get(CRASH_LOG)
    points = CrashPoints(told.get(CRASH_AT, ""), None if log is None else Path(log))

    def build(bus: Bus, clocks: Clocks) -> Node:
        ledger = executive.ledger_of(stage.settings)
        crashing = None if ledger is None else CrashLedger(ledger, points)
        return executive.service_node(stage, CrashBus(bus, points), clocks, crashing)

    run_leased(stage, build)


MOCK: Final = Role(name="mock", starts=10, kind="hardware", play=_play_mock)
CRASHING_EXECUTIVE: Final = Role(
    name="executive", starts=80, kind="executive", play=_play_crashing, rights=executive.RIGHTS
)
