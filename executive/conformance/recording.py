"""Everything that the hardware has told, as it was told: also what every other listener would drop."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeVar

from pydantic import ValidationError

from tandem.skills.ports import keys
from tandem.skills.ports.hardware import (
    Clock,
    GripperState,
    GroupStatus,
    JointStates,
    Odometry,
    StopState,
    Wrench,
)
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.lease import Leases
from tandem.skills.ports.message import Message, RobotTime, RobotTimer
from tandem.skills.ports.picture_header import split
from tandem.skills.ports.sensors import Bumpers, Cliffs, LaserScan, PoseReading, Ranges, RobotsSeen

if TYPE_CHECKING:
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.hardware import RgbdHeader
    from tandem.skills.ports.robot_description import RobotDescription

M = TypeVar("M", bound=Message)

AnyTopic = (
    Topic[Clock]
    | Topic[JointStates]
    | Topic[StopState]
    | Topic[Leases]
    | Topic[Odometry]
    | Topic[Bumpers]
    | Topic[GroupStatus]
    | Topic[GripperState]
    | Topic[Wrench]
    | Topic[LaserScan]
    | Topic[Ranges]
    | Topic[Cliffs]
    | Topic[PoseReading]
    | Topic[RobotsSeen]
)
"""What the hardware tells."""

ALWAYS: Final = (
    keys.JOINT_STATES.key,
    keys.ODOMETRY.key,
    keys.BUMPERS.key,
    keys.RANGES.key,
    keys.CLIFFS.key,
    keys.POSE_READING.key,
    keys.ROBOTS_SEEN.key,
    keys.STOP_STATE.key,
    keys.LEASES.key,
    keys.laser("*").key,
    keys.wrench("*").key,
    keys.group_status("*").key,
    keys.gripper_state("*").key,
)
"""What is recorded. Pictures are not: a camera works only while somebody listens."""


@dataclass(frozen=True)
class Told:
    """One message, and the newest clock once all that came with it had been read."""

    payload: bytes
    clock: RobotTime | None


class Recording:
    """All messages of the hardware's topics since the start. Call ``step`` whenever time has passed.

    Args:
        bus: where they are told.
    """

    def __init__(self, bus: Bus) -> None:
        self._inboxes = [bus.subscribe(key, depth=1024) for key in ALWAYS]
        self._clock_inbox = bus.subscribe(keys.CLOCK.key, depth=1024)
        self._told: dict[str, list[Told]] = defaultdict(list)
        self._timer = RobotTimer(0.0)
        self.clock: Clock | None = None
        """The newest; None before the first."""

    @property
    def passed(self) -> float:
        """Robot seconds since the first clock; they never fall."""
        return self._timer.reading

    @property
    def keys(self) -> tuple[str, ...]:
        """Keys on which something was told."""
        return tuple(self._told)

    def step(self) -> bool:
        """Take in what has come; say whether the clock was among it.

        The clock is read last: what belongs to a tick comes before it.
        """
        samples = [sample for inbox in self._inboxes for sample in inbox.drain()]
        ticks = self._clock_inbox.drain()
        for tick in ticks:
            read = _read(keys.CLOCK, tick.payload)
            if read is not None:
                self.clock = read
                self._timer.read(read.stamp)
        now = None if self.clock is None else self.clock.stamp
        for sample in (*samples, *ticks):
            self._told[sample.key].append(Told(sample.payload, now))
        return bool(ticks)

    def told(self, key: str, start: int = 0) -> list[Told]:
        """Return what was told on a key, readable or not, from the ``start``-th message on."""
        return self._told.get(key, [])[start:]

    def count(self, key: str) -> int:
        """Return how many messages were told on a key."""
        return len(self._told.get(key, []))

    def messages(self, topic: Topic[M], start: int = 0) -> list[M]:
        """Return a topic's readable messages, oldest first, from the ``start``-th message on."""
        read = (_read(topic, each.payload) for each in self.told(topic.key, start))
        return [each for each in read if each is not None]

    def latest(self, topic: Topic[M], start: int = 0) -> M | None:
        """Return a topic's newest readable message from the ``start``-th on, or None."""
        told = self.told(topic.key, start)
        return next((read for each in reversed(told) if (read := _read(topic, each.payload))), None)

    def close(self) -> None:
        """End the subscriptions."""
        for inbox in (*self._inboxes, self._clock_inbox):
            inbox.close()


def topics(robot: RobotDescription) -> tuple[Topic[Message], ...]:
    """Return the topics on which a robot may tell something."""
    driven = () if robot.drive is None else (keys.ODOMETRY, keys.BUMPERS)
    seen = (keys.RANGES, keys.CLIFFS, keys.POSE_READING, keys.ROBOTS_SEEN)
    return (
        *(
            _any(topic)
            for topic in (keys.CLOCK, keys.JOINT_STATES, keys.STOP_STATE, keys.LEASES, *driven, *seen)
        ),
        *(_any(keys.group_status(group.name)) for group in robot.groups),
        *(_any(keys.gripper_state(hand)) for hand in robot.hands),
        *(_any(keys.wrench(hand)) for hand in robot.hands),
        *(_any(keys.laser(laser.name)) for laser in robot.lasers),
    )


def _any(topic: AnyTopic) -> Topic[Message]:
    return keys.Topic(topic.key, topic.model)


def _read(topic: Topic[M], payload: bytes) -> M | None:
    try:
        return topic.decode(payload)
    except ValidationError:
        return None


class Pictures:
    """A camera's pictures as long as this lives: headers, without the pixels.

    Args:
        bus: where they are told.
        camera: its name.
    """

    def __init__(self, bus: Bus, camera: str) -> None:
        self._inbox = bus.subscribe(keys.rgbd(camera), depth=4)
        self.headers: list[RgbdHeader] = []
        self.wrong = ""
        """What was wrong with the first that was no picture."""

    def step(self) -> None:
        """Take in what has come."""
        for sample in self._inbox.drain():
            try:
                self.headers.append(split(sample.payload)[0])
            except ValueError as error:
                self.wrong = self.wrong or str(error)

    def close(self) -> None:
        """End the subscription."""
        self._inbox.close()
