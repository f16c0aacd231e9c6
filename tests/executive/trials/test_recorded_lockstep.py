"""A run in lockstep repeats its record; where it does not, the first message that differs is told."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.recording import Facts, Recording, open_recording
from tandem.executive.records.recording_sink import RecordingSink
from tandem.executive.trials.recorded_lockstep import HeldTo, ReachedError, RecordedLockstep
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.records import RecordingState
from tandem.skills.wire.clocks import SteppedClocks

pytestmark = [pytest.mark.lockstep, pytest.mark.thorough]
FACTS = Facts(site="lab", robot="tiago", release="0", began=0.0, lockstep=True)


def run(record: Recording | None, sink: RecordingSink | None, *, seed: int, periods: int) -> None:
    held = HeldTo(record, 0.5) if record is not None else sink
    assert held is not None
    system = RecordedLockstep(load_scenario("Demo"), seed, facts=FACTS, sinks=(held,))
    try:
        for _ in range(periods):
            system.advance()
    finally:
        system.close()


@pytest.fixture(scope="module")
def record(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Recording]:
    told: list[RecordingState] = []
    folder = tmp_path_factory.mktemp("run")
    sink = RecordingSink(folder, FACTS, SteppedClocks(), schema_of=JsonSchemas().of, tell=told.append)
    run(None, sink, seed=1, periods=80)
    made = open_recording(Path(told[0].file))
    yield made
    made.close()


def test_the_same_seed_repeats_the_record(record: Recording) -> None:
    with pytest.raises(ReachedError, match=r"the run is as recorded up to 0\.51 s") as reached:
        run(record, None, seed=1, periods=80)
    assert reached.value.same


def test_another_seed_is_told_from_it(record: Recording) -> None:
    with pytest.raises(ReachedError, match="the run differs from the record at") as reached:
        run(record, None, seed=2, periods=80)
    assert not reached.value.same


def test_cameras_are_heard_where_pictures_are_written() -> None:
    taken: list[Callable[[McapFile], None]] = []
    system = RecordedLockstep(load_scenario("Demo"), 1, facts=FACTS, sinks=(), write_pictures=taken.append)
    for _ in range(60):
        system.advance()
    system.close()
    assert taken
