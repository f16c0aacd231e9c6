"""All clauses, in the order in which they are tried: what stands still first, and stops before motions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance import (
    braking,
    clocks,
    described,
    described_urdf,
    documents,
    hands,
    joints,
    leases,
    sensors,
    states,
    stops,
    streams,
    trajectories,
)

if TYPE_CHECKING:
    from tandem.executive.conformance.clause import Clause

SUITE: Final[tuple[Clause, ...]] = (
    *described.CLAUSES,
    *described_urdf.CLAUSES,
    *clocks.CLAUSES,
    *joints.CLAUSES,
    *sensors.CLAUSES,
    *states.CLAUSES,
    *leases.CLAUSES,
    *documents.CLAUSES,
    *stops.CLAUSES,
    *trajectories.CLAUSES,
    *streams.CLAUSES,
    *hands.CLAUSES,
    *braking.CLAUSES,
)


def clause(name: str) -> Clause:
    """Return the clause; LookupError when there is none of this name."""
    for each in SUITE:
        if each.name == name:
            return each
    raise LookupError(f"no clause {name!r}")
