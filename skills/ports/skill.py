"""What a skill is: a generator that takes a goal, yields feedback and returns an outcome.

A skill is resumed by its period or by a message, whichever comes first, and each resumption may bring a
command: ``command = yield feedback``. A cancelled skill goes on yielding until the hardware is at rest
and then returns ``Outcome.canceled()``. It holds no threads, never sleeps and reads no wall clock.

See docs/decisions/002-skills-are-generators.md.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from enum import StrEnum
from typing import Generic, Protocol, TypeVar

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message

G = TypeVar("G", bound=Message)
F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)
G_contra = TypeVar("G_contra", bound=Message, contravariant=True)


class Command(StrEnum):
    """A command to a running skill."""

    GO_ON = "GO_ON"
    CANCEL = "CANCEL"
    PAUSE = "PAUSE"
    RESUME = "RESUME"


@dataclass(frozen=True)
class Slice:
    """Yielded between two slices of a computation: resume me as soon as you can.

    ``cost`` is the robot time in seconds that lockstep charges for the slice just done.
    """

    cost: float


@dataclass(frozen=True)
class Outcome(Generic[R]):
    """How a goal ended: exactly one of result, failure, canceled."""

    result: R | None = None
    failure: Failure | None = None

    @property
    def canceled(self) -> bool:
        """Whether it was cancelled and is at rest."""
        return self.result is None and self.failure is None


def succeeded(result: R) -> Outcome[R]:
    """Return a success."""
    return Outcome(result=result)


def failed(failure: Failure) -> Outcome[R]:
    """Return a failure."""
    return Outcome(failure=failure)


def canceled() -> Outcome[R]:
    """Return "cancelled, and at rest"."""
    return Outcome()


@dataclass(frozen=True)
class ActionType(Generic[G, F, R]):
    """The contract of an action: its name on the bus and its models. ``name`` may hold a side."""

    name: str
    goal: type[G]
    feedback: type[F]
    result: type[R]
    timeout: float
    """Robot seconds after which a client gives up, unless it says otherwise."""


Run = Generator[F | Slice, Command, Outcome[R]]
"""One run of a skill."""


class Skill(Protocol[G, F, R]):
    """How to do one thing."""

    @property
    def action(self) -> ActionType[G, F, R]:
        """The contract it fulfils."""
        ...

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions, at the most."""
        ...

    def check(self, goal: G) -> Failure | None:
        """Say at once why the goal can't be taken, or None. Moves nothing."""
        ...

    def run(self, goal: G, goal_id: str) -> Run[F, R]:
        """Do it."""
        ...
