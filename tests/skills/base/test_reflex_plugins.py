"""Reflexes of other packages run beside those that come along; what is wrong with one is said."""

from __future__ import annotations

import pytest

from tandem.skills.base.reflexes.registry import SHIPPED, plugged, reflexes
from tandem.skills.ports.actions.base import GO, GoGoal
from tests.fakes.packages import Installed
from tests.fakes.sonar_rig import SonarRig

SOURCE = """
from tandem.api.reflexes import BASE, BaseSurroundings, Failure, FailureKind, Message, ReflexType


class Nothing(Message):
    pass


class Fence:
    def __init__(self, at: BaseSurroundings, parameters: Nothing) -> None:
        self.at = at

    def look(self, *, holds: bool) -> Failure | None:
        odometry = self.at.localiser.odometry
        if odometry is None or odometry.base_in_odom.x < 0.5 or not (holds or self.at.board.holder):
            return None
        return Failure(kind=FailureKind.BASE_BLOCKED, message="beyond the fence")

    def act(self):
        return self.at.brake("fence")

    def close(self) -> None:
        pass


def made(name, resources):
    return ReflexType(
        name=name, about="stays west", resources=resources, rank=70, parameters=Nothing,
        needs=lambda robot: "", make=Fence,
    )


FENCE, ARM = made("fence", (BASE,)), made("arm", ("arm_left",))
"""


def install(installed: Installed) -> None:
    entries = {
        "fence": "fences:FENCE",
        "arm": "fences:ARM",
        "other": "fences:FENCE",
        "thing": "fences:Nothing",
        "bumper": "fences:FENCE",
    }
    installed.add("fences", {"fences": SOURCE}, {"tandem.reflexes": entries})


def test_one_of_another_package_takes_the_wheels(installed: Installed) -> None:
    install(installed)
    robot = SonarRig(left_out={})
    robot.wait(0.3)
    robot.send(GO.name, GoGoal(x=2.0, y=0.0))
    robot.wait(5.0)
    assert {each.reflex for each in robot.told} == {"", "fence"}
    assert 0.5 < robot.pose.x < 0.9


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("arm", "expected the resource 'base'"),
        ("other", "expected one name"),
        ("thing", "expected a ReflexType"),
        ("bumper", "taken"),
    ],
)
def test_what_is_wrong_with_one_is_said(installed: Installed, name: str, said: str) -> None:
    install(installed)
    (broken,) = [each for each in plugged().broken if each.plugin.name == name]
    assert said in broken.error


def test_without_plug_ins_there_are_those_that_come_along(installed: Installed) -> None:
    install(installed)
    assert [each.name for each in reflexes(None)] == list(SHIPPED)
    assert [each.name for each in reflexes()] == [*SHIPPED, "fence"]
