"""Algorithm 3 of the two-arm thesis on recorded traces: what was seen, and what was ordered."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import pytest

from tandem.skills.bimanual.coordination import (
    BARRED_AFTER,
    CLEAR_FOR,
    FIELD_ROOM,
    IN_THE_WAY,
    ROOM,
    ArmNow,
    Coordination,
    Mode,
    Situation,
    Stage,
)
from tandem.skills.ports.actions.bimanual import Order
from tandem.skills.ports.message import HandName

GO, HOLD, BACK, STOP = Order.GO, Order.HOLD, Order.BACK, Order.STOP
HOME = ArmNow(safe=True)


def field(distance: float, at: int = 5, recorded: int = 6) -> ArmNow:
    """An arm whose field runs."""
    return ArmNow(approaching=True, distance=distance, recorded=recorded, at=at, moving=True, away=1.0)


def stands(arm: ArmNow, at: int | None = None) -> ArmNow:
    """The same arm at rest, at a sample of its record."""
    return replace(arm, moving=False, at=arm.at if at is None else at)


GRASPS = ArmNow(moving=True, away=1.0)


@dataclass
class Trace:
    """Feeds the machine, and notes every change of what it says."""

    mode: Mode = "faithful"

    def __post_init__(self) -> None:
        self.state, self.seconds = Coordination(mode=self.mode), 0.0
        self.leaders: list[tuple[int, HandName]] = []

    def see(
        self,
        left: ArmNow,
        right: ArmNow,
        *,
        risk: bool = False,
        clearance: float = 0.2,
        clear: bool = False,
        cross: bool = False,
        room: float = math.inf,
    ) -> tuple[tuple[Order, int], tuple[Order, int]]:
        self.seconds += 0.01
        seen = Situation(self.seconds, risk, clearance, left, right, clear, ways_cross=cross, room=room)
        self.state = self.state.after(seen)
        if self.state.open:
            self.leaders.append((self.state.episode, self.state.leader))
        left_order, right_order = self.state.orders
        return (left_order.order, left_order.sample), (right_order.order, right_order.sample)


def test_without_a_risk_both_go() -> None:
    trace = Trace()
    assert trace.see(field(0.5), field(0.4)) == ((GO, 0), (GO, 0))
    assert trace.state.episode == 0


@pytest.mark.parametrize(
    ("left", "right", "leader"),
    [
        (field(0.2), field(0.3), "left"),
        (field(0.3), field(0.2), "right"),
        (field(0.3), field(0.3), "left"),
        (field(0.1), GRASPS, "right"),
        (GRASPS, field(0.1), "left"),
        (replace(GRASPS, away=0.5), GRASPS, "left"),
        (GRASPS, replace(GRASPS, away=0.5), "right"),
    ],
    ids=[
        "left nearer",
        "right nearer",
        "both alike",
        "right grasps",
        "left grasps",
        "left home first",
        "right",
    ],
)
def test_who_leads(left: ArmNow, right: ArmNow, leader: HandName) -> None:
    trace = Trace()
    trace.see(left, right, risk=True)
    assert trace.state.leader == leader


def test_an_arm_that_only_stands_there_stops_nobody() -> None:
    """The one that moves looks out for it itself."""
    assert Trace().see(field(0.3), replace(HOME, safe=False), risk=True) == ((GO, 0), (GO, 0))


def test_crossing_once() -> None:
    """Left leads; right goes back to its last sample, and goes on when left is home again."""
    trace, left, right = Trace(), field(0.2), field(0.4)
    assert trace.see(left, right, risk=True) == ((HOLD, 0), (BACK, 5))
    assert trace.see(left, right, risk=True) == ((HOLD, 0), (BACK, 5)), "both still move"
    assert trace.see(stands(left), stands(right)) == ((GO, 0), (BACK, 5))
    assert trace.see(GRASPS, stands(right)) == ((GO, 0), (BACK, 5)), "it has picked and comes home"
    assert trace.see(HOME, stands(right)) == ((GO, 0), (GO, 0))
    assert (trace.state.episode, trace.state.open) == (1, False)


def test_crossing_twice() -> None:
    """A second risk: a sample further back, and the same leader though it is farther by now."""
    trace, left, right = Trace(), field(0.2), field(0.4)
    trace.see(left, right, risk=True)
    trace.see(stands(left), stands(right))
    farther = replace(left, distance=0.9)
    assert trace.see(farther, stands(right), risk=True) == ((HOLD, 0), (BACK, 4))
    assert trace.see(stands(farther), stands(right, 5)) == ((HOLD, 0), (BACK, 4)), "it is not there yet"
    assert trace.see(stands(farther), stands(right, 4)) == ((GO, 0), (BACK, 4))
    assert set(trace.leaders) == {(1, "left")}


def test_crossing_until_home() -> None:
    """While the risk lasts: back sample by sample, never below 0; then the leader goes on."""
    trace, left, right = Trace(), field(0.2), field(0.4, at=2, recorded=3)
    assert trace.see(left, right, risk=True)[1] == (BACK, 2)
    samples = [trace.see(stands(left), stands(right, at), risk=True)[1][1] for at in (2, 1, 0, 0, 0)]
    assert samples == [1, 0, 0, 0, 0]
    assert trace.state.stage is Stage.LEADING
    assert trace.see(left, stands(right, 0), risk=True) == ((GO, 0), (BACK, 0)), "no worse than it was"


def test_what_gets_worse_with_the_follower_at_its_start_ends_for_both() -> None:
    trace, left, right = Trace(), field(0.2), field(0.4, at=0, recorded=1)
    trace.see(left, right, risk=True, clearance=0.03)
    trace.see(stands(left), stands(right), risk=True, clearance=0.03)
    assert trace.see(left, stands(right), risk=True, clearance=0.025)[0] == (GO, 0)
    assert trace.see(left, stands(right), risk=True, clearance=0.015) == ((STOP, 0), (STOP, 0))
    rest = replace(HOME, safe=False)
    assert trace.see(rest, rest, risk=True, clearance=0.015) == ((GO, 0), (GO, 0))
    assert trace.see(GRASPS, GRASPS, risk=True, clearance=0.015)[0] == (GO, 0), "it has not passed yet"
    trace.see(GRASPS, GRASPS, clearance=0.1)
    assert trace.see(GRASPS, GRASPS, risk=True)[0][0] is not GO


def cornered(trace: Trace, left: ArmNow, right: ArmNow, *, risk: bool) -> list[tuple[Order, int]]:
    """Send the right arm back, which gets one sample back and no further; return the left arm's orders."""
    trace.see(left, right, risk=True, clearance=0.03)
    trace.see(stands(left), stands(right, 4), risk=risk, clearance=0.03)
    barred = replace(right, at=4)  # it sets out again and again
    return [trace.see(stands(left), barred, risk=risk, clearance=0.03)[0] for _ in range(250)]


@pytest.mark.parametrize("risk", [True, False])
def test_a_follower_whose_way_back_is_barred_does_not_hold_the_leader_for_ever(*, risk: bool) -> None:
    trace, left, right = Trace(), field(0.2), field(0.4, recorded=4)
    told = cornered(trace, left, right, risk=risk)
    assert told[190] == (HOLD, 0), "it has some time"
    assert told[-1] == (GO, 0)
    assert trace.state.cornered


def test_what_gets_worse_with_the_follower_cornered_ends_for_both() -> None:
    trace, left, right = Trace(), field(0.2), field(0.4, recorded=4)
    cornered(trace, left, right, risk=True)
    barred = replace(right, at=4)
    assert trace.see(left, barred, risk=True, clearance=0.025)[0] == (GO, 0)
    assert trace.see(left, barred, risk=True, clearance=0.015) == ((STOP, 0), (STOP, 0))


def test_a_risk_during_the_leaders_grasp() -> None:
    """Both stop, the follower goes further back, the leader goes on."""
    trace, right = Trace(), field(0.4)
    trace.see(field(0.2), right, risk=True)
    trace.see(stands(field(0.2)), stands(right))
    assert trace.see(GRASPS, stands(right), risk=True) == ((HOLD, 0), (BACK, 4))
    assert trace.see(stands(GRASPS), stands(right, 4)) == ((GO, 0), (BACK, 4))


def test_two_without_a_field() -> None:
    """Both on plain moves: who is nearer to its safe place goes on, the other stands until that is there."""
    trace, near = Trace(), replace(GRASPS, away=0.4)
    assert trace.see(near, GRASPS, risk=True) == ((HOLD, 0), (BACK, 0))
    assert trace.see(stands(near), stands(GRASPS), risk=True) == ((GO, 0), (BACK, 0))
    assert trace.see(HOME, stands(GRASPS)) == ((GO, 0), (GO, 0))


def test_a_leader_that_gave_up_and_is_home_lets_the_other_go() -> None:
    trace, right = Trace(), field(0.4)
    trace.see(field(0.2), right, risk=True)
    trace.see(stands(field(0.2)), stands(right))
    assert trace.see(HOME, stands(right)) == ((GO, 0), (GO, 0))


def test_a_leader_that_has_only_begun_is_not_back_home() -> None:
    trace, right = Trace(), field(0.4)
    begun = replace(field(0.2), safe=True)
    trace.see(begun, right, risk=True)
    assert trace.see(stands(begun), stands(right)) == ((GO, 0), (BACK, 5))


def test_the_next_risk_opens_the_next_episode() -> None:
    trace, right = Trace(), field(0.4)
    trace.see(field(0.2), right, risk=True)
    trace.see(stands(field(0.2)), stands(right))
    trace.see(HOME, stands(right))
    trace.see(field(0.3), right, risk=True)
    assert (trace.state.episode, trace.state.leader) == (2, "left")


def test_phi_is_how_far_back_each_time() -> None:
    trace = Trace()
    trace.state = Coordination(mode="faithful", stride=3)
    trace.see(field(0.2), field(0.4), risk=True)
    assert trace.see(stands(field(0.2)), stands(field(0.4)), risk=True)[1] == (BACK, 2)


def leading(mode: Mode) -> Trace:
    """A trace in which left leads and right has gone back."""
    trace = Trace(mode)
    trace.see(field(0.2), field(0.4), risk=True)
    trace.see(stands(field(0.2)), stands(field(0.4)))
    return trace


def until_it_goes(trace: Trace) -> float:
    """Tell that the way is clear until the follower goes; return how long that took."""
    began = trace.seconds
    while trace.see(GRASPS, stands(field(0.4)), clear=True)[1][0] is not GO:
        assert trace.seconds - began < 5.0
    return trace.seconds - began


def test_eager_goes_on_once_its_way_has_been_clear_for_a_while() -> None:
    assert until_it_goes(leading("eager")) == pytest.approx(CLEAR_FOR + 0.01, abs=0.02)


@pytest.mark.parametrize(
    ("mode", "clear", "risk", "goes"),
    [
        ("eager", True, False, True),
        ("eager", False, False, False),
        ("eager", True, True, False),
        ("faithful", True, False, False),
    ],
)
def test_eager_the_leader_goes_on_while_the_follower_goes_back_once_its_way_is_clear(
    mode: Mode, *, clear: bool, risk: bool, goes: bool
) -> None:
    trace, left, right = Trace(mode), field(0.2), field(0.4)
    trace.see(left, right, risk=True)
    assert trace.see(left, right, risk=risk, clear=clear) == ((HOLD, 0), (BACK, 5)), "it still moves"
    orders = trace.see(stands(left), right, risk=risk, clear=clear)
    assert orders == (((GO, 0) if goes else (HOLD, 0)), (BACK, 5))


def test_faithful_waits_however_clear_the_way_is() -> None:
    trace = leading("faithful")
    for _ in range(500):
        assert trace.see(GRASPS, stands(field(0.4)), clear=True)[1][0] is BACK


def test_a_way_that_is_clear_now_and_then_is_not() -> None:
    trace = leading("eager")
    for k in range(500):
        assert trace.see(GRASPS, stands(field(0.4)), clear=k % 10 != 0)[1][0] is BACK


def test_eager_does_not_flutter() -> None:
    """Each time that going on was wrong it goes further back and waits twice as long; the leader stays."""
    trace, waits, samples = leading("eager"), [], []
    for _ in range(3):
        waits.append(until_it_goes(trace))
        samples.append(trace.see(GRASPS, field(0.4), risk=True)[1][1])
        trace.see(stands(GRASPS), stands(field(0.4), 0))
    assert waits == pytest.approx([CLEAR_FOR * 2**k + 0.01 for k in range(3)], abs=0.02)
    assert samples == [4, 3, 2]
    assert set(trace.leaders) == {(1, "left")}


def beside() -> Trace:
    """A trace in which left leads and right gives way, as their ways cross, without a stop."""
    trace = Trace("eager")
    assert trace.see(field(0.2), field(0.4), cross=True) == ((GO, 0), (GO, 0))
    assert (trace.state.episode, trace.state.open, trace.state.leader) == (0, True, "left")
    return trace


@pytest.mark.parametrize(("mode", "opens"), [("eager", True), ("faithful", False)])
def test_eager_one_gives_way_where_ways_cross_before_there_is_a_risk(mode: Mode, *, opens: bool) -> None:
    trace = Trace(mode)
    trace.see(field(0.2), field(0.4), cross=True)
    assert trace.state.open is opens


@pytest.mark.parametrize(
    ("leader", "room", "waits"),
    [
        (field(0.2), FIELD_ROOM - 0.001, True),
        (field(0.2), FIELD_ROOM, False),
        (GRASPS, ROOM - 0.001, True),
        (GRASPS, ROOM, False),
    ],
    ids=["near a field", "far enough from it", "near a planned way", "far enough from that"],
)
def test_the_follower_goes_until_it_would_stop_in_the_leaders_way(
    leader: ArmNow, room: float, *, waits: bool
) -> None:
    assert beside().see(leader, field(0.4), room=room) == ((GO, 0), (HOLD if waits else GO, 0))


def test_the_follower_goes_on_when_the_next_part_of_its_way_is_clear() -> None:
    trace = beside()
    trace.see(field(0.2), field(0.4), room=0.0)
    for _ in range(200):
        assert trace.see(GRASPS, stands(field(0.4)), room=0.2)[1][0] is HOLD, "its way is not clear"
    assert until_it_goes(trace) == pytest.approx(CLEAR_FOR + 0.01, abs=0.02)


def test_who_gives_way_does_so_until_the_leader_is_home() -> None:
    trace = beside()
    trace.see(field(0.2), field(0.4), room=0.0)
    assert trace.see(HOME, stands(field(0.4)), room=0.0) == ((GO, 0), (GO, 0))
    assert not trace.state.open


def test_a_follower_that_is_before_its_item_sooner_leads() -> None:
    """Its grasp has the turn: if it waited for the leader, and that for its turn, neither would go on."""
    trace = beside()
    trace.see(field(0.2), field(0.4), room=0.0)
    assert trace.see(field(0.1), GRASPS, room=0.0) == ((GO, 0), (GO, 0))
    assert trace.state.leader == "right"
    assert trace.see(field(0.1), GRASPS, room=0.0) == ((HOLD, 0), (GO, 0))


def test_a_follower_that_has_not_set_out_yet_does_not_lead() -> None:
    trace = beside()
    trace.see(field(0.1), HOME)
    assert trace.state.leader == "left"


def test_a_risk_beside_each_other_is_the_first_stop_and_the_leader_stays() -> None:
    trace = beside()
    farther = replace(field(0.4), distance=0.1)
    assert trace.see(field(0.2), farther, risk=True) == ((HOLD, 0), (BACK, 5))
    assert (trace.state.episode, trace.state.leader) == (1, "left")


@pytest.mark.parametrize(
    ("leader", "room", "goes_back"),
    [(stands(field(0.2)), 0.0, True), (field(0.2), 0.0, False), (stands(field(0.2)), IN_THE_WAY, False)],
    ids=["stands for it", "gets past it", "stands for something else"],
)
def test_a_follower_that_bars_the_leaders_way_goes_back(
    leader: ArmNow, room: float, *, goes_back: bool
) -> None:
    trace = beside()
    trace.see(field(0.2), field(0.4), room=0.0)
    periods = round(BARRED_AFTER / 0.01) + 2
    orders = [trace.see(leader, stands(field(0.4)), room=room)[1][0] for _ in range(periods)]
    assert orders[-10] is HOLD
    assert (orders[-1] is BACK) is goes_back
