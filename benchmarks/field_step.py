"""How long one period of an arm's field takes with ten obstacles: ``python -m benchmarks.field_step``.

Everything from the joints and beliefs to the next set-point that is known to be free: distances and
gradients, the choice of a pole, the hand's desired twist, the quadratic program, the jerk-limited step and
the check of its braking.
"""

from __future__ import annotations

import time

from benchmarks.rows import Row, spread
from tandem.sim.robots.registry import robot_model
from tandem.skills.arm.doubt import Doubt
from tandem.skills.arm.field.approach_context import Parts
from tandem.skills.arm.field.approach_steps import Ride
from tandem.skills.arm.field.ends import End, Ends
from tandem.skills.arm.field.field_controller import FieldController
from tandem.skills.arm.field.live import Live
from tandem.skills.arm.field.target import TargetTracker
from tandem.skills.arm.field.teller import Teller
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.right_of_way import Gate
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.grasping.tag_grasps import tool_orientation
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.ports.actions.approach import ApproachGoal
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES
from tandem.skills.ports.message import RobotTime, Vector3
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.world import (
    ROBOT_POSE,
    SCENE,
    WORLD,
    Box,
    ItemFact,
    PlanningScene,
    RobotPose,
    SceneObject,
    WorldState,
)
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus

CUBE: Vector3 = (0.07, 0.07, 0.07)
PLACES = ((0.65, 0.12), (0.50, 0.45), (0.62, 0.42), (0.75, 0.30), (0.80, 0.0), (0.50, -0.25), (0.65, -0.35),
          (0.80, -0.25), (0.90, 0.20))  # fmt: skip
"""Of nine cubes on a table, which is the tenth obstacle; the first is approached."""


class _Table:
    """An arm before a table: beliefs and joints as they would be heard."""

    def __init__(self, description: RobotDescription) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("bench")
        arm = Arm(load_hulls(description), description, "arm_left")
        self.parts = Parts(
            bus=self.bus,
            clocks=self.clocks,
            arm=arm,
            where="benchmark",
            live=Live(self.bus, self.clocks, arm),
            tracker=TargetTracker(self.bus, self.clocks),
            planner=MovePlanner(arm, PlannerSettings(), "benchmark"),
            gate=Gate(self.bus, self.clocks, "left"),
            teller=Teller(self.bus, self.clocks, "arm_left", "left"),
            doubt=Doubt(),
        )
        self.positions = {
            joint: value
            for posture in description.postures
            if posture.name == "home"
            for joint, value in zip(description.group(posture.group).joints, posture.positions, strict=True)
        }
        self._believe()

    def _believe(self) -> None:
        stamp = RobotTime(boot="bench", seconds=0.0)
        cubes = [Pose(position=(x, y, 0.745)) for x, y in PLACES]
        table = Box(size=(0.9, 1.24, 0.04), pose=Pose(position=(0.79, 0.0, 0.69)))
        things = [SceneObject(name="table", kind="furniture", box=table)]
        things += [
            SceneObject(name=f"item_{k}", kind="item", box=Box(size=CUBE, pose=pose), item=k)
            for k, pose in enumerate(cubes)
        ]
        SCENE.publish(self.bus, PlanningScene(stamp=stamp, version=1, objects=tuple(things)))
        tag = tag_of_item(cubes[0], CUBE[0])
        fact = ItemFact(item=0, size=CUBE, tag_in_map=tag, seen=stamp, quality=1.0, position_sigma=0.0)
        WORLD.publish(self.bus, WorldState(stamp=stamp, version=1, items=(fact,)))
        here = FloorPose(x=0.0, y=0.0, yaw=0.0)
        pose = RobotPose(stamp=stamp, localised=True, base_in_map=here, odom_in_map=here, position_sigma=0.0,
                         yaw_sigma=0.0, moving=False)  # fmt: skip
        ROBOT_POSE.publish(self.bus, pose)

    def tell(self) -> None:
        """Let a period pass, the arm where it is told to be."""
        self.clocks.advance(0.01)
        stamp = RobotTime(boot="bench", seconds=self.clocks.seconds)
        zeros = (0.0,) * len(self.positions)
        names, values = tuple(self.positions), tuple(self.positions.values())
        states = JointStates(stamp=stamp, names=names, positions=values, velocities=zeros, efforts=zeros)
        JOINT_STATES.publish(self.bus, states)


def _approach(table: _Table, goal: ApproachGoal) -> list[float]:
    """Return the seconds of each period of one approach."""
    table.tell()
    ride = Ride(table.parts, goal)
    ride.refresh()
    ride.motion.begin()
    controller = FieldController(table.parts.arm, table.parts.live, ride.guard, ride.motion, goal.speed)
    ends = Ends(table.parts.arm, table.parts.planner, table.parts.live, goal)
    end: End | None = None
    seconds: list[float] = []
    for _ in range(600):
        table.tell()
        ride.motion.ticks()
        began = time.thread_time()
        ride.refresh()
        assert ride.target is not None, "the item is believed in"
        if end is None:
            ends.think(ride.target, ride.motion.state.q)
            end = ends.end
            continue
        step = controller.step(1, ride.target, end)
        seconds.append(time.thread_time() - began)
        q = ride.motion.state.q
        table.positions |= dict(zip(table.parts.arm.group.joints, map(float, q), strict=True))
        if step.arrived:
            break
    return seconds


def rows(*, quick: bool = False) -> list[Row]:
    """Return the figures: CPU time of the thread, hearing of joints and beliefs included."""
    grasps = tuple(
        Pose(position=(0.0, 0.0, 0.0), orientation=tool_orientation(out, 0.785))
        for out in ((-1.0, 0.0, 0.0), (-0.7071067811865476, 0.7071067811865476, 0.0))
    )
    goal = ApproachGoal(item=0, grasps=grasps, hand_width=0.09)
    description, seconds = robot_model("tiago_dual").description, list[float]()
    for _ in range(1 if quick else 8):
        seconds += _approach(_Table(description), goal)
    return spread("field, one period of an arm, 10 obstacles, CPU", seconds, aim=1.0)


def main() -> None:
    """Print the figures."""
    for row in rows():
        print(f"{row.what:60} {row.value:8.3f} {row.unit} {row.note}")


if __name__ == "__main__":
    main()
