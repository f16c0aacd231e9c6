"""One run of DRIVE: plan, follow, go round what stands in the way, correct the end."""

from __future__ import annotations

import itertools
import math
from typing import Final

from tandem.skills.base.ending import laid_aside
from tandem.skills.base.journey_context import JourneyContext, Progress
from tandem.skills.base.leg import Leg
from tandem.skills.base.path import Path
from tandem.skills.base.path_follower import Follower
from tandem.skills.base.planner import Clearances, Planner
from tandem.skills.base.quicker import without_slow_corners
from tandem.skills.base.way_watch import Block
from tandem.skills.base.wheels_run import Motion, Ride
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.actions.base import DRIVE, DriveFeedback, DriveGoal, DriveResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import Outcome, Run, Slice, canceled, failed, succeeded

MARGIN: Final = 0.03
"""Metres that a plan keeps between the footprint and everything."""
SLICE_COST: Final = 0.001
"""Robot seconds that lockstep charges for one slice of planning."""
WAIT: Final = 1.0
"""Robot seconds to wait for a way to open."""
WAIT_FOR_PEOPLE: Final = 4.0
"""The same where people walk about: they stay longer than things that are carried by."""
MOST_REPLANS: Final = 4
"""Chosen: a way that is blocked again and again is the tree's matter."""
MOST_REPLANS_FOR_PEOPLE: Final = 8
"""Where people walk about: each who stops is gone round, or waited for."""
MOST_CORRECTIONS: Final = 3
"""Times that the end is approached anew when the base is off its goal."""
GOOD_YAW: Final = 0.3
"""Share of the tolerance within which the heading is left as it is."""
NUDGE: Final = 0.25
"""Metres up to which a correction goes straight, without a new plan."""
SETTLE: Final = 0.15
"""Robot seconds at rest, at the most, before the pose is judged: by then a scan has been taken from there."""
AT_PERSON: Final = 0.8
"""Metres from a person to what is in the way up to which it is the person: in a narrow place nothing is free
beside them either."""


class Journey:
    """One run of DRIVE.

    Args:
        course: what is known of the floor.
        ride: the wheels, the guards and the commands of this run.
        progress: what feedback tells; kept up to date here.
        goal: where to go.
    """

    def __init__(
        self, course: JourneyContext, ride: Ride[DriveFeedback], progress: Progress, goal: DriveGoal
    ) -> None:
        self._course, self._ride, self._progress, self._goal = course, ride, progress, goal
        self._watch = course.watch()
        self._chosen = 0
        self._replans = 0
        self._plan: tuple[Path, Clearances] | None = None
        self._problems: list[Failure] = []

    def run(self) -> Run[DriveFeedback, DriveResult]:
        """Do it."""
        done = yield from self._travel()
        yield from self._ride.rest()
        if self._ride.canceled:
            return canceled()
        if self._ride.failure is not None:
            return failed(self._ride.failure)
        return self._result() if done else failed(self._nowhere())

    def _travel(self) -> Motion[DriveFeedback]:
        if not (yield from self._plan_first()):
            return False
        return (yield from self._reach()) and (yield from self._finish(self._goal.poses[self._chosen]))

    def _finish(self, pose: FloorPose) -> Motion[DriveFeedback]:
        """Turn to the pose's heading, look where the base is, and correct it a few times at the most."""
        ride = self._ride
        for correction in range(MOST_CORRECTIONS + 1):
            off = wrap(pose.yaw - ride.pose.yaw)
            turns = abs(off) > GOOD_YAW * self._goal.yaw_tolerance or not ride.wheels.resting
            if turns and not (yield from ride.turn(off)):
                return False
            if not (yield from ride.settle_seen(SETTLE)):
                return False
            if self._within(pose):
                return True
            if correction < MOST_CORRECTIONS and not (yield from self._correct(pose)):
                return False
        ride.fail(
            FailureKind.BASE_OFF_GOAL,
            "the base came to rest outside the tolerance",
            position_error_m=floor_distance(ride.pose, pose),
            position_tolerance_m=self._goal.position_tolerance,
            yaw_error_rad=wrap(ride.pose.yaw - pose.yaw),
            yaw_tolerance_rad=self._goal.yaw_tolerance,
            corrections=MOST_CORRECTIONS,
        )
        return False

    def _plan_first(self) -> Motion[DriveFeedback]:
        """Take the first of the goal's poses that a checked plan leads to; wait where people are about."""
        left = MOST_REPLANS_FOR_PEOPLE
        while not (yield from self._plan_to_one_of(0)):
            if self._ride.canceled or self._ride.failure is not None:
                return False
            caution = self._course.caution
            if not left or caution is None or not caution.tracker.lately:
                self._ride.failure = self._nowhere()
                return False
            left, self._replans = left - 1, self._replans + 1
            self._problems.clear()
            if not (yield from self._ride.settle(WAIT_FOR_PEOPLE)):
                return False
        return True

    def _plan_to_one_of(self, first: int) -> Motion[DriveFeedback]:
        """Take the first of the goal's poses, from that number on, that a checked plan leads to."""
        for index in range(first, len(self._goal.poses)):
            self._chosen = index
            if (yield from self._plan_to(self._goal.poses[index])):
                return True
            if self._ride.canceled or self._ride.failure is not None:
                return False
        return False

    def _nowhere(self) -> Failure:
        return Failure(
            kind=FailureKind.BASE_NO_PATH,
            message=f"no free way to any of {len(self._goal.poses)} poses",
            where=DRIVE.name,
            evidence={"poses": len(self._goal.poses)},
            causes=tuple(self._problems),
        )

    def _plan_to(self, pose: FloorPose) -> Motion[DriveFeedback]:
        """Plan from here; True with ``_plan`` set, False with the reason among ``_problems``.

        A way with room for all that the arms reach is tried first; then one for the footprint alone. A way
        wide around people who stand comes before one that is close by.
        """
        for radius, berth in itertools.product(self._course.radii(), self._course.berths()):
            if (yield from self._plan_with(radius, berth, pose)):
                return True
            if self._ride.canceled or self._ride.failure is not None:
                return False
        return False

    def _plan_with(self, radius: float, berth: float, pose: FloorPose) -> Motion[DriveFeedback]:
        self._plan = None
        mapped = Clearances(self._course.site_map.plan, radius + MARGIN, self._ride.pose)
        planner = Planner(mapped, self._course.strange(berth), pose)
        for _ in planner.slices():
            if not (yield from self._ride.heed((yield Slice(SLICE_COST)))):
                return False
        if planner.path is None:
            self._problems.append(self._no_path(pose, planner, planner.clearances))
            return False
        path = planner.path
        for quicker in without_slow_corners(path, pose, self._course.drive, planner.clearances):
            path = quicker
            if not (yield from self._ride.heed((yield Slice(SLICE_COST)))):
                return False
        self._plan = (path, planner.clearances)
        self._progress.remaining = path.length
        self._progress.way = tuple((round(float(x), 3), round(float(y), 3)) for x, y in path.points)
        self._progress.total = max(self._progress.total, path.length)
        return True

    def _no_path(self, pose: FloorPose, planner: Planner, clearances: Clearances) -> Failure:
        return Failure(
            kind=FailureKind.BASE_NO_PATH,
            message=planner.problem,
            where=DRIVE.name,
            evidence={
                "x_m": pose.x,
                "y_m": pose.y,
                "goal_clearance_m": clearances.field.at_point(pose.x, pose.y),
                "start_clearance_m": clearances.field.at_point(clearances.start.x, clearances.start.y),
                "needed_m": clearances.needed,
                "expanded": planner.expanded,
            },
        )

    def _reach(self) -> Motion[DriveFeedback]:
        """Drive the plan, and others around what turns out to stand in the way."""
        ride, left = self._ride, self._most_replans()
        while self._plan is not None:
            block = yield from self._leg(*self._plan).drive()
            if ride.canceled or ride.failure is not None:
                return False
            if block is None:
                return True
            while True:
                if not left:
                    if (yield from self._plan_to_one_of(self._chosen + 1)):
                        left = self._most_replans()
                        break
                    if not (ride.canceled or ride.failure is not None):
                        self._blocked(block)
                    return False
                left, self._replans = left - 1, self._replans + 1
                if (yield from self._plan_to(self._goal.poses[self._chosen])):
                    break
                # No way round: what stands there may go away.
                if ride.canceled or ride.failure is not None or not (yield from ride.settle(self._wait())):
                    return False
        return False

    def _leg(self, path: Path, clearances: Clearances) -> Leg:
        goal, drive = self._goal.poses[self._chosen], self._course.drive
        return Leg(
            self._course,
            self._ride,
            self._watch,
            self._progress,
            Follower(laid_aside(path, goal, drive, clearances), drive, clearances, goal),
        )

    def _most_replans(self) -> int:
        return MOST_REPLANS if self._course.caution is None else MOST_REPLANS_FOR_PEOPLE

    def _wait(self) -> float:
        return WAIT if self._course.caution is None else WAIT_FOR_PEOPLE

    def _within(self, pose: FloorPose) -> bool:
        here = self._ride.pose
        return (
            floor_distance(here, pose) <= self._goal.position_tolerance
            and abs(wrap(here.yaw - pose.yaw)) <= self._goal.yaw_tolerance
        )

    def _correct(self, pose: FloorPose) -> Motion[DriveFeedback]:
        """Go the last centimetres straight, ahead or back, whichever turns less; farther off, plan anew."""
        ride = self._ride
        distance = floor_distance(ride.pose, pose)
        if distance <= self._goal.position_tolerance:
            return True
        if distance > NUDGE:
            return (yield from self._plan_to(pose)) and (yield from self._reach())
        off = wrap(math.atan2(pose.y - ride.pose.y, pose.x - ride.pose.x) - ride.pose.yaw)
        back = abs(off) > math.pi / 2
        if not (yield from ride.turn(wrap(off + math.pi) if back else off)):
            return False
        return (yield from ride.straight(-distance if back else distance))

    def _result(self) -> Outcome[DriveResult]:
        here, pose = self._ride.pose, self._goal.poses[self._chosen]
        return succeeded(
            DriveResult(
                pose=self._chosen,
                base_in_map=here,
                position_error=floor_distance(here, pose),
                yaw_error=abs(wrap(here.yaw - pose.yaw)),
                replans=self._replans,
            )
        )

    def _blocked(self, block: Block) -> None:
        caution = self._course.caution
        if caution is not None and caution.tracker.near(block.x, block.y, AT_PERSON) is not None:
            self._ride.blocked_by_person(block.x, block.y)
            return
        self._ride.failure = Failure(
            kind=FailureKind.BASE_BLOCKED,
            message="something stands in the way, and there is no way round",
            where=DRIVE.name,
            evidence={
                "obstacle_x_m": block.x,
                "obstacle_y_m": block.y,
                "distance_m": math.hypot(block.x - self._ride.pose.x, block.y - self._ride.pose.y),
                "replans": self._replans,
            },
            causes=tuple(self._problems[-1:]),
        )
