"""One crossing in its variants, in lockstep with physics, judged by the simulation itself."""

from __future__ import annotations

from typing import Final

import numpy as np

from tandem.executive.trials.crossings.draws import draw
from tandem.executive.trials.crossings.rig import Rig
from tandem.executive.trials.crossings.settings import (
    CrossingOptions,
    CrossingRun,
    Drive,
    Touch,
    What,
)
from tandem.executive.trials.crossings.witness import Witness
from tandem.sim.scenario import Scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import Site
from tandem.skills.site import load

WITHIN: Final = 60.0
"""Robot seconds for one drive."""


def run_crossing(options: CrossingOptions, run: int) -> CrossingRun:
    """Draw and drive run number ``run``; the same options and number give the same run."""
    site = load("picking")
    scenario, goal = draw(site, np.random.default_rng((options.seed, run)))
    seed = options.seed * 1000 + run
    ours = site.model_copy(update={"local_planner": options.planner})
    drives = [_drive("crossing", scenario, goal, ours, seed)]
    if options.baselines:
        today = site.model_copy(update={"local_planner": "pursuit"})
        nobody = scenario.model_copy(update={"people": ()})
        drives += [_drive("alone", nobody, goal, ours, seed), _drive("today", scenario, goal, today, seed)]
    return CrossingRun(run=run, people=len(scenario.people), drives=tuple(drives))


def _drive(what: What, scenario: Scenario, goal: FloorPose, site: Site, seed: int) -> Drive:
    assert scenario.start is not None, "the drawn scenario has one robot"
    rig = Rig(scenario, seed, site)
    try:
        witness = Witness(rig.station, rig.bus)
        rig.localise(scenario.start)
        before = len(rig.station.world.touches)
        status = rig.drive(goal, within=WITHIN, also=witness.step)
        touches = rig.station.world.touches[before:]
        witness.close()
        return Drive(
            what=what,
            state="STUCK" if status is None else status.state.value,
            failure=None if status is None else status.failure,
            lasted=round(witness.lasted, 2),
            near=round(witness.near, 2),
            nearest=round(min(witness.nearest, 99.0), 3),
            touches=tuple(
                Touch(person=each.person, at=each.at, stood=max(each.stood, 0.0)) for each in touches
            ),
            seen=witness.seen(),
        )
    finally:
        rig.close()
