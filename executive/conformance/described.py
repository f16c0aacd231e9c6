"""Clauses about the description as such."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Steps
from tandem.skills.ports import keys

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.robot_description import RobotDescription

ARM_POSTURES: Final = ("home", "carry")
SLACK: Final = 1e-3
"""rad or m by which a posture may lie beyond a limit: as much as a rounded number is off."""


def _served(bench: Bench) -> Steps:
    bench.know((yield from bench.ask(keys.DESCRIPTION, keys.Nothing())))


def _consistent(bench: Bench) -> Steps:
    wrong = next(_contradictions(bench.robot), None)
    if wrong is not None:
        raise Broken(*wrong)
    yield


def _contradictions(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    for what, names in (
        ("group", (group.name for group in robot.groups)),
        ("hand", robot.hands),
        ("joint", _joints(robot)),
    ):
        twice = [name for name, count in Counter(names).items() if count > 1]
        if twice:
            yield f"each {what} once", f"{', '.join(twice)} several times"
    yield from _of_hands(robot)
    yield from _of_postures(robot)
    for laser in robot.lasers:
        if not 0.0 <= laser.range_min < laser.range_max:
            yield f"{laser.name}: range_min below range_max", f"{laser.range_min:g} and {laser.range_max:g}"


def _of_hands(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    groups = {group.name for group in robot.groups}
    for hand in robot.end_effectors:
        if hand.group not in groups or hand.group != f"arm_{hand.side}":
            yield f"a group arm_{hand.side} that carries hand {hand.side}", f"group {hand.group!r}"
        having = {posture.name for posture in robot.postures if posture.group == hand.group}
        if lacking := [name for name in ARM_POSTURES if name not in having]:
            yield f"postures home and carry of {hand.group}", f"no {lacking[0]}"


def _of_postures(robot: RobotDescription) -> Iterator[tuple[str, str]]:
    groups = {group.name: group for group in robot.groups}
    for posture in robot.postures:
        group = groups.get(posture.group)
        who = f"posture {posture.name} of {posture.group}"
        if group is None or len(posture.positions) != len(group.limits):
            yield (
                f"{who}: a group, and a position of each of its joints",
                f"{len(posture.positions)} positions",
            )
            continue
        for limit, position in zip(group.limits, posture.positions, strict=True):
            if not limit.lower - SLACK <= position <= limit.upper + SLACK:
                yield f"{who}: {limit.joint} from {limit.lower:g} to {limit.upper:g}", f"{position:g}"


def _joints(robot: RobotDescription) -> Iterable[str]:
    yield from (joint for group in robot.groups for joint in group.joints)
    yield from (joint for hand in robot.end_effectors for joint in hand.gripper.joints)


SERVED: Final = Clause(
    "description_served",
    "A query on hw/description is answered with a valid description.",
    "interface.md#hardware",
    _served,
)
CLAUSES: Final = (
    SERVED,
    Clause(
        "description_consistent",
        "Names in the description are unique, hands have their groups, and postures fit their groups.",
        "extending.md#a-robot",
        _consistent,
    ),
)
