"""A robot, a pedestal and an item, driven through the hardware's messages: for benchmarks and tests."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.sim.body import RobotBody
from tandem.sim.hardware import Hardware
from tandem.sim.physics import Physics
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import Noise
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import (
    Answer,
    BaseVelocity,
    GripperCommand,
    GripperMotion,
    GripperState,
    GroupStatus,
    MotionState,
    TrajectoryGoal,
    TrajectoryPoint,
)
from tandem.skills.wire.memory import MemoryBus

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from tandem.skills.ports.hardware import SetPoint

TORSO: Final = 0.25
GRASP_POINT: Final = (0.68, 0.15, 0.78)
"""Where the left hand's tool frame is in the base at GRASP: pitched down by 0.6 rad, closing sideways."""
GRASP: Final = (1.04315, 0.14546, 1.56072, 1.55394, -1.03864, -1.13276, -0.33684)
PREGRASP: Final = (0.95712, 0.0679, 1.48707, 1.8778, -0.96867, -1.37433, -0.26277)
"""10 cm back along the hand's x."""
LIFT: Final = (1.05089, -0.01798, 1.42419, 1.55308, -0.83723, -1.23054, -0.44485)
"""10 cm up."""
SWING: Final = (0.5, 0.3, 1.42419, 1.9, -0.83723, -0.9, 0.3)
"""Elsewhere, with the hand turned: for moving to and fro."""


class Rig:
    """The hardware node on a bus in memory, with the left hand at PREGRASP and the item before it.

    Args:
        size: the item's edge, metres.
        mass: the item's, kg.
        friction: the item's coefficient; None leaves pedestal and item out.
        noise: of the sensors.
        start: joint positions to start with, by group, instead of the usual.
    """

    def __init__(
        self,
        *,
        size: float = 0.06,
        mass: float = 0.1,
        friction: float | None = 0.9,
        noise: Noise | None = None,
        start: dict[str, tuple[float, ...]] | None = None,
        resting_period: float | None = None,
    ) -> None:
        self.physics = Physics()
        self.floor = self.physics.add_floor()
        self.item = -1
        if friction is not None:
            x, y, z = GRASP_POINT
            top = z - size / 2.0
            self.physics.add_box((0.2, 0.4, top), 0.0, (x + 0.06, y, top / 2.0), friction=0.6)
            self.item = self.physics.add_box((size, size, size), mass, (x, y, z), friction=friction)
        self.model = robot_model("tiago_dual")
        description = self.model.description
        groups = {p.group: p.positions for p in description.postures if p.name == "home"}
        groups |= {"arm_left": PREGRASP, "torso": (TORSO,)} | (start or {})
        positions = {
            joint: value
            for group, values in groups.items()
            for joint, value in zip(description.group(group).joints, values, strict=True)
        }
        self.body = RobotBody(self.physics, self.model, positions=positions)
        self.bus = MemoryBus()
        self.hardware = Hardware(
            self.bus,
            self.body,
            boot="rig",
            noise=noise or Noise(),
            rng=np.random.default_rng(1),
            resting_period=resting_period,
        )
        self._inbox = {
            group.name: keys.Latest(self.bus, keys.group_status(group.name)) for group in description.groups
        }
        self._gripper = keys.Latest(self.bus, keys.gripper_state("left"))
        self._count = 0
        self.tracking: dict[str, float] = {}
        """The largest distance of each joint from its path so far."""

    def ticks(self, count: int) -> None:
        """Let ``count`` periods of 10 ms pass."""
        for _ in range(count):
            self.hardware.step()

    def status(self, group: str) -> GroupStatus:
        """Return the group's last status."""
        status = self._inbox[group].refresh()
        assert status is not None
        return status

    def gripper(self) -> GripperState:
        """Return the left gripper's last state."""
        state = self._gripper.refresh()
        assert state is not None
        return state

    def positions(self, group: str) -> NDArray[np.float64]:
        """Return the group's measured positions."""
        joints = self.model.description.group(group).joints
        return np.array([reading.position for reading in self.body.read(joints)])

    def goal(self, group: str, target: Sequence[float], seconds: float) -> TrajectoryGoal:
        """Return a goal from where the group is to ``target`` along a quintic (jerk-bounded) timing."""
        self._count += 1
        start = self.positions(group)
        way = np.array(target) - start
        points = []
        for u in np.linspace(0.0, 1.0, 21):
            share = u**3 * (10 - 15 * u + 6 * u**2)
            pace = 30 * u**2 * (1 - u) ** 2 / seconds
            points.append(
                TrajectoryPoint(
                    time=float(u * seconds),
                    positions=tuple((start + share * way).tolist()),
                    velocities=tuple((pace * way).tolist()),
                )
            )
        return TrajectoryGoal(id=f"{group}-{self._count}", keeper="", points=tuple(points))

    def send(self, group: str, goal: TrajectoryGoal) -> Answer:
        """Send a goal; one period passes before it is answered."""
        service = keys.group_goal(group)
        pending = service.query(self.bus, goal)
        self.ticks(1)
        payload = pending.poll()
        assert payload is not None
        return service.decode_answer(payload)

    def move(self, group: str, target: Sequence[float], seconds: float) -> GroupStatus:
        """Move a group and wait until it has ended."""
        answer = self.send(group, self.goal(group, target, seconds))
        assert answer.accepted, answer.reason
        return self.finish(group)

    def finish(self, group: str, most: int = 1000) -> GroupStatus:
        """Wait until the group's goal has ended."""
        for _ in range(most):
            self.ticks(1)
            status = self.status(group)
            if status.state is not MotionState.ACTIVE:
                return status
        raise TimeoutError(f"{group} is still moving")

    def grip(self, width: float, force: float = 16.0, speed: float = 0.06) -> GripperState:
        """Move the left gripper's pads and wait until they rest."""
        self._count += 1
        command = GripperCommand(id=f"grip-{self._count}", width=width, speed=speed, force=force)
        keys.gripper_command("left").query(self.bus, command)
        self.ticks(3)
        for _ in range(300):
            if self.gripper().motion is not GripperMotion.MOVING:
                break
            self.ticks(1)
        self.ticks(20)
        return self.gripper()

    def drive(self, linear: float, angular: float, seconds: float) -> None:
        """Send velocity commands at 20 Hz for so long."""
        for period in range(round(seconds * 100)):
            if period % 5 == 0:
                keys.BASE_VELOCITY.publish(self.bus, BaseVelocity(linear=linear, angular=angular))
            self.ticks(1)

    def stream(self, group: str, setpoint: SetPoint) -> None:
        """Send one set-point."""
        keys.group_setpoint(group).publish(self.bus, setpoint)

    def item_in_hand(self) -> NDArray[np.float64]:
        """Return the 4x4 pose of the item in the left tool frame."""
        import pybullet  # noqa: PLC0415  # only the rig looks at the truth

        position, orientation = self.physics.body_pose(self.item)
        pose = np.eye(4)
        pose[:3, :3] = np.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3)
        pose[:3, 3] = position
        result: NDArray[np.float64] = (
            np.linalg.inv(self.body.frame_matrix("gripper_left_grasping_frame")) @ pose
        )
        return result

    def close(self) -> None:
        """End the physics."""
        self.hardware.close()
        self.physics.close()


def slip(before: NDArray[np.float64], after: NDArray[np.float64]) -> tuple[float, float]:
    """Return how far a pose has moved: millimetres and degrees."""
    turn = np.clip((np.trace((np.linalg.inv(before) @ after)[:3, :3]) - 1.0) / 2.0, -1.0, 1.0)
    return float(np.linalg.norm(after[:3, 3] - before[:3, 3]) * 1e3), float(np.degrees(np.arccos(turn)))
