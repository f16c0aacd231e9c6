"""What a robot's joints, base and cameras did, sampled at even steps of robot time.

Between two messages the older one counts: a frame shows what was known at its moment, and nothing from later.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from tandem.executive.records.recording import Recorded, Recording
from tandem.skills.ports.hardware import BaseVelocity, JointStates, SetPoint
from tandem.skills.ports.keys import BASE_VELOCITY, DESCRIPTION, JOINT_STATES, group_setpoint
from tandem.skills.ports.message import read_leniently
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.world import ROBOT_POSE, RobotPose

Numbers = NDArray[np.float64]
BASE_STATE: Final = ("base.x", "base.y", "base.yaw")
"""In map: m, m, rad."""
BASE_ACTION: Final = ("base.linear", "base.angular")
"""m/s forward, rad/s to the left."""
BEFORE: Final = 2.0
"""Robot seconds before an episode that are read, so that its first frame knows what came last."""
AFTER: Final = 0.5
"""Robot seconds after its last step that are read."""
LONGEST: Final = 0.5
"""Robot seconds without joints that an episode may have. They come 20 to 100 times a second; what was lost
for longer is not to be learnt as standing still."""
OFTEN: Final = 1.5
"""Frames for each message of the joints that an episode may have: with more, most frames repeat the one
before, and its action is to stand still."""
LONGEST_PICTURE: Final = 2.0
"""The same of a camera's pictures, which come five times a second, and less often from one that is busy."""


@dataclass(frozen=True)
class Track:
    """Rows of numbers, each from its moment until the next one's."""

    at: Numbers
    """Robot seconds, rising."""
    rows: Numbers

    def places(self, moments: Numbers) -> NDArray[np.intp]:
        """Return the place of the row that counts at each moment; before the first one -1."""
        return np.searchsorted(self.at, moments + 1e-9, side="right") - 1

    def gap(self, moments: Numbers, longest: float) -> tuple[float, float] | None:
        """Return the longest time for which a row counts, and when it begins; None: none is too long.

        Before the first row, the time until it comes.
        """
        first, last = float(moments[0]), float(moments[-1])
        before = int(self.places(moments[:1])[0])
        within = self.at[(self.at > first) & (self.at < last)]
        edges = np.array([first if before < 0 else self.at[before], *within, last])
        worst = int(np.argmax(np.diff(edges)))
        length = float(edges[worst + 1] - edges[worst])
        return (length, max(first, float(edges[worst]))) if length > longest else None

    def sampled(self, moments: Numbers) -> Numbers:
        """Return the row that counts at each moment; before the first one that one."""
        return self.rows[np.maximum(self.places(moments), 0)]


@dataclass(frozen=True)
class Signals:
    """What was heard of a robot in some time."""

    joints: tuple[str, ...]
    positions: Track
    pose: Track | None
    """Of the base in map; None: it was not told."""
    velocity: Track | None
    """Commanded to the base; None: nothing was."""
    set_points: tuple[tuple[NDArray[np.intp], Track], ...] = ()
    """Of each group that was streamed to: its columns among the joints, and the positions."""
    dead_man: float = 0.0
    """Seconds after which a velocity of the base counts no more."""

    def state(self, moments: Numbers, *, base: bool) -> Numbers:
        """Return positions of the joints and, if asked for, the base's pose, a row for each moment."""
        held = self.positions.sampled(moments)
        if not base:
            return held
        pose = np.zeros((len(moments), 3)) if self.pose is None else self.pose.sampled(moments)
        return np.hstack([held, pose])

    def action(self, moments: Numbers, step: float, *, base: bool) -> Numbers:
        """Return what was wanted within ``step`` after each moment, a row for each.

        Of a joint: the last set-point that came in that time; where none did, where the joint was at its end.
        Of the base: the velocity that was commanded at its end.
        """
        after = moments + step
        wanted = self.positions.sampled(after)
        for columns, track in self.set_points:
            places = track.places(after)
            fresh = (places >= 0) & (track.at[np.maximum(places, 0)] > moments + 1e-9)
            wanted[np.ix_(np.flatnonzero(fresh), columns)] = track.rows[places[fresh]]
        return np.hstack([wanted, self._commanded(after, step)]) if base else wanted

    def _commanded(self, after: Numbers, step: float) -> Numbers:
        still = np.zeros((len(after), len(BASE_ACTION)))
        if self.velocity is None:
            return still
        places = self.velocity.places(after)
        age = after - self.velocity.at[np.maximum(places, 0)]
        counts = (places >= 0) & (age <= max(step, self.dead_man) + 1e-9)
        still[counts] = self.velocity.rows[places[counts]]
        return still


@dataclass
class _Heard:
    at: list[float] = field(default_factory=list)
    rows: list[tuple[float, ...]] = field(default_factory=list)

    def add(self, at: float, row: tuple[float, ...]) -> None:
        self.at.append(at)
        self.rows.append(row)

    def track(self) -> Track | None:
        return Track(np.array(self.at), np.array(self.rows)) if self.at else None


def moments_of(begin: float, end: float, fps: int) -> Numbers:
    """Return the moments of an episode's frames: even steps from its begin up to its end."""
    count = int((end - begin) * fps + 1e-6) + 1
    return begin + np.arange(count) / fps


def signals(record: Recording, since: float, until: float) -> Signals | None:
    """Return what was heard between two moments, and a little before and after; None without joints."""
    robot = description_of(record)
    groups = {} if robot is None else {group_setpoint(each.name).key: each.joints for each in robot.groups}
    heard: defaultdict[str, _Heard] = defaultdict(_Heard)
    names: tuple[str, ...] = ()
    for message in record.messages(since - BEFORE, until + AFTER):
        try:
            row, said = _row(message, groups, names)
        except ValidationError:
            continue  # a wrong message is as good as none
        names = names or said
        if row:
            heard[message.key].add(message.at, row)
    positions = heard[JOINT_STATES.key].track()
    if positions is None:
        return None
    return Signals(
        joints=names,
        positions=positions,
        pose=heard[ROBOT_POSE.key].track(),
        velocity=heard[BASE_VELOCITY.key].track(),
        set_points=tuple(_streamed(groups, heard, names)),
        dead_man=0.0 if robot is None or robot.drive is None else robot.drive.dead_man,
    )


def _row(
    message: Recorded, groups: Mapping[str, tuple[str, ...]], names: tuple[str, ...]
) -> tuple[tuple[float, ...], tuple[str, ...]]:
    """Return the numbers of a message, none if it has no part in an episode; of joints also their names."""
    key, payload = message.key, message.payload
    if key == JOINT_STATES.key:
        joints = read_leniently(JointStates, payload)
        same = not names or set(names) == set(joints.names)
        return (joints.position_of(names or joints.names) if same else ()), joints.names
    if key == ROBOT_POSE.key:
        pose = read_leniently(RobotPose, payload).base_in_map
        return (pose.x, pose.y, pose.yaw), ()
    if key == BASE_VELOCITY.key:
        wanted = read_leniently(BaseVelocity, payload)
        return (wanted.linear, wanted.angular), ()
    if key in groups:
        positions = read_leniently(SetPoint, payload).positions
        return (positions if len(positions) == len(groups[key]) else ()), ()
    return (), ()


def description_of(record: Recording) -> RobotDescription | None:
    """Return the robot's description, as it stands beside the messages; None if it does not."""
    for each in record.attachments:
        if each.name == DESCRIPTION.key:
            return read_leniently(RobotDescription, each.data)
    return None


def _streamed(
    groups: Mapping[str, tuple[str, ...]], heard: Mapping[str, _Heard], names: Sequence[str]
) -> Iterable[tuple[NDArray[np.intp], Track]]:
    for key, joints in groups.items():
        track = heard[key].track() if key in heard else None
        if track is not None:
            yield np.array([names.index(each) for each in joints], np.intp), track
