"""Roles are found by being there, and a robot has those that its description needs."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.system.playing import play
from tandem.executive.system.roles.registry import (
    names,
    needed_roles,
    role_named,
    role_of,
    shipped,
    skill_roles,
)
from tandem.executive.system.roles.role import Role, Surroundings
from tandem.executive.system.roles.skills import gathered
from tandem.executive.trials.campaigns.mock_roles import CRASHING, MOCKED
from tandem.sim.robots.registry import robot_model
from tandem.skills.ports.node import Node
from tandem.skills.site import load
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.wire.workers import InlineCompute

ROBOT = robot_model("tiago_base").description
SETTINGS = WorkerSettings(role="base", endpoint="tcp/127.0.0.1:1", prefix="lab/roles", site="lab")


def test_a_whole_system_starts_the_router_first_and_the_executive_last() -> None:
    whole = names(mock_description())
    assert whole[:2] == ("router", "hardware")
    assert whole[-1] == "executive"
    assert "observer" in shipped()
    assert "observer" not in whole


@pytest.mark.parametrize("role", needed_roles(mock_description()), ids=lambda role: role.name)
def test_a_role_is_played_in_one_way(role: object) -> None:
    ways = [getattr(role, way) for way in ("nodes", "play", "route")]
    assert sum(way is not None for way in ways) == 1


def test_a_robot_with_one_hand_needs_neither_the_other_arm_nor_what_takes_two() -> None:
    both = mock_description()
    left = both.model_copy(update={"end_effectors": (both.end_effector("left"),)})
    needed, all_of_them = ({role.name for role in skill_roles(each)} for each in (left, both))
    assert all_of_them - needed == {"arm_right", "bimanual"}


def test_a_robot_has_a_role_for_each_hand_whatever_it_is_called() -> None:
    robot = mock_description()
    hook = robot.end_effector("left").model_copy(update={"side": "hook"})
    robot = robot.model_copy(update={"end_effectors": (hook,), "cameras": ()})
    needed = [role.name for role in skill_roles(robot)]
    assert needed == ["keeper", "base", "arm_hook"]
    assert role_of(SETTINGS.model_copy(update={"role": "arm_hook"})).name == "arm_hook"
    assert role_named("arm_") is None


def test_what_ships_knows_no_mock_and_played_by_names_it() -> None:
    assert "mock" not in shipped()
    assert role_of(SETTINGS.model_copy(update={"role": "mock", "played_by": MOCKED})).kind == "hardware"
    crashing = role_of(SETTINGS.model_copy(update={"role": "executive", "played_by": CRASHING}))
    assert (crashing.name, crashing is shipped()["executive"]) == ("executive", False)


def test_a_role_that_nobody_declares_is_refused_with_those_that_there_are() -> None:
    with pytest.raises(RefusalError, match=r"'cook': expected one of router, hardware, .*, observer"):
        play(SETTINGS.model_copy(update={"role": "cook"}), lambda: True)


def test_skills_that_share_a_process_are_those_that_would_have_one_each() -> None:
    whole = names(mock_description())
    assert gathered(whole) == ("router", "hardware", "skills", "executive")
    assert gathered(("router", "a_plug_in")) == ("router", "a_plug_in")


def test_the_process_that_they_share_steps_the_nodes_of_each_in_their_order() -> None:
    def at() -> Surroundings:
        clocks = SteppedClocks()
        return Surroundings(
            bus=MemoryBus(),
            clocks=clocks,
            description=ROBOT,
            site=load("lab"),
            compute=InlineCompute(clocks),
            seed=1,
        )

    alone = [node.name for role in skill_roles(ROBOT) for node in made(role, at())]
    assert [node.name for node in made(shipped()["skills"], at())] == alone


def made(role: Role, at: Surroundings) -> Sequence[Node]:
    assert role.nodes is not None
    return role.nodes(at)
