"""A goal that has the wheels: taken before it begins, given back however it ends."""

from __future__ import annotations

from typing import TypeVar

from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.wheels import Wheels
from tandem.skills.ports.actions.base import BaseState
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import Run, failed

F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)


def with_wheels(
    run: Run[F, R], board: BaseStatusBoard, wheels: Wheels, action: str, serves_item: int | None = None
) -> Run[F, R]:
    """Do a run of a skill with the wheels; it fails as BUSY when an action or a reflex has them.

    Args:
        run: what drives; it has not begun yet.
        board: who has the wheels.
        wheels: what the run commands; they are told to stand if it ends on the way.
        action: the skill's name.
        serves_item: for which item it drives, if any.
    """
    busy = board.pipeline.busy(action)
    if busy is not None:
        run.close()
        return failed(busy)
    board.claim(action, serves_item)
    state = BaseState.BASE_GOAL_FAIL
    try:
        outcome = yield from run
        if outcome.canceled:
            state = BaseState.BASE_IDLE
        elif outcome.result is not None:
            state = BaseState.BASE_GOAL_OK
        return outcome
    finally:
        if not wheels.resting:
            wheels.halt()
        board.release(action, state)
