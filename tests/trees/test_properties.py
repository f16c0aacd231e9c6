"""Whatever goes wrong, and whenever a cancel comes: the rules hold. Longer: ``tandem tree properties``."""

from __future__ import annotations

import random

from hypothesis import given, settings
from hypothesis import strategies as st

from tandem.executive.trials.exploration.properties import draw, run, search
from tandem.executive.trials.exploration.worlds import fetch_worlds

WORLDS = fetch_worlds()
TICKS = 12_000


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.integers(min_value=0, max_value=2**32))
def test_any_schedule_ends_as_it_should(seed: int) -> None:
    schedule = draw(WORLDS, random.Random(seed))  # noqa: S311 - no secret hangs on it
    verdict = run(WORLDS, schedule)
    assert verdict.broken == (), schedule.words()


def test_ten_thousand_ticks_of_drawn_schedules_break_no_rule() -> None:
    told: list[str] = []
    runs, bad = search(WORLDS, ticks=TICKS, seed=1, tell=told.append)
    assert runs > 0
    assert bad == 0, told
