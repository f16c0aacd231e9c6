"""One run, in lockstep with physics, from its draw to its verdict, which is read from the truth."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

import numpy as np
from pydantic import JsonValue

from tandem.executive.system.systems import LockstepSystem, System, SystemFailure
from tandem.executive.trials.demo import Caller
from tandem.executive.trials.rocs.draws import DISTANCE, draw
from tandem.executive.trials.rocs.settings import Case, RocsOptions
from tandem.executive.trials.trial import trial, warm_up
from tandem.executive.trials.truly import NEAR
from tandem.sim.things import BoxShape
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import FollowSource
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.reflex import PipelineState, ReflexSwitch, pipeline_state, reflex_switch

if TYPE_CHECKING:
    from tandem.sim.station import Station
    from tandem.skills.ports.bus import Bus

WITHIN: Final = 240.0
"""Robot seconds for one run."""
FOLLOWS: Final = (0.9, 1.8)
"""Metres between the two centres, in EXP3, for"""
MOST_OF_IT: Final = 0.90
"""of the time."""
CORNERS: Final = ((1.2, 1.2), (-1.2, 1.2), (-1.2, -1.2), (1.2, -1.2))
"""EXP3's, in the map (m): as far from the walls as the follower behind needs to turn."""
Request = Mapping[str, JsonValue]


@dataclass(frozen=True)
class Plan:
    """What an experiment asks of whom.

    Args:
        asked: the robot whose task is judged.
        request: what it is asked.
        places: where it must have been, in order (m in the map); at the last one it must be in the end.
        follower: the robot that follows it meanwhile, if any.
    """

    asked: str
    request: Request
    places: tuple[tuple[float, float], ...]
    follower: str = ""


_ORIGIN: Final[Request] = MappingProxyType({"task": "go_to", "x": 0.0, "y": 0.0, "tolerance": 0.12})
PLANS: Final[Mapping[Case, Plan]] = MappingProxyType(
    {
        1: Plan("r2", _ORIGIN, ((0.0, 0.0),)),
        2: Plan("r3", MappingProxyType({**_ORIGIN, "stay": 20.0}), ((0.0, 0.0),)),
        3: Plan(
            "r2",
            MappingProxyType({"task": "patrol", "corners": [{"x": x, "y": y} for x, y in CORNERS]}),
            CORNERS,
            follower="r3",
        ),
    }
)
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
    off_goal: float
    """Metres from the last place at the end, in truth."""
    missed: Count = 0
    """Places where it was not when their turn came, in truth."""
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
        """Whether it was at each place, and in the end at the last, and touched nothing on its way."""
        there = self.off_goal <= NEAR and not self.missed
        near = self.kept is None or self.kept >= MOST_OF_IT
        return self.state == "SUCCEEDED" and there and near and not self.caused


class RocsExperiment(Message):
    """All runs: what ``--report`` writes."""

    options: RocsOptions
    runs: tuple[RocsRun, ...]


def run_rocs(options: RocsOptions, run: int) -> RocsRun:
    """Draw and make run number ``run``; the same options and number give the same run."""
    scenario, plan = draw(options.case, np.random.default_rng((options.seed, run))), PLANS[options.case]
    system = LockstepSystem(scenario, options.seed * 1000 + run)
    try:
        buses = {name: system.of(name).bus for name in system.lockstep.robots}
        witness, one = Witness(system.lockstep.station, buses), system.of(plan.asked)
        warm_up(one)
        if options.route == "deliberative":
            reflex_switch("avoid_collision").query(one.bus, ReflexSwitch(on=False, by="the experiment"))
        if plan.follower:
            _follow(system.of(plan.follower), plan.asked, options.source, witness)
        if options.route == "reactive":
            end = _by_reflexes(one, plan, witness)
        else:
            end = _by_request(one, plan.request, witness)
        path = witness.paths[plan.asked]
        (x, y), (x_end, y_end) = (path[-1].x, path[-1].y), plan.places[-1]
        return RocsRun(
            run=run,
            state=end.state,
            failure=end.failure,
            lasted=end.lasted,
            kept=_kept(path, witness.paths[plan.follower]) if plan.follower else None,
            off_goal=round(math.hypot(x - x_end, y - y_end), 3),
            missed=missed(path, plan.places),
            bumps=tuple(witness.bumps),
            replans=end.replans,
            reactive=round(sum(each.reactive for each in path) / max(1, len(path)), 3),
            paths={name: tuple(points) for name, points in witness.paths.items()},
            boxes=tuple(
                (each.x, each.y, each.yaw, *each.shape.size[:2])
                for each in scenario.obstacles
                if isinstance(each.shape, BoxShape)
            ),
        )
    finally:
        system.close()


@dataclass(frozen=True)
class _End:
    """How it went, by the robot's own account; without a tree, by where it is."""

    state: str
    failure: Failure | None
    lasted: float
    replans: int


def _by_request(system: System, request: Request, witness: Witness) -> _End:
    made = trial(system, dict(request), within=WITHIN, also=witness)
    result = {} if made.status is None or made.status.result is None else made.status.result
    told = result.get("replans", 0)
    replans = told if isinstance(told, int) else 0
    return _End(made.state.partition(":")[0], made.failure, made.lasted, replans)


def _by_reflexes(system: System, plan: Plan, witness: Witness) -> _End:
    """Switch on the reflex that steers to the origin, and wait until the robot has stayed there."""
    reflex_switch("approach").query(system.bus, ReflexSwitch(on=True, by="the experiment"))
    began, stays = robot_seconds(system.clocks), plan.request.get("stay", 0.0)
    assert isinstance(stays, float)
    there: float | None = None
    while (now := robot_seconds(system.clocks)) - began < WITHIN:
        system.advance()
        witness.step()
        at = witness.paths[plan.asked][-1]
        near = math.dist((at.x, at.y), plan.places[-1]) <= NEAR
        there = (now if there is None else there) if near else None
        if there is not None and now - there >= max(STOOD, stays):
            return _End("SUCCEEDED", None, round(now - began, 2), 0)
    return _End("STUCK", None, WITHIN, 0)


def missed(path: Sequence[Point], places: Sequence[tuple[float, float]]) -> int:
    """Return how many places a path leaves out, each looked for after the one before."""
    begin, left_out = 0, 0
    for x, y in places:
        at = (k for k in range(begin, len(path)) if math.hypot(path[k].x - x, path[k].y - y) <= NEAR)
        found = next(at, None)
        if found is None:
            left_out += 1
        else:
            begin = found
    return left_out


def _follow(system: System, robot: str, source: FollowSource, witness: Witness) -> None:
    """Have a robot follow another one until the run is over.

    Raises:
        SystemFailure: the request is refused.
    """
    request: dict[str, JsonValue] = {
        "task": "follow",
        "robot": robot,
        "distance": DISTANCE,
        "seconds": WITHIN,
        "source": source,
    }
    answer = Caller(system, lambda _: None, also=witness).request(request)
    if not answer.accepted:
        raise SystemFailure(f"{request} was refused: {answer.problems}")


def _kept(path: Sequence[Point], other: Sequence[Point]) -> float:
    """Return the share of the time for which the two were within their distances of each other."""
    apart = [math.dist((a.x, a.y), (b.x, b.y)) for a, b in zip(path, other, strict=True)]
    return round(sum(FOLLOWS[0] <= each <= FOLLOWS[1] for each in apart) / max(1, len(apart)), 3)


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
        """Say whether a range sensor of the robot looks where it was touched, as seen from its axis.

        Twice as wide as a sensor's cone: what touches the robot between two cones was in one of them before.
        """
        body = self.station.world.robots[name]
        (x, y, _), _ = body.base_pose()
        bearing = math.atan2(place[1] - y, place[0] - x)
        for sensor in body.model.description.range_sensors:
            matrix = body.frame_matrix(sensor.frame)
            if abs(wrap(bearing - math.atan2(matrix[1, 0], matrix[0, 0]))) <= sensor.cone:
                return True
        return False
