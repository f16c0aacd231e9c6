"""Problems for comparing planners: shelf picks of the LoCoBot, and slots between plates."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from benchmarks.arm_problems import STAMP, Drawing
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import load_scenario
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.motions import Motions, Space
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.steps import run_through
from tandem.skills.ports.world import Box, PlanningScene, SceneObject
from tandem.skills.site import load

ASIDE: Final = 0.9
"""Radians of the waist on both sides of the slot."""
LEVEL: Final = (0.22, 0.34)
"""Metres above the floor between which a slot's middle is drawn."""
SLOT: Final = (0.20, 0.26)
"""Metres of its height."""


@dataclass(frozen=True)
class PlannerProblem:
    """From where the joints stand in a moment to joint positions."""

    moment: Moment
    goal: MoveGoal


@dataclass(frozen=True)
class Room:
    """The LoCoBot in the room of shelves, and its arm."""

    drawing: Drawing
    arm: Arm


def room() -> Room:
    """Return the scenario ``Locobot``."""
    scenario = load_scenario("Locobot")
    description = robot_model("locobot").description
    arm = Arm(load_hulls(description), description, description.end_effectors[0].group)
    return Room(Drawing(description, load(scenario.site), scenario), arm)


def picks(world: Room, count: int, seed: int) -> tuple[list[PlannerProblem], Mapping[str, int]]:
    """Return so many picks whose straight motion is blocked, and how many others were drawn, by reason."""
    rng, left_out = np.random.default_rng(seed), Counter[str]()
    found: list[PlannerProblem] = []
    planner = MovePlanner(world.arm, PlannerSettings(), "benchmark")
    while len(found) < count:
        drawn = world.drawing.problem(rng)
        if drawn is None:
            left_out["no room"] += 1
            continue
        reached = run_through(planner.reach(drawn.pre_grasp, drawn.moment))
        if isinstance(reached, Failure):
            left_out["no joint positions"] += 1
            continue
        goal = MoveGoal(joints=tuple(map(float, reached.q)), hand_width=drawn.width)
        problem = PlannerProblem(drawn.moment, goal)
        if _blocked(world.arm, problem):
            found.append(problem)
        else:
            left_out["straight"] += 1
    return found, dict(left_out)


def passages(world: Room, count: int, seed: int) -> tuple[list[PlannerProblem], Mapping[str, int]]:
    """Return so many slots between two plates across the arm's way, which it must go through or around."""
    rng, left_out = np.random.default_rng(seed), Counter[str]()
    found: list[PlannerProblem] = []
    arm = world.arm
    low, high = arm.limits.lower, arm.limits.upper
    base = FloorPose(x=0.0, y=0.0, yaw=0.0)
    while len(found) < count:
        middle, height = rng.uniform(*LEVEL), rng.uniform(*SLOT)
        scene = PlanningScene(
            stamp=STAMP,
            version=1,
            objects=(
                _plate("below", 0.0, middle - height / 2.0),
                _plate("above", middle + height / 2.0, 0.9),
            ),
        )
        reach = np.array([0.0, *rng.uniform(low[1:], high[1:])])
        start, end = reach.copy(), reach.copy()
        start[0], end[0] = rng.uniform(0.6 * ASIDE, ASIDE), -rng.uniform(0.6 * ASIDE, ASIDE)
        goal = MoveGoal(joints=tuple(map(float, end)))
        problem = PlannerProblem(_standing(world, start, scene, base), goal)
        checker = arm.checker(problem.moment, goal)
        x, _, z = checker.chain.pose(reach, arm.hand.frame if arm.hand else "").position
        if not (checker.free(start) and checker.free(end)) or x < REACHES or abs(z - middle) > height:
            left_out["ends"] += 1
        elif _blocked(arm, problem):
            found.append(problem)
        else:
            left_out["straight"] += 1
    return found, dict(left_out)


REACHES: Final = 0.35
"""Metres ahead of the base that the hand reaches at least: so the arm is long where the plates are."""


def _plate(name: str, low: float, high: float) -> SceneObject:
    box = Box(size=(0.5, 0.02, high - low), pose=Pose(position=(0.47, 0.0, (low + high) / 2.0)))
    return SceneObject(name=name, kind="furniture", box=box)


def _standing(world: Room, q: Array, scene: PlanningScene, base: FloorPose) -> Moment:
    joints: JointStates = world.drawing.at_home()
    at = dict(zip(joints.names, joints.positions, strict=True))
    at |= dict(zip(world.arm.group.joints, map(float, q), strict=True))
    return Moment(replace_joints(joints, at), scene, base)


def replace_joints(joints: JointStates, at: Mapping[str, float]) -> JointStates:
    """Return the states with other positions."""
    return joints.model_copy(update={"positions": tuple(at[name] for name in joints.names)})


def _blocked(arm: Arm, problem: PlannerProblem) -> bool:
    """Say whether the straight motion is not free, though both its ends are."""
    checker = arm.checker(problem.moment, problem.goal)
    checker.touch(allowed=False)
    start, end = arm.start(problem.moment), np.array(problem.goal.joints)
    checker.let_rest(start)
    motions = Motions(checker, Space(arm.limits, arm.weights))
    return checker.free(start) and checker.free(end) and not motions.free(start, end)
