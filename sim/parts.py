"""The hardware's parts: each joins a controller to the physics on one side and to its keys on the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Protocol, TypeVar

from tandem.sim.base import BaseController, Odometer
from tandem.sim.gripper import SOUND, GripperController
from tandem.sim.joints import Report
from tandem.sim.motors import GroupServos
from tandem.sim.wrench import WristSensor, pressed_bumpers
from tandem.skills.ports import keys
from tandem.skills.ports.endpoint import Endpoint, answering
from tandem.skills.ports.hardware import (
    Answer,
    GripperCommand,
    GripperMotion,
    GripperState,
    GroupStatus,
    Odometry,
    TrajectoryGoal,
    Wrench,
)
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.lease import Leased
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.sensors import Bumpers, LaserScan

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    import numpy as np

    from tandem.sim.body import RobotBody
    from tandem.sim.model import Hand, Wheels
    from tandem.sim.scenario import Noise
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.hardware import BaseVelocity
    from tandem.skills.ports.hearing import Ear
    from tandem.skills.ports.lease import LeaseRefusal
    from tandem.skills.ports.robot_description import EndEffector, JointGroup
    from tandem.skills.ports.sensors import LaserSensor

C = TypeVar("C", bound=Leased)

CLOSED: Final = 0.001
"""Metres between pads that have met: the hand is a fist."""
PRESSING: Final = 2.0
"""Newtons with which a fist's fingertips press before static friction keeps its place there."""
STATE_EVERY: Final = 2
"""Periods between two odometry, gripper and wrench messages (50 Hz)."""
BUMPERS_EVERY: Final = 20
"""Periods between two bumper messages when nothing changes."""
ROLLING: Final = 0.005
"""m/s or rad/s by its wheels from which on a base moves: a pushed one does; one that stands creeps less."""
STATUS_EVERY: Final = 100
"""Periods between two status messages when nothing changes."""
STOPPED: Final = Answer(accepted=False, reason="the stop is set; an operator releases it")


@dataclass(frozen=True)
class Gate:
    """What every command that moves something must pass.

    Attributes:
        stopped: says whether the stop is set.
        refuse: says why a command's sender may not command; None when it may.
    """

    stopped: Callable[[], bool]
    refuse: Callable[[Leased], LeaseRefusal | None]

    def shut_to(self, command: Leased) -> Answer | None:
        """Return the answer to a command that must not be obeyed; None when it may be."""
        if self.stopped():
            return STOPPED
        refusal = self.refuse(command)
        return None if refusal is None else Answer(accepted=False, reason=refusal.reason)

    def pass_on(self, streamed: Sequence[C], key: str, ear: Ear) -> list[C]:
        """Return those of streamed commands that may be obeyed; the others are dropped, and counted."""
        if self.stopped():
            return []
        passed = []
        for command in streamed:
            refusal = self.refuse(command)
            if refusal is None:
                passed.append(command)
            else:
                ear.refuse(key, Reason.FENCED, refusal.reason)
        return passed


class Part(Protocol):
    """What the hardware node is made of."""

    def listen(self) -> None:
        """Read what is streamed."""
        ...

    def halt(self) -> None:
        """Come to rest within the limits."""
        ...

    def act(self, period: float) -> None:
        """Set the motors for the coming period."""
        ...

    @property
    def rests(self) -> bool:
        """Whether nothing moves here, nor is to."""
        ...

    def tell(self, now: RobotTime, tick: int, *, streams: bool) -> None:
        """Publish what is due after the period that ended ``now``; if it ``streams``, its state as well."""
        ...

    def close(self) -> None:
        """Stop serving."""
        ...


class GroupPart:
    """A joint group: trajectory goals, cancels, set-points, status."""

    def __init__(self, bus: Bus, body: RobotBody, group: JointGroup, gate: Gate) -> None:
        self._bus, self._gate = bus, gate
        self._body = body
        self._group = group
        self.servos = GroupServos(body, group)
        self._setpoints = keys.Latest(bus, keys.group_setpoint(group.name))
        self._status = keys.group_status(group.name)
        self._told: Report | None = None
        self.stalled: Mapping[str, bool] = {}
        """Motors that don't follow, by joint: False holds where it is, True exerts nothing."""

    def endpoints(self) -> tuple[Endpoint, ...]:
        """Return what is to be served: goals and cancels."""
        name = self._group.name
        return (
            answering(keys.group_goal(name), self._take),
            answering(keys.group_cancel(name), lambda cancel: self.servos.controller.cancel(cancel.id)),
        )

    def listen(self) -> None:
        """Take set-points."""
        key = keys.group_setpoint(self._group.name).key
        for setpoint in self._gate.pass_on(self._setpoints.take(), key, self._bus.ear):
            self.servos.controller.stream(setpoint)

    def _take(self, goal: TrajectoryGoal) -> Answer:
        refused = self._gate.shut_to(goal)
        if refused is not None:
            return refused
        if goal.keeper and goal.keeper not in self._bus.alive():
            reason = f"its keeper {goal.keeper} is not announced"
            return Answer(accepted=False, reason=reason)
        return self.servos.controller.accept(goal)

    def halt(self) -> None:
        """Brake; a goal ends ABORTED."""
        self.servos.controller.stop()

    def act(self, period: float) -> None:
        """Follow the goal, the stream, or hold."""
        controller = self.servos.controller
        if controller.keeper:
            awake, gone = self._bus.goes_on(controller.keeper), controller.keeper not in self._bus.alive()
            controller.keep(awake=awake, gone=gone)
        self.servos.advance(period, self._body.read(self._group.joints))
        for limit in self._group.limits:
            if limit.joint in self.stalled:
                effort = 0.0 if self.stalled[limit.joint] else limit.effort
                self._body.drive_velocities([limit.joint], [0.0], [effort])

    @property
    def rests(self) -> bool:
        """Whether the group holds, and stands."""
        return self.servos.controller.rests

    def tell(self, now: RobotTime, tick: int, *, streams: bool) -> None:  # noqa: ARG002 - a status does not
        """Publish the status on each change and once a second."""
        report = self.servos.controller.report
        if report == self._told and tick % STATUS_EVERY:
            return
        self._told = report
        status = GroupStatus(
            stamp=now,
            group=self._group.name,
            goal_id=report.goal_id,
            state=report.state,
            joint=report.joint,
            error=report.error,
            at_rest=report.at_rest,
            held=report.held,
        )
        self._status.publish(self._bus, status)

    def close(self) -> None:
        """Stop serving."""
        self._setpoints.close()


class HandPart:
    """A gripper and the wrist's force/torque sensor behind it."""

    def __init__(
        self,
        bus: Bus,
        body: RobotBody,
        hand: Hand,
        effector: EndEffector,
        gate: Gate,
    ) -> None:
        self._bus, self._gate = bus, gate
        self._body = body
        self._side = effector.side
        self._gripper = effector.gripper
        self._hand, self._anchored = hand, False
        self.defects = SOUND
        self._joints = (hand.inner, hand.outer)
        inner, outer = body.read(self._joints)
        self.controller = GripperController(effector.gripper, (inner.position, outer.position))
        self._sensor = WristSensor(body, hand.wrench_joint)
        self._state = keys.gripper_state(effector.side)
        self._wrench = keys.wrench(effector.side)
        self._told = (self.controller.command_id, self.controller.motion)

    def endpoints(self) -> tuple[Endpoint, ...]:
        """Return what is to be served: commands."""
        return (answering(keys.gripper_command(self._side), self._take),)

    def listen(self) -> None:
        """Hear nothing: nothing is streamed to a gripper."""

    def _take(self, command: GripperCommand) -> Answer:
        return self._gate.shut_to(command) or self.controller.accept(command)

    def halt(self) -> None:
        """Stand still, and hold on to what is held."""
        self.controller.stop()

    def act(self, period: float) -> None:
        """Drive both fingers."""
        inner, outer = self._body.read(self._joints)
        drive = self.controller.advance(
            period, (inner.position, outer.position), (inner.effort, outer.effort)
        )
        squeezing = self.controller.squeezing or self._presses()
        if self.defects != SOUND:
            drive = self.defects.bend(drive, self._gripper.speed / 2.0, self._gripper.force)
            squeezing = squeezing and not self.defects.opens
        self._body.drive_velocities(self._joints, drive.speeds, drive.forces)
        if squeezing is not self._anchored:
            self._anchored = squeezing
            self._body.anchor_pads(self._hand, anchored=self._anchored)

    def _presses(self) -> bool:
        """Say whether the closed hand presses with its fingertips, as two fists do on a carton."""
        closed = self.controller.motion is GripperMotion.AT_WIDTH and self.controller.width < CLOSED
        return closed and self._body.pad_force(self._hand) >= PRESSING

    @property
    def rests(self) -> bool:
        """Whether the fingers have come to where they were told, or can't."""
        return self.controller.motion is not GripperMotion.MOVING

    def tell(self, now: RobotTime, tick: int, *, streams: bool) -> None:
        """Publish the gripper's state (also on each change) and the wrench."""
        self._sensor.update()
        controller = self.controller
        news = (controller.command_id, controller.motion)
        due = streams and tick % STATE_EVERY == 0
        if due or news != self._told:
            state = GripperState(
                stamp=now,
                side=self._side,
                command_id=controller.command_id,
                motion=controller.motion,
                width=controller.width,
                force=controller.force,
            )
            self._state.publish(self._bus, state)
            self._told = news
        if due:
            reading = Wrench(stamp=now, side=self._side, force=self._sensor.force, torque=self._sensor.torque)
            self._wrench.publish(self._bus, reading)

    def close(self) -> None:
        """Close nothing: the hardware serves its endpoints."""


class BasePart:
    """The wheels, odometry and bumpers."""

    def __init__(
        self,
        bus: Bus,
        body: RobotBody,
        wheels: Wheels,
        gate: Gate,
        *,
        noise: Noise,
        rng: np.random.Generator,
    ) -> None:
        self._bus, self._gate = bus, gate
        self._body = body
        self._joints = wheels.joints
        self._efforts = (wheels.effort,) * len(self._joints)
        self.controller = BaseController(body.model.description.driven, wheels, self._angles())
        self.odometer = Odometer(wheels, self._angles(), noise, rng)
        self._velocity: keys.Latest[BaseVelocity] = keys.Latest(bus, keys.BASE_VELOCITY)
        self._pressed: tuple[str, ...] = ()
        self.jammed: frozenset[str] = frozenset()
        """Bumpers that read pressed whatever touches them."""
        self._period = body.model.description.period

    def _angles(self) -> tuple[float, ...]:
        return tuple(reading.position for reading in self._body.read(self._joints))

    def listen(self) -> None:
        """Take the newest velocity command."""
        commands = self._gate.pass_on(self._velocity.take(), keys.BASE_VELOCITY.key, self._bus.ear)
        if commands:
            self.controller.command(commands[-1])

    def halt(self) -> None:
        """Brake and stand."""
        self.controller.stop()

    def act(self, period: float) -> None:
        """Turn the wheels."""
        speeds = self.controller.advance(period, self._angles())
        self._body.drive_velocities(self._joints, speeds, self._efforts)

    @property
    def rests(self) -> bool:
        """Whether the base is told to stand, and the wheels do."""
        rolling = max(abs(self.odometer.linear), abs(self.odometer.angular))
        return self.controller.stands and rolling < ROLLING

    def tell(self, now: RobotTime, tick: int, *, streams: bool) -> None:
        """Publish odometry, and the bumpers on each change and five times a second."""
        self.odometer.update(self._period, self._angles())
        if streams and tick % STATE_EVERY == 0:
            odometry = Odometry(
                stamp=now,
                base_in_odom=self.odometer.pose,
                linear=self.odometer.linear,
                angular=self.odometer.angular,
            )
            keys.ODOMETRY.publish(self._bus, odometry)
        touched = pressed_bumpers(self._body, self._body.model.bumper_links)
        pressed = tuple(
            each.name for each in self._body.model.bumpers if each.name in touched or each.name in self.jammed
        )
        if pressed != self._pressed or tick % BUMPERS_EVERY == 0:
            keys.BUMPERS.publish(self._bus, Bumpers(stamp=now, pressed=pressed))
            self._pressed = pressed

    def close(self) -> None:
        """Stop listening."""
        self._velocity.close()


class LaserSensorNode:
    """Publishes a scan each of the laser's periods; a sensor of the hardware node.

    Args:
        bus: where scans go.
        sensor: of the robot's description.
        scan: takes one.
    """

    rests: Final = False

    def __init__(self, bus: Bus, sensor: LaserSensor, scan: Callable[[], tuple[float, ...]]) -> None:
        self._bus = bus
        self._period, self._topic = sensor.period, keys.laser(sensor.name)
        self._scan = scan
        self._next = 0.0

    def step(self, now: RobotTime) -> None:
        """Publish when it is time."""
        if now.seconds < self._next - 1e-9:
            return
        self._next = now.seconds + self._period
        self._topic.publish(self._bus, LaserScan(stamp=now, ranges=self._scan()))
