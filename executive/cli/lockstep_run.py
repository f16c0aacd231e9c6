"""A run in lockstep as its options say: alone, recorded, or held to a record."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from tandem.executive.config.fault_file import load_faults
from tandem.executive.config.run_options import RunOptions
from tandem.executive.records.process import release
from tandem.executive.records.recorder import Sink
from tandem.executive.records.recording import Facts, open_recording
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.provenance import checkout
from tandem.executive.trials.recorded_lockstep import HeldTo, RecordedLockstep
from tandem.sim.scenario import Scenario, load_scenario
from tandem.skills.site import load
from tandem.skills.testing.faulty_bus import BusFaults
from tandem.skills.wire.clocks import HostClocks


@contextmanager
def lockstep_of(
    options: RunOptions, scenario: Scenario, bus_faults: BusFaults | None
) -> Iterator[LockstepSystem]:
    """Return the system; it ends with the context.

    Raises:
        RecordError: when the record that it is to be held to can't be used.
    """
    record = None if options.again is None else open_recording(options.again)
    try:
        sink: Sink | None = _recording(options) if options.record is not None else None
        if record is not None:
            sink = HeldTo(record, options.again_until)
        system = _system(options, scenario, bus_faults, sink)
        try:
            yield system
        finally:
            system.close()
    finally:
        if record is not None:
            record.close()


def _system(
    options: RunOptions, scenario: Scenario, bus_faults: BusFaults | None, sink: Sink | None
) -> LockstepSystem:
    if sink is None:
        return LockstepSystem(scenario, options.seed, bus_faults=bus_faults, left_out=options.left_out)
    return RecordedLockstep(
        scenario,
        options.seed,
        facts=facts_of(options),
        sinks=(sink,),
        bus_faults=bus_faults,
        left_out=options.left_out,
    )


def facts_of(options: RunOptions) -> Facts:
    """Return what the record of a run in lockstep is of."""
    return Facts(
        site=options.bus.site,
        robot=options.bus.robot,
        scenario=options.scenario,
        seed=options.seed,
        lockstep=True,
        request=options.request,
        faults=_faults(options),
        release=release(),
        commit=checkout()[0],
        began=0.0,
    )


def _faults(options: RunOptions) -> str:
    """Return the file of faults as JSON; empty when there is none."""
    if options.faults is None:
        return ""
    site = load(load_scenario(options.scenario, options.site).site)
    return load_faults(options.faults, site).model_dump_json(exclude_none=True)


def _recording(options: RunOptions) -> Sink:
    from tandem.executive.records.foxglove_view import FoxgloveView  # noqa: PLC0415 - of the extra `record`
    from tandem.executive.records.json_schemas import JsonSchemas  # noqa: PLC0415
    from tandem.executive.records.recording_sink import RecordingSink  # noqa: PLC0415

    assert options.record is not None, "asked by who knows"
    return RecordingSink(
        options.record,
        facts_of(options),
        HostClocks(),
        schema_of=JsonSchemas().of,
        tell=lambda _: None,
        shows=FoxgloveView(),
    )
