"""Drawn faults will strike: none waits for an event that a fetch can do without."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tandem.executive.trials.campaigns.fetch import description_of
from tandem.executive.trials.campaigns.troubles import DRIVES, HOPELESS, LOOKS, MOTIONS, RECOVERABLE, Case
from tandem.sim.defects import misfit
from tandem.sim.draw import draw_fetch, why_not
from tandem.sim.faults import Fault, HardwareSilent, ItemMoves, JointStall, ObstacleAppears
from tandem.sim.scenario import Scenario, load_scenario
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.site import load

SURE = {
    "camera_used": LOOKS,
    "base_moving": DRIVES,
    "base_at_rest_after_moving": 1,
    "arm_moving": MOTIONS,
    "gripper_closed": 1,
    "item_lifted": 1,
}
"""How often each event happens in any fetch."""
SHORTEST = 45.0
"""Robot seconds: no fetch that the campaign has drawn was shorter."""
DEMO, LOCOBOT = load_scenario("Demo"), load_scenario("Locobot")


@cache
def _site_and_robot(scenario: Scenario) -> tuple[Site, RobotDescription]:
    return load(scenario.site), description_of(scenario)


def cases(count: int, scenario: Scenario = DEMO) -> list[Case]:
    made, (site, robot) = [], _site_and_robot(scenario)
    for seed in range(count):
        rng = np.random.default_rng(seed)
        drawn = draw_fetch(site, scenario, rng, robot.footprint_radius + ARM_MARGIN)
        made.append(Case(rng, drawn.item, site, robot, drawn.scenario, _everywhere))
    return made


def _everywhere(_: Scenario, __: int) -> None:
    """Take every place for reachable: to judge them takes seconds each."""


def strikes(fault: Fault) -> bool:
    if fault.when is None:
        return (fault.at or 0.0) < SHORTEST
    one_arm = getattr(fault.when, "side", None) is not None
    return fault.when.nth <= SURE[fault.when.event] and not one_arm


@pytest.mark.parametrize("name", RECOVERABLE)
def test_a_recoverable_fault_waits_for_what_any_fetch_does(name: str) -> None:
    for case in cases(12):
        for fault in RECOVERABLE[name](case):
            assert strikes(fault), fault


@pytest.mark.parametrize("name", [name for name in HOPELESS if name != "arms stall for good"])
def test_a_hopeless_fault_waits_for_what_any_fetch_does(name: str) -> None:
    """But for the arms: the second one moves because the first can't."""
    for case in cases(12):
        for fault in HOPELESS[name][0](case):
            assert strikes(fault), fault


def test_an_item_is_moved_to_a_free_place_on_its_surface() -> None:
    for case in cases(12):
        for name in ("item moved on the way", "item moved before the grasp"):
            (fault,) = RECOVERABLE[name](case)
            assert isinstance(fault, ItemMoves)
            stood = case.scenario.item(case.item)
            yaw = wrap(stood.yaw + fault.dyaw)
            there = stood.model_copy(update={"x": stood.x + fault.dx, "y": stood.y + fault.dy, "yaw": yaw})
            assert why_not(case.site, case.scenario, there) is None


def test_an_item_is_not_moved_out_of_reach() -> None:
    for case in cases(4):
        east = case.scenario.item(case.item).x

        def out_of_reach(scenario: Scenario, tag: int, east: float = east) -> str | None:
            return "too far" if scenario.item(tag).x > east else None

        (fault,) = RECOVERABLE["item moved on the way"](replace(case, out_of_reach=out_of_reach))
        assert isinstance(fault, ItemMoves)
        assert fault.dx <= 0.0


def test_drawn_faults_are_of_parts_that_a_robot_with_one_arm_of_six_joints_has() -> None:
    draws = [*RECOVERABLE.values(), *(draw for draw, _ in HOPELESS.values())]
    (case,) = cases(1, LOCOBOT)
    for fault in (fault for _ in range(12) for draw in draws for fault in draw(case)):
        assert not misfit(fault, case.robot)


def test_all_arms_of_a_robot_stall_for_good() -> None:
    for scenario, arms in ((DEMO, {"arm_left", "arm_right"}), (LOCOBOT, {"arm_single"})):
        (case,) = cases(1, scenario)
        stalls = HOPELESS["arms stall for good"][0](case)
        assert {fault.group for fault in stalls if isinstance(fault, JointStall)} == arms


def test_who_stands_in_the_way_waits_for_room() -> None:
    for case in cases(4):
        (fault,) = RECOVERABLE["way blocked for a while"](case)
        assert isinstance(fault, ObstacleAppears)
        assert fault.waits


def test_silent_hardware_falls_silent_within_the_shortest_fetch() -> None:
    for case in cases(20):
        (fault,) = RECOVERABLE["hardware silent"](case)
        assert isinstance(fault, HardwareSilent)
        assert (fault.at or 0.0) < SHORTEST
