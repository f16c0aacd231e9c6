"""A fetch of what is not a box, by the whole system in lockstep; what it comes to is read from the truth."""

from __future__ import annotations

import math

import pytest

from tandem.executive.trials.campaigns.oracle import IN_SLOT
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.tasks import TaskState
from tandem.skills.site import load
from tests.acceptance.course import course

pytestmark = pytest.mark.lockstep


def test_a_tin_is_taken_from_the_table_and_put_into_its_slot() -> None:
    site = load("pantry")
    with course(load_scenario("Tins"), site=site) as run:
        assert run.fetch(20, within=150.0).state is TaskState.SUCCEEDED
        assert run.delivered(20)
        x, y, _ = run.truth().item(20).pose.position
        assert math.dist((x, y), site.depots[0].slots[0].position[:2]) < IN_SLOT
        world = run.world()
        assert world is not None
        fact = world.item(20)
        assert fact is not None
        assert fact.shape == "cylinder"
