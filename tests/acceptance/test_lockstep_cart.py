"""The example of a robot of one's own, with an arm of five joints, fetches in the room of a new project."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.cli.commands.new_command import project
from tandem.sim.robots import registry
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.tasks import TaskState
from tests.acceptance.course import course
from tests.fakes.examples import example_cart

pytestmark = pytest.mark.lockstep


def test_the_cart_brings_the_box_to_its_slot(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    cart = example_cart().ROBOT
    monkeypatch.setattr(registry, "shipped", lambda: {cart.name: cart})
    for path, text in project("mine").items():
        if path.endswith(".yaml"):
            (tmp_path / Path(path).name).write_text(text, "utf-8")
    scenario = load_scenario(str(tmp_path / "first.yaml")).model_copy(update={"robot": cart.name})
    with course(scenario) as run:
        # 29 s are enough at the first attempt; before its hand's poses could turn it tried in vain for 48.
        assert run.fetch(29, within=40.0).state is TaskState.SUCCEEDED, run.account()
        assert run.delivered(29)
