"""A robot on a plane: a differential drive and a laser that speak the hardware's messages, without physics.

It drives exactly as commanded (within the drive's limits), collides with nothing unless told to, and its
odometry and laser err as they are told to. Truth is at hand for tests: ``truth``.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import to_floor, wrap
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import BaseVelocity, Clock, Odometry, StopState
from tandem.skills.ports.keys import (
    BASE_VELOCITY,
    BUMPERS,
    CLIFFS,
    CLOCK,
    ODOMETRY,
    STOP_STATE,
    Latest,
    laser,
)
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import (
    DifferentialDrive,
    EndEffector,
    Gripper,
    JointGroup,
    JointLimit,
    RobotDescription,
)
from tandem.skills.ports.sensors import Bumpers, CameraSensor, Cliffs, LaserScan, LaserSensor, RangeReading
from tandem.skills.ports.site import Site, SiteBox

FloatArray = npt.NDArray[np.float64]
BOOT = "planar"
LASER_HEIGHT = 0.0945
URDF = f"""<robot name="planar"><link name="base_footprint"/><link name="base_laser_link"/>
  <joint name="laser" type="fixed"><parent link="base_footprint"/><child link="base_laser_link"/>
    <origin xyz="0.202 0 {LASER_HEIGHT}"/></joint></robot>"""


@dataclass(frozen=True)
class PlanarNoise:
    """How odometry and laser err: shares of way and turn, radians a root metre, metres."""

    scale: float = 0.03
    turn_scale: float = -0.02
    drift: float = 0.02
    laser_sigma: float = 0.015


@dataclass
class PlanarClocks:
    """Robot time as the fake counts it; the other clocks follow it."""

    seconds: float = 0.0

    def robot(self) -> RobotTime:
        return RobotTime(boot=BOOT, seconds=self.seconds)

    def passed(self) -> float:
        return self.seconds

    def monotonic(self) -> float:
        return self.seconds

    def utc(self) -> float:
        return self.seconds


def describe(*, arms: tuple[str, ...] = ("arm_left", "arm_right"), radius: float = 0.3) -> RobotDescription:
    """Return a description of the fake: TIAGo's drive and laser, arms by name only."""
    limit = JointLimit(joint="j", lower=-1, upper=1, velocity=1, acceleration=5, jerk=50, effort=10)
    hand = Gripper(joints=("f",), max_width=0.09, speed=0.05, force=16)
    return RobotDescription(
        name="planar",
        urdf=URDF,
        base_frame="base_footprint",
        footprint_radius=radius,
        height=1.3,
        groups=tuple(JointGroup(name=arm, limits=(limit,)) for arm in arms),
        end_effectors=tuple(
            EndEffector(
                side="left" if arm.endswith("left") else "right",
                group=arm,
                frame="tool",
                touch_links=(),
                gripper=hand,
            )
            for arm in arms
        ),
        cameras=(CameraSensor(name="head", frame="camera", width=1280, height=720, horizontal_fov=1.05),),
        lasers=(
            LaserSensor(
                name="base",
                frame="base_laser_link",
                angle_min=math.radians(-110),
                angle_step=math.radians(0.5),
                beams=441,
                range_min=0.05,
                range_max=10.0,
                period=0.1,
            ),
        ),
        drive=DifferentialDrive(
            forward=1.0, backward=0.2, acceleration=0.5, turn=1.05, turn_acceleration=1.05, dead_man=0.3
        ),
        postures=(),
        period=0.01,
    )


@dataclass
class PlanarRobot:
    """The fake itself: ``step`` moves it by one period of 10 ms and publishes what is due.

    ``boxes`` is what the laser sees; add to it for what no map knows.
    ``laser_on``, ``stopped`` and ``pressed`` are faults.
    """

    bus: Bus
    clocks: PlanarClocks
    description: RobotDescription
    site: Site
    rng: np.random.Generator
    truth: FloorPose
    noise: PlanarNoise = PlanarNoise()
    boxes: list[SiteBox] = field(default_factory=list)
    laser_on: bool = True
    stopped: bool = False
    pressed: tuple[str, ...] = ()
    floor: Callable[[PlanarRobot], dict[str, float]] = lambda _: {}
    """What each cliff sensor reads (m), to which a little noise comes; one that is not there is silent."""
    stuck: bool = False
    """Whether cliff sensors read without noise."""
    tick: int = 0
    driven: float = 0.0
    linear: float = 0.0
    angular: float = 0.0

    def __post_init__(self) -> None:
        mount = Chain.from_urdf(
            self.description.urdf, self.description.base_frame, self.description.laser.frame
        )
        self.laser_in_base = to_floor(mount.pose({}))
        self.boxes += [
            box
            for furniture in self.site.furniture
            for box in furniture.boxes
            if abs(box.centre[2] - LASER_HEIGHT) <= box.size[2] / 2
        ]
        self._commands = Latest(self.bus, BASE_VELOCITY)
        self._commanded_at = -math.inf
        self._odometry = FloorPose(x=0.0, y=0.0, yaw=0.4)

    def step(self) -> None:
        """Move on by one period."""
        period = self.description.period
        self.tick += 1
        self.clocks.seconds = round(self.tick * period, 6)
        if self._commands.take():
            self._commanded_at = self.clocks.seconds
        self._move(period)
        stamp = self.clocks.robot()
        CLOCK.publish(self.bus, Clock(stamp=stamp, tick=self.tick))
        if self.tick % 2 == 0:
            ODOMETRY.publish(
                self.bus,
                Odometry(stamp=stamp, base_in_odom=self._odometry, linear=self.linear, angular=self.angular),
            )
        if self.description.cliff_sensors and self.tick % 2 == 0:
            noise = 0.0 if self.stuck else 1e-5 * (self.tick % 7)
            readings = (
                RangeReading(sensor=name, distance=far + noise) for name, far in self.floor(self).items()
            )
            CLIFFS.publish(self.bus, Cliffs(stamp=stamp, readings=tuple(readings)))
        if self.laser_on and self.tick % round(self.description.laser.period / period) == 0:
            laser("base").publish(self.bus, LaserScan(stamp=stamp, ranges=tuple(self.ranges().tolist())))
        if self.tick % 20 == 0:
            STOP_STATE.publish(self.bus, StopState(stopped=self.stopped))
            BUMPERS.publish(self.bus, Bumpers(stamp=stamp, pressed=self.pressed))

    def leap(self, by: FloorPose) -> None:
        """Have odometry take a step that the base didn't."""
        self._odometry = _advance_to(self._odometry, by)

    def _move(self, period: float) -> None:
        drive = self.description.driven
        command = self._commands.value
        fresh = self.clocks.seconds - self._commanded_at <= drive.dead_man
        asked = (
            command
            if command is not None and fresh and not self.stopped
            else BaseVelocity(linear=0, angular=0)
        )
        linear = min(max(asked.linear, -drive.backward), drive.forward)
        angular = min(max(asked.angular, -drive.turn), drive.turn)
        self.linear = _towards(self.linear, linear, 1.2 * drive.acceleration * period)
        self.angular = _towards(self.angular, angular, 1.2 * drive.turn_acceleration * period)
        ds, dyaw = self.linear * period, self.angular * period
        self.truth = _advance(self.truth, ds, dyaw)
        self.driven += abs(ds)
        noise = self.noise
        wobble = noise.drift * math.sqrt(abs(ds)) * float(self.rng.normal())
        self._odometry = _advance(
            self._odometry, ds * (1 + noise.scale), dyaw * (1 + noise.turn_scale) + wobble
        )

    def ranges(self) -> FloatArray:
        """Return one noisy scan from where the robot truly is (m)."""
        sensor = self.description.laser
        laser = _advance_to(self.truth, self.laser_in_base)
        angles = laser.yaw + sensor.angle_min + sensor.angle_step * np.arange(sensor.beams)
        hits = cast_rays(self.boxes, laser.x, laser.y, np.asarray(angles, dtype=np.float64))
        hits = hits + self.rng.normal(0.0, self.noise.laser_sigma or 1e-12, len(hits))
        return np.where(hits >= sensor.range_max, sensor.range_max, np.maximum(hits, 0.0))

    def clearance(self) -> float:
        """Return the distance from the robot's axis to the nearest thing that the laser could see (m)."""
        return min(_gap(box, self.truth) for box in self.boxes)


def cast_rays(boxes: list[SiteBox], x: float, y: float, angles: FloatArray) -> FloatArray:
    """Return the distance along each direction to the first box (m; 1e3 for none): the slab method."""
    nearest = np.full(len(angles), 1e3)
    for box in boxes:
        c, s = math.cos(box.yaw), math.sin(box.yaw)
        dx, dy = x - box.centre[0], y - box.centre[1]
        origin = (c * dx + s * dy, c * dy - s * dx)
        direction = (np.cos(angles - box.yaw), np.sin(angles - box.yaw))
        enter, leave = np.full(len(angles), -np.inf), np.full(len(angles), np.inf)
        for axis in range(2):
            step = np.where(np.abs(direction[axis]) < 1e-12, 1e-12, direction[axis])
            a = (-box.size[axis] / 2 - origin[axis]) / step
            b = (box.size[axis] / 2 - origin[axis]) / step
            enter, leave = np.maximum(enter, np.minimum(a, b)), np.minimum(leave, np.maximum(a, b))
        hit = (enter <= leave) & (enter > 0)
        nearest = np.where(hit, np.minimum(nearest, enter), nearest)
    return nearest


def _towards(value: float, target: float, step: float) -> float:
    return value + min(max(target - value, -step), step)


def _advance(pose: FloorPose, ds: float, dyaw: float) -> FloorPose:
    middle = pose.yaw + dyaw / 2
    return FloorPose(
        x=pose.x + ds * math.cos(middle), y=pose.y + ds * math.sin(middle), yaw=wrap(pose.yaw + dyaw)
    )


def _advance_to(pose: FloorPose, offset: FloorPose) -> FloorPose:
    c, s = math.cos(pose.yaw), math.sin(pose.yaw)
    return FloorPose(
        x=pose.x + c * offset.x - s * offset.y,
        y=pose.y + s * offset.x + c * offset.y,
        yaw=pose.yaw + offset.yaw,
    )


def _gap(box: SiteBox, pose: FloorPose) -> float:
    c, s = math.cos(box.yaw), math.sin(box.yaw)
    dx, dy = pose.x - box.centre[0], pose.y - box.centre[1]
    ex = max(abs(c * dx + s * dy) - box.size[0] / 2, 0.0)
    ey = max(abs(c * dy - s * dx) - box.size[1] / 2, 0.0)
    return math.hypot(ex, ey)
