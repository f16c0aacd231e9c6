"""Nobody coordinates: a risk stops both arms, once."""

from __future__ import annotations

from tandem.skills.bimanual.coordination import ArmNow, Situation
from tandem.skills.bimanual.uncoordinated_stop import UncoordinatedStop
from tandem.skills.ports.actions.bimanual import Order

MOVES, RESTS = ArmNow(moving=True), ArmNow()


def seen(left: ArmNow, right: ArmNow, *, risk: bool = True, clearance: float = 0.05) -> Situation:
    return Situation(0.0, risk, clearance, left, right)


def orders(state: UncoordinatedStop) -> list[Order]:
    return [each.order for each in state.orders]


def test_both_stop_until_both_are_at_rest() -> None:
    state = UncoordinatedStop().after(seen(MOVES, MOVES))
    assert orders(state) == [Order.STOP, Order.STOP]
    state = state.after(seen(RESTS, MOVES))
    assert orders(state) == [Order.STOP, Order.STOP]
    assert orders(state.after(seen(RESTS, RESTS))) == [Order.GO, Order.GO]


def test_one_that_moves_past_the_other_was_checked_against_it() -> None:
    assert orders(UncoordinatedStop().after(seen(MOVES, RESTS))) == [Order.GO, Order.GO]


def test_they_may_leave_where_they_were_stopped() -> None:
    stopped = UncoordinatedStop().after(seen(MOVES, MOVES)).after(seen(RESTS, RESTS))
    assert orders(stopped.after(seen(MOVES, MOVES))) == [Order.GO, Order.GO]
    assert stopped.after(seen(MOVES, MOVES)).episode == 1


def test_what_gets_worse_is_stopped_again() -> None:
    stopped = UncoordinatedStop().after(seen(MOVES, MOVES)).after(seen(RESTS, RESTS))
    assert orders(stopped.after(seen(MOVES, MOVES, clearance=0.03))) == [Order.STOP, Order.STOP]


def test_a_risk_that_passed_and_came_back_is_a_new_one() -> None:
    state = (
        UncoordinatedStop()
        .after(seen(MOVES, MOVES))
        .after(seen(RESTS, RESTS))
        .after(seen(MOVES, MOVES, risk=False))
    )
    assert state.after(seen(MOVES, MOVES)).episode == 2
