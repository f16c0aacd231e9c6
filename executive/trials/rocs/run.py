"""One run, in lockstep with physics, from its draw to its verdict, which is read from the truth."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

import numpy as np
from pydantic import JsonValue

from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.demo import Caller
from tandem.executive.trials.rocs.draws import DISTANCE, draw
from tandem.executive.trials.rocs.settings import RocsOptions
from tandem.executive.trials.trial import trial, warm_up
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.reflex import PipelineState, ReflexSwitch, pipeline_state, reflex_switch

if TYPE_CHECKING:
    from tandem.sim.station import Station
    from tandem.skills.ports.bus import Bus

WITHIN: Final = 240.0
"""Robot seconds for one run."""
STAY: Final = 20.0
"""Robot seconds for which EXP2's robot holds its place."""
NEAR: Final = 0.15
"""Metres from the goal that count as there."""
CORNERS: Final = ((1.2, 1.2), (-1.2, 1.2), (-1.2, -1.2), (1.2, -1.2))
"""EXP3's, in the map (m): as far from the walls as the follower behind needs to turn."""
FOLLOWS: Final = (0.9, 1.8)
"""Metres between the two centres, in EXP3, for"""
MOST_OF_IT: Final = 0.90
"""of the time."""
POINT_EVERY: Final = 10
"""Periods between two points of a path: 0.1 s."""
STOOD: Final = 1.0
"""Robot seconds for which a robot has stood when a contact is nobody's fault but the other's."""
STANDS: Final = 0.02
"""m/s below which it stands."""


class Bump(Message):
    """A contact: of which robot, with what, from when on (robot seconds), and how hard (N)."""

    robot: str
    what: str
    at: float
    force: float
    stood: bool
    """Whether the robot had stood for a second or more."""
    unseen: bool
    """Whether it was touched from where none of its range sensors looks."""

    @property
    def caused(self) -> bool:
        """Whether the robot is to blame."""
        return not (self.stood or self.unseen)


class Point(Message):
    """Where a robot was."""

    at: float
    x: float
    y: float
    reactive: bool


class RocsRun(Message):
    """One run."""

    run: int
    state: str
    failure: Failure | None
    lasted: float
    """Robot seconds from the request to the end of the task."""
    kept: float | None = None
    """EXP3: share of the time for which the two centres were within ``FOLLOWS``."""
    off_goal: float | None
    """Metres from the goal at the end, in truth; None where there is no one goal."""
    bumps: tuple[Bump, ...]
    replans: Count
    reactive: float
    """Share of the time on the reactive route, of the robot that was asked."""
    paths: dict[str, tuple[Point, ...]]
    boxes: tuple[tuple[float, float, float, float, float], ...] = ()
    """x, y, yaw and the sizes along x and y of each."""

    @property
    def caused(self) -> tuple[Bump, ...]:
        """The contacts that a robot that runs Tandem is to blame for."""
        return tuple(each for each in self.bumps if each.caused)

    @property
    def reached(self) -> bool:
        """Whether it got there, and touched nothing on its way."""
        there = self.off_goal is None or self.off_goal <= NEAR
        near = self.kept is None or self.kept >= MOST_OF_IT
        return self.state == "SUCCEEDED" and there and near and not self.caused


class RocsExperiment(Message):
    """All runs: what ``--report`` writes."""

    options: RocsOptions
    runs: tuple[RocsRun, ...]


def run_rocs(options: RocsOptions, run: int) -> RocsRun:
    """Draw and make run number ``run``; the same options and number give the same run."""
    scenario = draw(options.case, np.random.default_rng((options.seed, run)))
    system = LockstepSystem(scenario, options.seed * 1000 + run)
    asked = "r3" if options.case == 2 else "r2"  # noqa: PLR2004 - EXP2's robot
    try:
        witness = Witness(
            system.lockstep.station, {name: system.of(name).bus for name in system.lockstep.robots}
        )
        one = system.of(asked)
        warm_up(one)
        if options.route == "deliberative":
            reflex_switch("avoid_collision").query(one.bus, ReflexSwitch(on=False, by="the experiment"))
        if options.case == 3:  # noqa: PLR2004 - EXP3's follower
            follow: dict[str, JsonValue] = {
                "task": "follow",
                "robot": "r2",
                "distance": DISTANCE,
                "seconds": WITHIN,
            }
            Caller(system.of("r3"), _quiet, also=witness).request(follow)
        made = trial(one, _request(options), within=WITHIN, also=witness)
        x, y, _ = system.lockstep.station.world.robots[asked].base_pose()[0]
        result = {} if made.status is None or made.status.result is None else made.status.result
        told = result.get("replans", 0)
        path = witness.paths[asked]
        return RocsRun(
            run=run,
            state=made.state.partition(":")[0],
            failure=made.failure,
            lasted=made.lasted,
            kept=_kept(witness.paths) if options.case == 3 else None,  # noqa: PLR2004 - EXP3
            off_goal=None if options.case == 3 else round(math.hypot(x, y), 3),  # noqa: PLR2004
            bumps=tuple(witness.bumps),
            replans=told if isinstance(told, int) else 0,
            reactive=round(sum(each.reactive for each in path) / max(1, len(path)), 3),
            paths={name: tuple(points) for name, points in witness.paths.items()},
            boxes=tuple(
                (each.x, each.y, each.yaw, *each.shape.size[:2])  # type: ignore[union-attr]
                for each in scenario.obstacles
            ),
        )
    finally:
        system.close()


def _request(options: RocsOptions) -> dict[str, JsonValue]:
    if options.case == 3:  # noqa: PLR2004 - EXP3 visits the corners
        corners: list[JsonValue] = [{"x": x, "y": y} for x, y in CORNERS]
        return {"task": "patrol", "corners": corners, "tolerance": 0.15}
    stay = STAY if options.case == 2 else 0.0  # noqa: PLR2004 - EXP2 holds its place
    return {"task": "go_to", "x": 0.0, "y": 0.0, "tolerance": 0.12, "stay": stay}


def _kept(paths: Mapping[str, Sequence[Point]]) -> float:
    """Return the share of the time for which the two were within their distances of each other."""
    apart = [math.dist((a.x, a.y), (b.x, b.y)) for a, b in zip(paths["r2"], paths["r3"], strict=True)]
    return round(sum(FOLLOWS[0] <= each <= FOLLOWS[1] for each in apart) / max(1, len(apart)), 3)


def _quiet(_: str) -> None:
    """Tell nobody."""


@dataclass(eq=False)
class Witness:
    """Looks at the simulation itself after each of its periods: a node."""

    station: Station
    buses: dict[str, Bus]
    """Of the robots that run Tandem."""
    bumps: list[Bump] = field(default_factory=list)
    paths: dict[str, list[Point]] = field(default_factory=dict)
    name: str = "witness"

    def __post_init__(self) -> None:
        """Hear which route each robot is on."""
        self._routes: dict[str, Latest[PipelineState]] = {
            name: Latest(bus, pipeline_state("base"), depth=8) for name, bus in self.buses.items()
        }
        self._steps = 0
        self._under_way: set[tuple[str, str]] = set()
        self._moved_at = dict.fromkeys(self.buses, 0.0)
        self.paths = {name: [] for name in self.station.world.robots}

    def step(self) -> bool:
        """Look."""
        seconds = round(self.station.hardware.now.seconds, 2)
        for name, body in self.station.world.robots.items():
            (x, y, _), _ = body.base_pose()
            if name in self._moved_at and self._speed(name) > STANDS:
                self._moved_at[name] = seconds
            if self._steps % POINT_EVERY == 0:
                route = self._routes[name].refresh() if name in self._routes else None
                reactive = route is not None and bool(route.reflex)
                self.paths[name].append(Point(at=seconds, x=round(x, 3), y=round(y, 3), reactive=reactive))
        self._contacts(seconds)
        self._steps += 1
        return False

    def close(self) -> None:
        """End the subscriptions."""
        for each in self._routes.values():
            each.close()

    def _speed(self, name: str) -> float:
        """Return m/s over the floor."""
        (vx, vy, _), _ = self.station.physics.body_velocity(self.station.world.robots[name].body)
        return math.hypot(vx, vy)

    def _contacts(self, seconds: float) -> None:
        world, names = self.station.world, self.station.world.names_with_robots()
        now: dict[tuple[str, str], tuple[float, tuple[float, float, float]]] = {}
        for name in self.buses:
            body = world.robots[name].body
            for contact in self.station.physics.contacts(body):
                if contact.body_b in {body, world.floor} or contact.force <= 0.0:
                    continue
                pair = (name, names.get(contact.body_b, "?"))
                if contact.force > now.get(pair, (0.0, (0.0, 0.0, 0.0)))[0]:
                    now[pair] = (contact.force, contact.position)
        for pair, (force, place) in now.items():
            if pair in self._under_way:
                continue
            name, what = pair
            self.bumps.append(
                Bump(
                    robot=name,
                    what=what,
                    at=seconds,
                    force=round(force, 1),
                    stood=seconds - self._moved_at[name] >= STOOD,
                    unseen=not self._looks_at(name, place),
                )
            )
        self._under_way = set(now)

    def _looks_at(self, name: str, place: tuple[float, float, float]) -> bool:
        """Say whether a range sensor of the robot looks where it was touched."""
        body = self.station.world.robots[name]
        for sensor in body.model.description.range_sensors:
            matrix = body.frame_matrix(sensor.frame)
            bearing = math.atan2(place[1] - matrix[1, 3], place[0] - matrix[0, 3])
            if abs(wrap(bearing - math.atan2(matrix[1, 0], matrix[0, 0]))) <= sensor.cone / 2.0:
                return True
        return False
