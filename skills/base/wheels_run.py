"""One run of a skill on the wheels: cycles that heed commands, turning, and coming to rest.

What makes the base stop on the way are reflexes (``skills/base/reflexes``): they take the wheels from a run.

Each motion is a generator that yields feedback and returns whether it came to its end; where it did not,
``canceled`` or ``failure`` says why, and the wheels are already braking.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from typing import Final, Generic, TypeVar

from tandem.skills.base.floor import compose
from tandem.skills.base.odometry import ahead
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.wheels import CYCLE, Wheels, stopping_speed
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import Command, Slice

LATENCY: Final = 0.05
"""Seconds between a command and what odometry tells of it."""
AIM: Final = 0.008
"""Radians: a turn ends when as near."""
SLOW_TURN: Final = 0.04
"""rad/s: a turn ends when as slow."""
BRAKING: Final = 0.7
"""Share of the speed from which a turn could just stop: as fast, it is taken to brake."""
STUCK_AFTER: Final = 4.0
"""Robot seconds of commanding without getting nearer after which something holds the base."""
PATIENCE: Final = 30.0
"""Robot seconds for which the base waits for people without a break."""
GIVE_UP_RESTING: Final = 5.0
"""Robot seconds in which a base that is told to stand must be at rest: ours brake within 2."""
CREEP: Final = 0.15
"""m/s ahead at which the last centimetres are corrected."""
CLOSE: Final = 0.002
"""Metres: a correction ends when as near."""
KEEP_HEADING: Final = 1.5
"""rad/s for each radian off the heading while going straight."""

F = TypeVar("F", bound=Message)
Motion = Generator[F | Slice, Command, bool]


class Ride(Generic[F]):
    """What the motions of one run share.

    Args:
        clocks: robot time.
        localiser: where the base is.
        wheels: what moves it.
        feedback: builds what is yielded.
        where: the action's name, for failures.
        caution: what is heeded of people, by robots that track them.
    """

    def __init__(
        self,
        clocks: Clocks,
        localiser: Whereabouts,
        wheels: Wheels,
        *,
        feedback: Callable[[], F],
        where: str,
        caution: Caution | None = None,
    ) -> None:
        self._clocks, self._localiser = clocks, localiser
        self._feedback, self._where = feedback, where
        self.wheels, self.caution = wheels, caution
        self._halted_for = 0.0
        self._paused_for = 0.0
        self.canceled = False
        self.failure: Failure | None = None
        self.turned = 0.0
        """Radians turned in the present (or last) turn."""
        wheels.begin(localiser.odometry)

    @property
    def now(self) -> float:
        """Robot seconds."""
        return robot_seconds(self._clocks)

    @property
    def active(self) -> float:
        """Robot seconds, pauses left out: for all that is given up after a time."""
        return self.now - self._paused_for

    @property
    def halted(self) -> bool:
        """Whether the base stands, or brakes, because somebody would be at it too soon."""
        return self._halted_for > 0.0

    @property
    def pose(self) -> FloorPose:
        """base_in_map now: odometry carried on to this moment, seen from the map."""
        odometry, now = self._localiser.odometry, self._clocks.robot()
        if odometry is None:
            return self._localiser.odom_in_map
        age = None if now is None else now.since(odometry.stamp)
        late = min(max(age or 0.0, 0.0), 2 * CYCLE)
        return compose(self._localiser.odom_in_map, ahead(odometry, late))

    def cycle(self, linear: float, angular: float) -> Motion[F]:
        """Send speeds and wait one cycle; False when the run has to end. Who comes near stops the base."""
        if self._must_halt(linear, angular):
            self.wheels.brake()
        else:
            self.wheels.send(linear, angular)
        yield from self._wait(CYCLE)
        return self._may_go_on()

    def heed(self, command: Command) -> Motion[F]:
        """Obey a command that came with a slice of a computation; False when the run has to end."""
        if command is Command.CANCEL:
            self.canceled = True
        elif command is Command.PAUSE:
            yield from self._pause()
        return self._may_go_on()

    def turn(self, angle: float, rolls_on: float = 0.0) -> Motion[F]:
        """Turn on the spot by ``angle`` radians (more than a full turn too), as the map tells.

        ``rolls_on``: radians before the end at which a base that brakes is left turning, to drive on.
        """
        remaining, yaw = angle, self.pose.yaw
        best, best_at = abs(remaining), self.active
        drive = self.wheels.drive
        self.turned = 0.0
        while abs(remaining) > AIM or abs(self.wheels.angular) > SLOW_TURN:
            speed = stopping_speed(abs(remaining), drive.turn_acceleration, LATENCY)
            if abs(remaining) < rolls_on and abs(self.wheels.angular) > BRAKING * speed:
                return True
            if not (yield from self.cycle(0.0, math.copysign(speed, remaining))):
                return False
            turned = wrap(self.pose.yaw - yaw)
            remaining, yaw = remaining - turned, wrap(yaw + turned)
            self.turned += turned
            if abs(remaining) < best - AIM / 2 or abs(remaining) <= AIM:
                best, best_at = abs(remaining), self.active
            elif self.active - best_at > STUCK_AFTER:
                self.fail(FailureKind.BASE_BLOCKED, "the base does not turn", remaining_rad=remaining)
                return False
        yield from self.rest()
        return True

    def straight(self, distance: float) -> Motion[F]:
        """Go straight by a few centimetres, back when negative (m), keeping the heading."""
        start, sign = self.pose, math.copysign(1.0, distance)
        begun, drive = self.active, self.wheels.drive
        top = drive.backward if distance < 0.0 else min(drive.forward, CREEP)
        while True:
            here = self.pose
            done = math.cos(start.yaw) * (here.x - start.x) + math.sin(start.yaw) * (here.y - start.y)
            remaining = abs(distance) - sign * done
            if remaining < CLOSE:
                break
            speed = min(stopping_speed(remaining, drive.acceleration, LATENCY), top)
            if not (yield from self.cycle(sign * speed, KEEP_HEADING * wrap(start.yaw - here.yaw))):
                return False
            if self.active - begun > STUCK_AFTER + 2.0 * abs(distance) / top:
                self.fail(FailureKind.BASE_BLOCKED, "the base does not move", remaining_m=remaining)
                return False
        yield from self.rest()
        return True

    def rest(self) -> Generator[F | Slice, Command, None]:
        """Brake to standstill; no command ends it, a cancellation is noted."""
        start = self.active
        while not self.wheels.resting or self._localiser.moving:
            self.wheels.send(0.0, 0.0)
            yield from self._wait(CYCLE)
            if self.active - start > GIVE_UP_RESTING:
                self.fail(FailureKind.HARDWARE_LOST, "the base does not come to rest")
                return

    def settle(self, seconds: float) -> Motion[F]:
        """Stand still for so long; False when the run has to end."""
        until = self.active + seconds
        while self.active < until:
            if not (yield from self.cycle(0.0, 0.0)):
                return False
        return True

    def settle_seen(self, most: float) -> Motion[F]:
        """Stand still until the pose has been judged by what is seen from here, at most so many seconds."""
        rested, until = self._clocks.robot(), self.active + most
        while self.active < until and not self._seen_since(rested):
            if not (yield from self.cycle(0.0, 0.0)):
                return False
        return True

    def _seen_since(self, moment: RobotTime | None) -> bool:
        seen = self._localiser.taken_in
        return moment is not None and seen is not None and seen.is_after(moment) is True

    def fail(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> None:
        """Note why the run has to end; the first reason stays."""
        if self.failure is None:
            self.failure = Failure(kind=kind, message=message, where=self._where, evidence=dict(evidence))

    def _must_halt(self, linear: float, angular: float) -> bool:
        """Say whether somebody would be at the base before it has stood for long enough."""
        if self.caution is None or (self.wheels.resting and linear == 0.0 and angular == 0.0):
            return False
        speeds = self.wheels.next_speeds(linear, angular)
        if self.caution.safe(self.pose, *speeds):
            self._halted_for = 0.0
            return False
        self._halted_for += CYCLE
        self._paused_for += CYCLE
        if self._halted_for > PATIENCE:
            self.blocked_by_person(self.pose.x, self.pose.y)
        return True

    def blocked_by_person(self, x: float, y: float) -> None:
        """End the run: somebody at or near a place in map does not go away."""
        person = None if self.caution is None else self.caution.nearest(x, y)
        if person is None:
            self.fail(FailureKind.BASE_BLOCKED, "something stands in the way", obstacle_x_m=x, obstacle_y_m=y)
            return
        px, py = person.place
        self.fail(
            FailureKind.BASE_BLOCKED,
            f"a person is in the way, at ({px:.2f}, {py:.2f})",
            person_x_m=round(px, 3),
            person_y_m=round(py, 3),
            distance_m=math.hypot(px - self.pose.x, py - self.pose.y),
        )

    def _may_go_on(self) -> bool:
        return not self.canceled and self.failure is None

    def _wait(self, seconds: float) -> Generator[F | Slice, Command, None]:
        """Yield feedback until robot time has gone on by ``seconds``; notes a cancellation, obeys a pause."""
        until = self.now + seconds - 1e-6
        while True:
            command = yield self._feedback()
            if command is Command.CANCEL:
                self.canceled = True
            elif command is Command.PAUSE and not self.canceled:
                yield from self._pause()
                return
            if self.now >= until:
                return

    def _pause(self) -> Generator[F | Slice, Command, None]:
        """Brake, then stand until told to go on or to cancel."""
        since = send_at = self.now
        while True:
            if self.now >= send_at:
                self.wheels.send(0.0, 0.0)
                send_at = self.now + CYCLE - 1e-6
            command = yield self._feedback()
            if command is Command.CANCEL:
                self.canceled = True
            if self.canceled or command is Command.RESUME:
                self._paused_for += self.now - since
                return
