"""What each process of a run is told: its ``WorkerSettings``, out of the options of the whole."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.config.run_options import RunOptions
from tandem.executive.system.crews import Crew
from tandem.executive.system.roles.observer import NAME as OBSERVER
from tandem.executive.system.roles.recorder import NAME as RECORDER
from tandem.executive.system.roles.skills import NAME as SKILLS
from tandem.executive.system.roles.web import NAME as WEB

KEEPERS: Final = ("keeper", SKILLS)
"""Roles that keep what no sensor can restore."""


class SettingsOfProcesses:
    """Makes the settings of each process of one run.

    Args:
        options: of the run.
        crews: of its robots.
        site: the site file that is used.
        folder: where a robot's data go that has no folder for them.
        played_by: what plays a role, by the role's name, where a campaign has it played by code of its own.
    """

    def __init__(
        self,
        options: RunOptions,
        crews: Sequence[Crew],
        *,
        site: str,
        folder: Path,
        played_by: Mapping[str, str],
    ) -> None:
        self._options, self._crews = options, crews
        self._site, self._folder, self._played_by = site, folder, played_by

    def of(self, crew: Crew, role: str) -> WorkerSettings:
        """Return what the process of a robot's role is told."""
        options, called = self._options, crew.called(role)
        data = crew.data or self._folder / crew.robot
        return WorkerSettings(
            role=role,
            unit="" if called == role else called,
            played_by=self._played_by.get(role, ""),
            endpoint=options.bus.endpoint,
            prefix=crew.prefix,
            site=self._site,
            scenario=options.scenario,
            faults=None if options.faults is None else str(options.faults),
            seed=options.seed,
            speed=options.speed,
            gui=options.gui,
            journal=str(data / "held.jsonl") if role in KEEPERS else None,
            data=str(data),
            on_restart=options.on_restart,
            verbose=options.verbose,
            log_format=options.log_format,
            metrics=self._metrics_of(crew) if role == OBSERVER else "",
            traces=options.traces if role == OBSERVER else "",
            web=options.web if role == WEB else "",
            web_of=tuple(each.robot for each in self._crews if each.robot) if role == WEB else (),
            person=options.person if role == WEB else "",
            record=_record_of(options, crew.robot) if role == RECORDER else "",
            record_pictures=options.record_pictures,
            commit=options.commit,
            silent_after=options.silent_after,
            listen=options.listen if role == "router" else (),
            left_out=options.left_out,
            prefixes=tuple(each.prefix for each in self._crews) if role == "router" else (),
            keys=None if options.bus.keys is None else str(options.bus.keys),
            holder=crew.holder(options),
        )

    def _metrics_of(self, crew: Crew) -> str:
        """Return where a robot's metrics are served: of several, each at the port after the one before."""
        if not self._options.metrics:
            return ""
        host, _, port = self._options.metrics.rpartition(":")
        return f"{host}:{int(port) + self._crews.index(crew) if int(port) else 0}"


def _record_of(options: RunOptions, robot: str) -> str:
    """Return the folder of a robot's recordings: of several robots one each."""
    return "" if options.record is None else str((options.record / robot).absolute())
