"""Drive along one path: turn to it, follow it, heed people, leave it for them where the site has a band."""

from __future__ import annotations

import math
from collections.abc import Generator
from typing import Final

from tandem.skills.base.band.bend import Bend
from tandem.skills.base.ending import ARRIVED
from tandem.skills.base.headway import Headway
from tandem.skills.base.journey_context import JourneyContext, Progress
from tandem.skills.base.path_follower import Follower
from tandem.skills.base.way_watch import Block, Watch
from tandem.skills.base.wheels_run import Motion, Ride
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import DriveFeedback
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.skill import Command, Slice

SET_OFF: Final = 0.15
"""Radians off the path's first piece from which on the base turns before it drives."""
ROOMY: Final = 0.12
"""Metres of spare clearance from which on the base may turn while it sets off."""
LONG: Final = 0.8
"""Metres: a shorter way is better faced first."""
BLOCKED_FOR: Final = 0.4
"""Robot seconds for which something must be in the way before another way is looked for."""
CRAWL: Final = 0.05
"""m/s: slower, the base waits for people."""
HELD: Final = 0.02
"""rad/s: slower commands are no turning."""
BACK_UP: Final = 0.8
"""Metres up to which the base may go backwards, where the laser does not look."""
SLICE_COST: Final = 0.001
"""Robot seconds that lockstep charges for one step of a band's plan."""


class Leg:
    """One path, driven once.

    Args:
        course: what is known of the floor.
        ride: the wheels, the guards and the commands of this run.
        watch: what stands in the way.
        progress: what feedback tells; kept up to date here.
        follower: on the path.
    """

    def __init__(
        self,
        course: JourneyContext,
        ride: Ride[DriveFeedback],
        watch: Watch,
        progress: Progress,
        follower: Follower,
    ) -> None:
        self._course, self._ride, self._watch, self._progress = course, ride, watch, progress
        self._follower = follower
        self._bend: Bend | None = None
        if course.bends and course.caution is not None:
            self._bend = Bend(course.caution, course.radius, course.watch, follower)

    def drive(self) -> Generator[DriveFeedback | Slice, Command, Block | None]:
        """Drive and come to rest; returns what blocks it, None at its (or the run's) end.

        A base that turns already to its pose's heading turns on: ``follower.turns_on``.
        A base that people have driven off its path, and that finds no way back to it, is blocked there.
        """
        ride, follower = self._ride, self._follower
        if self._back_is_sooner():
            yield from self._back_up()
            return None
        if self._must_turn_first() and not (
            yield from ride.turn(follower.off(ride.pose), rolls_on=follower.swing)
        ):
            return None
        free_at, headway = ride.active, Headway(ride.active)
        while follower.remaining > ARRIVED:
            block = self._watch.block(follower.path, follower.way)
            linear, angular, waits = yield from self._speeds(block)
            self._progress.remaining = max(follower.remaining, 0.0)
            if not (yield from ride.cycle(linear, angular)):
                break
            if self._bend is not None and self._bend.astray:
                yield from ride.rest()
                return Block(follower.way, *follower.path.at(follower.way))
            if block is None:
                free_at = ride.active
            elif ride.active - free_at > BLOCKED_FOR:
                yield from ride.rest()
                return block
            excused = block is not None or abs(angular) > HELD
            if headway.look(follower.remaining, ride.active, excused=excused, waits=waits):
                self._end_held(tired=headway.tired)
                break
        if follower.remaining > ARRIVED or not follower.turns_on:
            yield from ride.rest()
        return None

    def _end_held(self, *, tired: bool) -> None:
        follower = self._follower
        if tired:
            self._ride.blocked_by_person(*follower.path.at(follower.way + LONG))
            return
        self._ride.fail(FailureKind.BASE_BLOCKED, "the base does not move", remaining_m=follower.remaining)

    def _speeds(
        self, block: Block | None
    ) -> Generator[DriveFeedback | Slice, Command, tuple[float, float, bool]]:
        """Return speeds (m/s, rad/s) as its cliff sensors allow them, and whether it waits for people."""
        linear, angular, waits = yield from self._heeding_people(block)
        most = self._course.speed(linear)
        return most, angular * most / linear if most < linear else angular, waits

    def _heeding_people(
        self, block: Block | None
    ) -> Generator[DriveFeedback | Slice, Command, tuple[float, float, bool]]:
        """Return speeds (m/s, rad/s) that heed people, and whether the base waits for them."""
        ride, follower, caution = self._ride, self._follower, self._course.caution
        blocked_at = None if block is None else block.way
        wanted, angular = follower.speeds(ride.pose, ride.wheels.linear, blocked_at)
        if caution is None:
            return wanted, angular, False
        pace = caution.pace(follower.path, follower.way, wanted) if wanted > 0.0 else wanted
        bent = None
        if self._bend is not None:
            bent = yield from self._bent(self._bend, slowed=pace < wanted or ride.halted)
        if bent is not None:
            return *bent, bent[0] < CRAWL
        if wanted <= 0.0:
            return wanted, angular, False
        return pace, angular * pace / wanted, pace < CRAWL and pace < wanted

    def _bent(
        self, bend: Bend, *, slowed: bool
    ) -> Generator[DriveFeedback | Slice, Command, tuple[float, float] | None]:
        """Let the band plan, in slices, if it is its turn; return its speeds, None to follow the path."""
        ride = self._ride
        if bend.due(ride.now, ride.pose, slowed=slowed):
            for _ in bend.plan(ride.now, ride.pose, ride.wheels.linear, ride.wheels.angular):
                yield from ride.heed((yield Slice(SLICE_COST)))
        return bend.speeds(ride.now, ride.pose)

    def _must_turn_first(self) -> bool:
        """Say whether to face the path before driving: where there is room, the base turns on the way."""
        follower, here = self._follower, self._ride.pose
        length = follower.path.length
        if length <= ARRIVED or abs(follower.off(here)) <= SET_OFF:
            return False
        clearances = follower.clearances
        spare = clearances.field.at_point(here.x, here.y) - clearances.needed
        return spare < ROOMY or length < LONG

    def _back_is_sooner(self) -> bool:
        """Say whether a short straight way is done sooner backwards, with less turning."""
        path, goal = self._follower.path, self._follower.goal
        if goal is None or len(path.points) > 2 or not ARRIVED < path.length < BACK_UP:  # noqa: PLR2004 - one piece
            return False
        here, drive, ahead = self._ride.pose, self._course.drive, path.heading_at(0.0)
        turns = [abs(wrap(way - here.yaw)) + abs(wrap(goal.yaw - way)) for way in (ahead, ahead + math.pi)]
        return path.length / drive.backward + turns[1] / drive.turn < (
            path.length / drive.forward + turns[0] / drive.turn
        )

    def _back_up(self) -> Motion[DriveFeedback]:
        ride, path = self._ride, self._follower.path
        if not (yield from ride.turn(wrap(path.heading_at(0.0) + math.pi - ride.pose.yaw))):
            return False
        return (yield from ride.straight(-path.length))
