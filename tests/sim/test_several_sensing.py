"""What robots in one world see of each other, by sonar and by robot sensor."""

from __future__ import annotations

import pytest

from tandem.sim.scenario import Scenario
from tandem.sim.starts import RobotStart
from tandem.sim.station import Station, StationSettings
from tandem.skills.ports import keys
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus


def test_the_one_ahead_is_seen_by_name_and_by_distance() -> None:
    """The SUMMIT-XL looks east at a Pioneer 1.5 m ahead; the Pioneer, turned away, has it behind itself."""
    robots = (
        RobotStart(name="looker", robot="summit_xl", start=FloorPose(x=0.0, y=0.0, yaw=0.0)),
        RobotStart(name="seen", robot="p3dx", start=FloorPose(x=1.5, y=0.0, yaw=0.0)),
    )
    buses = {each.name: MemoryBus() for each in robots}
    station = Station(
        buses,
        load("rocs"),
        Scenario(name="two", site="rocs", robots=robots),
        StationSettings(boot="b", seed=1),
    )
    ranges = {name: keys.Latest(bus, keys.RANGES) for name, bus in buses.items()}
    seen = keys.Latest(buses["looker"], keys.ROBOTS_SEEN)
    for _ in range(30):
        station.step()
    told, before, behind = seen.refresh(), ranges["looker"].refresh(), ranges["seen"].refresh()
    station.close()
    assert told is not None
    (other,) = told.robots
    assert (other.name, other.x, other.y) == (
        "seen",
        pytest.approx(1.5, abs=5e-3),
        pytest.approx(0.0, abs=5e-3),
    )
    assert before is not None
    assert before.of("range_middle") == pytest.approx(1.5 - 0.365 - 0.248, abs=0.02)
    assert behind is not None
    assert behind.of("sonar_11") == pytest.approx(1.5 - 0.255 - 0.36, abs=0.03)
