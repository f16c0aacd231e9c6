"""Carries clauses out, one after the other."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Finding, Skip, State
from tandem.executive.conformance.described import SERVED

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench

LISTENED: Final = 2.5
"""Robot seconds of listening before the first clause: what is told once a second is told twice in them."""


def run(
    clauses: Iterable[Clause], bench: Bench, wait: Callable[[], None], *, listened: float = LISTENED
) -> Iterator[Finding]:
    """Yield each clause's finding when it has ended.

    Args:
        clauses: in the order in which they are tried.
        bench: the hardware.
        wait: lets a moment pass.
        listened: robot seconds of listening before the first.
    """
    _play(Clause("", "", "", lambda bench: bench.pause(listened)), bench, wait)
    known = _play(SERVED, bench, wait)
    for clause in clauses:
        yield known if clause is SERVED else _play(clause, bench, wait)


def _play(clause: Clause, bench: Bench, wait: Callable[[], None]) -> Finding:
    """Carry a clause out and return how it ended."""
    try:
        for _ in clause.check(bench):
            wait()
            bench.step()
    except Broken as broken:
        return Finding(clause, State.FAILED, expected=broken.expected, found=broken.found)
    except Skip as skip:
        return Finding(clause, State.SKIPPED, why=str(skip))
    return Finding(clause, State.OK)
