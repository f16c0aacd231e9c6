"""Clauses about leases: who may command."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.bench import ROLE
from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.executive.conformance.harmless import expect_refusal
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import BaseVelocity

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.lease import Lease

TOLD_WITHIN: Final = 2.5
"""Host seconds for the table, which is told once a second."""


def _granted(bench: Bench) -> Steps:
    lease = yield from bench.leased()
    clock = bench.recording.clock
    if lease.role != ROLE:
        raise Broken(f"a lease of {ROLE}", f"one of {lease.role}")
    if clock is not None and lease.boot != clock.stamp.boot:
        raise Broken(f"a lease of boot {clock.stamp.boot}", f"one of {lease.boot}")
    again = yield from bench.ask(keys.LEASE, bench.request_lease())
    if again.lease != lease:
        raise Broken(
            "the same lease for the same claim", f"epoch {again.lease.epoch if again.lease else 'none'}"
        )


def _epoch_rises(bench: Bench) -> Steps:
    before = yield from bench.leased()
    after = yield from bench.leased(anew=True)
    if after.epoch != before.epoch + 1:
        raise Broken(f"epoch {before.epoch + 1} for a later process", f"{after.epoch}")


def _table_told(bench: Bench) -> Steps:
    lease, began = (yield from bench.leased()), bench.host_seconds
    while bench.host_seconds - began < TOLD_WITHIN:
        table = bench.recording.latest(keys.LEASES)
        held = None if table is None else table.of(ROLE)
        if held is not None and held.epoch == lease.epoch:
            return
        yield
    raise Broken(f"epoch {lease.epoch} of {ROLE} on {keys.LEASES.key}", "not told")


def _refused(bench: Bench, lease: Lease | None, of: str) -> Steps:
    """Broken unless a command under this lease is refused; a base answers none, but counts those it drops."""
    robot = bench.robot
    if robot.groups or robot.hands or robot.drive is None:
        yield from expect_refusal(bench, lease, of)
        return

    def dropped() -> int:
        table = bench.recording.latest(keys.LEASES)
        return 0 if table is None else table.refused

    before, began = dropped(), bench.host_seconds
    keys.BASE_VELOCITY.publish(bench.bus, BaseVelocity(linear=0.0, angular=0.0, lease=lease))
    while dropped() <= before:
        if bench.host_seconds - began > TOLD_WITHIN:
            raise Broken(
                f"{of} dropped, and counted in `refused` on {keys.LEASES.key}", f"{before}, as before"
            )
        yield


def _without(bench: Bench) -> Steps:
    yield from bench.leased()
    yield from _refused(bench, None, "a command without a lease")


def _old(bench: Bench) -> Steps:
    old = yield from bench.leased()
    yield from bench.leased(anew=True)
    yield from _refused(bench, old, "a command of a lower epoch")


def _other_boot(bench: Bench) -> Steps:
    lease = yield from bench.leased()
    if lease.boot == "before":
        raise Skip("the boot is called 'before'")
    yield from _refused(
        bench, lease.model_copy(update={"boot": "before"}), "a command with a lease of another boot"
    )


_WHERE: Final = "endpoints.md#presence-and-leases"
CLAUSES: Final = (
    Clause(
        "lease_granted",
        "hw/lease grants a lease of the clock's boot, and the same one again to the same claim.",
        _WHERE,
        _granted,
    ),
    Clause(
        "lease_epoch_rises",
        "A later process of one parent gets the next epoch.",
        _WHERE,
        _epoch_rises,
    ),
    Clause(
        "leases_told",
        "The table of leases is told on each change and once a second.",
        _WHERE,
        _table_told,
    ),
    Clause(
        "no_lease_refused",
        "Once any process holds a lease, a command without one is refused.",
        _WHERE,
        _without,
    ),
    Clause(
        "old_lease_refused",
        "A command with a lower epoch than the role's is refused.",
        _WHERE,
        _old,
    ),
    Clause(
        "other_boot_refused",
        "A command with a lease of another boot is refused.",
        _WHERE,
        _other_boot,
    ),
)
