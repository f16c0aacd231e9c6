"""Whether an arm may move, as the coordination has it."""

from __future__ import annotations

import pytest

from tandem.skills.arm.right_of_way import Gate
from tandem.skills.ports.actions.bimanual import ORDER_LOST_AFTER, RIGHT_OF_WAY, ArmOrder, Order, RightOfWay
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus

LATE = ORDER_LOST_AFTER + 0.1


@pytest.mark.parametrize(
    ("side", "order", "opened", "later", "expected"),
    [
        ("left", Order.GO, True, 0.0, None),
        ("left", Order.HOLD, True, 0.0, Order.HOLD),
        ("left", Order.BACK, True, 0.0, Order.BACK),
        ("left", Order.STOP, True, 0.0, Order.STOP),
        ("right", Order.HOLD, True, 0.0, None),
        (None, Order.HOLD, True, 0.0, None),
        ("left", Order.GO, True, LATE, Order.HOLD),
        ("left", Order.GO, False, LATE, None),
    ],
    ids=["go", "hold", "back", "stop", "other side", "no hand", "open and silent", "closed and silent"],
)
def test_what_an_arm_must_do(
    *, side: HandName | None, order: Order, opened: bool, later: float, expected: Order | None
) -> None:
    bus, clocks = MemoryBus(), SteppedClocks("test")
    gate = Gate(bus, clocks, side)
    clocks.advance(1.0)
    said = RightOfWay(
        stamp=RobotTime(boot="test", seconds=1.0),
        episode=1,
        open=opened,
        orders=(ArmOrder(side="left", order=order), ArmOrder(side="right", order=Order.GO)),
    )
    RIGHT_OF_WAY.publish(bus, said)
    clocks.advance(later)
    told = gate.order()
    assert (None if told is None else told.order) is expected
    assert gate.gives_up() is (expected is Order.STOP)


def test_without_coordination_it_may_go() -> None:
    clocks = SteppedClocks("test")
    clocks.advance(1.0)
    assert Gate(MemoryBus(), clocks, "left").order() is None


def test_what_was_said_before_the_robot_started_anew_does_not_count() -> None:
    bus, clocks = MemoryBus(), SteppedClocks("new")
    gate = Gate(bus, clocks, "left")
    clocks.advance(1.0)
    stamp = RobotTime(boot="old", seconds=1.0)
    said = RightOfWay(stamp=stamp, episode=1, open=True, orders=(ArmOrder(side="left", order=Order.HOLD),))
    RIGHT_OF_WAY.publish(bus, said)
    assert gate.order() is None
