"""The arm's process plans as its site says."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from pydantic import ValidationError

from tandem.executive.system.roles.arm import FAMILY
from tandem.executive.system.roles.role import Surroundings
from tandem.sim.robots.registry import robot_model
from tandem.skills.arm import process
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.site import Site
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.wire.workers import InlineCompute


def site(**changes: object) -> Site:
    return Site.model_validate({**load("picking").model_dump(), **changes})


@pytest.mark.parametrize(
    ("told", "planner"),
    [({}, PlannerName.RRT_CONNECT), ({"arm_planner": "RRTstar+STOMP"}, PlannerName.RRT_STAR_STOMP)],
)
def test_the_sites_planner_is_the_arms(
    told: dict[str, str], planner: PlannerName, monkeypatch: pytest.MonkeyPatch
) -> None:
    chosen: list[PlannerName] = []

    def nodes(*_: object, settings: PlannerSettings, **__: object) -> Sequence[object]:
        chosen.append(settings.planner)
        return ()

    monkeypatch.setattr(process, "nodes", nodes)
    clocks = SteppedClocks(boot="test")
    at = Surroundings(
        bus=MemoryBus(),
        clocks=clocks,
        description=robot_model("locobot").description,
        site=site(**told),
        compute=InlineCompute(clocks),
        seed=1,
    )
    role = FAMILY.role("single")
    assert role.nodes is not None
    role.nodes(at)
    assert chosen == [planner]


def test_a_planner_that_there_is_not_is_refused_with_those_that_there_are() -> None:
    with pytest.raises(ValidationError, match=r"RRTstar\+CHOMP"):
        site(arm_planner="TrajOpt")
