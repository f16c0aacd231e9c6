"""Leases: which process plays a role, and which commands are refused because theirs does not.

A process *claims* a role (``Claim``); the hardware *grants* it a lease with an epoch, one higher each time.
Every command carries the lease of its sender, and a lower epoch is refused: a process that was replaced
can't move anything, even if it lives on and does not know it. An epoch counts within one boot of the
hardware; a lease of another boot is worth nothing and is asked for anew.

This module is the arithmetic: no bus, no clock. ``tandem.skills.ports.fencing`` joins it to the bus.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.message import Count, Message

MAX_EPOCH: Final = 2**53 - 1
"""The largest whole number that every reader of JSON keeps exactly."""
KEPT_UNSEEN: Final = 1.0
"""Host seconds after a grant in which the holder counts as present although its name has not been heard: on
a busy machine the name may come after the question. Longer would keep out who replaces a holder that died at
once."""
NAME: Final = r"^[a-z][a-z0-9_]{0,63}$"
_CLAIM: Final = re.compile(r"([0-9a-z]{1,32})\.(\d{1,9})\.(\d{1,10})\.([0-9A-Za-z_-]{1,64})")

Epoch = Annotated[int, Field(ge=1, le=MAX_EPOCH)]
RoleName = Annotated[str, Field(pattern=NAME)]


@dataclass(frozen=True)
class Claim:
    """Who wants to play a role.

    Attributes:
        lineage: random name of the parent that starts the role's processes one after the other.
        generation: counts them; a later one replaces an earlier one, whose end its parent has seen.
        pid: process id, for people.
        host: where it runs, for people.
    """

    lineage: str
    generation: int
    pid: int
    host: str

    @property
    def text(self) -> str:
        """The claim as one part of a key."""
        return f"{self.lineage}.{self.generation}.{self.pid}.{self.host}"

    @classmethod
    def read(cls, text: str) -> Claim | None:
        """Return the claim that a part of a key holds; None when it holds none."""
        found = _CLAIM.fullmatch(text)
        if found is None:
            return None
        lineage, generation, pid, host = found.groups()
        return cls(lineage, int(generation), int(pid), host)

    def beats(self, other: Claim) -> bool:
        """Say whether this one stays when both are new: the later of one parent, else the lower lineage."""
        if self.lineage == other.lineage:
            return self.generation > other.generation
        return self.lineage < other.lineage

    def describe(self) -> str:
        """Return who it is, in words for people."""
        return f"process {self.pid} on {self.host}"


class Lease(Message):
    """A command's lease: its sender was the ``epoch``-th process in ``role`` in the hardware's ``boot``."""

    role: RoleName
    boot: str
    epoch: Epoch


class Leased(Message):
    """Base of commands. ``lease`` is the sender's; without one it is refused once anybody holds one."""

    lease: Lease | None = None


class LeaseRequest(Message):
    """Request the lease of a role. The same claim always gets the same lease."""

    role: RoleName
    claim: Annotated[str, Field(pattern=f"^{_CLAIM.pattern}$")]


class LeaseAnswer(Message):
    """The lease, or the reason for a refusal: then ``holder`` is the claim that has it."""

    lease: Lease | None = None
    holder: str = ""
    reason: str = ""


class Held(Message):
    """The current lease of a role."""

    role: RoleName
    epoch: Epoch
    claim: str


class Leases(Message):
    """All leases of a boot; published on each change and once a second while there are any."""

    boot: str
    held: tuple[Held, ...] = ()
    refused: Count = 0
    """Number of commands in this boot that were refused or dropped because of their lease."""

    def of(self, role: str) -> Held | None:
        """Return the role's lease."""
        return next((held for held in self.held if held.role == role), None)


@dataclass(frozen=True)
class LeaseRefusal:
    """Why a command is not obeyed."""

    reason: str
    over: bool = False
    """Whether the sender has been replaced; else it may ask for a lease and send the command again."""


def refusal_of(
    lease: Lease | None, boot: str, held: Held | None, *, others: bool = False
) -> LeaseRefusal | None:
    """Return why a command with this lease must not be obeyed; None when it may be.

    Args:
        lease: the command's.
        boot: the hardware's present one.
        held: the present lease of the role that the command is of, or None when nobody has it.
        others: whether any role has a lease: then a command without one is a stranger's.
    """
    if lease is None:
        if held is None and not others:
            return None
        return LeaseRefusal("the command carries no lease; ask for one on hw/lease and send it along")
    if lease.boot != boot:
        return LeaseRefusal(
            f"the lease is of boot {lease.boot}, the hardware's is {boot}; ask for a lease anew"
        )
    if held is not None and lease.epoch < held.epoch:
        claim = Claim.read(held.claim)
        by = "another process" if claim is None else claim.describe()
        text = f"{lease.role} epoch {lease.epoch} is over: {by} plays the role, in epoch {held.epoch}"
        return LeaseRefusal(text, over=True)
    return None


@dataclass
class _Entry:
    """A role's present lease in the book, and when (host seconds) it was granted."""

    held: Held
    since: float


@dataclass
class LeaseBook:
    """The one place that grants leases, for one boot.

    Per role the epoch only rises, and only the last one granted is obeyed.
    """

    boot: str
    refused: int = 0
    _entries: dict[str, _Entry] = field(default_factory=dict)

    def ask(self, asked: LeaseRequest, present: frozenset[str], now: float) -> LeaseAnswer:
        """Grant a lease, or say who has it.

        Args:
            asked: by whom, for which role.
            present: claims that are announced as players of the role.
            now: monotonic host seconds.
        """
        entry, claim = self._entries.get(asked.role), Claim.read(asked.claim)
        if claim is None:
            return LeaseAnswer(reason=f"{asked.claim!r} is no claim")
        if entry is None:
            return self._grant(asked, 1, now)
        holder = Claim.read(entry.held.claim)
        if holder == claim:
            return LeaseAnswer(lease=self._lease(entry.held))
        if holder is not None and holder.lineage == claim.lineage:
            replaces = claim.beats(holder)
        else:
            replaces = entry.held.claim not in present and now - entry.since > KEPT_UNSEEN
        if replaces:
            return self._grant(asked, entry.held.epoch + 1, now)
        by = entry.held.claim if holder is None else holder.describe()
        return LeaseAnswer(holder=entry.held.claim, reason=f"{by} has the lease of {asked.role}")

    def refuse(self, command: Leased) -> LeaseRefusal | None:
        """Return why the command must not be obeyed, and count it; None when it may be."""
        lease = command.lease
        entry = None if lease is None else self._entries.get(lease.role)
        held = None if entry is None else entry.held
        refusal = refusal_of(lease, self.boot, held, others=bool(self._entries))
        if refusal is None and lease is not None and (held is None or lease.epoch > held.epoch):
            text = f"{lease.role} epoch {lease.epoch} was never granted; ask for a lease on hw/lease"
            refusal = LeaseRefusal(text)
        if refusal is not None:
            self.refused += 1
        return refusal

    def table(self) -> Leases:
        """Return all that is granted."""
        held = tuple(entry.held for _, entry in sorted(self._entries.items()))
        return Leases(boot=self.boot, held=held, refused=self.refused)

    def _grant(self, asked: LeaseRequest, epoch: int, now: float) -> LeaseAnswer:
        held = Held(role=asked.role, epoch=epoch, claim=asked.claim)
        self._entries[asked.role] = _Entry(held, now)
        return LeaseAnswer(lease=self._lease(held))

    def _lease(self, held: Held) -> Lease:
        return Lease(role=held.role, boot=self.boot, epoch=held.epoch)


@dataclass
class Fence:
    """What one who is commanded by a role, but grants nothing, knows of the role's lease.

    It learns from the table and from the commands themselves: one of a higher epoch proves that it was
    granted.
    """

    role: str
    boot: str = ""
    held: Held | None = None
    refused: int = 0

    def learn(self, table: Leases) -> None:
        """Take in what was granted. A table that is older than what is known changes nothing."""
        told = table.of(self.role)
        if table.boot != self.boot:
            self.boot, self.held = table.boot, told
        elif told is not None and (self.held is None or told.epoch >= self.held.epoch):
            self.held = told

    def refuse(self, lease: Lease | None) -> LeaseRefusal | None:
        """Return why a command with this lease must not be obeyed, and count it; None when it may be."""
        if lease is not None and not self.boot:
            self.boot = lease.boot
        if lease is not None and lease.role != self.role:
            refusal: LeaseRefusal | None = LeaseRefusal(
                f"expected a lease of {self.role}, not one of {lease.role}"
            )
        else:
            refusal = refusal_of(lease, self.boot, self.held)
        if refusal is not None:
            self.refused += 1
        elif lease is not None and (self.held is None or lease.epoch > self.held.epoch):
            self.held = Held(role=self.role, epoch=lease.epoch, claim="")
        return refusal

    def is_over(self, lease: Lease | None) -> bool:
        """Say whether what was begun under this lease has lost its owner to a later one of the same boot."""
        held = self.held
        return lease is not None and held is not None and lease.boot == self.boot and lease.epoch < held.epoch


def claim_name(role: str, claim: Claim) -> str:
    """Return the name under which a settled player of a role is announced."""
    return f"role/{role}/{claim.text}"


def present_claims(names: frozenset[str], role: str) -> frozenset[str]:
    """Return the claims that are announced as players of a role."""
    start = f"role/{role}/"
    return frozenset(name.removeprefix(start) for name in names if name.startswith(start))
