"""The servers of a mocked robot's skills: each has faults and notes its calls, and each can be lost alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, TypeVar

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.message import Message
from tandem.skills.ports.node import Node
from tandem.skills.ports.skill import ActionType, Outcome
from tandem.skills.server import ActionServer
from tandem.skills.testing.mock_skill import Fault, MockSkill

G = TypeVar("G", bound=Message)
F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)


class ClosableBus(Bus, Protocol):
    """An end of a bus that can be left."""

    def close(self) -> None:
        """Leave it."""
        ...


class _Mortal:
    """An end of a bus whose process can die: from then on nothing leaves it."""

    def __init__(self, bus: ClosableBus) -> None:
        self._bus, self._dead, self.ear = bus, False, bus.ear
        self.subscribe, self.serve, self.query = bus.subscribe, bus.serve, bus.query
        self.listened, self.announce = bus.listened, bus.announce
        self.alive, self.awake, self.goes_on = bus.alive, bus.awake, bus.goes_on
        self.lease = bus.lease

    def publish(self, key: str, payload: bytes) -> None:
        """Send, unless it is dead."""
        if not self._dead:
            self._bus.publish(key, payload)

    def die(self) -> None:
        """Take back all names, and say nothing more."""
        self._dead = True
        self._bus.close()


@dataclass(eq=False)
class _Served:
    """A skill, its server, and how to make another one."""

    make: Callable[[Bus], Node]
    server: Node
    bus: _Mortal | None
    there: bool = True


class MockServers:
    """Base of a node that serves mocked skills.

    Args:
        bus: where the trees are.
        clocks: robot time.
        duration: robot seconds that each skill takes.
        ends: makes ends of the same bus; with it each skill gets one of its own, and can be lost alone.
    """

    def __init__(
        self, bus: Bus, clocks: Clocks, *, duration: float, ends: Callable[[], ClosableBus] | None
    ) -> None:
        self.bus, self._clocks, self._duration = bus, clocks, duration
        self._faults: dict[str, dict[int, Fault]] = {}
        self.leaf_faults: dict[str | tuple[str, int], Fault] = {}
        """Faults by the leaf that sent the goal, at each of its attempts or at one (1 is the first)."""
        self.calls: list[tuple[str, Message]] = []
        """Each goal that was run, with its action's name, in order."""
        self._recorded: list[_Clearable] = []
        self.watch: Callable[[str, str, str, Message], None] = lambda *_: None
        """Told "began" and "ended" of each goal, with action, id and goal."""
        self._ends, self._servers = ends, dict[str, _Served]()

    def tell(self) -> None:
        """Publish all beliefs: done after each goal."""

    def faults(self, action: str) -> dict[int, Fault]:
        """Return the faults of an action by the number of the call; put more in."""
        return self._faults[action]

    def calls_of(self, action: str) -> int:
        """Return how often an action was run."""
        return sum(1 for name, _ in self.calls if name == action)

    def forget_calls(self) -> None:
        """Count calls from zero again: a mock that lives for long must not keep all of them."""
        self.calls.clear()
        for calls in self._recorded:
            calls.clear()

    def serve(self, action: ActionType[G, F, R], idle: F, effect: Callable[[G], Outcome[R]]) -> None:
        """Mock one more skill, such as one of your own.

        Args:
            action: its contract.
            idle: the feedback while it runs.
            effect: returns how a goal ends.
        """
        self._serve(action, idle, effect)

    def _serve(self, action: ActionType[G, F, R], idle: F, effect: object, *, endless: bool = False) -> None:
        def recorded(goal: G) -> Outcome[R]:
            outcome: Outcome[R] = effect(goal)  # type: ignore[operator]
            self.tell()
            return outcome

        faults = self._faults.setdefault(action.name, {})
        fault_of = self._hangs if endless else self._fault_of
        skill = MockSkill(action, self._clocks, idle, recorded, self._duration, faults, fault_of)
        skill.calls = _Recorded(self.calls, action.name)
        self._recorded.append(skill.calls)
        skill.began = lambda goal_id, goal: self.watch("began", action.name, goal_id, goal)
        skill.ended = lambda goal_id, goal: self.watch("ended", action.name, goal_id, goal)
        mortal = None if self._ends is None else _Mortal(self._ends())

        def serve(at: Bus) -> Node:
            return ActionServer(at, self._clocks, skill)

        self._servers[action.name] = _Served(serve, serve(mortal or self.bus), mortal)

    def _fault_of(self, goal_id: str) -> Fault | None:
        _, _, rest = goal_id.partition("/")
        leaf, _, attempt = rest.rpartition("/")
        return self.leaf_faults.get((leaf, int(attempt))) or self.leaf_faults.get(leaf)

    def _hangs(self, goal_id: str) -> Fault:
        return self._fault_of(goal_id) or Fault(hangs=True)

    def lose(self, action: str) -> None:
        """Have the process of a skill die: its name goes, and its goal with it."""
        served = self._servers[action]
        assert served.bus is not None, "give the robot ``ends`` to lose a skill alone"
        if served.there:
            served.there = False
            served.bus.die()
            served.server.close()

    def bring_back(self, action: str) -> None:
        """Have it started anew: it knows nothing of its goals."""
        served = self._servers[action]
        if not served.there and self._ends is not None:
            served.bus = _Mortal(self._ends())
            served.server, served.there = served.make(served.bus), True

    @property
    def busy(self) -> tuple[str, ...]:
        """The names of the actions that have a goal under way."""
        return tuple(
            name
            for name, served in self._servers.items()
            if served.there and isinstance(served.server, ActionServer) and served.server.busy
        )

    def _step_servers(self) -> bool:
        more = [served.server.step() for served in self._servers.values() if served.there]
        return any(more)

    def _close_servers(self) -> None:
        for served in self._servers.values():
            served.server.close()


class _Clearable(Protocol):
    def clear(self) -> None: ...


class _Recorded(list[G]):
    """A skill's calls that also go, with the action's name, into the robot's."""

    def __init__(self, calls: list[tuple[str, Message]], action: str) -> None:
        super().__init__()
        self._calls, self._action = calls, action

    def append(self, goal: G) -> None:
        """Keep the call in both places."""
        super().append(goal)
        self._calls.append((self._action, goal))
