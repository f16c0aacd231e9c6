"""What is heard of the wrists while nobody leads both arms."""

from __future__ import annotations

from tandem.skills.bimanual.hold import TwoArms
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.hardware import Wrench
from tandem.skills.ports.keys import JOINT_STATES, wrench
from tandem.skills.ports.message import RobotTime
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.skills.reflex.two_arms import joint_states, positions, robot


def tell(bus: MemoryBus, newtons: float) -> None:
    for side in PAIR:
        felt = Wrench(
            stamp=RobotTime(boot="test", seconds=newtons),
            side=side,
            force=(newtons, 0.0, 0.0),
            torque=(0.0, 0.0, 0.0),
        )
        wrench(side).publish(bus, felt)


def test_the_wrists_are_read_when_somebody_leads_both_arms() -> None:
    description, hulls = robot()
    bus = MemoryBus()
    arms = TwoArms(bus, SteppedClocks("test"), description, hulls)
    JOINT_STATES.publish(bus, joint_states(0.0, positions()))
    tell(bus, 1.0)
    arms.step()
    assert arms.ready
    tell(bus, 2.0)
    arms.step()
    assert arms._felt("left")[0] == 1.0
    arms.engage()
    assert arms._felt("left")[0] == 2.0
