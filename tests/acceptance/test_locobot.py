"""A LoCoBot takes an item out of a shelf: the hand comes in between the boards and touches nothing else."""

from __future__ import annotations

import pytest

from tandem.executive.trials.campaigns.fetch import run_fetch
from tandem.executive.trials.campaigns.oracle import Oracle
from tandem.sim.scenario import load_scenario
from tandem.sim.things import TrueItem
from tandem.skills.ports.pose import FloorPose
from tests.acceptance.course import course

pytestmark = pytest.mark.lockstep

BEFORE_THE_SHELF = FloorPose(x=1.20, y=0.68, yaw=-0.60)
ON_THE_UPPER_BOARD = TrueItem(item=29, support="upper_board", x=1.78, y=0.395, yaw=0.96)
LIFTED = 0.55
"""Metres: on the board the item's middle is 0.48 m high."""


def test_the_hand_takes_an_item_from_between_two_boards() -> None:
    scenario = load_scenario("Locobot").with_item(ON_THE_UPPER_BOARD).starting_at(BEFORE_THE_SHELF)
    with course(scenario) as run:
        oracle = Oracle(run.system, run.site, 29, "depot")
        run.ask(29)
        run.until(lambda: run.truth().item(29).pose.position[2] > LIFTED, within=60.0)
        verdict = oracle.verdict()
        assert verdict.disturbed == ()
        assert any(other.startswith("robot/") for other in run.truth().touching("item_29"))


@pytest.mark.thorough
def test_it_fetches_from_anywhere_in_its_room() -> None:
    done = run_fetch(load_scenario("Locobot"), 1, 1)
    assert done.right, done
