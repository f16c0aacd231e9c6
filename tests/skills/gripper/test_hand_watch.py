"""The watch over a hand: what it tells, and how soon."""

from __future__ import annotations

import pytest

from tandem.skills.gripper.commands import Order, name_command, order_of
from tandem.skills.gripper.hand_watch import HandWatch
from tandem.skills.ports.actions.gripper import HandState, HandStatus, hand_status
from tandem.skills.ports.hardware import GripperMotion, GripperState
from tandem.skills.ports.keys import gripper_state
from tandem.skills.ports.message import RobotTime
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.wire.memory import MemoryBus

OPEN, HOLDING, EMPTY = HandState
M = GripperMotion
PERIOD = 0.02
CLOSES, OPENS = name_command("t/grip/1", 0, Order.CLOSE), name_command("t/open/1", 0, Order.OPEN)


class Watched:
    """A watch, and a gripper that says what the test wants."""

    def __init__(self) -> None:
        self.bus = MemoryBus()
        self.inbox = self.bus.subscribe(hand_status("left").key)
        self.seconds, self.boot = 0.0, "b"
        self.start()

    def start(self) -> None:
        self.watch = HandWatch(self.bus, mock_description().end_effector("left"))

    def tell(
        self, seconds: float, width: float, motion: M = M.STALLED, force: float = 15.0, command: str = CLOSES
    ) -> list[HandStatus]:
        """Let the gripper say so for that long; return what the watch told meanwhile."""
        for _ in range(round(seconds / PERIOD)):
            self.seconds += PERIOD
            stamp = RobotTime(boot=self.boot, seconds=self.seconds)
            state = GripperState(
                stamp=stamp, side="left", command_id=command, motion=motion, width=width, force=force
            )
            gripper_state("left").publish(self.bus, state)
            self.watch.step()
        return [HandStatus.model_validate_json(each.payload) for each in self.inbox.drain()]


@pytest.fixture
def hand() -> Watched:
    made = Watched()
    assert made.tell(0.5, 0.06)[-1].state is HOLDING
    return made


def states(told: list[HandStatus]) -> list[HandState]:
    return [each.state for each in told]


def test_without_a_change_it_tells_twice_a_second(hand: Watched) -> None:
    assert len(hand.tell(2.0, 0.06)) == pytest.approx(4, abs=1)


def test_while_pads_move_it_tells_ten_times_a_second(hand: Watched) -> None:
    told = [each for k in range(50) for each in hand.tell(PERIOD, 0.06 - 0.0002 * k, M.MOVING, 0.0)]
    assert len(told) == pytest.approx(10 * 50 * PERIOD, abs=1)


def test_a_drop_is_told_well_within_half_a_second(hand: Watched) -> None:
    began = hand.seconds
    told = []
    for k in range(1, 61):  # the pads close at 5 cm/s
        told += hand.tell(PERIOD, max(0.0, 0.06 - 0.001 * k), M.MOVING, 0.0)
    first = next(each for each in told if each.state is EMPTY)
    assert first.stamp.seconds - began < 0.4


def test_a_hand_that_opens_by_itself_is_empty(hand: Watched) -> None:
    began = hand.seconds
    told = hand.tell(0.1, 0.065, force=0.0) + hand.tell(0.4, 0.09, force=0.0)
    first = next(each for each in told if each.state is EMPTY)
    assert first.stamp.seconds - began < 0.4


def test_pads_that_take_hold_anew_have_lost_nothing(hand: Watched) -> None:
    told = hand.tell(0.2, 0.056, M.MOVING, 0.0) + hand.tell(0.5, 0.055)
    assert set(states(told)) == {HOLDING}


def test_a_moment_without_force_is_nothing(hand: Watched) -> None:
    assert set(states(hand.tell(0.1, 0.06, force=0.0) + hand.tell(0.5, 0.06))) == {HOLDING}


def test_a_hand_that_is_opened_is_never_empty(hand: Watched) -> None:
    told = hand.tell(0.02, 0.06, M.MOVING, 0.0, OPENS)
    told += hand.tell(0.5, 0.09, M.MOVING, 0.0, OPENS) + hand.tell(0.5, 0.002, M.AT_WIDTH, 0.0, OPENS)
    assert set(states(told)) == {OPEN}
    assert told[0].stamp.seconds == pytest.approx(0.52), "at once"


def test_a_hand_that_closes_is_open_until_it_stalls() -> None:
    hand = Watched()
    told = hand.tell(0.5, 0.08, M.MOVING, 0.0) + hand.tell(0.2, 0.06)
    assert list(dict.fromkeys(states(told))) == [OPEN, HOLDING]


def test_pads_that_met_are_empty() -> None:
    hand = Watched()
    told = hand.tell(0.3, 0.002, M.AT_WIDTH, 0.0)
    assert list(dict.fromkeys(states(told))) == [OPEN, EMPTY]


def test_a_watch_that_starts_late_knows_what_the_hand_was_told(hand: Watched) -> None:
    hand.start()
    assert hand.tell(0.2, 0.06)[-1].state is HOLDING
    hand.start()
    assert hand.tell(0.2, 0.001, M.AT_WIDTH, 0.0)[-1].state is EMPTY


@pytest.mark.parametrize("order", list(Order))
def test_a_commands_name_tells_its_order(order: Order) -> None:
    assert order_of(name_command("task/node#2/1", 3, order)) is order


def test_a_command_of_another_tells_none() -> None:
    assert order_of("somebody") is None
