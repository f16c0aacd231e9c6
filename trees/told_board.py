"""A task's board in words, for who looks on: what its leaves have decided so far."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import fields, is_dataclass
from typing import Final

from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import MOST_ON_BOARD

LONGEST: Final = 100
"""Letters of a value; what is longer is cut."""
SHOWN: Final = 4
"""Values of a list that are told; of a longer one their number too."""
DIGITS: Final = 3
"""After the point: millimetres and milliradians."""


def told_board(board: object) -> dict[str, str]:
    """Return the values by name, those of boards within one as ``left.item``; what is not set is left out.

    Args:
        board: a dataclass, or a tuple of such; anything else tells nothing.
    """
    told: dict[str, str] = {}
    for name, value in _values(board, ""):
        if len(told) == MOST_ON_BOARD:
            break
        told[name] = value if len(value) <= LONGEST else f"{value[: LONGEST - 1]}…"
    return told


def _values(board: object, before: str) -> Iterator[tuple[str, str]]:
    if isinstance(board, tuple):
        for number, each in enumerate(board):
            name = getattr(each, "side", None) or number
            yield from _values(each, f"{before}{name}.")
    elif is_dataclass(board) and not isinstance(board, type):
        for field in fields(board):
            value = getattr(board, field.name)
            if is_dataclass(value):
                yield from _values(value, f"{before}{field.name}.")
            elif words := _words(value):
                yield f"{before}{field.name}", words


def _words(value: object) -> str:
    if isinstance(value, Message):
        told = ((name, _words(getattr(value, name))) for name in type(value).model_fields)
        return ", ".join(f"{name} {words}" for name, words in told if words)
    if isinstance(value, AbstractSet):
        return _list(sorted(value, key=repr))
    if isinstance(value, Sequence) and not isinstance(value, str):
        return _list(value)
    return _plain(value)


def _plain(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{round(value, DIGITS):g}"
    if isinstance(value, str | int):
        return str(value)
    return "" if value is None else type(value).__name__


def _list(values: Sequence[object]) -> str:
    if not values:
        return ""
    numbers = all(isinstance(each, int | float) for each in values)
    joined = (", " if numbers else "; ").join(_words(each) for each in values[:SHOWN])
    more = f" and {len(values) - SHOWN} more" if len(values) > SHOWN else ""
    return f"({joined}){more}" if numbers else f"{joined}{more}"
