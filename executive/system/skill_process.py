"""A process of skills: its nodes live for one boot of the hardware, and its goals are journalled."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.system.leased_loop import run_leased
from tandem.executive.system.roles.role import Role, Stage, Surroundings
from tandem.skills import map_file
from tandem.skills.goal_journal import GoalJournal
from tandem.skills.limbs import Limb
from tandem.skills.one_boot import OneBoot
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.description_check import check_description
from tandem.skills.ports.keys import DESCRIPTION, Nothing
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.server import ActionServer
from tandem.skills.site import load
from tandem.skills.wire.workers import ProcessCompute
from tandem.skills.wire.zenoh_bus import ZenohBus, wait_until

DESCRIPTION_WITHIN: Final = 30.0
"""Host seconds in which the hardware must have told who it is."""


def nodes_of(role: Role, at: Surroundings) -> Sequence[Node]:
    """Return the nodes of a skills role for one boot, in the order in which they are stepped."""
    assert role.nodes is not None, f"{role.name} is no role of skills"
    at.bus.ear.know(at.description)
    return role.nodes(at)


def play_skills(stage: Stage, role: Role) -> None:
    """Play a role of skills until the process is told to end.

    Raises:
        RefusalError: the hardware does not tell who it is.
        RivalError: another process has the lease.
    """
    settings, site = stage.settings, load(stage.settings.site)
    if settings.data is not None:
        Path(settings.data).mkdir(parents=True, exist_ok=True)
    compute = ProcessCompute(stage.bus.waker.wake, stage.worker, once=role.worker == "once")
    try:
        description = _ask_description(stage.bus, stage.stopped)

        live: list[OneBoot] = []

        def skills(bus: Bus, clocks: Clocks) -> Node:
            def build(bus: Bus, description: RobotDescription) -> Sequence[Node]:
                at = Surroundings(
                    bus=bus,
                    clocks=clocks,
                    description=description,
                    site=site,
                    compute=compute,
                    seed=settings.seed,
                    left_out=settings.left_out,
                    journal=None if settings.journal is None else Path(settings.journal),
                    map_file=map_file.path_of(settings.site, settings.data),
                    commons=stage.bus.commons(),
                    robot=settings.prefix.rpartition("/")[2],
                )
                nodes = nodes_of(role, at) if role.needed(description) else ()
                _keep_goals(settings, nodes)
                return nodes

            live.append(OneBoot(settings.role, bus, clocks, build, description))
            return live[0]

        run_leased(stage, skills, calm=lambda: calm_now(role, live[0].nodes))
    finally:
        compute.close()


def calm_now(role: Role, nodes: Sequence[Node]) -> bool:
    """Say whether these nodes move nothing now."""
    if role.calm == "between goals":
        return not any(isinstance(node, ActionServer | Limb) and node.busy for node in nodes)
    return role.calm == "always"


def _keep_goals(settings: WorkerSettings, nodes: Sequence[Node]) -> None:
    """Have the action servers of a process journal the goals that they accept."""
    if settings.data is None:
        return
    journal = GoalJournal(Path(settings.data) / f"{settings.role}.goals")
    for node in nodes:
        if isinstance(node, ActionServer):
            node.keep(journal)


def _ask_description(bus: ZenohBus, stopped: Callable[[], bool]) -> RobotDescription:
    deadline = time.monotonic() + DESCRIPTION_WITHIN
    while not stopped() and time.monotonic() < deadline:
        answer = wait_until(bus, DESCRIPTION.query(bus, Nothing()), 2.0)
        if answer is not None:
            description = DESCRIPTION.decode_answer(answer)
            check_description(description)
            return description
        bus.waker.wait(0.05)
    raise RefusalError(f"no robot told its description on hw/description within {DESCRIPTION_WITHIN:.0f} s")
