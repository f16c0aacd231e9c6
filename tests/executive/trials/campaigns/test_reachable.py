"""What counts as out of reach in a campaign: shown by trying every face, arm and stand."""

from __future__ import annotations

import pytest

from tandem.executive.trials.campaigns.reachable import Reachable
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import Scenario, load_scenario
from tandem.sim.things import BoxShape, Obstacle
from tandem.skills.site import load

DEMO = load_scenario("Demo").model_copy(update={"obstacles": (), "items": (load_scenario("Demo").item(29),)})


@pytest.fixture(scope="module")
def reachable() -> Reachable:
    return Reachable(robot_model("tiago_dual").description, load("lab"))


def at(x: float, y: float, *walls: Obstacle) -> Scenario:
    item = DEMO.item(29).model_copy(update={"x": x, "y": y})
    return DEMO.with_item(item).model_copy(update={"obstacles": walls})


def test_an_item_at_the_edge_is_in_reach(reachable: Reachable) -> None:
    assert reachable.why_not(at(0.47, 0.5), 29) is None


def test_an_item_in_the_corner_of_the_shelf_is_out_of_reach_of_all(reachable: Reachable) -> None:
    far = DEMO.item(29).model_copy(update={"support": "shelf_board", "x": -1.52, "y": 2.93})
    assert "even with nothing but furniture there" in str(reachable.why_not(DEMO.with_item(far), 29))


def test_an_item_that_is_walled_in_is_out_of_reach_among_what_stands_there(reachable: Reachable) -> None:
    walls = tuple(
        Obstacle(name=f"wall_{n}", shape=BoxShape(size=size), support="table", x=0.6 + dx, y=0.5 + dy)
        for n, (dx, dy, size) in enumerate(
            (
                (0.08, 0.0, (0.02, 0.2, 0.4)),
                (-0.08, 0.0, (0.02, 0.2, 0.4)),
                (0.0, 0.08, (0.1, 0.02, 0.4)),
                (0.0, -0.08, (0.1, 0.02, 0.4)),
            )
        )
    )
    assert "among what stands there" in str(reachable.why_not(at(0.6, 0.5, *walls), 29))
