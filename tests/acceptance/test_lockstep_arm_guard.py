"""An arm whose joint states fall silent on its way stands, and the task goes on once they are back."""

from __future__ import annotations

import pytest

from tandem.sim.faults import ArmMoving, JointsSilent
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import PipelineState, pipeline_state
from tests.acceptance.course import STILL, course

pytestmark = pytest.mark.lockstep

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)
SILENT_FOR = 1.5
"""Robot seconds: half a second until it is noticed, and another one in which the arm is watched standing."""


def test_an_arm_that_nobody_sees_stands_and_the_task_tries_again() -> None:
    fault = JointsSilent(when=ArmMoving(after=0.2), lasts=SILENT_FOR)
    with course(load_scenario("Demo").starting_at(BEFORE_THE_TABLE).with_faults((fault,))) as run:
        arms = [Latest(run.system.bus, pipeline_state(f"arm_{side}")) for side in ("left", "right")]

        def told() -> list[PipelineState]:
            return [state for each in arms if (state := each.refresh()) is not None]

        run.ask(29)
        run.until(lambda: any(each.reflex for each in told()), within=120.0)
        (taken,) = [each for each in told() if each.reflex]
        assert taken.why is not None
        assert (taken.reflex, taken.why.kind) == (
            f"arm_guard_{taken.resource[4:]}",
            FailureKind.HARDWARE_LOST,
        )
        run.until(lambda: not any(each.reflex for each in told()), within=1.0)
        assert run.moves() < STILL, "it stands before anybody sees it again"
        run.until(lambda: any(each.holder for each in told()), within=10.0)
