"""What a clause is, and how it may end."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench

Steps = Generator[None, None, None]
"""What a clause does: each ``yield`` lets the hardware go on for a moment."""


class Broken(Exception):  # noqa: N818 - a finding, not an error of this program
    """The hardware does not keep the clause.

    Args:
        expected: what the clause requires here.
        found: what the hardware did instead.
    """

    def __init__(self, expected: str, found: str) -> None:
        super().__init__(f"expected {expected}, found {found}")
        self.expected, self.found = expected, found


class Skip(Exception):  # noqa: N818 - as Broken
    """The clause says nothing about this robot, or can't be tried now; the text says why."""


class State(StrEnum):
    """How a clause ended."""

    OK = "ok"
    FAILED = "failed"
    SKIPPED = "skipped"


@dataclass(frozen=True)
class Clause:
    """One promise of the hardware.

    Attributes:
        name: for people and programs.
        requires: the promise, one sentence.
        where: the page that makes it, relative to ``docs/``.
        check: tries it; returns when it is kept.
        moving: whether trying it moves something.
        interrupts: whether trying it stops a robot at work, though it moves nothing.
    """

    name: str
    requires: str
    where: str
    check: Callable[[Bench], Steps]
    moving: bool = False
    interrupts: bool = False


@dataclass(frozen=True)
class Finding:
    """How a clause ended: ``expected`` and ``found`` if it failed, ``why`` if it was skipped."""

    clause: Clause
    state: State
    expected: str = ""
    found: str = ""
    why: str = ""
