"""A whole system at work, in one of its two forms, seen from whoever runs it: a demo, a campaign, a test."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from tandem.executive.system.deferred_signals import signals_later
from tandem.sim.chatter import unheard
from tandem.sim.scenario import Scenario
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.site import Site
from tandem.skills.testing.faulty_bus import BusFaults


class SystemFailure(RuntimeError):  # noqa: N818 - what happened to a system, not a mistake in a call
    """The system can't go on; the message says which process ended, with its last words."""


class LedgerFailure(SystemFailure):
    """The executive can't keep its ledger; the message says why."""


class RefusedError(RuntimeError):
    """The system must not start here; the message says why."""


class System(Protocol):
    """What both forms offer."""

    @property
    def bus(self) -> Bus:
        """An end of the bus."""
        ...

    @property
    def clocks(self) -> Clocks:
        """Robot time as heard."""
        ...

    def advance(self) -> None:
        """Let the system go on a little.

        Raises:
            SystemFailure: when a part of it has ended.
        """
        ...

    def close(self) -> None:
        """End it."""
        ...


@dataclass(frozen=True)
class RobotSystem:
    """A system as one of its robots has it, for a client of that robot. All robots go on together.

    Args:
        whole: what goes on.
        bus: an end of the robot's bus.
        clocks: the robot's.
    """

    whole: System
    bus: Bus
    clocks: Clocks

    def advance(self) -> None:
        """Let the whole system go on a little."""
        self.whole.advance()

    def close(self) -> None:
        """End the whole system."""
        self.whole.close()


class LockstepSystem:
    """All in one thread.

    Args:
        scenario: where all starts.
        seed: of all that is random.
        digest: take every message into a hash.
        site: what is known beforehand, when it is not the scenario's own site file.
        bus_faults: what happens to messages that skills and executive receive.
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int,
        *,
        digest: bool = False,
        site: Site | None = None,
        bus_faults: BusFaults | None = None,
        left_out: Mapping[str, str] | None = None,
    ) -> None:
        with unheard():
            # pybullet prints when it was built. A process that only watches others never loads it.
            from tandem.executive.system.lockstep import Digest, Lockstep  # noqa: PLC0415

            self.lockstep = Lockstep(scenario, seed, site=site, bus_faults=bus_faults, left_out=left_out)
        self._digest = Digest()
        if digest:
            self.lockstep.watch(self._digest)
        self.bus: Bus = self.lockstep.bus
        self.clocks: Clocks = self.lockstep.clocks

    def of(self, robot: str) -> RobotSystem:
        """Return the same system as one of its robots has it: with that robot's bus and clocks.

        Raises:
            KeyError: naming the robots that have an executive.
        """
        robots = self.lockstep.robots
        if robot not in robots:
            raise KeyError(f"no robot {robot!r} with an executive; there are {', '.join(robots)}")
        return RobotSystem(self, robots[robot].bus, robots[robot].clocks)

    def advance(self) -> None:
        """Let one period pass. A Ctrl-C waits for its end: in a skill, it would be the skill's mistake."""
        with signals_later():
            self.lockstep.step()

    def digest(self) -> str:
        """Return the hash over all messages so far."""
        return self._digest.hexdigest()

    def close(self) -> None:
        """End all nodes."""
        self.lockstep.close()


def wait_for(system: System, pending: Pending, within: float) -> bytes | None:
    """Let the system go on until a query has ended, at most ``within`` host (lockstep: robot) seconds."""
    deadline = system.clocks.monotonic() + within
    while pending.poll() is None and not pending.done() and system.clocks.monotonic() < deadline:
        system.advance()
    return pending.poll()
