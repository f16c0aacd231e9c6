"""A robot of which only joints exist, for tests of arms: it follows each trajectory to the letter."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tandem.skills.arm.problem import Moment
from tandem.skills.arm.process import nodes
from tandem.skills.arm.reflexes.registry import OWNER
from tandem.skills.arm.trajectory import Trajectory
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.limbs import Limb, arm
from tandem.skills.ports.action import GoalState, GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.actions.arm import ArmState, MoveGoal, MoveResult, arm_status, move
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.hardware import (
    Answer,
    CancelMotion,
    GroupStatus,
    JointStates,
    MotionState,
    TrajectoryGoal,
)
from tandem.skills.ports.keys import JOINT_STATES, Latest, group_cancel, group_goal, group_status
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.reflex import ARM
from tandem.skills.ports.robot_description import (
    DifferentialDrive,
    EndEffector,
    Gripper,
    JointGroup,
    JointLimit,
    Posture,
    RobotDescription,
)
from tandem.skills.ports.sensors import CameraSensor, LaserSensor
from tandem.skills.ports.world import ROBOT_POSE, SCENE, Box, PlanningScene, RobotPose, SceneObject
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus

PANDA_HOME = (0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785)
PANDA = "package://example-robot-data/robots/panda_description/urdf/panda.urdf"
PANDA_LIMITS = (
    (-2.8973, 2.8973, 2.175),
    (-1.7628, 1.7628, 2.175),
    (-2.8973, 2.8973, 2.175),
    (-3.0718, -0.0698, 2.175),
    (-2.8973, 2.8973, 2.61),
    (-0.0175, 3.7525, 2.61),
    (-2.8973, 2.8973, 2.61),
)


def panda() -> RobotDescription:
    """Return another robot: one arm, on the floor, by its description alone."""
    limits = tuple(
        JointLimit(
            joint=f"panda_joint{i}",
            lower=low,
            upper=high,
            velocity=fast,
            acceleration=6.0,
            jerk=60.0,
            effort=87.0,
        )
        for i, (low, high, fast) in enumerate(PANDA_LIMITS, start=1)
    )
    hand = EndEffector(
        side="right",
        group="arm",
        frame="panda_hand_tcp",
        touch_links=("panda_leftfinger", "panda_rightfinger"),
        gripper=Gripper(
            joints=("panda_finger_joint1", "panda_finger_joint2"), max_width=0.08, speed=0.1, force=20.0
        ),
        work_point=(0.5, 0.0),
    )
    return RobotDescription(
        name="panda",
        urdf=resolve(PANDA).read_text(encoding="utf-8"),
        base_frame="panda_link0",
        footprint_radius=0.3,
        height=1.2,
        groups=(JointGroup(name="arm", limits=limits),),
        end_effectors=(hand,),
        cameras=(CameraSensor(name="none", frame="panda_link0", width=2, height=2, horizontal_fov=1.0),),
        lasers=(
            LaserSensor(
                name="base",
                frame="panda_link0",
                angle_min=-1.0,
                angle_step=0.1,
                beams=3,
                range_min=0.1,
                range_max=10.0,
                period=0.1,
            ),
        ),
        drive=DifferentialDrive(
            forward=1.0, backward=0.2, acceleration=0.5, turn=1.0, turn_acceleration=1.0, dead_man=0.2
        ),
        postures=(Posture(name="home", group="arm", positions=PANDA_HOME),),
        period=0.01,
    )


def box(
    name: str,
    size: tuple[float, float, float],
    position: tuple[float, float, float],
    *,
    item: int | None = None,
) -> SceneObject:
    """Return an upright box of the scene: furniture, or an item."""
    return SceneObject(
        name=name,
        kind="furniture" if item is None else "item",
        box=Box(size=size, pose=Pose(position=position)),
        item=item,
    )


@dataclass
class JointsOnly:
    """The hardware of one group; a ``Node``. ``stray_at`` aborts a motion at that share of its time.

    The joint ``stuck`` stays where it is, and aborts motions in which it strays or does not arrive. So many
    answers to goals as ``answers_lost`` says never arrive. While it is ``silent``, it tells no joint states.
    """

    bus: MemoryBus
    clocks: SteppedClocks
    group: JointGroup
    positions: dict[str, float]
    stray_at: float | None = None
    answers_lost: int = 0
    stuck: str = ""
    silent: bool = False
    goals: list[TrajectoryGoal] = field(default_factory=list)
    _began: float = 0.0
    _active: Trajectory | None = None

    name = "joints only"

    def __post_init__(self) -> None:
        self._goal = self.bus.serve(group_goal(self.group.name).key)
        self._cancel = self.bus.serve(group_cancel(self.group.name).key)

    @property
    def stamp(self) -> RobotTime:
        return RobotTime(boot="test", seconds=self.clocks.seconds)

    def step(self) -> bool:
        for request in self._goal.drain():
            goal = TrajectoryGoal.model_validate_json(request.payload)
            if self.answers_lost:
                self.answers_lost -= 1
            else:
                request.reply(Answer(accepted=True).model_dump_json().encode())
            if self.goals and self.goals[-1].id == goal.id:
                continue
            self.goals.append(goal)
            points = goal.points
            self._active = Trajectory(
                np.array([p.time for p in points]),
                np.array([p.positions for p in points]),
                np.array([p.velocities for p in points]),
            )
            self._began = self.clocks.seconds
            self._tell(MotionState.ACTIVE, at_rest=False)
        for request in self._cancel.drain():
            CancelMotion.model_validate_json(request.payload)
            request.reply(Answer(accepted=True).model_dump_json().encode())
            if self._active is not None:
                self._active = None
                self._tell(MotionState.CANCELED, at_rest=True)
        if self._active is not None:
            self._follow(self._active)
        if self.silent:
            return False
        names = tuple(self.positions)
        rest = tuple(0.0 for _ in names)
        values = tuple(self.positions.values())
        JOINT_STATES.publish(
            self.bus,
            JointStates(stamp=self.stamp, names=names, positions=values, velocities=rest, efforts=rest),
        )
        return False

    @property
    def moves(self) -> bool:
        """Whether a motion is under way."""
        return self._active is not None

    def close(self) -> None:
        self._goal.close()

    def _follow(self, active: Trajectory) -> None:
        t = self.clocks.seconds - self._began
        q = active.sample(np.array([t]))[0]
        there, off = dict(zip(self.group.joints, map(float, q), strict=True)), 0.0
        goal, late = self.goals[-1], t - active.duration
        if self.stuck:
            off = abs(there.pop(self.stuck) - self.positions[self.stuck])
        if off > goal.path_tolerance or (off > goal.goal_tolerance and late >= goal.goal_time):
            self._active = None
            self._tell(MotionState.ABORTED, at_rest=True, joint=self.stuck, error=off)
            return
        self.positions |= there
        if self.stray_at is not None and t >= self.stray_at * active.duration:
            self._active = None
            self._tell(MotionState.ABORTED, at_rest=True, joint=self.group.joints[0], error=0.2)
        elif late >= 0.0 and off <= goal.goal_tolerance:
            self._active = None
            self._tell(MotionState.SUCCEEDED, at_rest=True)

    def _tell(self, state: MotionState, *, at_rest: bool, joint: str = "", error: float = 0.0) -> None:
        status = GroupStatus(
            stamp=self.stamp,
            group=self.group.name,
            goal_id=self.goals[-1].id,
            state=state,
            joint=joint,
            error=error,
            at_rest=at_rest,
        )
        group_status(self.group.name).publish(self.bus, status)


class ArmRig:
    """Hardware, the move's server and a client, stepped together, 10 ms a round."""

    def __init__(
        self, description: RobotDescription, group: str, *, seed: int = 0, hulls: RobotHulls | None = None
    ) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("test")
        home = {
            joint: value
            for posture in description.postures
            if posture.name == "home"
            for joint, value in zip(description.group(posture.group).joints, posture.positions, strict=True)
        }
        self.description, self.group = description, description.group(group)
        self.hardware = JointsOnly(self.bus, self.clocks, self.group, home)
        self.hulls = load_hulls(description) if hulls is None else hulls
        limbs = [self._limb(hand.side) for hand in description.end_effectors if hand.group == group]
        pipelines = {group: limbs[0].pipeline(ARM)} if limbs else {}
        servers = nodes(
            self.bus,
            self.clocks,
            description,
            (group,),
            hulls=self.hulls,
            seed=seed,
            charge=True,
            pipelines=pipelines,
        )
        self._nodes = [self.hardware, *limbs, *servers]
        self._status = Latest(self.bus, status_topic(f"{group}/move"))
        self._states = Latest(self.bus, arm_status(group))
        self.states: list[ArmState] = []
        self.set_scene()
        self.tell_pose()
        self.rounds(2)

    def _limb(self, side: str) -> Limb:
        choice = OWNER.chosen_for(OWNER.types(None), self.description, load("lab"), "lab", part=side)
        return Limb(arm(self.bus, self.clocks, self.description, side), choice)

    def set_scene(self, *objects: SceneObject, version: int = 1) -> None:
        """Tell a scene."""
        SCENE.publish(self.bus, PlanningScene(stamp=self.hardware.stamp, version=version, objects=objects))

    def tell_pose(self, x: float = 0.0, *, localised: bool = True) -> None:
        """Tell that the robot stands at the map's origin, or so far before it (m), or believes to."""
        pose = RobotPose(
            stamp=self.hardware.stamp,
            localised=localised,
            base_in_map=FloorPose(x=x, y=0.0, yaw=0.0),
            odom_in_map=FloorPose(x=0.0, y=0.0, yaw=0.0),
            position_sigma=0.0,
            yaw_sigma=0.0,
            moving=False,
        )
        ROBOT_POSE.publish(self.bus, pose)

    def moment(self, *objects: SceneObject) -> Moment:
        """Return what would be believed with these objects in the scene."""
        names, values = tuple(self.hardware.positions), tuple(self.hardware.positions.values())
        rest = tuple(0.0 for _ in names)
        stamp = self.hardware.stamp
        joints = JointStates(stamp=stamp, names=names, positions=values, velocities=rest, efforts=rest)
        return Moment(
            joints, PlanningScene(stamp=stamp, version=1, objects=objects), FloorPose(x=0, y=0, yaw=0)
        )

    def rounds(self, count: int) -> None:
        """Let time pass."""
        for _ in range(count):
            self.clocks.advance(0.01)
            for node in self._nodes:
                node.step()
            for status in self._states.take():
                if not self.states or self.states[-1] is not status.state:
                    self.states.append(status.state)

    def send(self, goal: MoveGoal, goal_id: str = "t/move/1") -> Pending:
        """Send a goal."""
        document = goal.model_dump(mode="json")
        return goal_service(f"{self.group.name}/move").query(
            self.bus, SendGoal(goal_id=goal_id, client="", goal=document)
        )

    def until(self, *states: GoalState, most: int = 3000) -> GoalStatus:
        """Go on until the goal is in one of the states."""
        for _ in range(most):
            self.rounds(1)
            status = self._status.refresh()
            if status is not None and status.state in states:
                return status
        raise AssertionError(f"not {states} after {most} rounds, but {self._status.value}")

    def run(self, goal: MoveGoal, goal_id: str = "t/move/1") -> GoalStatus:
        """Send a goal and go on until it has ended."""
        self.send(goal, goal_id)
        return self.until(GoalState.SUCCEEDED, GoalState.FAILED, GoalState.CANCELED, GoalState.REJECTED)

    def result(self, status: GoalStatus) -> MoveResult:
        """Return the result of a goal that succeeded."""
        assert status.result is not None, status
        return move(self.group.name).result.model_validate(status.result)
