"""Who goes on and who hangs, by the beats that are heard; with a clock set by hand."""

from __future__ import annotations

import pytest

from tandem.skills.wire.pulse import BEAT_PERIOD, SILENT_AFTER, STALLED, Pulse

NAMES = ("executive", "skill/base/drive")


class Here:
    """A pulse that listens, its loop turned every 50 ms."""

    def __init__(self) -> None:
        self.now = 0.0
        self.pulse = Pulse(lambda: self.now)
        self.beats = 0
        self.let_pass(1.0)

    def let_pass(self, seconds: float, *, beating: tuple[str, ...] = NAMES) -> None:
        for _ in range(round(seconds / 0.05)):
            self.now += 0.05
            self.beats += self.pulse.turn()
            self.pulse.hear(beating)

    def awake(self) -> set[str]:
        return set(self.pulse.awake(NAMES))


def test_who_beats_is_awake() -> None:
    assert Here().awake() == set(NAMES)


def test_who_falls_silent_is_missed_within_the_bound() -> None:
    here = Here()
    here.let_pass(SILENT_AFTER - 0.05, beating=("executive",))
    assert here.awake() == set(NAMES)
    here.let_pass(0.1, beating=("executive",))
    assert here.awake() == {"executive"}
    here.let_pass(0.05)
    assert here.awake() == set(NAMES)


def test_who_never_beat_is_believed() -> None:
    here = Here()
    assert here.pulse.awake(("a driver of its own",)) == {"a driver of its own"}


def test_who_comes_under_an_old_name_begins_anew() -> None:
    here = Here()
    here.let_pass(1.0, beating=("executive",))
    here.pulse.forget("skill/base/drive")
    assert here.awake() == set(NAMES)


def test_who_did_not_listen_himself_blames_nobody() -> None:
    here = Here()
    here.now += 5.0
    here.pulse.turn()
    assert here.awake() == set(NAMES)
    here.let_pass(SILENT_AFTER + 0.1, beating=())
    assert here.awake() == set()


def test_a_loop_that_is_slow_but_turns_is_no_excuse() -> None:
    here = Here()
    for _ in range(5):
        here.now += STALLED - 0.01
        here.pulse.turn()
    assert here.awake() == set()


def test_own_beats_come_at_their_period() -> None:
    here = Here()
    before = here.beats
    here.let_pass(1.0)
    assert here.beats - before == pytest.approx(1.0 / BEAT_PERIOD, abs=1)


def test_who_is_listened_to_from_now_on_is_not_missed_at_once() -> None:
    now = [0.0]
    pulse = Pulse(lambda: now[0])
    pulse.hear(NAMES)
    for _ in range(20):
        now[0] += 0.05
        pulse.turn()
    assert pulse.awake(NAMES) == set()
    pulse.listen()
    assert pulse.awake(NAMES) == set(NAMES)


def test_a_loop_that_turns_at_the_period_of_beats_beats_each_turn() -> None:
    now = [0.0]
    pulse = Pulse(lambda: now[0])
    beats = 0
    for turn in range(100):
        now[0] = turn * BEAT_PERIOD + 0.02 * (turn % 2)
        beats += pulse.turn()
    assert beats == 100
