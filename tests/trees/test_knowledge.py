"""What was told under another boot of the hardware is not known; the task waits until it is told again."""

from __future__ import annotations

import pytest

from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import Site
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.trees.knowledge import Knowledge


class Rig:
    """A robot that tells all that a task needs, when the test says so."""

    def __init__(self, site: Site) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("first")
        self.robot = MockRobot(self.bus, self.clocks, site, items={29: Pose()})
        self.knowledge = Knowledge(self.bus, self.clocks, site)

    def pass_time(self, seconds: float, *, tells: bool = True) -> None:
        for tick in range(round(seconds / 0.1)):
            self.clocks.advance(0.1)
            stamp = self.clocks.robot()
            assert stamp is not None
            CLOCK.publish(self.bus, Clock(stamp=stamp, tick=tick))
            if tells:
                self.robot.step()
                self.robot.tell()
            self.knowledge.refresh()


@pytest.fixture
def rig() -> Rig:
    rig = Rig(load("lab"))
    rig.pass_time(2.0)
    return rig


def test_what_was_told_under_another_boot_is_not_known(rig: Rig) -> None:
    assert rig.knowledge.missing() == ()
    rig.clocks.reboot("second")
    rig.pass_time(0.1, tells=False)
    assert rig.knowledge.world is None
    assert rig.knowledge.robot is None
    assert rig.knowledge.scene is None
    assert rig.knowledge.zones is None
    assert rig.knowledge.arm("left") is None
    assert "hw/description" in rig.knowledge.missing(), "it may be another robot"


def test_hardware_that_has_started_anew_is_silent_until_all_is_told_again(rig: Rig) -> None:
    assert rig.knowledge.hardware_silent_for == 0.0
    rig.clocks.reboot("second")
    rig.pass_time(1.0, tells=False)
    assert rig.knowledge.hardware_silent_for == pytest.approx(1.0)
    rig.pass_time(2.0)
    assert rig.knowledge.missing() == ()
    assert rig.knowledge.hardware_silent_for == 0.0


def test_the_first_boot_is_no_new_start(rig: Rig) -> None:
    fresh = Knowledge(rig.bus, rig.clocks, rig.knowledge.site)
    rig.knowledge = fresh
    rig.pass_time(1.0, tells=False)
    assert fresh.missing() != ()
    assert fresh.hardware_silent_for == 0.0, "a task's first leaf waits, and says for what"
