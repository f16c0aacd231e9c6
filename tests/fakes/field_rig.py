"""TIAGo++ of which only joints exist, for tests of approaches; they follow as the sim's controllers do."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from tandem.sim.joints import GroupController
from tandem.skills.arm.process import nodes
from tandem.skills.arm.reflexes.registry import OWNER
from tandem.skills.geometry.poses import about, compose
from tandem.skills.grasping.tag_grasps import tool_orientation
from tandem.skills.kinematics.bodies import BoxShape, Obstacle
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.limbs import Limb, arm
from tandem.skills.ports.action import (
    GoalCommand,
    GoalState,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    status_topic,
)
from tandem.skills.ports.actions.approach import ApproachGoal, ApproachPhase, ApproachStatus, approach_status
from tandem.skills.ports.actions.bimanual import RIGHT_OF_WAY, ArmOrder, Order, RightOfWay
from tandem.skills.ports.hardware import (
    CancelMotion,
    GroupStatus,
    JointStates,
    SetPoint,
    StopState,
    TrajectoryGoal,
)
from tandem.skills.ports.keys import (
    JOINT_STATES,
    STOP_STATE,
    Latest,
    group_cancel,
    group_goal,
    group_setpoint,
    group_status,
)
from tandem.skills.ports.message import HandName, Message, RobotTime, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.reflex import ARM
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.skill import Command
from tandem.skills.ports.world import (
    ROBOT_POSE,
    SCENE,
    WORLD,
    Box,
    ItemFact,
    PlanningScene,
    SceneObject,
    WorldState,
)
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.robot_pose import localised

PERIOD = 0.01
CUBE: Vector3 = (0.07, 0.07, 0.07)
TABLE_TOP = 0.71
TAG_ON_ITEM = Pose(position=(0.035, 0.0, 0.0), orientation=(0.5, 0.5, 0.5, 0.5))
"""The tag in the item's frame: z out along the item's x, y up."""
TORSO = 0.30


@dataclass
class Joints:
    """The controllers of some groups; a ``Node``. ``sent`` keeps what was streamed to each."""

    bus: MemoryBus
    clocks: SteppedClocks
    description: RobotDescription
    groups: tuple[str, ...]
    positions: dict[str, float]
    held_fast: bool = False
    stopped: bool = False
    silent: bool = False
    sent: dict[str, list[SetPoint]] = field(default_factory=dict)

    name = "joints"

    def __post_init__(self) -> None:
        self._controllers = {
            name: GroupController(
                self.description.group(name), [self.positions[j] for j in self.joints(name)]
            )
            for name in self.groups
        }
        self._setpoints = {name: Latest(self.bus, group_setpoint(name)) for name in self.groups}
        self._goals = {name: self.bus.serve(group_goal(name).key) for name in self.groups}
        self._cancels = {name: self.bus.serve(group_cancel(name).key) for name in self.groups}
        self._told: dict[str, object] = {}
        self.sent = {name: [] for name in self.groups}

    def joints(self, group: str) -> tuple[str, ...]:
        return self.description.group(group).joints

    def step(self) -> bool:
        stamp = RobotTime(boot="test", seconds=self.clocks.seconds)
        speeds = dict.fromkeys(self.positions, 0.0)
        for name in self.groups:
            self._follow(name, stamp, speeds)
        names = tuple(self.positions)
        states = JointStates(
            stamp=stamp,
            names=names,
            positions=tuple(self.positions.values()),
            velocities=tuple(speeds[each] for each in names),
            efforts=tuple(0.0 for _ in names),
        )
        if not self.silent:
            JOINT_STATES.publish(self.bus, states)
        STOP_STATE.publish(self.bus, StopState(stopped=self.stopped))
        return False

    def _follow(self, name: str, stamp: RobotTime, speeds: dict[str, float]) -> None:
        controller = self._controllers[name]
        for request in self._goals[name].drain():
            answer = controller.accept(TrajectoryGoal.model_validate_json(request.payload))
            request.reply(answer.model_dump_json().encode())
        for request in self._cancels[name].drain():
            answer = controller.cancel(CancelMotion.model_validate_json(request.payload).id)
            request.reply(answer.model_dump_json().encode())
        for setpoint in self._setpoints[name].take():
            self.sent[name].append(setpoint)
            if not self.stopped:
                controller.stream(setpoint)
        if self.stopped:
            controller.stop()
        q = np.array([self.positions[joint] for joint in self.joints(name)])
        controller.advance(PERIOD, q, controller.velocity_to_reference)
        if not self.held_fast:
            self.positions |= dict(zip(self.joints(name), map(float, controller.position), strict=True))
            speeds |= dict(zip(self.joints(name), map(float, controller.velocity), strict=True))
        report = controller.report
        if report != self._told.get(name):
            self._told[name] = report
            group_status(name).publish(
                self.bus,
                GroupStatus(
                    stamp=stamp,
                    group=name,
                    goal_id=report.goal_id,
                    state=report.state,
                    joint=report.joint,
                    error=report.error,
                    at_rest=report.at_rest,
                ),
            )

    def close(self) -> None:
        for desk in (*self._goals.values(), *self._cancels.values()):
            desk.close()


class FieldRig:
    """A robot before a table, beliefs that a test sets, the arms' servers; stepped together."""

    def __init__(
        self, description: RobotDescription, hulls: RobotHulls, sides: tuple[HandName, ...] = ("left",)
    ) -> None:
        self.bus, self.clocks, self.description = MemoryBus(), SteppedClocks("test"), description
        self.hulls = hulls
        groups = tuple(f"arm_{side}" for side in sides)
        positions = {
            joint: value
            for posture in description.postures
            if posture.name == "home"
            for joint, value in zip(description.group(posture.group).joints, posture.positions, strict=True)
        }
        positions["torso_lift_joint"] = TORSO
        for hand in description.end_effectors:
            positions |= dict.fromkeys(hand.gripper.joints, 0.045)
        self.hardware = Joints(self.bus, self.clocks, description, groups, positions)
        limbs = {f"arm_{side}": self._limb(side) for side in sides}
        pipelines = {group: limb.pipeline(ARM) for group, limb in limbs.items()}
        self._nodes = [
            self.hardware,
            *limbs.values(),
            *nodes(self.bus, self.clocks, description, groups, hulls=hulls, charge=True, pipelines=pipelines),
        ]
        self._status = {g: Latest(self.bus, status_topic(f"{g}/approach")) for g in groups}
        self._told = {g: Latest(self.bus, approach_status(g)) for g in groups}
        self.phases: dict[str, list[ApproachPhase]] = {g: [] for g in groups}
        self.items: dict[int, Pose] = {}
        self.others: tuple[SceneObject, ...] = (table(),)
        self._version = 0

    def _limb(self, side: HandName) -> Limb:
        choice = OWNER.chosen_for(OWNER.types(None), self.description, load("lab"), "lab", part=side)
        return Limb(arm(self.bus, self.clocks, self.description, side), choice)

    def put(self, item: int, x: float, y: float, yaw: float = 0.0) -> None:
        """Have an item be believed to stand on the table there (its centre, in the map and the base)."""
        centre = (x, y, TABLE_TOP + CUBE[2] / 2.0)
        self.items[item] = Pose(position=centre, orientation=about((0.0, 0.0, 1.0), yaw))
        self.tell()

    def topple(self, item: int) -> None:
        """Have an item lie where it stood, its tag on top."""
        over = about((0.0, 1.0, 0.0), -math.pi / 2.0)
        self.items[item] = Pose(position=self.items[item].position, orientation=over)
        self.tell()

    def tell(self) -> None:
        """Tell all beliefs."""
        self._version += 1
        stamp = RobotTime(boot="test", seconds=self.clocks.seconds)
        facts = tuple(
            ItemFact(
                item=item,
                size=CUBE,
                tag_in_map=compose(pose, TAG_ON_ITEM),
                seen=stamp,
                quality=1.0,
                position_sigma=0.002,
            )
            for item, pose in self.items.items()
        )
        WORLD.publish(self.bus, WorldState(stamp=stamp, version=self._version, items=facts))
        cubes = tuple(
            SceneObject(name=f"item_{item}", kind="item", box=Box(size=CUBE, pose=pose), item=item)
            for item, pose in self.items.items()
        )
        scene = PlanningScene(stamp=stamp, version=self._version, objects=(*self.others, *cubes))
        SCENE.publish(self.bus, scene)
        ROBOT_POSE.publish(self.bus, localised(stamp))

    def order(self, side: HandName, order: Order, sample: int = 0, *, opened: bool = True) -> None:
        """Tell an order of the coordination."""
        stamp = RobotTime(boot="test", seconds=self.clocks.seconds)
        orders = (ArmOrder(side=side, order=order, sample=sample),)
        RIGHT_OF_WAY.publish(self.bus, RightOfWay(stamp=stamp, episode=1, open=opened, orders=orders))

    def rounds(self, count: int) -> None:
        """Let time pass."""
        for _ in range(count):
            self.clocks.advance(PERIOD)
            for node in self._nodes:
                node.step()
            for group, told in self._told.items():
                for status in told.take():
                    if status.active and (
                        not self.phases[group] or self.phases[group][-1] is not status.phase
                    ):
                        self.phases[group].append(status.phase)

    def stall(self, count: int) -> None:
        """Let time pass in which the arms' processes get no turn."""
        for _ in range(count):
            self.clocks.advance(PERIOD)
            self.hardware.step()

    def told(self, group: str = "arm_left") -> ApproachStatus:
        """Return what was last told of an approach."""
        status = self._told[group].value
        assert status is not None
        return status

    def send(self, goal: Message, group: str = "arm_left", goal_id: str = "t/approach/1") -> None:
        """Send a goal."""
        document = goal.model_dump(mode="json")
        goal_service(f"{group}/approach").query(self.bus, SendGoal(goal_id=goal_id, client="", goal=document))

    def command(self, command: Command, group: str = "arm_left", goal_id: str = "t/approach/1") -> None:
        """Send a command to a running goal."""
        command_service(f"{group}/approach").query(self.bus, GoalCommand(goal_id=goal_id, command=command))

    def until(self, *states: GoalState, group: str = "arm_left", most: int = 3000) -> GoalStatus:
        """Go on until the goal is in one of the states."""
        for _ in range(most):
            self.rounds(1)
            status = self._status[group].refresh()
            if status is not None and status.state in states:
                return status
        raise AssertionError(f"not {states} after {most} rounds, but {self._status[group].value}")

    def ended(self, group: str = "arm_left", most: int = 3000) -> GoalStatus:
        """Go on until the goal has ended."""
        ends = (GoalState.SUCCEEDED, GoalState.FAILED, GoalState.CANCELED, GoalState.REJECTED)
        return self.until(*ends, group=group, most=most)

    def status(self, group: str = "arm_left") -> GoalStatus | None:
        """Return what was last told of the goal."""
        return self._status[group].refresh()

    def forget(self) -> None:
        """Have no item be believed in any more."""
        self.items.clear()
        self.tell()

    def hold_fast(self) -> None:
        """Have the joints stay where they are."""
        self.hardware.held_fast = True

    def stop(self) -> None:
        """Set the hardware's stop."""
        self.hardware.stopped = True

    def named(self, group: str, positions: tuple[float, ...]) -> dict[str, float]:
        """Return a group's positions by joint."""
        return dict(zip(self.description.group(group).joints, positions, strict=True))

    def obstacles(self) -> tuple[Obstacle, ...]:
        """Return all that is believed to stand around, as it is."""
        boxes = [(each.name, each.box.size, each.box.pose) for each in self.others]
        boxes += [(f"item_{item}", CUBE, pose) for item, pose in self.items.items()]
        return tuple(Obstacle(name, BoxShape(size), pose) for name, size, pose in boxes)

    def tool(self, side: HandName = "left") -> Pose:
        """Return where the hand's tool frame is, in the base."""
        return self.hulls.robot.pose(self.description.end_effector(side).frame, self.hardware.positions)


def table(distance: float = 0.34, height: float = TABLE_TOP) -> SceneObject:
    """Return the document's table (124 x 90 cm, 5.1), its edge so far ahead of the base's axis."""
    size = (0.90, 1.24, 0.04)
    centre = (distance + size[0] / 2.0, 0.0, height - size[2] / 2.0)
    return SceneObject(name="table", kind="furniture", box=Box(size=size, pose=Pose(position=centre)))


def block(name: str, size: Vector3, centre: Vector3) -> SceneObject:
    """Return an upright thing in the way."""
    return SceneObject(name=name, kind="clutter", box=Box(size=size, pose=Pose(position=centre)))


def grasps(*headings: float, pitch: float = 0.785) -> tuple[Pose, ...]:
    """Return grasps of an item that approach with these headings in the item's frame (rad), pitched down."""
    found = []
    for heading in headings:
        out = (-np.cos(heading), -np.sin(heading), 0.0)
        found.append(Pose(position=(0.0, 0.0, 0.0), orientation=tool_orientation(out, pitch)))
    return tuple(found)


def goal(item: int = 29, *headings: float) -> ApproachGoal:
    """Return an approach of an item, the hand pointing ahead and inwards unless said otherwise."""
    return ApproachGoal(item=item, grasps=grasps(*(headings or (-0.785, 0.0, -0.4, 0.4))), hand_width=0.09)
