"""The one table of key expressions, relative to ``<site>/<robot>``.

A ``Topic`` is a key and the message that travels on it; a ``Service`` is a key that is queried.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Generic, TypeVar

from tandem.skills.ports.bus import Bus, Commons, Inbox, Pending, Sample
from tandem.skills.ports.hardware import (
    Answer,
    BaseVelocity,
    CancelMotion,
    Clock,
    GripperCommand,
    GripperState,
    GroupStatus,
    JointStates,
    Odometry,
    SetPoint,
    Stop,
    StopRelease,
    StopState,
    TrajectoryGoal,
    Wrench,
)
from tandem.skills.ports.hearing import Entrance
from tandem.skills.ports.lease import LeaseAnswer, Leased, LeaseRequest, Leases
from tandem.skills.ports.limits import SMALL, Limits
from tandem.skills.ports.message import Message, read_leniently
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import Bumpers, Cliffs, LaserScan, PoseReading, Ranges, RobotsSeen

TOLD: Final = ("task/", "tree/", "world/")
"""How the keys begin whose messages and answers are for clients, of any version."""
M = TypeVar("M", bound=Message)
Asked = TypeVar("Asked", bound=Message)
Answered = TypeVar("Answered", bound=Message)


class Nothing(Message):
    """An empty document, for a query without arguments."""


def _with_lease(bus: Commons, message: Message) -> Message:
    lease = bus.lease() if isinstance(message, Leased) and message.lease is None else None
    return message if lease is None else message.model_copy(update={"lease": lease})


def _read(key: str, model: type[M], payload: bytes) -> M:
    """Return a message of a key; only those for clients may have fields that this version does not know."""
    return read_leniently(model, payload) if key.startswith(TOLD) else model.model_validate_json(payload)


@dataclass(frozen=True)
class Topic(Generic[M]):
    """A key and the model of what is put on it, as JSON."""

    key: str
    model: type[M]

    def publish(self, bus: Commons, message: M) -> None:
        """Put the message; a command carries the lease of the bus's process."""
        bus.publish(self.key, _with_lease(bus, message).model_dump_json().encode())

    def publish_written(self, bus: Commons, document: bytes) -> None:
        """Put what is JSON already. Not for commands: it carries no lease."""
        bus.publish(self.key, document)

    def decode(self, payload: bytes) -> M:
        """Return the message; pydantic's ValidationError when it is none."""
        return _read(self.key, self.model, payload)


@dataclass(frozen=True)
class Service(Generic[Asked, Answered]):
    """A key that is queried: what is asked and what is answered, as JSON (``tandem.skills.ports.serving``).

    With ``reads`` it is a question: it changes nothing, so that anybody who looks around may ask it, with a
    wildcard and without a document. Otherwise it is a command. With ``exact`` it is a question whose answer
    costs work: no wildcard asks it.
    """

    key: str
    asked: type[Asked]
    answered: type[Answered]
    reads: bool = False
    exact: bool = False
    limits: Limits = SMALL

    def query(self, bus: Bus, message: Asked, *, timeout: float = 2.0) -> Pending:
        """Ask; poll the result and give it to ``decode_answer``. A command carries the process's lease."""
        return bus.query(self.key, _with_lease(bus, message).model_dump_json().encode(), timeout=timeout)

    def decode_answer(self, payload: bytes) -> Answered:
        """Return the answer; pydantic's ValidationError when it is none."""
        return _read(self.key, self.answered, payload)


class Latest(Generic[M]):
    """The newest message of a topic. Call ``refresh`` (or ``take``) in each step of the node.

    What gets here has been checked (``skills.ports.hearing``): a wrong message is as good as none. One with a
    stamp that is older than what is known (of the same boot) has been overtaken on its way, and does not
    become the value.
    """

    def __init__(self, bus: Bus, topic: Topic[M], *, depth: int = 64) -> None:
        """Subscribe."""
        self._inbox: Inbox = bus.subscribe(topic.key, depth=depth)
        self._entrance = Entrance(bus.ear, topic.decode)
        self.value: M | None = None

    def take(self) -> list[M]:
        """Return all that has arrived since the last call, oldest first; ``value`` becomes the newest."""
        arrived: list[M] = []
        for sample in self._inbox.drain():
            message = self._entrance.read(sample.key, sample.payload)
            if message is None:
                continue
            newer = self._entrance.is_newer(sample.key, message)
            if newer:
                self.value = message
            if newer or self._entrance.keeps_old(sample.key, message):
                arrived.append(message)
        return arrived

    def refresh(self) -> M | None:
        """Return the newest message that ever came, or None."""
        samples = self._inbox.drain()
        while samples:
            sample = samples.pop()
            message = self._entrance.read(sample.key, sample.payload)
            if message is None:
                continue
            if self._entrance.is_newer(sample.key, message):
                self.value = message
            else:
                self._entrance.keeps_old(sample.key, message)  # which counts it
                # A late one hides no newer one that came before it.
                self._take_newer(samples)
            break
        return self.value

    def _take_newer(self, samples: Sequence[Sample]) -> None:
        for sample in samples:
            message = self._entrance.read(sample.key, sample.payload)
            if message is not None and self._entrance.is_newer(sample.key, message):
                self.value = message

    def close(self) -> None:
        """End the subscription."""
        self._inbox.close()


TRAJECTORY: Final = Limits(bytes=1024 * 1024)
"""A minute of a seven-jointed arm at 50 points a second is 0.9 MB."""

# The hardware.
DESCRIPTION: Final = Service("hw/description", Nothing, RobotDescription, reads=True)
CLOCK: Final = Topic("hw/clock", Clock)
JOINT_STATES: Final = Topic("hw/joints/state", JointStates)
BASE_VELOCITY: Final = Topic("hw/base/velocity", BaseVelocity)
ODOMETRY: Final = Topic("hw/base/odometry", Odometry)
BUMPERS: Final = Topic("hw/base/bumpers", Bumpers)
RANGES: Final = Topic("hw/ranges", Ranges)
CLIFFS: Final = Topic("hw/cliffs", Cliffs)
POSE_READING: Final = Topic("hw/pose", PoseReading)
ROBOTS_SEEN: Final = Topic("hw/robots", RobotsSeen)
STOP: Final = Service("hw/stop", Stop, StopState, limits=Limits(per_step=128, rate=math.inf))
"""The one command that an unreadable document does not keep from being carried out, nor a flood."""
STOP_RELEASE: Final = Service("hw/stop/release", StopRelease, StopState)
STOP_STATE: Final = Topic("hw/stop/state", StopState)
LEASE: Final = Service("hw/lease", LeaseRequest, LeaseAnswer)
LEASES: Final = Topic("hw/leases", Leases)


def laser(name: str) -> Topic[LaserScan]:
    """Return the topic of a laser's scans."""
    return Topic(f"hw/{name}/laser", LaserScan)


def rgbd(camera: str) -> str:
    """Return the key of a camera's pictures. Binary: see ``tandem.skills.ports.image``."""
    return f"hw/camera/{camera}/rgbd"


def group_goal(group: str) -> Service[TrajectoryGoal, Answer]:
    """Return the service that takes a group's trajectory goals."""
    return Service(f"hw/group/{group}/goal", TrajectoryGoal, Answer, limits=TRAJECTORY)


def group_cancel(group: str) -> Service[CancelMotion, Answer]:
    """Return the service that stops a group's goal."""
    return Service(f"hw/group/{group}/cancel", CancelMotion, Answer)


def group_status(group: str) -> Topic[GroupStatus]:
    """Return the topic of a group's status."""
    return Topic(f"hw/group/{group}/status", GroupStatus)


def group_setpoint(group: str) -> Topic[SetPoint]:
    """Return the topic of a group's streamed set-points."""
    return Topic(f"hw/group/{group}/setpoint", SetPoint)


def gripper_command(side: str) -> Service[GripperCommand, Answer]:
    """Return the service that moves a gripper."""
    return Service(f"hw/gripper/{side}/command", GripperCommand, Answer)


def gripper_state(side: str) -> Topic[GripperState]:
    """Return the topic of a gripper's state."""
    return Topic(f"hw/gripper/{side}/state", GripperState)


def wrench(side: str) -> Topic[Wrench]:
    """Return the topic of a wrist's force and torque."""
    return Topic(f"hw/wrench/{side}", Wrench)
