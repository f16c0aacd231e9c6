"""LOCALISE: find the robot on the whole floor, or near a hint, from a few scans at rest."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray, compose, invert, points_in
from tandem.skills.base.guard import Guard
from tandem.skills.base.localiser import Localiser
from tandem.skills.base.map import SiteMap
from tandem.skills.base.scan import ScanPoints
from tandem.skills.base.search import Found, Search, near, whole_floor
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.wheels_run import Ride
from tandem.skills.ports.actions.base import (
    LOCALISE,
    BaseState,
    LocaliseFeedback,
    LocaliseGoal,
    LocaliseResult,
)
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import ActionType, Command, Outcome, Run, Slice, canceled, failed, succeeded

SCANS: Final = 4
"""Scans at rest that are searched with together: their noise averages out."""
PATIENCE: Final = 3.0
"""Robot seconds to wait for the base to be at rest, and for the scans."""
SLICE_COST: Final = 0.002
"""Robot seconds that lockstep charges for one slice of the search."""
GOOD_FIT: Final = 0.6
"""Share of beams that the map must explain."""
CLEAR_LEAD: Final = 0.03
"""By how much the best pose's score must beat the best elsewhere."""
FOUND_SIGMA: Final = (0.03, 0.02)
"""Metres and radians to which a found pose is trusted at first."""

TURN: Final = 2.0
"""Radians by which the base turns to see more, when two places look alike."""
ROOM: Final = 0.02
"""Metres beyond the footprint that must be free of hits for that."""

Steps = Generator[LocaliseFeedback | Slice, Command, bool]


@dataclass(frozen=True)
class _View:
    """What was seen from one place: points in the base, shape (n, 2), and base_in_odom there."""

    points: FloatArray
    base_in_odom: FloorPose
    stamp: RobotTime


class Localise:
    """The skill of finding out where the robot is.

    It stands still, and turns on the spot only when two places look alike and nothing is too close.

    Args:
        clocks: robot time.
        site_map: the map.
        localiser: the monitor that is started from what is found.
        guard: whether the base may move.
        board: who has the wheels.
        wheels: to turn on the spot.
        radius: the footprint's (m).
    """

    def __init__(
        self,
        clocks: Clocks,
        site_map: SiteMap,
        localiser: Localiser,
        *,
        guard: Guard,
        board: BaseStatusBoard,
        wheels: Wheels,
        radius: float,
    ) -> None:
        self._clocks, self._localiser, self._map = clocks, localiser, site_map
        self._guard, self._board, self._wheels, self._radius = guard, board, wheels, radius

    @property
    def action(self) -> ActionType[LocaliseGoal, LocaliseFeedback, LocaliseResult]:
        """The contract."""
        return LOCALISE

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.05

    def check(self, goal: LocaliseGoal) -> Failure | None:
        """Refuse a hint outside the floor, and while another skill has the wheels."""
        busy = self._board.pipeline.busy(LOCALISE.name)
        if busy is not None:
            return busy
        x_min, y_min, x_max, y_max = self._map.bounds
        hint = goal.hint
        if hint is not None and not (x_min <= hint.x <= x_max and y_min <= hint.y <= y_max):
            return self._failure(
                FailureKind.INVALID_GOAL, "expected a hint on the floor", x_m=hint.x, y_m=hint.y
            )
        return None

    def run(self, goal: LocaliseGoal, goal_id: str) -> Run[LocaliseFeedback, LocaliseResult]:  # noqa: ARG002
        """Wait for scans at rest, search, start the localiser there."""
        region = whole_floor(self._map) if goal.hint is None else near(goal.hint)
        views: list[_View] = []
        while True:
            if (yield from self._look(views)):
                return canceled()
            if not views or not len(views[-1].points):
                return failed(self._nothing_seen(silent=not views))
            search = Search(self._map, _together(views), region)
            if (yield from self._search(search)):
                return canceled()
            outcome = self._conclude(search.best, search.runner_up, views[-1])
            if outcome is not None:
                return outcome
            assert search.best is not None
            assert search.runner_up is not None
            ambiguous = self._ambiguous(search.best, search.runner_up)
            if len(views) > 1 or not self._may_turn(views[-1]):
                return failed(ambiguous)
            if (yield from self._turn()):
                return canceled()

    def _may_turn(self, view: _View) -> bool:
        gaps = np.hypot(view.points[:, 0], view.points[:, 1])
        free = bool(gaps.min() > self._radius + ROOM)
        busy = self._board.pipeline.busy(LOCALISE.name)
        return free and busy is None and self._guard.refusal(LOCALISE.name, anywhere=True) is None

    def _turn(self) -> Steps:
        """Turn on the spot, as odometry tells; True: cancelled. Else the next look tells how it went."""
        if not self._board.claim(LOCALISE.name, anywhere=True):
            return False
        try:
            ride = Ride(
                self._clocks,
                self._localiser,
                self._wheels,
                feedback=lambda: LocaliseFeedback(progress=0.5),
                where=LOCALISE.name,
            )
            yield from ride.turn(TURN)
            yield from ride.rest()
            return ride.canceled
        finally:
            if not self._wheels.resting:
                self._wheels.halt()
            self._board.release(LOCALISE.name, BaseState.BASE_IDLE)

    def _look(self, views: list[_View]) -> Steps:
        """Add what is seen from here, if anything comes; True: cancelled."""
        scans: list[ScanPoints] = []
        if (yield from self._gather(scans)):
            return True
        odometry = self._localiser.odometry
        if scans and odometry is not None:
            points = np.concatenate([scan.in_base for scan in scans])
            views.append(_View(points, odometry.base_in_odom, scans[-1].stamp))
        else:
            views.clear()
        return False

    def _gather(self, scans: list[ScanPoints]) -> Steps:
        """Collect scans at rest; True: cancelled."""
        start = robot_seconds(self._clocks)
        known = self._localiser.recent[-1].stamp if self._localiser.recent else self._clocks.robot()
        while len(scans) < SCANS and robot_seconds(self._clocks) - start < PATIENCE:
            command = yield LocaliseFeedback(progress=0.0)
            heard_at = robot_seconds(self._clocks)
            if (yield from _stand(command)):
                return True
            start += robot_seconds(self._clocks) - heard_at  # a pause does not count
            if self._localiser.moving:
                scans.clear()
                known = self._clocks.robot()
                continue
            since = scans[-1].stamp if scans else known
            scans += [s for s in self._localiser.recent if since is None or s.stamp.is_after(since)]
        return False

    def _search(self, search: Search) -> Steps:
        """Run the search to its end; True: cancelled."""
        for number, progress in enumerate(search.slices()):
            command = yield Slice(SLICE_COST)
            if number % 20 == 0 and command is Command.GO_ON:
                command = yield LocaliseFeedback(progress=min(progress, 1.0))
            if (yield from _stand(command)):
                return True
        return False

    def _conclude(
        self, best: Found | None, runner_up: Found | None, view: _View
    ) -> Outcome[LocaliseResult] | None:
        """Return how it ended; None when two places look alike."""
        if best is None or best.fit < GOOD_FIT:
            fit = 0.0 if best is None else best.fit
            return failed(
                self._failure(
                    FailureKind.NOT_LOCALISED, "no pose fits the scan well", fit=fit, needed=GOOD_FIT
                )
            )
        if runner_up is not None and best.score - runner_up.score < CLEAR_LEAD:
            return None
        if not self._localiser.initialise(best.pose, view.stamp, FOUND_SIGMA):
            return failed(self._failure(FailureKind.NOT_READY, "the base moved while its place was searched"))
        fit_elsewhere = 0.0 if runner_up is None else runner_up.fit
        return succeeded(LocaliseResult(base_in_map=best.pose, fit=best.fit, runner_up=fit_elsewhere))

    def _ambiguous(self, best: Found, runner_up: Found) -> Failure:
        return self._failure(
            FailureKind.NOT_LOCALISED,
            "two places fit the scan alike",
            x_m=best.pose.x,
            y_m=best.pose.y,
            other_x_m=runner_up.pose.x,
            other_y_m=runner_up.pose.y,
            lead=best.score - runner_up.score,
        )

    def _nothing_seen(self, *, silent: bool) -> Failure:
        if not silent:
            return self._failure(FailureKind.NOT_LOCALISED, "the laser sees nothing")
        if self._localiser.moving:
            return self._failure(FailureKind.NOT_READY, "the base does not come to rest", waited_s=PATIENCE)
        return self._failure(FailureKind.LASER_SILENT, f"no scan within {PATIENCE:g} s", waited_s=PATIENCE)

    def _failure(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> Failure:
        return Failure(kind=kind, message=message, where=LOCALISE.name, evidence=dict(evidence))


def _stand(command: Command) -> Steps:
    """Wait, after a pause, until the run is resumed; True: cancelled."""
    if command is Command.PAUSE:
        while command not in {Command.RESUME, Command.CANCEL}:
            command = yield LocaliseFeedback(progress=0.0)
    return command is Command.CANCEL


def _together(views: list[_View]) -> FloatArray:
    """Return all points in the base as it stands at the last view, shape (n, 2)."""
    back = invert(views[-1].base_in_odom)
    return np.concatenate([points_in(compose(back, view.base_in_odom), view.points) for view in views])
