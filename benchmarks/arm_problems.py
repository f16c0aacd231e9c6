"""Problems for the planning of arms: items drawn over the surfaces of a scenario, the robot before them.

The world is the scenario's true one: furniture, clutter and all items. For each problem one of the items is
put elsewhere on a surface, with a side that looks about where a robot would stand; the base stands at the
first proximity pose with room for its footprint, the joints at ``home``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from tandem.sim.scenario import Scenario, SpawnSurface
from tandem.sim.scene import SceneBody, as_box, build_scene, item_body
from tandem.skills.arm.problem import Moment
from tandem.skills.geometry.poses import about, add, from_axes, multiply, rotate
from tandem.skills.grasping.tag_grasps import FINGER_ROOM, PITCHES, Grasp, grasp, proximity_poses
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import Box, PlanningScene, SceneObject

STAMP = RobotTime(boot="benchmark", seconds=0.0)
ASKEW = 0.35
"""Radians (sigma) by which the tag's side looks past the place where the robot would stand."""
ROOM = 0.03
"""Metres kept between the footprint and everything."""
APART = 0.03
"""Metres between the item and other things on the surface; the fingers need them."""


@dataclass(frozen=True)
class Problem:
    """One item to be picked: where it is, how it may be grasped, and what is believed."""

    side: HandName
    item: int
    surface: str
    moment: Moment
    grasps: tuple[Grasp, ...]
    width: float
    """Metres that the hand is opened for it."""

    @property
    def pre_grasp(self) -> MoveGoal:
        """The goal that ``tandem.trees.leaves.pre_grasp`` sends."""
        candidates = tuple(
            Candidate(pose=each.pre_grasp, followed_by=(each.grasp, each.retraction)) for each in self.grasps
        )
        return MoveGoal(candidates=candidates, touch_item=self.item, hand_width=self.width)

    def straight(self, pose: Pose, *, lift: bool = False) -> MoveGoal:
        """The goals of the reach, and (``lift``) of the retraction with the item in the hand."""
        return MoveGoal(
            candidates=(Candidate(pose=pose),), straight=True, touch_item=self.item, touch_support=lift
        )


@dataclass(frozen=True)
class Drawing:
    """Draws problems.

    Attributes:
        description: the robot.
        site: its furniture and the sizes of items.
        scenario: the true world and the surfaces.
        work_point: x and |y| (m) instead of the description's.
        torso: the torso's height (m) instead of the one at home.
    """

    description: RobotDescription
    site: Site
    scenario: Scenario
    work_point: tuple[float, float] | None = None
    torso: float | None = None
    surfaces: tuple[SpawnSurface, ...] = ()

    def problem(self, rng: np.random.Generator) -> Problem | None:
        """Return a problem, or None if the item does not fit where it was drawn or the robot before it."""
        surfaces = self.surfaces or self.scenario.surfaces
        surface = surfaces[int(rng.integers(len(surfaces)))]
        true = self.scenario.items[int(rng.integers(len(self.scenario.items)))]
        sides = self.description.hands
        side = sides[int(rng.integers(len(sides)))]
        x, y = (float(rng.uniform(a, b)) for a, b in zip(surface.lower, surface.upper, strict=True))
        yaw = surface.facing + float(np.clip(rng.normal(0.0, ASKEW), -0.78, 0.78))
        moved = replace_item(self.scenario, true.item, surface.support, x, y, yaw)
        others = build_scene(self.site, moved.without_item(true.item))
        item = item_body(self.site, moved.item(true.item))
        if any(_near(body, item) for body in others if body.mass > 0.0):
            return None
        bodies = build_scene(self.site, moved)
        tag, depth = tag_of(item)
        hand = self.description.end_effector(side)
        work_x, work_y = hand.work_point if self.work_point is None else self.work_point
        work = (work_x, math.copysign(work_y, hand.work_point[1]))
        stands = proximity_poses(tag.position, yaw, work, hand.work_heading)
        base = next((pose for pose in stands if self._fits(pose, bodies)), None)
        if base is None:
            return None
        moment = Moment(self.at_home(), scene_of(bodies), base)
        grasps = tuple(grasp(tag, depth, pitch) for pitch in PITCHES)
        width = min(as_box(item).size[1] + 2 * FINGER_ROOM, hand.gripper.max_width)
        return Problem(side, true.item, surface.name, moment, grasps, width)

    def _fits(self, base: FloorPose, bodies: tuple[SceneBody, ...]) -> bool:
        radius = self.description.footprint_radius + ROOM
        x_min, y_min, x_max, y_max = self.site.bounds
        inside = x_min + radius < base.x < x_max - radius and y_min + radius < base.y < y_max - radius
        return inside and all(_gap(base.x, base.y, as_box(body)) > radius for body in bodies)

    def at_home(self) -> JointStates:
        """Return the joints where problems begin."""
        positions: dict[str, float] = {}
        for posture in self.description.postures:
            if posture.name == "home":
                joints = self.description.group(posture.group).joints
                positions |= dict(zip(joints, posture.positions, strict=True))
        for hand in self.description.end_effectors:  # opened after the pre-grasp only
            positions |= dict.fromkeys(hand.gripper.joints, 0.0)
        if self.torso is not None:
            positions |= dict.fromkeys(self.description.group("torso").joints, self.torso)
        return states(positions)


def states(positions: dict[str, float]) -> JointStates:
    """Return joint states, at rest."""
    rest = tuple(0.0 for _ in positions)
    return JointStates(
        stamp=STAMP,
        names=tuple(positions),
        positions=tuple(positions.values()),
        velocities=rest,
        efforts=rest,
    )


def scene_of(bodies: tuple[SceneBody, ...]) -> PlanningScene:
    """Return the planning scene that knows all that is true."""
    return PlanningScene(stamp=STAMP, version=1, objects=tuple(_object(body) for body in bodies))


def held(moment: Moment, problem: Problem, number: int) -> Moment:
    """Return the moment at which the item is in the hand."""
    taken = problem.grasps[number]
    objects = tuple(
        each.model_copy(
            update={
                "attached_to": problem.side,
                "box": each.box.model_copy(update={"pose": taken.item_in_tool}),
            }
        )
        if each.item == problem.item
        else each
        for each in moment.scene.objects
    )
    return replace(moment, scene=PlanningScene(stamp=STAMP, version=2, objects=objects))


def replace_item(  # noqa: PLR0917 - a place
    scenario: Scenario, item: int, support: str, x: float, y: float, yaw: float
) -> Scenario:
    """Return the scenario with one item elsewhere."""
    yaw = math.remainder(yaw, 2 * math.pi)
    items = tuple(
        each.model_copy(update={"support": support, "x": x, "y": y, "yaw": yaw})
        if each.item == item
        else each
        for each in scenario.items
    )
    return scenario.model_copy(update={"items": items})


def tag_of(item: SceneBody) -> tuple[Pose, float]:
    """Return the tag on the item's +x side in the map, and the item's depth behind it."""
    size, yaw = as_box(item).size, item.pose.orientation
    position = add(item.pose.position, rotate(yaw, (size[0] / 2, 0.0, 0.0)))
    return Pose(
        position=position, orientation=multiply(yaw, from_axes((0, 1, 0), (0, 0, 1), (1, 0, 0)))
    ), size[0]


def _object(body: SceneBody) -> SceneObject:
    item = None if body.label is None else body.label.item
    box = as_box(body)
    if item is not None:
        return SceneObject(name=body.name, kind="item", box=box, item=item)
    return SceneObject(name=body.name, kind="clutter" if body.mass > 0.0 else "furniture", box=box)


def _near(body: SceneBody, item: SceneBody) -> bool:
    x, y, z = item.pose.position
    other = as_box(body)
    half = math.hypot(*as_box(item).size[:2]) / 2
    level = abs(other.pose.position[2] - z) < (other.size[2] + as_box(item).size[2]) / 2
    return level and _gap(x, y, other) < half + APART


def _gap(x: float, y: float, box: Box) -> float:
    """Return the metres in plan between a point and a box."""
    yaw = about((0, 0, 1), 0.0) if box.pose.orientation is None else box.pose.orientation
    dx, dy = x - box.pose.position[0], y - box.pose.position[1]
    turned = rotate((-yaw[0], -yaw[1], -yaw[2], yaw[3]), (dx, dy, 0.0))
    return math.hypot(max(0.0, abs(turned[0]) - box.size[0] / 2), max(0.0, abs(turned[1]) - box.size[1] / 2))
