"""A shelf that is not in the site file, lower than the laser's plane, is driven around after one look."""

from __future__ import annotations

import math

import pytest

from tandem.sim.scenario import load_scenario
from tandem.sim.things import BoxShape, Obstacle
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.occupancy import OccupancySetting
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.world import OCCUPANCY
from tandem.skills.site import load
from tests.acceptance.course import course

pytestmark = [pytest.mark.lockstep, pytest.mark.thorough]

SHELF = Obstacle(name="shelf", shape=BoxShape(size=(0.20, 0.70, 0.18)), x=-0.20, y=-0.40, mass=0.0)
START, GOAL = FloorPose(x=-1.30, y=-0.40, yaw=0.0), FloorPose(x=0.70, y=-0.40, yaw=0.0)


def test_a_low_shelf_in_the_way_is_driven_around() -> None:
    scenario = load_scenario("Locobot").model_copy(update={"obstacles": (SHELF,)}).starting_at(START)
    site = load("picking").model_copy(update={"occupancy": OccupancySetting()})
    with course(scenario, site=site) as run:
        told, touched = Latest(run.system.bus, OCCUPANCY), set[str]()
        asked = run.caller.request({"task": "go_to", "x": GOAL.x, "y": GOAL.y, "tolerance": 0.12})
        assert asked.accepted, asked.problems

        def there() -> bool:
            truth = run.truth()
            touched.update(truth.touching("shelf"))
            x, y, _ = truth.base_in_map.position
            return math.hypot(x - GOAL.x, y - GOAL.y) < 0.15

        run.until(there, within=60.0)
        cells = told.refresh()
        assert not touched
        assert cells is not None
        assert len(cells.numbers()) > 10
