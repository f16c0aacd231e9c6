"""The pipeline of one resource: who commands it now, at which of two priorities (RoCS paper, 5.1).

A goal of the tree claims the resource at normal priority. A reflex overrides it at high priority, at once:
the claim is void from that moment, what its holder still sends goes nowhere, and its goal ends as
``OVERRIDDEN``. Among reflexes the higher rank wins. All of it happens in the process of the resource's owner.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tandem.skills.ports.failure import Failure, FailureKind

MayCommand = Callable[[], bool]


@dataclass(frozen=True)
class Override:
    """A reflex that has a resource: its rank, and what it saw."""

    reflex: str
    rank: int
    why: Failure


class Pipeline:
    """Who has a resource.

    Args:
        resource: its name, such as ``base``.
    """

    def __init__(self, resource: str) -> None:
        self.resource = resource
        self.holder = ""
        """The action that has it at normal priority."""
        self.override: Override | None = None
        """The reflex that has it."""
        self.doing: tuple[str, ...] = ()
        """The action at work, outermost first."""
        self.overridden = 0
        """Claims that reflexes have ended."""
        self.claims = 0
        """Claims there have been: a reflex sees by it that another goal has begun."""
        self._taken = 0
        self._last: Override | None = None
        self._ends: Callable[[], None] = _nothing

    def claim(self, action: str, ends: Callable[[], None] | None = None) -> bool:
        """Take it at normal priority; False while another action, or a reflex, has it.

        Args:
            action: what takes it.
            ends: brings to rest what the action moves. Called when a reflex takes the resource, before the
                reflex commands anything; without it, what the action still sends must go nowhere
                (``normal``).
        """
        if self.override is not None or self.holder not in {"", action}:
            return False
        self.holder, self._ends = action, ends or _nothing
        self.claims += 1
        return True

    def release(self, action: str) -> None:
        """Give it back; nothing happens when the action has it no more."""
        if self.holder == action:
            self.holder, self.doing, self._ends = "", (), _nothing

    def yields_to(self, reflex: str, rank: int) -> bool:
        """Say whether a reflex of that rank may take it."""
        return self.override is None or self.override.reflex == reflex or self.override.rank < rank

    def take(self, override: Override) -> None:
        """Take it at high priority, from whoever has it; only ``take_all`` calls this."""
        if self.holder:
            self.overridden += 1
        ends, self._ends = self._ends, _nothing
        self.holder, self.doing = "", ()
        self.override = self._last = override
        self._taken += 1
        ends()

    def let_go(self, reflex: str) -> None:
        """Give it back to the tree; nothing happens when another reflex has it by now."""
        if self.override is not None and self.override.reflex == reflex:
            self.override, self.doing = None, ()

    def normal(self, action: str) -> MayCommand:
        """Return what says whether the action may still command the resource, under its present claim."""
        claim = self.claims
        return lambda: self.override is None and self.holder == action and self.claims == claim

    def high(self, reflex: str) -> MayCommand:
        """Return what says whether the reflex has the resource."""
        return lambda: self.has(reflex)

    def has(self, reflex: str) -> bool:
        """Say whether the reflex has the resource."""
        return self.override is not None and self.override.reflex == reflex

    def mark(self) -> int:
        """Return what ``taken_since`` compares with."""
        return self._taken

    def taken_since(self, mark: int, where: str) -> Failure | None:
        """Return the end of a goal that began at ``mark``, if a reflex has taken the resource since."""
        last = self._last
        if last is None or self._taken == mark:
            return None
        return Failure(
            kind=FailureKind.OVERRIDDEN,
            message=f"reflex {last.reflex} took the {self.resource}: {last.why.message}",
            where=where,
            evidence={"reflex": last.reflex, **last.why.evidence},
            causes=(last.why,),
        )

    def busy(self, where: str) -> Failure | None:
        """Return why no goal can begin now, or None."""
        if self.override is not None:
            said = f"reflex {self.override.reflex} has the {self.resource}: {self.override.why.message}"
            return Failure(
                kind=FailureKind.BUSY,
                message=said,
                where=where,
                evidence={"reflex": self.override.reflex},
                causes=(self.override.why,),
            )
        if self.holder:
            return Failure(
                kind=FailureKind.BUSY, message=f"{self.holder} has the {self.resource}", where=where
            )
        return None


def _nothing() -> None:
    """End nothing."""


def take_all(pipelines: Sequence[Pipeline], override: Override) -> bool:
    """Take all of the resources, or none: False when a reflex of the same rank or a higher one has any."""
    if not all(each.yields_to(override.reflex, override.rank) for each in pipelines):
        return False
    for each in pipelines:
        each.take(override)
    return True
