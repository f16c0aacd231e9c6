"""Clauses about the description as such."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Steps
from tandem.skills.ports import keys
from tandem.skills.ports.description_check import contradictions

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench


def _served(bench: Bench) -> Steps:
    bench.know((yield from bench.ask(keys.DESCRIPTION, keys.Nothing())))


def _consistent(bench: Bench) -> Steps:
    wrong = next(contradictions(bench.robot), None)
    if wrong is not None:
        raise Broken(*wrong)
    yield


SERVED: Final = Clause(
    "description_served",
    "A query on hw/description is answered with a valid description.",
    "interface.md#hardware",
    _served,
)
CLAUSES: Final = (
    SERVED,
    Clause(
        "description_consistent",
        "Names in the description are unique, hands have their groups, and postures fit their groups.",
        "extending.md#a-robot",
        _consistent,
    ),
)
