"""One fetch, in lockstep with physics: drawn as the fetch campaign draws it, judged by the truth."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.executive.system.systems import LockstepSystem, SystemFailure, wait_for
from tandem.executive.trials.campaigns.fetch import DEPOT, TASK_WITHIN, draw_run
from tandem.executive.trials.campaigns.oracle import Oracle
from tandem.executive.trials.demo import ANSWER_WITHIN
from tandem.executive.trials.picking.phases import seconds, stretches
from tandem.executive.trials.picking.settings import PickingOptions, PickingRun
from tandem.executive.trials.picking.witness import Witness
from tandem.executive.trials.trial import trial, warm_up
from tandem.sim.faults import ArmMoving, GripperStuck
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TASK_TIMELINE, NameTask, Span, Timeline
from tandem.skills.site import load

if TYPE_CHECKING:
    from tandem.sim.draw import Draw

STUCK: Final = GripperStuck(lasts=60.0, when=ArmMoving(nth=1))
"""60 s: longer than both other grasps that are tried before the way home (``trees/subtrees/get_item.py``)."""


def run_picking(options: PickingOptions, figures: Path | None, run: int) -> PickingRun:
    """Draw and make run number ``run``; the same options and number give the same run.

    Args:
        options: of all runs.
        figures: folder into which this run is drawn, if any.
        run: its number, as in ``tandem campaign fetch`` with the same seed.
    """
    scenario = load_scenario(options.scenario)
    draw = draw_run(load(scenario.site), scenario, np.random.default_rng((options.seed, run)))
    faults = (*draw.scenario.faults, *((STUCK,) if options.arm_fails else ()))
    system = LockstepSystem(draw.scenario.model_copy(update={"faults": faults}), options.seed * 1000 + run)
    try:
        return _fetch(system, draw, run, figures)
    finally:
        system.close()


def _fetch(system: LockstepSystem, draw: Draw, run: int, figures: Path | None) -> PickingRun:
    site = load(draw.scenario.site)
    oracle = Oracle(system, site, draw.item, DEPOT)
    warm_up(system)
    began, witness = system.clocks.robot(), Witness(system, draw.item, shoots=figures is not None)
    if began is None:
        raise SystemFailure("the robot's clock is silent")
    made = trial(system, {"task": "fetch", "item": draw.item, "to": DEPOT}, within=TASK_WITHIN, also=witness)
    work = stretches(_timeline(system, made.task), began)
    witness.close()
    place = draw.place
    done = PickingRun(
        run=run,
        item=draw.item,
        place=FloorPose(x=place.x, y=place.y, yaw=place.yaw),
        state=made.state,
        wrong=oracle.verdict().wrong,
        failure=made.failure,
        lasted=made.lasted,
        phases=seconds(work, made.lasted),
        stretches=work,
        path=tuple(witness.path),
    )
    if figures is not None:
        from tandem.executive.trials.picking.drawing import write_figures  # noqa: PLC0415 - loads OpenCV

        write_figures(figures, done, site, system.lockstep.station, witness.shots)
    return done


def _timeline(system: LockstepSystem, task: str) -> tuple[Span, ...]:
    answer = wait_for(system, TASK_TIMELINE.query(system.bus, NameTask(task=task)), ANSWER_WITHIN)
    if answer is None:
        raise SystemFailure(f"the executive did not tell when the nodes of task {task} ran")
    return Timeline.model_validate_json(answer).spans
