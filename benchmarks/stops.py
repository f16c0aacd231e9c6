"""How soon 200 stops and 200 cancels get through, and what was under way at those that were late.

As ``stop_latency``, over as many fetches as that takes (about 15 minutes). Late is later than the aim; how
many were is told by the goals that were under way: an arm's process answers between two slices of a plan, and
the hardware between two of its periods.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from typing import Final

from benchmarks.rows import Row, spread
from benchmarks.stop_latency import AIM, Trial, trials

EACH: Final = 200
MOST: Final = 860.0
"""Host seconds after which no more are begun."""
MOST_QUICK: Final = 10.0


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    each, most = (1, MOST_QUICK) if quick else (EACH, MOST)
    stops, cancels = trials(each, most=most)
    yield from told("from hw/stop to the hardware's answer", stops, lambda trial: trial.answered)
    yield from told("from task/cancel to the skill's CANCELING", cancels, lambda trial: trial.canceling)


def told(what: str, done: Sequence[Trial], seconds: Callable[[Trial], float | None]) -> Iterator[Row]:
    """Return median, p99 and maximum, and by what was under way how many were late."""
    heard = [(value, trial) for trial in done if (value := seconds(trial)) is not None]
    yield from spread(what, [value for value, _ in heard], aim=AIM, note="in one run", most=True)
    late = [trial for value, trial in heard if 1e3 * value > AIM]
    for goals, count in Counter(trial.goals for trial in late).most_common():
        among = sum(trial.goals == goals for _, trial in heard)
        yield Row(f"{what}: late at {goals}", count, "times", note=f"of {among} then")
