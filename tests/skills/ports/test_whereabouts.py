"""What robots tell each other of themselves: newest first, own key only, age by the hearer's clock."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import Neighbours, RobotWhereabouts, whereabouts
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus


def told(sequence: int, *, x: float = 0.0, start: str = "a", name: str = "r2") -> RobotWhereabouts:
    pose = FloorPose(x=x, y=0.0, yaw=0.0)
    return RobotWhereabouts(name=name, start=start, sequence=sequence, base_in_map=pose, phase="corner 2")


class Site:
    """The commons of a site, and a robot r1 that hears."""

    def __init__(self) -> None:
        self.commons, self.clocks = MemoryBus(), SteppedClocks()
        self.neighbours = Neighbours(self.commons, self.clocks, "r1")

    def tell(self, message: RobotWhereabouts, key: str = "") -> None:
        whereabouts(key or message.name).publish(self.commons, message)
        self.neighbours.refresh()

    def x(self) -> float | None:
        known = self.neighbours.of("r2")
        return None if known is None or known.told.base_in_map is None else known.told.base_in_map.x


@pytest.mark.parametrize(
    ("messages", "x"),
    [
        ([], None),
        ([told(0, x=1.0)], 1.0),
        ([told(0, x=1.0), told(1, x=2.0)], 2.0),
        ([told(5, x=1.0), told(4, x=2.0)], 1.0),
        ([told(5, x=1.0), told(5, x=2.0)], 1.0),
        ([told(5, x=1.0), told(0, x=2.0, start="b")], 2.0),
    ],
    ids=["nothing", "one", "next", "overtaken", "twice", "another start"],
)
def test_the_newest_of_a_start_counts(messages: list[RobotWhereabouts], x: float | None) -> None:
    site = Site()
    for message in messages:
        site.tell(message)
    assert site.x() == x


@pytest.mark.parametrize(
    "tell",
    [
        lambda site: site.tell(told(0, name="r3"), key="r2"),
        lambda site: site.tell(told(0, name="r1")),
        lambda site: site.commons.publish("world/robots/r2", b"{}"),
    ],
    ids=["under another's key", "its own", "no such document"],
)
def test_what_nobody_else_tells_of_itself_is_not_heard(tell: Callable[[Site], None]) -> None:
    site = Site()
    tell(site)
    site.neighbours.refresh()
    assert not site.neighbours.all()


def test_age_counts_from_when_it_came_by_ones_own_clock() -> None:
    site = Site()
    site.tell(told(0))
    site.clocks.advance(2.5)
    site.neighbours.refresh()
    known = site.neighbours.of("r2")
    assert known is not None
    assert known.age == pytest.approx(2.5)
    site.tell(told(0))  # said again: it is no younger
    known = site.neighbours.of("r2")
    assert known is not None
    assert known.age == pytest.approx(2.5)


def test_without_commons_there_is_nobody() -> None:
    neighbours = Neighbours(None, SteppedClocks(), "r1")
    neighbours.refresh()
    assert not neighbours.all()
