"""ROS time to robot time: the fastest message says how far the clocks are apart."""

from __future__ import annotations

import pytest

from tandem.skills.ros.stamps import JUMP, SURE, WINDOW, Stamps

ROS = 1_700_000_000.0
"""What the sender's clock says at robot second 0."""


def told(stamps: Stamps, sent: float, late: float) -> float:
    """Return what a message of robot second ``sent`` is stamped that came so much later."""
    return stamps.robot_seconds(ROS + sent, sent + late)


def test_a_slow_message_is_older_by_what_it_took_longer() -> None:
    stamps = Stamps()
    told(stamps, 1.0, 0.002)
    assert told(stamps, 2.0, 0.302) == pytest.approx(2.002, abs=1e-5)
    assert told(stamps, 3.0, 0.002) == pytest.approx(3.002, abs=1e-5)


def test_nothing_is_stamped_after_it_came() -> None:
    stamps = Stamps()
    told(stamps, 1.0, 0.2)
    assert told(stamps, 2.0, 0.05) <= 2.05


def test_a_message_without_a_stamp_is_of_now() -> None:
    assert Stamps().robot_seconds(0.0, 5.0) == 5.0


def test_clocks_that_drift_apart_are_followed() -> None:
    stamps = Stamps()
    for second in range(int(WINDOW) * 4):
        stamp = told(stamps, float(second), 0.001 * second)
    assert stamp == pytest.approx(second + 0.001 * second, abs=0.001 * 2 * WINDOW + 1e-5)


def test_one_stamp_from_the_future_ages_no_other() -> None:
    stamps = Stamps()
    told(stamps, 1.0, 0.0)
    assert stamps.robot_seconds(ROS + 500.0, 2.0) == 2.0
    assert told(stamps, 3.0, 0.0) == pytest.approx(3.0, abs=1e-5)


def test_what_was_held_up_is_old_and_a_clock_that_was_set_is_believed_in_the_end() -> None:
    stamps = Stamps()
    told(stamps, 1.0, 0.0)
    held = [told(stamps, 1.0 + 0.1 * k, JUMP + 4.0) for k in range(SURE)]
    assert held[0] == pytest.approx(1.0, abs=1e-5)
    assert held[-1] == pytest.approx(1.0 + 0.1 * (SURE - 1) + JUMP + 4.0)
