"""The whole system in one thread: same nodes, bus in memory, all clocks from the simulated step.

The same seed gives the same run, to the last message.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence

from tandem.executive.system.roles.executive import executive_node
from tandem.executive.system.roles.registry import skill_roles
from tandem.executive.system.roles.role import Role, Surroundings
from tandem.executive.system.skill_process import nodes_of
from tandem.sim.scenario import Scenario
from tandem.sim.station import Station, StationSettings
from tandem.skills.one_boot import OneBoot
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import RobotDescription
from tandem.skills.ports.node import Node
from tandem.skills.ports.site import Site
from tandem.skills.site import load
from tandem.skills.testing.faulty_bus import BusFaults, FaultyBus
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import Kind, MemoryBus, MemoryHub
from tandem.skills.wire.workers import InlineCompute


class Digest:
    """A hash over every message on a bus: two runs are the same when theirs are."""

    def __init__(self) -> None:
        """Start with nothing."""
        self._hash = hashlib.blake2b(digest_size=16)
        self.messages = 0

    def __call__(self, kind: Kind, key: str, payload: bytes) -> None:
        """Take one message in."""
        self.messages += 1
        self._hash.update(f"{kind} {key} {len(payload)}\n".encode())
        self._hash.update(payload)

    def hexdigest(self) -> str:
        """Return the hash so far."""
        return self._hash.hexdigest()


class Lockstep:
    """Hardware, skills and executive, stepped one after the other, one hardware period at a time.

    Args:
        scenario: where things truly are.
        seed: of all noise and all planning.
        without: roles that are left out.
        site: what is known beforehand, when it is not the scenario's own site file.
        bus_faults: what happens to messages that skills and executive receive.
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int,
        *,
        without: Sequence[str] = (),
        site: Site | None = None,
        bus_faults: BusFaults | None = None,
        left_out: Mapping[str, str] | None = None,
    ) -> None:
        self.hub = MemoryHub()
        self._seed, self._bus_faults, self._left_out = seed, bus_faults, left_out
        self.clocks = SteppedClocks()
        site = load(scenario.site) if site is None else site
        how = StationSettings(boot=self.clocks.boot, seed=seed)
        self.station = Station(MemoryBus(self.hub), site, scenario, how)
        self.period = self.station.model.description.period
        self.nodes: list[Node] = [self.station]
        for role in skill_roles(self.station.model.description, left_out):
            if role.name not in without:
                self.nodes.append(self._skills(role, seed, site))
        self.bus = MemoryBus(self.hub)
        """An end of the bus for whoever runs the system."""
        if "executive" not in without:
            self.nodes.append(
                executive_node(self._end("executive"), self.clocks, site, start="", left_out=left_out)
            )

    def _skills(self, role: Role, seed: int, site: Site) -> Node:
        def build(bus: Bus, description: RobotDescription) -> Sequence[Node]:
            at = Surroundings(
                bus=bus,
                clocks=self.clocks,
                description=description,
                site=site,
                compute=InlineCompute(self.clocks),
                seed=seed,
                charge=True,
                left_out=self._left_out,
            )
            return nodes_of(role, at)

        return OneBoot(role.name, self._end(role.name), self.clocks, build, self.station.model.description)

    def _end(self, role: str) -> Bus:
        """Return an end of the bus for a role."""
        bus = MemoryBus(self.hub)
        if self._bus_faults is None:
            return bus
        return FaultyBus(bus, self.clocks, f"{self._seed}/{role}", self._bus_faults)

    @property
    def seconds(self) -> float:
        """Robot seconds since the start."""
        return self.clocks.seconds

    def step(self) -> None:
        """Let one period pass."""
        self.clocks.advance(self.period, heard=not self.station.silent)
        for node in self.nodes:
            node.step()
            if node is self.station and self.station.boot != self.clocks.boot:
                self.clocks.reboot(self.station.boot)

    def run_until(self, condition: Callable[[], bool], *, within: float) -> bool:
        """Step until the condition holds, at most ``within`` robot seconds; return whether it does."""
        end = self.clocks.seconds + within
        while not condition():
            if self.clocks.seconds >= end:
                return False
            self.step()
        return True

    def close(self) -> None:
        """End all nodes, the last one first."""
        for node in reversed(self.nodes):
            node.close()
