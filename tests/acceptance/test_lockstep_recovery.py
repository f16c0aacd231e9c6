"""Recovery with all physics: what is dropped is noticed at once; short, seeded forms of the campaign."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tandem.sim.controls import FAULTS
from tandem.sim.faults import HandOpens, ItemLifted
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.hardware import GripperMotion, GripperState
from tandem.skills.ports.keys import Latest, gripper_state
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState
from tests.acceptance.course import STILL, course

pytestmark = pytest.mark.lockstep

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)
NOTICED_WITHIN = 0.5
"""Robot seconds from the fingers' opening to the tree's turning to something else."""


def test_a_dropped_item_is_noticed_within_half_a_second_and_the_robot_stops() -> None:
    fault = HandOpens(when=ItemLifted(after=8.0))
    scenario = load_scenario("Demo").starting_at(BEFORE_THE_TABLE).with_faults((fault,))
    with course(scenario) as run:
        events, pads = Latest(run.system.bus, FAULTS), Latest(run.system.bus, gripper_state("left"))
        task = run.ask(29)
        run.until(lambda: events.refresh() is not None, within=120.0)
        assert events.value is not None
        assert any("while the item is in the hand" in path for path in run.running()), "it was carried"
        opened = events.value.stamp.seconds
        run.until(lambda: not (run.world() or pytest.fail("no world")).held, within=NOTICED_WITHIN)
        run.until(
            lambda: not any("bring item to slot" in path for path in run.running()),
            within=NOTICED_WITHIN,
        )
        assert run.seconds - opened < NOTICED_WITHIN + 0.1, "a tick of the tree later at the most"
        assert run.cancel(task).accepted
        assert run.caller.follow(task, within=5.0).state is TaskState.CANCELED
        # A hand that has lost what it held closes by itself.
        run.until(lambda: not _moving(pads.refresh()), within=1.0)
        assert run.moves() < STILL


def _moving(pads: GripperState | None) -> bool:
    return pads is None or pads.motion is GripperMotion.MOVING


@pytest.mark.parametrize(
    ("what", "arguments"),
    [
        pytest.param(
            "recovered", ["--runs", "1", "--hopeless", "0", "--first", "1"], marks=pytest.mark.thorough
        ),
        ("right_kind", ["--runs", "0", "--hopeless", "1", "--first", "3"]),
    ],
    ids=["camera silent", "camera dark for good"],
)
def test_a_drawn_trouble_ends_as_it_must(tmp_path: Path, what: str, arguments: list[str]) -> None:
    report = tmp_path / "campaign.json"
    command = ["campaign", "recovery", *arguments, "--seed", "1", "--jobs", "1"]
    argv = ["tandem", *command, "--report", str(report)]
    program = f"import sys; sys.argv = {argv!r}; from tandem.executive.cli.main import run; run()"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert json.loads(report.read_text("utf-8"))["result"][what] == 1
