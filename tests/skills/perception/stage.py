"""A little robot with a head and a camera, over the bus in memory, that shows painted pictures."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import compose, to_pose
from tandem.skills.ports.hardware import (
    Answer,
    CancelMotion,
    GroupStatus,
    JointStates,
    MotionState,
    StopState,
    TrajectoryGoal,
)
from tandem.skills.ports.image import RgbdImage, encode
from tandem.skills.ports.keys import JOINT_STATES, STOP_STATE, group_cancel, group_goal, group_status, rgbd
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import DifferentialDrive, JointGroup, JointLimit, RobotDescription
from tandem.skills.ports.sensors import CameraSensor, LaserSensor
from tandem.skills.ports.world import ROBOT_POSE, RobotPose
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus

URDF = """<robot name="post">
  <link name="base"/><link name="neck"/><link name="skull"/><link name="eye"/><link name="optical"/>
  <joint name="pan" type="revolute"><parent link="base"/><child link="neck"/>
    <origin xyz="0 0 1.2"/><axis xyz="0 0 1"/>
    <limit lower="-1.3" upper="1.3" velocity="3" effort="5"/></joint>
  <joint name="tilt" type="revolute"><parent link="neck"/><child link="skull"/>
    <axis xyz="0 -1 0"/><limit lower="-1" upper="0.7" velocity="3" effort="5"/></joint>
  <joint name="eye_joint" type="fixed"><parent link="skull"/><child link="eye"/>
    <origin xyz="0.1 0 0"/></joint>
  <joint name="optical_joint" type="fixed"><parent link="eye"/><child link="optical"/>
    <origin rpy="-1.5707963267948966 0 -1.5707963267948966"/></joint>
</robot>"""

HEAD = JointGroup(
    name="head",
    limits=tuple(
        JointLimit(joint=name, lower=low, upper=up, velocity=3.0, acceleration=5.0, jerk=50.0, effort=5.0)
        for name, low, up in (("pan", -1.3, 1.3), ("tilt", -1.0, 0.7))
    ),
)

DESCRIPTION = RobotDescription(
    name="post",
    urdf=URDF,
    base_frame="base",
    footprint_radius=0.25,
    height=1.4,
    groups=(HEAD,),
    end_effectors=(),
    cameras=(CameraSensor(name="head", frame="optical", width=1280, height=720, horizontal_fov=math.pi / 3),),
    lasers=(
        LaserSensor(
            name="base",
            frame="base",
            angle_min=-1,
            angle_step=0.1,
            beams=21,
            range_min=0.1,
            range_max=5,
            period=0.1,
        ),
    ),
    drive=DifferentialDrive(
        forward=1, backward=0.2, acceleration=0.5, turn=1, turn_acceleration=1, dead_man=0.2
    ),
    postures=(),
    period=0.01,
)

Painter = Callable[[Pose, RobotTime], RgbdImage]


@dataclass
class Stage:
    """Steps of 10 ms: the head follows its goal, the camera shows what the painter paints, 10 a second."""

    painter: Painter
    base_in_map: FloorPose = field(default_factory=lambda: FloorPose(x=0, y=0, yaw=0))
    bus: MemoryBus = field(default_factory=MemoryBus)
    clocks: SteppedClocks = field(default_factory=lambda: SteppedClocks("b"))
    localised: bool = True
    camera_works: bool = True
    head: NDArray[np.float64] = field(default_factory=lambda: np.zeros(2))
    speed: NDArray[np.float64] = field(default_factory=lambda: np.zeros(2))
    painted: list[float] = field(default_factory=list)
    goals: list[TrajectoryGoal] = field(default_factory=list)
    refuse: str = ""
    held_up_at: float = -math.inf
    """Radians of the tilt below which the head can't get, whatever its limits say."""

    def __post_init__(self) -> None:
        self.clocks.advance(1.0)
        self._goals = self.bus.serve(group_goal("head").key)
        self._cancels = self.bus.serve(group_cancel("head").key)
        self._chain = Chain.from_urdf(URDF, "base", "optical")
        self._active: TrajectoryGoal | None = None
        self._began = 0.0
        self._late: list[tuple[float, bytes]] = []

    @property
    def now(self) -> RobotTime:
        return RobotTime(boot="b", seconds=self.clocks.seconds)

    def camera_in_map(self) -> Pose:
        in_base = self._chain.pose({"pan": float(self.head[0]), "tilt": float(self.head[1])})
        return compose(to_pose(self.base_in_map), in_base)

    def stop(self) -> None:
        STOP_STATE.publish(self.bus, StopState(stopped=True, by="test", reason="red button"))

    def step(self) -> None:
        self.clocks.advance(0.01)
        self._take_goals()
        self._move()
        JOINT_STATES.publish(
            self.bus,
            JointStates(
                stamp=self.now,
                names=HEAD.joints,
                positions=tuple(self.head.tolist()),
                velocities=tuple(self.speed.tolist()),
                efforts=(0.0, 0.0),
            ),
        )
        tick = round(self.clocks.seconds * 100)
        if tick % 5 == 0:
            ROBOT_POSE.publish(
                self.bus,
                RobotPose(
                    stamp=self.now,
                    localised=self.localised,
                    base_in_map=self.base_in_map,
                    odom_in_map=FloorPose(x=0, y=0, yaw=0),
                    position_sigma=0.01,
                    yaw_sigma=0.01,
                    moving=False,
                ),
            )
        if tick % 10 == 0 and self.camera_works and self.bus.listened(rgbd("head")):
            self.painted.append(self.clocks.seconds)
            self._late.append(
                (self.clocks.seconds + 0.06, encode(self.painter(self.camera_in_map(), self.now)))
            )
        while self._late and self._late[0][0] <= self.clocks.seconds:
            self.bus.publish(rgbd("head"), self._late.pop(0)[1])

    def _take_goals(self) -> None:
        for request in self._goals.drain():
            goal = group_goal("head").asked.model_validate_json(request.payload)
            request.reply(Answer(accepted=not self.refuse, reason=self.refuse).model_dump_json().encode())
            if not self.refuse:
                self.goals.append(goal)
                self._active, self._began = goal, self.clocks.seconds
        for request in self._cancels.drain():
            asked = CancelMotion.model_validate_json(request.payload)
            if self._active is not None and asked.id in ("", self._active.id):
                self._end(MotionState.CANCELED)
            request.reply(Answer(accepted=True).model_dump_json().encode())

    def _move(self) -> None:
        before = self.head
        if self._active is not None:
            points = self._active.points
            t = self.clocks.seconds - self._began
            times = [point.time for point in points]
            self.head = np.array(
                [np.interp(t, times, [point.positions[i] for point in points]) for i in range(2)]
            )
            held_up = float(self.head[1]) < self.held_up_at
            self.head[1] = max(float(self.head[1]), self.held_up_at)
            if held_up or t >= times[-1] + 0.03:
                self._end(MotionState.ABORTED if held_up else MotionState.SUCCEEDED)
        self.speed = (self.head - before) / 0.01

    def _end(self, state: MotionState) -> None:
        assert self._active is not None
        group_status("head").publish(
            self.bus, GroupStatus(stamp=self.now, group="head", goal_id=self._active.id, state=state)
        )
        self._active = None
