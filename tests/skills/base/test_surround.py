"""What the sensors of a base see near it, put together."""

from __future__ import annotations

from tandem.sim.robots.registry import robot_model
from tandem.skills.base.surround import Surround
from tandem.skills.ports.keys import ROBOTS_SEEN
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import RobotsSeen, SeenRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus


def with_two_sensors() -> RobotDescription:
    description = robot_model("summit_xl").description
    (seeing,) = description.robot_sensors
    rear = seeing.model_copy(update={"name": "rear"})
    return description.model_copy(update={"robot_sensors": (seeing, rear)})


def test_a_sensor_that_sees_nobody_hides_no_robot_that_another_sees() -> None:
    description, bus, clocks = with_two_sensors(), MemoryBus(), SteppedClocks("rig")
    front, rear = (each.name for each in description.robot_sensors)
    surround = Surround(bus, clocks, description, lambda: False)
    clocks.advance(1.0)
    now = clocks.robot()
    assert now is not None
    other = SeenRobot(name="other", x=1.0, y=0.0)
    ROBOTS_SEEN.publish(bus, RobotsSeen(stamp=now, sensor=front, robots=(other,)))
    ROBOTS_SEEN.publish(bus, RobotsSeen(stamp=now, sensor=rear, robots=()))
    surround.step()
    assert surround.robots == (other,)
    clocks.advance(1.0)
    surround.step()
    assert surround.robots == (), "what was seen a second ago may be elsewhere"
