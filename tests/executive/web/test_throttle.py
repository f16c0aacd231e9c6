"""Wrong log-ins are counted by address, and all together."""

from __future__ import annotations

import pytest

from tandem.executive.web.throttle import ALL_TRIES, TRIES, WITHIN, Throttle


@pytest.mark.parametrize(
    ("guesser", "other", "closed"),
    [
        ("192.0.2.1", "192.0.2.1", True),
        ("192.0.2.1", "192.0.2.2", False),
        ("2001:db8::1", "2001:db8::ffff", True),
        ("2001:db8::1", "2001:db8:0:1::1", False),
        ("::ffff:192.0.2.1", "::ffff:192.0.2.2", False),
        ("", "", True),
        ("testclient", "192.0.2.1", False),
    ],
)
def test_who_guesses_is_heard_no_more_and_his_neighbours_are(
    guesser: str, other: str, *, closed: bool
) -> None:
    throttle = Throttle(lambda: 0.0)
    for _ in range(TRIES):
        assert throttle.closed_to(other) == ""
        throttle.note(guesser)
    assert bool(throttle.closed_to(other)) is closed


def test_many_addresses_together_are_bounded_and_a_minute_opens_again() -> None:
    now = 0.0
    throttle = Throttle(lambda: now)
    for number in range(ALL_TRIES):
        throttle.note(f"10.0.{number // 250}.{number % 250}")
    assert "many addresses" in throttle.closed_to("192.0.2.1")
    now = WITHIN + 1.0
    assert throttle.closed_to("192.0.2.1") == ""
