"""The example of a robot of one's own, with an arm of five joints, at work in the room of a new project."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.cli.commands.new_command import project
from tandem.sim.robots import registry
from tandem.sim.scenario import Scenario, load_scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState
from tests.acceptance.course import course
from tests.fakes.examples import example_cart

pytestmark = pytest.mark.lockstep


@pytest.fixture
def first(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Scenario:
    """The project's scenario, with the cart in it."""
    cart = example_cart().ROBOT
    monkeypatch.setattr(registry, "shipped", lambda: {cart.name: cart})
    for path, text in project("mine").items():
        if path.endswith(".yaml"):
            (tmp_path / Path(path).name).write_text(text, "utf-8")
    return load_scenario(str(tmp_path / "first.yaml")).model_copy(update={"robot": cart.name})


def test_the_cart_brings_the_box_to_its_slot(first: Scenario) -> None:
    with course(first) as run:
        # 29 s are enough at the first attempt; before its hand's poses could turn it tried in vain for 48.
        assert run.fetch(29, within=40.0).state is TaskState.SUCCEEDED, run.account()
        assert run.delivered(29)


def test_the_cart_picks_by_the_field_from_where_it_stands(first: Scenario) -> None:
    aside = FloorPose(x=-0.13, y=0.04, yaw=0.0)  # 6 cm off where its arm would point straight at the box
    with course(first.model_copy(update={"start": aside})) as run:
        answer = run.caller.request({"task": "pick", "item": 29})
        assert answer.accepted, answer.problems
        # 7 s; before the field's grasps could turn it had NO_IK at each of three attempts.
        assert run.caller.follow(answer.task, within=20.0).state is TaskState.SUCCEEDED, run.account()
