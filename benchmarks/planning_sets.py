"""Planning problems drawn from seeds, in the manner of MotionBenchMaker, for any arm.

Chamzas et al., "MotionBenchMaker: A Tool to Generate and Benchmark Motion Planning Datasets" (IEEE RA-L 7(2),
2022): scenes of one kind vary in where their parts stand, and start and goal are joint positions whose hands
are in places of the scene. The scenes here are our own. Lengths are told for an arm of the Panda's reach,
about its shoulder, and are scaled for others. Nothing is stored: set, seed and number give a problem.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

import numpy as np

from benchmarks.arm_problems import STAMP, scene_of, states
from tandem.sim.robots.registry import robot_model
from tandem.skills.arm.problem import Arm, Moment
from tandem.skills.geometry.poses import about, add, from_rpy, multiply, rotate
from tandem.skills.kinematics.described import home_positions, load_hulls
from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.steps import run_through
from tandem.skills.ports.world import Box, PlanningScene, SceneObject

Triple = tuple[float, float, float]
TRIES: Final = 300
"""Places that are tried for one end of a problem."""
STARTS: Final = 30
"""Of inverse kinematics, at each place."""
DOWN: Final = math.pi / 2
"""Pitch of a hand that points down."""
THICK: Final = 0.02
"""Metres of boards and walls."""


class Part(NamedTuple):
    """A box of a scene about the shoulder: centre and edges, in the Panda's metres."""

    name: str
    centre: Triple
    size: Triple


class Place(NamedTuple):
    """Where a hand may be: its point is drawn between the corners, its direction about the pitch (rad)."""

    low: Triple
    high: Triple
    pitch: float = 0.0
    askew: float = 0.3


@dataclass(frozen=True)
class Scene:
    """Parts and places; all is turned about the vertical by ``yaw`` where it stands."""

    parts: tuple[Part, ...]
    places: tuple[Place, ...]
    yaw: float = 0.0


@dataclass(frozen=True)
class Stand:
    """A robot whose arm is asked: everything that does not change from problem to problem."""

    arm: Arm
    shoulder: Triple
    scale: float


@dataclass(frozen=True)
class Planned:
    """One problem: the world and the start (``moment``), and the goal's joints."""

    name: str
    moment: Moment
    goal: MoveGoal


REACHES: Final = {"panda": 0.855, "tiago_dual": 0.87, "locobot": 0.55}
"""Metres from shoulder to wrist and flange, stretched."""
ROBOTS: Final = tuple(REACHES)


def stand(robot: str) -> Stand:
    """Return the robot with the first of its arms."""
    description = robot_model(robot).description
    return stand_of(description, REACHES[robot])


def stand_of(description: RobotDescription, reach: float) -> Stand:
    """Return the robot with the first of its arms, which reaches so many metres."""
    hulls = load_hulls(description)
    arm = Arm(hulls, description, description.end_effectors[0].group, field=True)
    at = hulls.robot.pose(arm.group.joints[0], home_positions(description)).position
    return Stand(arm, at, reach / REACHES["panda"])


def problem(name: str, of: Stand, number: int, seed: int = 1) -> Planned:
    """Return a problem of a set; every second one begins at home, the others in another place.

    Raises:
        LookupError: no place can be reached without collision (another number will do).
    """
    rng = np.random.default_rng([seed, sorted(SETS).index(name), number])
    for _ in range(4):
        scene = SETS[name](rng)
        positions = _home(of.arm.description)
        moment = Moment(states(positions), _scene(scene, of), FloorPose(x=0.0, y=0.0, yaw=0.0))
        goal = _end(scene, of, moment, rng)
        start = _end(scene, of, moment, rng) if number % 2 else of.arm.start(moment)
        if goal is None or start is None or not _free(of, moment, start):
            continue
        began = {**positions, **dict(zip(of.arm.group.joints, map(float, start), strict=True))}
        moment = Moment(states(began), moment.scene, moment.base_in_map)
        return Planned(f"{name} {number}", moment, MoveGoal(joints=tuple(map(float, goal))))
    raise LookupError(f"set {name!r}, number {number}, seed {seed}: no end without collision in 4 scenes")


def _home(description: RobotDescription) -> dict[str, float]:
    fingers = [joint for hand in description.end_effectors for joint in hand.gripper.joints]
    wide = {
        joint: hand.gripper.max_width / len(hand.gripper.joints)
        for hand in description.end_effectors
        for joint in hand.gripper.joints
    }
    return {**home_positions(description), **{joint: 0.5 * wide[joint] for joint in fingers}}


def _free(of: Stand, moment: Moment, q: Array) -> bool:
    return of.arm.checker(moment, MoveGoal(posture="home")).free(q)


def _end(scene: Scene, of: Stand, moment: Moment, rng: np.random.Generator) -> Array | None:
    """Return joint positions without collision whose hand is in one of the scene's places."""
    checker = of.arm.checker(moment, MoveGoal(posture="home"))
    solver = of.arm.solver
    assert solver is not None
    for _ in range(TRIES):
        place = scene.places[int(rng.integers(len(scene.places)))]
        point = tuple(float(each) for each in rng.uniform(place.low, place.high))
        roll, pitch, yaw = (float(each) for each in rng.uniform(-place.askew, place.askew, 3))
        roll += math.pi / 2 * int(rng.integers(4))
        turn = multiply(about((0, 0, 1), scene.yaw), from_rpy(0.0, place.pitch + pitch, yaw))
        pose = Pose(position=_there(point, scene, of), orientation=multiply(turn, about((1, 0, 0), roll)))
        middle = 0.5 * (of.arm.limits.lower + of.arm.limits.upper)
        answers = run_through(solver.solve(checker.chain, [to_se3(pose)], middle, STARTS))
        free = [q for q in answers[0].solutions if checker.free(q)]
        if free:
            chosen: Array = free[int(rng.integers(len(free)))]
            return chosen
    return None


def _there(point: Sequence[float], scene: Scene, of: Stand) -> Triple:
    x, y, z = (of.scale * each for each in point)
    return add(of.shoulder, rotate(about((0, 0, 1), scene.yaw), (x, y, z)))


def _scene(scene: Scene, of: Stand) -> PlanningScene:
    objects = []
    for number, part in enumerate(scene.parts):
        x, y, z = (of.scale * each for each in part.size)
        pose = Pose(position=_there(part.centre, scene, of), orientation=about((0, 0, 1), scene.yaw))
        kind: Literal["clutter", "furniture"] = "clutter" if part.name == "thing" else "furniture"
        objects.append(
            SceneObject(name=f"{part.name} {number}", kind=kind, box=Box(size=(x, y, z), pose=pose))
        )
    empty = scene_of(())
    return PlanningScene(stamp=STAMP, version=empty.version, objects=tuple(objects))


def _shelf(rng: np.random.Generator, height: float, columns: int, rows: int) -> Scene:
    """A shelf with back and sides; things stand in some compartments."""
    front, depth = float(rng.uniform(0.42, 0.52)), float(rng.uniform(0.25, 0.32))
    width = 0.85
    bottom = float(rng.uniform(-0.1, 0.1)) - rows * height / 2
    middle, top = front + depth / 2, bottom + rows * height
    parts = [Part("back", (front + depth, 0.0, (bottom + top) / 2), (THICK, width, top - bottom))]
    parts += [
        Part("board", (middle, 0.0, bottom + row * height), (depth, width, THICK)) for row in range(rows + 1)
    ]
    for column in range(columns + 1):
        y = -width / 2 + column * width / columns
        parts.append(Part("side", (middle, y, (bottom + top) / 2), (depth, THICK, top - bottom)))
    places = []
    for row in range(rows):
        for column in range(columns):
            y, z = -width / 2 + (column + 0.5) * width / columns, bottom + row * height
            room, up = width / columns / 2 - 0.08, height - 0.07
            places.append(Place((front + 0.02, y - room, z + 0.07), (front + 0.18, y + room, z + up)))
            if rng.random() < 0.4:
                thing = float(rng.uniform(0.3, 0.6)) * height
                at = y + float(rng.uniform(-room, room))
                parts.append(Part("thing", (middle + 0.05, at, z + thing / 2 + 0.02), (0.06, 0.06, thing)))
    return Scene(tuple(parts), tuple(places), float(rng.uniform(-0.25, 0.25)))


def _box(rng: np.random.Generator) -> Scene:
    """An open crate on a table; the hand points down."""
    x, y = float(rng.uniform(0.45, 0.55)), float(rng.uniform(-0.15, 0.15))
    edge, deep, floor = float(rng.uniform(0.36, 0.5)), float(rng.uniform(0.15, 0.25)), -0.45
    half, middle = edge / 2, floor + deep / 2
    parts = [
        Part("table", (0.65, 0.0, floor - 0.025), (0.8, 1.2, 0.03)),
        Part("wall", (x - half, y, middle), (THICK, edge, deep)),
        Part("wall", (x + half, y, middle), (THICK, edge, deep)),
        Part("wall", (x, y - half, middle), (edge, THICK, deep)),
        Part("wall", (x, y + half, middle), (edge, THICK, deep)),
    ]
    inner = half - 0.1
    places = (Place((x - inner, y - inner, floor + 0.05), (x + inner, y + inner, floor + 0.15), DOWN),)
    for _ in range(3):
        size = float(rng.uniform(0.08, 0.2))
        side = float(rng.choice((-1.0, 1.0)))
        at = (x + float(rng.uniform(-0.2, 0.2)), y + side * (half + 0.12), floor + size)
        parts.append(Part("thing", at, (0.1, 0.1, 2 * size)))
    return Scene(tuple(parts), places, float(rng.uniform(-0.3, 0.3)))


def _cage(rng: np.random.Generator) -> Scene:
    """A cage of bars before the arm, with room for a forearm between them; the hand is inside."""
    front, deep = float(rng.uniform(0.4, 0.46)), float(rng.uniform(0.4, 0.45))
    wide, tall = float(rng.uniform(0.62, 0.72)), float(rng.uniform(0.6, 0.7))
    low = float(rng.uniform(-0.4, -0.25))
    bar, middle = 0.025, front + deep / 2
    parts = [Part("floor", (middle, 0.0, low), (deep, wide, THICK))]
    for x in (front, front + deep):
        for k in range(4 if x > front else 3):
            y = -wide / 2 + k * wide / (3 if x > front else 2)
            parts.append(Part("bar", (x, y, low + tall / 2), (bar, bar, tall)))
        parts += [Part("rail", (x, 0.0, low + k * tall / 2), (bar, wide, bar)) for k in (1, 2)]
    for y in (-wide / 2, wide / 2):
        parts.append(Part("bar", (middle, y, low + tall / 2), (bar, bar, tall)))
        parts += [Part("rail", (middle, y, low + k * tall / 2), (deep, bar, bar)) for k in (1, 2)]
    parts.append(Part("rail", (middle, 0.0, low + tall), (bar, wide, bar)))
    for _ in range(2):
        x, y = float(rng.uniform(front + 0.15, front + deep - 0.08)), float(rng.uniform(-0.2, 0.2))
        parts.append(Part("thing", (x, y, low + 0.07), (0.06, 0.06, 0.12)))
    inside = Place(
        (front + 0.08, -wide / 2 + 0.08, low + 0.1), (front + deep - 0.12, wide / 2 - 0.08, low + tall - 0.12)
    )
    return Scene(tuple(parts), (inside,), float(rng.uniform(-0.2, 0.2)))


def _table(rng: np.random.Generator) -> Scene:
    """A table full of things; the hand points down or ahead between them."""
    top = float(rng.uniform(-0.45, -0.3))
    parts = [Part("table", (0.7, 0.0, top - 0.02), (0.8, 1.3, 0.03))]
    for _ in range(int(rng.integers(6, 11))):
        x, y = float(rng.uniform(0.4, 0.85)), float(rng.uniform(-0.45, 0.45))
        tall = float(rng.uniform(0.1, 0.35))
        parts.append(Part("thing", (x, y, top + tall / 2), (0.08, 0.08, tall)))
    places = (
        Place((0.4, -0.35, top + 0.05), (0.65, 0.35, top + 0.2), DOWN),
        Place((0.4, -0.35, top + 0.08), (0.65, 0.35, top + 0.2), 0.3),
    )
    return Scene(tuple(parts), places, float(rng.uniform(-0.2, 0.2)))


def _under_table(rng: np.random.Generator) -> Scene:
    """A table with legs and a crossbar; the hand is below its top."""
    front, top = float(rng.uniform(0.35, 0.45)), float(rng.uniform(-0.15, 0.05))
    parts = [Part("table", (front + 0.35, 0.0, top), (0.7, 1.2, 0.03))]
    for x in (front + 0.03, front + 0.67):
        parts += [Part("leg", (x, y, top - 0.35), (0.05, 0.05, 0.66)) for y in (-0.57, 0.57)]
    parts.append(Part("bar", (front + 0.35, 0.0, top - 0.5), (0.04, 1.1, 0.04)))
    for _ in range(3):
        x, y = front + float(rng.uniform(0.1, 0.4)), float(rng.uniform(-0.4, 0.4))
        parts.append(Part("thing", (x, y, top + 0.1), (0.08, 0.08, 0.15)))
    places = (Place((front + 0.03, -0.3, top - 0.3), (front + 0.2, 0.3, top - 0.1)),)
    return Scene(tuple(parts), places, float(rng.uniform(-0.2, 0.2)))


SETS: Final[dict[str, Callable[[np.random.Generator], Scene]]] = {
    "shelf-small": lambda rng: _shelf(rng, 0.3, 2, 3),
    "shelf-tall": lambda rng: _shelf(rng, 0.42, 2, 2),
    "shelf-thin": lambda rng: _shelf(rng, 0.3, 3, 3),
    "box": _box,
    "cage": _cage,
    "table": _table,
    "under-table": _under_table,
}
