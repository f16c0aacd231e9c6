"""Who hangs for so long that it is killed."""

from __future__ import annotations

import pytest

from tandem.executive.system.hung_processes import Hung


class Looks:
    def __init__(self, after: float) -> None:
        self.now = 0.0
        self.hung = Hung(lambda: self.now, after)

    def look(self, seconds: float, *silent: str) -> tuple[str, ...]:
        self.now += seconds
        return self.hung.look(("a", "b"), {"a", "b"} - set(silent))


def test_who_is_silent_for_too_long_is_told_once() -> None:
    looks = Looks(1.0)
    looks.look(0.1)
    told = [looks.look(0.1, "a") for _ in range(12)]
    assert [each for each in told if each] == [("a",)]


@pytest.mark.parametrize("gap", [(), ("b",)])
def test_a_beat_in_between_begins_anew(gap: tuple[str, ...]) -> None:
    looks = Looks(1.0)
    assert not any(looks.look(0.1, *(("a",) if k % 8 else gap)) for k in range(40))


def test_nobody_is_blamed_while_the_looker_stood() -> None:
    looks = Looks(1.0)
    looks.look(0.1)
    assert not any(looks.look(30.0, "a") for _ in range(5))


def test_the_silence_of_one_who_has_gone_is_forgotten() -> None:
    looks = Looks(1.0)
    looks.look(0.1)
    assert not any(looks.look(0.1, "a") for _ in range(8))
    looks.now += 0.1
    assert looks.hung.look(("b",), ("b",)) == ()
    assert not any(looks.look(0.1, "a") for _ in range(8))
