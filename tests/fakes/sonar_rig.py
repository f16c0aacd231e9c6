"""A base with a pose sensor and sonars, on a planar robot that obeys at once and sees what a test says."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from tandem.sim.robots.registry import robot_model
from tandem.skills.base.process import build
from tandem.skills.ports.action import GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.hardware import BaseVelocity, Odometry
from tandem.skills.ports.keys import BASE_VELOCITY, ODOMETRY, POSE_READING, RANGES, ROBOTS_SEEN, Latest
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import PipelineState, pipeline_state
from tandem.skills.ports.sensors import PoseReading, RangeReading, Ranges, RobotsSeen, SeenRobot
from tandem.skills.ports.whereabouts import Neighbours
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus

PERIOD = 0.02


@dataclass
class SonarRig:
    """A P3-DX without physics: its wheels do as they are told."""

    robot: str = "p3dx"
    pose: FloorPose = field(default_factory=lambda: FloorPose(x=0.0, y=0.0, yaw=0.0))
    seen: dict[str, float] = field(default_factory=dict)
    """Metres that sonars tell; the others tell that they see nothing."""
    silent: set[str] = field(default_factory=set)
    others: dict[str, tuple[float, float]] = field(default_factory=dict)
    """Where other robots are in the map, for a robot that has a sensor for them."""
    left_out: dict[str, str] | None = None
    """Plug-ins that are known not to load; None: there are none."""

    def __post_init__(self) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("rig")
        self.description = robot_model(self.robot).description
        self.commons = MemoryBus()
        self.nodes = build(
            self.bus,
            self.clocks,
            self.description,
            load("rocs"),
            left_out=self.left_out,
            neighbours=Neighbours(self.commons, self.clocks, "rig"),
        )
        self._commands = Latest(self.bus, BASE_VELOCITY, depth=256)
        self._states = Latest(self.bus, pipeline_state("base"), depth=256)
        self.speed = BaseVelocity(linear=0.0, angular=0.0)
        self.commands: list[BaseVelocity] = []
        self.told: list[PipelineState] = []
        self._ticks = 0

    def step(self) -> None:
        """One period: the robot moves and tells, and its nodes are stepped."""
        self._ticks += 1
        self.clocks.advance(PERIOD)
        turned = self.speed.angular * PERIOD
        way, middle = self.speed.linear * PERIOD, self.pose.yaw + turned / 2.0
        self.pose = FloorPose(
            x=self.pose.x + way * math.cos(middle),
            y=self.pose.y + way * math.sin(middle),
            yaw=math.remainder(self.pose.yaw + turned, math.tau),
        )
        now = self.clocks.robot()
        assert now is not None
        ODOMETRY.publish(
            self.bus,
            Odometry(stamp=now, base_in_odom=self.pose, linear=self.speed.linear, angular=self.speed.angular),
        )
        if self._ticks % 3 == 0:
            sensor = self.description.pose_sensors[0].name
            POSE_READING.publish(self.bus, PoseReading(stamp=now, sensor=sensor, base_in_map=self.pose))
        if self._ticks % 5 == 0:
            readings = tuple(
                RangeReading(sensor=each.name, distance=self.seen.get(each.name, each.range_max))
                for each in self.description.range_sensors
                if each.name not in self.silent
            )
            RANGES.publish(self.bus, Ranges(stamp=now, readings=readings))
            for each in self.description.robot_sensors:
                seen = [self._seen(*at, name, each.field) for name, at in self.others.items()]
                robots = tuple(one for one in seen if one is not None)
                ROBOTS_SEEN.publish(self.bus, RobotsSeen(stamp=now, sensor=each.name, robots=robots))
        for node in self.nodes:
            node.step()
        sent = self._commands.take()
        self.commands += sent
        if sent:
            self.speed = sent[-1]
        self.told += self._states.take()

    def _seen(self, x: float, y: float, name: str, field_of_view: float) -> SeenRobot | None:
        dx, dy, yaw = x - self.pose.x, y - self.pose.y, self.pose.yaw
        at = SeenRobot(
            name=name,
            x=math.cos(yaw) * dx + math.sin(yaw) * dy,
            y=-math.sin(yaw) * dx + math.cos(yaw) * dy,
        )
        return at if abs(math.atan2(at.y, at.x)) <= field_of_view / 2.0 else None

    def wait(self, seconds: float) -> None:
        """Let so many robot seconds pass."""
        for _ in range(round(seconds / PERIOD)):
            self.step()

    def send(self, action: str, goal: Message) -> Latest[GoalStatus]:
        """Send a goal; return what tells how it is."""
        statuses = Latest(self.bus, status_topic(action), depth=256)
        goal_service(action).query(
            self.bus, SendGoal(goal_id=f"t/{action}/1", client="", goal=goal.model_dump(mode="json"))
        )
        return statuses

    def until_ended(self, statuses: Latest[GoalStatus], within: float = 60.0) -> GoalStatus:
        """Step until the goal has ended."""
        for _ in range(round(within / PERIOD)):
            self.step()
            status = statuses.refresh()
            if status is not None and status.state.terminal:
                return status
        raise AssertionError(f"no end within {within} s, at {self.pose}")
