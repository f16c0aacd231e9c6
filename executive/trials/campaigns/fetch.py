"""Fetches from anywhere of anything: start, item and its place drawn, in lockstep with all physics."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.random import Generator

from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.campaigns.oracle import Oracle
from tandem.executive.trials.campaigns.reachable import Reachable
from tandem.executive.trials.campaigns.recording import UNRECORDED, Runs
from tandem.executive.trials.phase_times import Phases
from tandem.executive.trials.trial import trial, warm_up
from tandem.sim.draw import Draw, draw_fetch
from tandem.sim.scenario import Scenario
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.site import load

DEPOT: Final = "depot"
TASK_WITHIN: Final = 600.0
"""Robot seconds for one fetch."""


class FetchRun(Message):
    """One fetch of a campaign. ``right``: the task succeeded, and nothing is ``wrong`` in truth.

    Right in truth: the item lies in the slot that was reported, nothing else moved by 1 cm or fell over,
    the robot touched no furniture, and it is at rest at home.
    """

    run: int
    item: int
    start: FloorPose
    place: FloorPose
    """Where the item stood, and its heading."""
    rejected: tuple[str, ...]
    """Draws that were thrown away, with the reason."""
    unreachable: int
    """How many of these because no arm gets at the item there."""
    state: str
    slot: int | None
    """The slot of the depot in which the item is reported to lie."""
    wrong: tuple[str, ...]
    """What the ground truth contradicts: see ``executive.trials.campaigns.oracle``."""
    right: bool
    failure: Failure | None
    robot_seconds: float
    phases: dict[str, float]
    """Robot seconds by phase."""
    digest: str
    """Of all messages on the bus."""


class FetchCampaign(Message):
    """A whole campaign. ``right``: how many runs were. ``unreachable``: places that no arm gets at."""

    scenario: str
    seed: int
    right: int
    unreachable: int
    runs: tuple[FetchRun, ...]


def run_fetch(scenario: Scenario, seed: int, run: int, *, runs: Runs = UNRECORDED) -> FetchRun:
    """Draw and run fetch number ``run`` of the campaign ``seed``; the same numbers give the same run.

    ``runs`` makes its system: one that is recorded, for instance.
    """
    site = load(scenario.site)
    draw = draw_run(site, scenario, np.random.default_rng((seed, run)))
    system = runs.system(draw.scenario, seed * 1000 + run, run)
    try:
        return _fetch(system, run, draw)
    finally:
        system.close()


def draw_run(site: Site, scenario: Scenario, rng: Generator) -> Draw:
    """Draw a fetch over all that the robot reaches of the scenario's surfaces."""
    description = description_of(scenario)
    reachable = Reachable(description, site)
    return draw_fetch(site, scenario, rng, description.footprint_radius + ARM_MARGIN, reachable.why_not)


def description_of(scenario: Scenario) -> RobotDescription:
    """Return what the robot of a scenario tells about itself."""
    from tandem.sim.robots.registry import robot_model  # noqa: PLC0415 - loads pybullet; used only here

    return robot_model(scenario.first.robot).description


def _fetch(system: LockstepSystem, run: int, draw: Draw) -> FetchRun:
    scenario, item, site = draw.scenario, draw.item, load(draw.scenario.site)
    oracle, phases = Oracle(system, site, item, DEPOT), Phases(system)
    warm_up(system)
    made = trial(system, {"task": "fetch", "item": item, "to": DEPOT}, within=TASK_WITHIN, also=phases)
    digest, wrong = system.digest(), oracle.verdict().wrong
    place = scenario.item(item)
    return FetchRun(
        run=run,
        item=item,
        start=scenario.first.start,
        place=FloorPose(x=place.x, y=place.y, yaw=place.yaw),
        rejected=tuple(
            f"{each.what} at ({each.x:.2f}, {each.y:.2f}, {each.yaw:.2f}): {each.reason}"
            for each in draw.rejected
        ),
        unreachable=sum(each.unreachable for each in draw.rejected),
        state=made.state,
        slot=oracle.slot(),
        wrong=wrong,
        right=not wrong and made.succeeded,
        failure=made.failure,
        robot_seconds=made.lasted,
        phases=phases.seconds(),
        digest=digest,
    )
