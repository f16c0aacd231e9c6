"""The file of ``--faults``: what goes wrong on purpose, besides the scenario's own faults."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from tandem.sim.faults import BumperPressed, Fault, JointStall, RangeSilent, RangeStuck
from tandem.sim.scene import fault_problems
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import DocumentError, Source
from tandem.skills.testing.faulty_bus import BusFaults
from tandem.skills.yaml_file import read_document, validate


class FaultFile(Message):
    """Faults of robot and room, and of the bus between the processes."""

    faults: tuple[Fault, ...] = ()
    bus: BusFaults | None = None
    """Of what skills and executive receive; the hardware's own end stays sound."""


def load_faults(path: str | Path, site: Site) -> FaultFile:
    """Return what a YAML file says.

    Args:
        path: of the file.
        site: has the names of the items.

    Raises:
        DocumentError: with one line for each mistake: file, path and line in it, what was expected.
    """
    return _read(path, site)[0]


def _read(path: str | Path, site: Site) -> tuple[FaultFile, Source]:
    data, source = read_document(Path(path))
    if not isinstance(data, dict):
        raise DocumentError(f"{source.name}: expected a mapping with faults: [...], bus: {{...}} or both")
    return validate(data, source, FaultFile, knowing=site), source


def check_faults(path: str | Path, site: Site, robots: Mapping[str, str]) -> FaultFile:
    """Return what a file says, when its faults fit the site and the robots: kinds by name, the first first.

    Raises:
        DocumentError: as ``load_faults``.
    """
    file, source = _read(path, site)
    if problems := fault_problems(site, file.faults, source, tuple(robots)):
        raise DocumentError("\n".join(problems))
    if any(isinstance(fault, JointStall | BumperPressed | RangeSilent | RangeStuck) for fault in file.faults):
        # Only what names joints or sensors needs the robot, which takes a moment to be put together.
        from tandem.sim.defects import check_faults as check_parts  # noqa: PLC0415
        from tandem.sim.robots.registry import robot_model  # noqa: PLC0415

        described = {name: robot_model(robot).description for name, robot in robots.items()}
        check_parts(file.faults, described, source=source)
    return file
