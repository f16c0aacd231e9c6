"""What a benchmark measures: lines of one table."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """One line of the table. ``aim``: what the value should not exceed, or not fall below with ``more``."""

    what: str
    value: float
    unit: str
    aim: float | None = None
    more: bool = False
    note: str = ""
    others: float | None = None
    """Cores that everybody else on the machine kept busy meanwhile; figures taken then are worth less."""

    @property
    def ratio(self) -> float | None:
        """How the value stands to its aim: 1 or less is good either way."""
        if self.aim is None:
            return None
        low, high = (self.aim, self.value) if self.more else (self.value, self.aim)
        return low / high if high else float("inf")


def quantile(values: Iterable[float], share: float) -> float:
    """Return the value below which a share of the values lies (the nearest one there is)."""
    ordered: Sequence[float] = sorted(values)
    if not ordered:
        return float("nan")
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def spread(
    what: str, seconds: Sequence[float], *, aim: float | None = None, note: str = "", most: bool = False
) -> list[Row]:
    """Return median and p99 (with ``most`` also the maximum) of durations, in ms; the aim is the p99's."""
    count = f"of {len(seconds)}{', ' if note else ''}{note}"
    rows = [
        Row(f"{what}, median", 1e3 * quantile(seconds, 0.5), "ms", note=count),
        Row(f"{what}, p99", 1e3 * quantile(seconds, 0.99), "ms", aim),
    ]
    if most:
        rows.append(Row(f"{what}, max", 1e3 * max(seconds, default=float("nan")), "ms"))
    return rows
