"""Work that can't be sliced goes to a worker; in lockstep it is done in place and charged."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, Protocol, TypeVar

Argument = TypeVar("Argument")
Result = TypeVar("Result")
Result_co = TypeVar("Result_co", covariant=True)


class Job(Protocol, Generic[Result_co]):
    """A piece of work under way."""

    def done(self) -> bool:
        """Say whether the result is there (in lockstep: whether its declared cost has passed)."""
        ...

    def result(self) -> Result_co:
        """Return the result, or raise what the function raised. Only when ``done``."""
        ...


class Compute(Protocol):
    """Runs a module-level function of one picklable argument beside the loop."""

    def submit(
        self, function: Callable[[Argument], Result], argument: Argument, *, cost: float
    ) -> Job[Result]:
        """Start the work.

        Args:
            function: a module-level function (a worker process imports it).
            argument: what it gets; picklable.
            cost: the robot seconds that lockstep charges for it.
        """
        ...
