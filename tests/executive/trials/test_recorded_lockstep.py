"""A run in lockstep repeats its record; where it does not, the first message that differs is told."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.recording import Facts, Recording, open_recording
from tandem.executive.records.recording_sink import RecordingSink
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.campaigns.recording import HeldRuns, RecordedRuns
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
        advance(system, periods)
    finally:
        system.close()


def advance(system: LockstepSystem, periods: int) -> None:
    for _ in range(periods):
        system.advance()


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


def test_a_run_of_a_campaign_is_recorded_with_pictures_and_repeats_its_record(tmp_path: Path) -> None:
    system = RecordedRuns(tmp_path, "fetch", "Demo", seed=1).system(load_scenario("Demo"), 1000, 0)
    advance(system, 80)
    system.close()
    (path,) = tmp_path.glob("fetch-0000/*.mcap")
    record = open_recording(path)
    assert [each.key for each in record.pictures()]
    held = HeldRuns(record, 0.5).system(load_scenario("Demo"), 1000, 0)
    with pytest.raises(ReachedError, match="the run is as recorded") as reached:
        advance(held, 80)
    held.close()
    assert reached.value.same
    record.close()
