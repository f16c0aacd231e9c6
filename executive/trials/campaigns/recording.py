"""Runs of a campaign that are recorded, and one that is held to its record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final, Protocol

from tandem.executive.config.fault_file import FaultFile
from tandem.executive.config.run_options import DEFAULT_ROBOT, DEFAULT_SITE
from tandem.executive.records.process import release
from tandem.executive.records.recording import Facts, Recording
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.recorded_lockstep import HeldTo, RecordedLockstep
from tandem.sim.scenario import Scenario
from tandem.skills.testing.faulty_bus import BusFaults
from tandem.skills.wire.clocks import HostClocks

if TYPE_CHECKING:
    from tandem.executive.records.mcap_writing import McapFile


class Runs(Protocol):
    """Makes the system of a run."""

    def system(
        self, scenario: Scenario, seed: int, run: int, bus_faults: BusFaults | None = None
    ) -> LockstepSystem:
        """Return the system.

        Args:
            scenario: as it was drawn for the run, with its faults.
            seed: of all that is random in the run.
            run: its number.
            bus_faults: what happens to messages.
        """
        ...


@dataclass(frozen=True)
class Unrecorded:
    """Runs that nobody records; implements ``Runs``."""

    def system(
        self, scenario: Scenario, seed: int, run: int, bus_faults: BusFaults | None = None
    ) -> LockstepSystem:
        """Return the system."""
        del run
        return LockstepSystem(scenario, seed, digest=True, bus_faults=bus_faults)


UNRECORDED: Final = Unrecorded()


@dataclass(frozen=True)
class RecordedRuns:
    """Runs that are recorded, each into a folder of its own; implements ``Runs``.

    Args:
        folder: in which these folders are made.
        campaign: what the runs are of, as in ``Facts.campaign``.
        scenario: of which they are drawn, by name or path.
        seed: of the campaign.
        commit: of the checkout; empty: not known.
        pictures: whether the cameras' pictures are recorded.
    """

    folder: Path
    campaign: str
    scenario: str
    seed: int
    commit: str = ""
    pictures: bool = True

    def system(
        self, scenario: Scenario, seed: int, run: int, bus_faults: BusFaults | None = None
    ) -> LockstepSystem:
        """Return the system; its file ends when it is closed."""
        from tandem.executive.records.foxglove_view import FoxgloveView  # noqa: PLC0415 - of the extra `record`
        from tandem.executive.records.json_schemas import JsonSchemas  # noqa: PLC0415
        from tandem.executive.records.recording_sink import RecordingSink  # noqa: PLC0415

        facts = self.facts(scenario, run, bus_faults)
        sink = RecordingSink(
            self.folder / f"{self.campaign}-{run:04d}",
            facts,
            HostClocks(),
            schema_of=JsonSchemas().of,
            tell=lambda _: None,
            shows=FoxgloveView(),
        )
        return RecordedLockstep(
            scenario,
            seed,
            facts=facts,
            sinks=(sink,),
            bus_faults=bus_faults,
            digest=True,
            write_pictures=sink.also if self.pictures else None,
        )

    def facts(self, scenario: Scenario, run: int, bus_faults: BusFaults | None) -> Facts:
        """Return what the record of a run is of."""
        faults = FaultFile(faults=scenario.faults, bus=bus_faults)
        return Facts(
            site=DEFAULT_SITE,
            robot=DEFAULT_ROBOT,
            scenario=self.scenario,
            seed=self.seed,
            lockstep=True,
            campaign=self.campaign,
            run=run,
            faults="" if faults == FaultFile() else faults.model_dump_json(exclude_none=True),
            pictures=self.pictures,
            release=release(),
            commit=self.commit,
            began=0.0,
        )


@dataclass(frozen=True)
class HeldRuns:
    """A run that is held to its record; implements ``Runs``.

    Args:
        record: of the run.
        until: robot seconds at which it is enough.
    """

    record: Recording
    until: float

    def system(
        self, scenario: Scenario, seed: int, run: int, bus_faults: BusFaults | None = None
    ) -> LockstepSystem:
        """Return the system; it ends with a ``ReachedError``."""
        del run
        return RecordedLockstep(
            scenario,
            seed,
            facts=self.record.facts,
            sinks=(HeldTo(self.record, self.until),),
            bus_faults=bus_faults,
            digest=True,
            write_pictures=_drop if self.record.facts.pictures else None,
        )


def _drop(_: Callable[[McapFile], None]) -> None:
    """Write no picture: the record has it."""
