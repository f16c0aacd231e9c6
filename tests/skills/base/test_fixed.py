"""A robot whose base is fixed is where its site has it at home, from the first moment on."""

from __future__ import annotations

from tandem.skills.base.fixed import FixedBase
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.world import ROBOT_POSE
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus


def test_it_tells_home_twenty_times_a_second() -> None:
    bus, clocks, home = MemoryBus(), SteppedClocks("test"), FloorPose(x=1.0, y=2.0, yaw=0.5)
    heard, node = Latest(bus, ROBOT_POSE), FixedBase(bus, clocks, home)
    for _ in range(100):
        clocks.advance(0.01)
        node.step()
    told = heard.take()
    assert len(told) == 20
    assert told[-1].localised
    assert told[-1].base_in_map == home
