"""The file of ``--faults``: what goes wrong on purpose, besides the scenario's own faults."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from sim.faults import Fault, JointStall
from sim.scenario import ScenarioError, mistakes, read_yaml
from sim.scene import fault_problems
from skills.ports.message import Message
from skills.ports.site import Site
from skills.testing.faulty_bus import BusFaults


class FaultFile(Message):
    """Faults of robot and room, and of the bus between the processes."""

    faults: tuple[Fault, ...] = ()
    bus: BusFaults | None = None
    """Of what skills and executive receive; the hardware's own end stays sound."""


def load_faults(path: str | Path) -> FaultFile:
    """Return what a YAML file says.

    Raises:
        ScenarioError: with one line for each mistake: file, path in it, what was expected.
    """
    document, source = read_yaml(Path(path))
    if not isinstance(document, dict):
        raise ScenarioError(f"{source}: a mapping with faults: [...], bus: {{...}} or both was expected")
    try:
        return FaultFile.model_validate(document)
    except ValidationError as error:
        raise ScenarioError("\n".join(mistakes(error, source))) from error


def check_faults(path: str | Path, site: Site) -> FaultFile:
    """Return what a file says, when its faults fit the site and the robot.

    Raises:
        ScenarioError: as ``load_faults``.
    """
    file = load_faults(path)
    problems = fault_problems(site, file.faults, str(path))
    if problems:
        raise ScenarioError("\n".join(problems))
    if any(isinstance(fault, JointStall) for fault in file.faults):
        # Only what names joints needs the robot, which takes a moment to be put together.
        from sim.defects import check_faults as check_joints  # noqa: PLC0415
        from sim.robot import compose_robot  # noqa: PLC0415

        check_joints(file.faults, compose_robot().description, source=str(path))
    return file
