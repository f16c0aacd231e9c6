"""Reflexes of other packages run beside those that come along; what is wrong with one is said."""

from __future__ import annotations

import pytest

from tandem.skills.arm.reflexes.registry import OWNER as ARMS
from tandem.skills.base.reflexes.registry import OWNER
from tandem.skills.ports.actions.base import GO, GoGoal
from tandem.skills.reflex_owners import plugged
from tests.fakes.packages import Installed
from tests.fakes.sonar_rig import SonarRig

SOURCE = """
from tandem.api.reflexes import ARM, BASE, HAND, BaseSurroundings, Failure, FailureKind, Message, ReflexType


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


FENCE, SQUEEZE = made("fence", (BASE,)), made("squeeze", (HAND, ARM))
ARM_LEFT, BOTH = made("arm_left", ("arm_left",)), made("both", (BASE, ARM))
"""


def install(installed: Installed) -> None:
    entries = {
        "fence": "fences:FENCE",
        "squeeze": "fences:SQUEEZE",
        "arm_left": "fences:ARM_LEFT",
        "both": "fences:BOTH",
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
        ("arm_left", "expected resources of one owner (base, or arm and hand, or head)"),
        ("both", "expected resources of one owner"),
        ("other", "expected one name"),
        ("thing", "expected a ReflexType"),
        ("bumper", "taken"),
    ],
)
def test_what_is_wrong_with_one_is_said(installed: Installed, name: str, said: str) -> None:
    install(installed)
    (broken,) = [each for each in plugged().broken if each.plugin.name == name]
    assert said in broken.error


def test_each_owner_has_its_own_and_those_that_come_along(installed: Installed) -> None:
    install(installed)
    assert [each.name for each in OWNER.types(None)] == list(OWNER.shipped)
    assert [each.name for each in OWNER.types()] == [*OWNER.shipped, "fence"]
    assert [each.name for each in ARMS.types()] == [*ARMS.shipped, "squeeze"]
