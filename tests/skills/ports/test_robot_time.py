"""Moments of two boots can't be compared; timers count on over them."""

from __future__ import annotations

import pytest

from tandem.skills.ports.message import RobotTime, RobotTimer


def at(seconds: float, boot: str = "a") -> RobotTime:
    return RobotTime(boot=boot, seconds=seconds)


def test_within_one_boot_moments_compare() -> None:
    assert at(3.0).since(at(1.0)) == 2.0
    assert at(1.0).since(at(3.0)) == -2.0
    assert at(3.0).is_after(at(1.0)) is True
    assert at(1.0).is_after(at(1.0)) is False
    assert at(1.0).is_fresh(at(1.5), 0.5)
    assert not at(1.0).is_fresh(at(1.6), 0.5)
    assert at(1.0).plus(0.5) == at(1.5)


def test_over_two_boots_the_answer_is_unknown() -> None:
    before, after = at(500.0), at(0.5, "b")
    assert after.since(before) is None
    assert after.is_after(before) is None
    assert before.is_after(after) is None
    assert not before.is_fresh(after, 1e9)
    assert not after.is_fresh(before, 1e9)


def test_order_and_difference_do_not_exist() -> None:
    with pytest.raises(TypeError):
        at(1.0) < at(2.0)  # type: ignore[operator]  # noqa: B015
    with pytest.raises(TypeError):
        at(2.0) - at(1.0)  # type: ignore[operator]


def test_a_timer_counts_on_over_boots_and_never_falls() -> None:
    timer = RobotTimer()
    told = [at(50.0), at(52.0), at(51.0), at(0.5, "b"), at(1.5, "b"), at(9.0, "c"), at(9.5, "c")]
    assert [timer.read(stamp) for stamp in told] == [50.0, 52.0, 52.0, 52.0, 53.0, 53.0, 53.5]


def test_a_timer_may_begin_at_zero() -> None:
    timer = RobotTimer(0.0)
    assert timer.reading == 0.0
    assert [timer.read(stamp) for stamp in (at(50.0), at(52.0))] == [0.0, 2.0]
