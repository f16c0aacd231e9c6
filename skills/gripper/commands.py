"""The names of the commands that the hardware is sent: they tell what the hand was last told to do.

The gripper tells the name of the command that it follows, so whoever watches the hand, be it from a process
that has just started, knows whether it is to squeeze.
"""

from __future__ import annotations

from enum import StrEnum


class Order(StrEnum):
    """What the pads are told."""

    OPEN = "open"
    CLOSE = "close"
    HOLD = "hold"
    """Stand where they are."""


def name_command(goal_id: str, number: int, order: Order) -> str:
    """Return the name of a goal's command; ``number`` counts the times that it was sent anew."""
    return f"{goal_id}#{number}#{order}"


def order_of(command_id: str) -> Order | None:
    """Return what a command of that name tells the pads; None for one of another's."""
    last = command_id.rpartition("#")[2]
    return Order(last) if last in set(Order) else None
