"""The whole system in one thread: same nodes, bus in memory, all clocks from the simulated step.

The same seed gives the same run, to the last message.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

from tandem.executive.system.roles.executive import executive_node
from tandem.executive.system.roles.registry import skill_roles
from tandem.executive.system.roles.role import Role, Surroundings
from tandem.executive.system.skill_process import nodes_of
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.starts import ALONE
from tandem.sim.station import Station, StationSettings
from tandem.skills.one_boot import OneBoot
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
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


@dataclass(frozen=True)
class LockstepRobot:
    """One robot of a lockstep: its own bus, clocks, skills and executive; nothing of it is another's.

    Args:
        name: as the scenario has it.
        hub: what travels on its keys.
        clocks: what it knows of the time.
        nodes: its skills and its executive, in the order in which they are stepped.
    """

    name: str
    hub: MemoryHub
    clocks: SteppedClocks
    nodes: tuple[Node, ...]

    @cached_property
    def bus(self) -> Bus:
        """An end of its bus for whoever runs the system."""
        return MemoryBus(self.hub)


class Lockstep:
    """Hardware, skills and executives, stepped one after the other, one hardware period at a time.

    The hardware of all robots goes first, then robot by robot, in the scenario's order, its skills and its
    executive. ``hub``, ``bus`` and ``clocks`` are those of the first robot.

    Args:
        scenario: where things truly are.
        seed: of all noise and all planning.
        without: roles that are left out.
        site: what is known beforehand, when it is not the scenario's own site file.
        bus_faults: what happens to messages that skills and executives receive.
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.

    Raises:
        ScenarioError: when the scenario does not fit the site, or no robot in it has an executive.
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
        self._seed, self._bus_faults, self._left_out = seed, bus_faults, left_out
        self._site = load(scenario.site) if site is None else site
        driven = [each.name for each in scenario.placed if each.drives == "executive"]
        if not driven:
            raise ScenarioError(f"{scenario.name}: robots: expected one with drives: executive, found none")
        hubs = {name: MemoryHub() for name in driven}
        clocks = {name: SteppedClocks() for name in driven}
        self.commons = MemoryHub()
        """What travels on the keys that all robots of the site share."""
        how = StationSettings(boot=clocks[driven[0]].boot, seed=seed)
        buses = {name: MemoryBus(hub) for name, hub in hubs.items()}
        self.station = Station(buses, self._site, scenario, how)
        self.period = self.station.model.description.period
        self.robots: dict[str, LockstepRobot] = {
            name: LockstepRobot(
                name, hubs[name], clocks[name], self._nodes(name, hubs[name], clocks[name], without)
            )
            for name in driven
        }
        """Those that have an executive, by name."""
        self.nodes: list[Node] = [
            self.station,
            *(node for robot in self.robots.values() for node in robot.nodes),
        ]

    @property
    def hub(self) -> MemoryHub:
        """What travels on the first robot's keys."""
        return self._first.hub

    @property
    def bus(self) -> Bus:
        """An end of the first robot's bus for whoever runs the system."""
        return self._first.bus

    @property
    def clocks(self) -> SteppedClocks:
        """The first robot's clocks."""
        return self._first.clocks

    @property
    def _first(self) -> LockstepRobot:
        return next(iter(self.robots.values()))

    def watch(self, digest: Digest) -> None:
        """Have a digest take in every message: of several robots, with the robot's name before the key."""
        for name, robot in self.robots.items():
            robot.hub.watch(digest if len(self.robots) == 1 else partial(_named, digest, name))

    def _nodes(
        self, name: str, hub: MemoryHub, clocks: SteppedClocks, without: Sequence[str]
    ) -> tuple[Node, ...]:
        end = partial(self._end, name, hub, clocks)
        description = self.station.robots[name].model.description
        nodes: list[Node] = [
            self._skills(role, name, end(role.name), clocks, description)
            for role in skill_roles(description, self._left_out)
            if role.name not in without
        ]
        if "executive" not in without:
            left_out = self._left_out
            bus, commons = end("executive"), MemoryBus(self.commons)
            nodes.append(
                executive_node(
                    bus, clocks, self._site, start="", left_out=left_out, commons=commons, robot=name
                )
            )
        return tuple(nodes)

    def _skills(
        self, role: Role, robot: str, bus: Bus, clocks: SteppedClocks, description: RobotDescription
    ) -> Node:
        def build(bus: Bus, description: RobotDescription) -> Sequence[Node]:
            at = Surroundings(
                bus=bus,
                clocks=clocks,
                description=description,
                site=self._site,
                compute=InlineCompute(clocks),
                seed=self._seed,
                charge=True,
                left_out=self._left_out,
                commons=MemoryBus(self.commons),
                robot=robot,
            )
            return nodes_of(role, at)

        return OneBoot(role.name, bus, clocks, build, description)

    def _end(self, robot: str, hub: MemoryHub, clocks: SteppedClocks, role: str) -> Bus:
        """Return an end of a robot's bus for a role."""
        bus = MemoryBus(hub)
        if self._bus_faults is None:
            return bus
        who = role if robot == ALONE else f"{robot}/{role}"
        return FaultyBus(bus, clocks, f"{self._seed}/{who}", self._bus_faults)

    @property
    def seconds(self) -> float:
        """Robot seconds since the start."""
        return self.clocks.seconds

    def step(self) -> None:
        """Let one period pass."""
        for name, robot in self.robots.items():
            robot.clocks.advance(self.period, heard=not self.station.robots[name].silent)
        for node in self.nodes:
            node.step()
            if node is self.station and self.station.boot != self.clocks.boot:
                for robot in self.robots.values():
                    robot.clocks.reboot(self.station.boot)

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


def _named(digest: Digest, robot: str, kind: Kind, key: str, payload: bytes) -> None:
    digest(kind, f"{robot}/{key}", payload)
