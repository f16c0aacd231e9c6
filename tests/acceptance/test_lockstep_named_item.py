"""An item that has a name and no number, in a room of one's own, seen by a detector of one's own."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.cli.commands.new_command import project
from tandem.executive.cli.commands.task_commands import _request
from tandem.executive.render.failure_words import explain
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import number_of
from tandem.skills.ports.tasks import TaskState
from tests.acceptance.course import Course, course
from tests.fakes.examples import EXAMPLES
from tests.fakes.packages import Installed

pytestmark = pytest.mark.lockstep

MUG = number_of("mug")
IN_VIEW = FloorPose(x=-0.9, y=0.2, yaw=-0.12)
"""Of the mug, which stands 1.6 m ahead."""
EDITS = {
    "workshop.yaml": (
        "{item: 29, name: box, size: [0.06, 0.06, 0.06], tag_size: 0.048}",
        "{name: mug, size: [0.06, 0.06, 0.08], colour: [0.9, 0.1, 0.1]}",
    ),
    "first.yaml": (
        "{item: box, support: table, x: 0.60, y: 0.10, yaw: 3.141592653589793}",
        "{item: mug, support: table, x: 0.62, y: -0.20, yaw: 3.0}",
    ),
}
OFF = 0.03
"""Metres between the believed and the true place of the face: half of what a grasp allows on either side."""


@pytest.fixture
def run(installed: Installed, tmp_path: Path) -> Iterator[Course]:
    """The room of a new project, with a red mug instead of its box, and the example of a detector."""
    source = (EXAMPLES / "by_colour.py").read_text("utf-8")
    entries = {"tandem.detectors": {"by_colour": "by_colour:by_colour"}}
    installed.add("somebody", {"by_colour": source}, entries)
    files = {Path(path).name: text for path, text in project("mine").items()}
    for name, (before, after) in EDITS.items():
        assert before in files[name]
        (tmp_path / name).write_text(files[name].replace(before, after), "utf-8")
    scenario = load_scenario(tmp_path / "first.yaml").starting_at(IN_VIEW)
    with course(scenario, left_out={}) as running:
        yield running


def test_it_is_asked_for_found_and_told_of_by_its_name(run: Course) -> None:
    refused = run.caller.request({"task": "fetch", "item": "cup"})
    assert [each.expected for each in refused.problems] == [f"one of the site's items: {MUG} (mug)"]
    answer = run.caller.request({"task": "fetch", "item": "mug"})
    assert answer.accepted, answer.problems

    run.until(lambda: (world := run.world()) is not None and world.item(MUG) is not None, within=10.0)
    world = run.world()
    assert world is not None
    fact = world.item(MUG)
    assert fact is not None
    lies = run.truth().item(MUG).pose.position
    assert math.dist(fact.tag_in_map.position[:2], lies[:2]) == pytest.approx(0.03, abs=OFF)

    assert run.cancel(answer.task).accepted
    status = run.caller.follow(answer.task, within=10.0)
    assert status.state is TaskState.CANCELED
    assert _request(status) == '{"item": "mug"}'
    assert '"item": "mug"' in explain(status)
