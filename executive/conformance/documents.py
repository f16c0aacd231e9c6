"""Clauses about documents that can't be read, and keys that nobody serves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from pydantic import ValidationError

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Answer

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench

UNREADABLE: Final = b'{"id": '
NOBODYS: Final = "no_such_part"


def _unreadable(bench: Bench) -> Steps:
    robot = bench.robot
    served = [keys.group_goal(group.name).key for group in robot.groups]
    served += [keys.gripper_command(hand).key for hand in robot.hands]
    if not served:
        raise Skip("the robot has neither groups nor hands")
    for key in served:
        reply = yield from bench.reply(key, UNREADABLE)
        if reply.nothing:
            raise Broken(f"an answer to an unreadable document on {key}", "none")
        if reply.answer is not None and _accepts(reply.answer):
            raise Broken(f"an unreadable document on {key} refused", "accepted")


def _unknown(bench: Bench) -> Steps:
    for key in (keys.group_goal(NOBODYS).key, keys.gripper_command(NOBODYS).key):
        reply = yield from bench.reply(key, b'{"id": "nobody"}', times=1)
        if reply.answer is not None:
            raise Broken(f"no answer on {key}, which is no part of the robot", "one")


def _accepts(answer: bytes) -> bool:
    try:
        return Answer.model_validate_json(answer).accepted
    except ValidationError:
        return False


CLAUSES: Final = (
    Clause(
        "unreadable_answered",
        "A document that can't be read is answered, and refused.",
        "endpoints.md",
        _unreadable,
    ),
    Clause(
        "unknown_key_unanswered",
        "A key of a part that the robot does not have is not served.",
        "interface.md#hardware",
        _unknown,
    ),
)
