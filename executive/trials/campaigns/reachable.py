"""Where an item can be picked up at all, by the arms' own arithmetic among what truly stands there.

The survey that the tree asks before it drives (docs/decisions/003-survey-before-driving.md), with perfect
knowledge: for each face of the item, each arm and each stand with room for the base, is there a pre-grasp
free of collisions that goes on to grasp and retraction? Where there is none, no fetch can succeed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import numpy as np

from tandem.sim.scenario import Scenario
from tandem.sim.scene import SceneBody, as_box, build_scene, furniture_bodies, item_body, item_name
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment
from tandem.skills.geometry.floor_plan import FloorPlan
from tandem.skills.grasping.item_frames import face, item_in_map, outward, tag_of_item
from tandem.skills.grasping.tag_grasps import FINGER_ROOM, PITCHES, grasps_on, proximity_poses
from tandem.skills.grasping.turns import to_grasp
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.ports.actions.arm import Candidate, MoveGoal
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.shapes import Solid, extents, solid
from tandem.skills.ports.site import Site
from tandem.skills.ports.steps import run_through
from tandem.skills.ports.world import PlanningScene, SceneObject

FACES: Final = (0, 1, 2, -1)
"""An item's tagged faces, by quarter turns: the robot may see it from anywhere."""
_STAMP: Final = RobotTime(boot="draw", seconds=0.0)


class Reachable:
    """Judges places of items. Made once for a run; loading the robot's bodies takes a second.

    Args:
        description: the robot.
        site: furniture, and the items' sizes.
    """

    def __init__(self, description: RobotDescription, site: Site) -> None:
        self._site, self._description = site, description
        self._floor = FloorPlan(site)
        hulls, settings = load_hulls(description, 0), PlannerSettings()
        self._planners: Mapping[HandName, MovePlanner] = {
            hand.side: MovePlanner(Arm(hulls, description, hand.group), settings, "draw")
            for hand in description.end_effectors
        }
        self._joints = _at_home(description)

    def why_not(self, scenario: Scenario, tag: int) -> str | None:
        """Return in words why no arm gets at the item where the scenario has it; None when one does."""
        bodies = build_scene(self._site, scenario)
        item = item_body(self._site, scenario.item(tag))
        if self._reached(item, tag, bodies):
            return None
        alone = self._reached(item, tag, (*furniture_bodies(self._site), item))
        among = "among what stands there" if alone else "even with nothing but furniture there"
        return f"is out of reach: no arm gets at any face of it from any stand, {among}"

    def _reached(self, item: SceneBody, tag: int, bodies: tuple[SceneBody, ...]) -> bool:
        scene = PlanningScene(stamp=_STAMP, version=1, objects=tuple(_object(body) for body in bodies))
        shape = solid(as_box(item))
        depth = extents(shape)[0]
        front = tag_of_item(item.pose, depth)
        return any(
            self._reaches(side, face(front, depth, turns), shape, tag, scene)
            for turns in FACES
            for side in self._planners
        )

    def _reaches(
        self,
        side: HandName,
        tag_in_map: Pose,
        shape: Solid,
        tag: int,
        scene: PlanningScene,
    ) -> bool:
        hand, out = self._description.end_effector(side), outward(tag_in_map)
        ways = grasps_on(tag_in_map, shape, PITCHES, hand.gripper.palm)
        goal = MoveGoal(
            candidates=tuple(
                Candidate(pose=way.pre_grasp, followed_by=(way.grasp, way.retraction)) for way in ways
            ),
            touch_item=tag,
            hand_width=extents(shape)[1] + 2 * FINGER_ROOM,
            turn=to_grasp(item_in_map(tag_in_map, extents(shape)[0]).position, shape, hand.gripper.max_width),
        )
        stands = proximity_poses(
            tag_in_map.position, math.atan2(out[1], out[0]), hand.work_point, hand.work_heading
        )
        return any(self._from(stand, side, goal, scene) for stand in stands if self._room(stand))

    def _from(self, stand: FloorPose, side: HandName, goal: MoveGoal, scene: PlanningScene) -> bool:
        moment = Moment(self._joints, scene, stand)
        return run_through(self._planners[side].reaches(goal, moment, np.random.default_rng(0)))

    def _room(self, stand: FloorPose) -> bool:
        radius = self._description.footprint_radius + ARM_MARGIN
        return self._floor.has_room(stand.x, stand.y, radius)


def _object(body: SceneBody) -> SceneObject:
    if body.label is not None:
        return SceneObject(
            name=item_name(body.label.item), kind="item", box=as_box(body), item=body.label.item
        )
    return SceneObject(name=body.name, kind="clutter" if body.mass > 0.0 else "furniture", box=as_box(body))


def _at_home(description: RobotDescription) -> JointStates:
    positions: dict[str, float] = {}
    for posture in description.postures:
        if posture.name == "home":
            joints = description.group(posture.group).joints
            positions |= dict(zip(joints, posture.positions, strict=True))
    for effector in description.end_effectors:
        positions |= dict.fromkeys(effector.gripper.joints, 0.0)
    rest = (0.0,) * len(positions)
    return JointStates(
        stamp=_STAMP,
        names=tuple(positions),
        positions=tuple(positions.values()),
        velocities=rest,
        efforts=rest,
    )
