"""Clauses about the URDF in the description."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.skills.ports.description_check import strangers_in_urdf
from tandem.skills.ports.urdf_check import UrdfError, parsed

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench


def _parses(bench: Bench) -> Steps:
    try:
        parsed(bench.robot.urdf)
    except UrdfError as error:
        raise Broken("a URDF whose joints can be believed", str(error).replace("\n", "; ")) from error
    yield


def _holds_parts(bench: Bench) -> Steps:
    robot = bench.robot
    try:
        root = parsed(robot.urdf)
    except UrdfError as error:
        raise Skip("the URDF can't be read") from error
    wrong = next(strangers_in_urdf(robot, root), None)
    if wrong is not None:
        raise Broken(*wrong)
    yield


CLAUSES: Final = (
    Clause(
        "urdf_parses",
        "The URDF is XML, and each of its joints has ends, an axis and limits that can be right.",
        "extending.md#a-robot",
        _parses,
    ),
    Clause(
        "urdf_holds_parts",
        "The URDF has each joint and frame that the description names, with base_frame as its root.",
        "extending.md#a-robot",
        _holds_parts,
    ),
)
