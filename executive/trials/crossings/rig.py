"""The base alone in the simulated room: it is told that the arm is folded, and goals come from here."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from tandem.executive.system.systems import SystemFailure
from tandem.sim.chatter import unheard
from tandem.skills.ports.action import GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.actions.arm import ArmState, ArmStatus, arm_status
from tandem.skills.ports.actions.base import DRIVE, LOCALISE, DriveGoal, LocaliseGoal
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.world import ROBOT_POSE

if TYPE_CHECKING:
    from tandem.sim.scenario import Scenario
    from tandem.sim.station import Station
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.clocks import Clocks
    from tandem.skills.ports.site import Site

CLIENT: Final = "crossings"
"""What this is announced as; a goal comes to rest without its client."""
TELLS_EVERY: Final = 10
"""Periods between two words of the arm."""
AGAIN_WITHIN: Final = 10.0
"""Robot seconds for localising then."""
AGAIN_AFTER: Final = 1.0
"""Robot seconds after which a goal that a reflex has ended is sent again."""
SETTLES: Final = 0.5
"""Robot seconds before the first goal."""


class Rig:
    """Hardware and base in lockstep.

    Args:
        scenario: the room and who is in it.
        seed: of all that is random.
        site: what is known beforehand.
    """

    def __init__(self, scenario: Scenario, seed: int, site: Site) -> None:
        with unheard():
            from tandem.executive.system.lockstep import Lockstep  # noqa: PLC0415 - as LockstepSystem
            from tandem.executive.system.roles.registry import skill_roles  # noqa: PLC0415
            from tandem.sim.robots.registry import robot_model  # noqa: PLC0415

            self._description = robot_model(scenario.robot).description
            others = [role.name for role in skill_roles(self._description) if role.name != "base"]
            self._lockstep = Lockstep(scenario, seed, without=[*others, "executive"], site=site)
        self._ticks = self._goals = 0
        self.bus: Bus = self._lockstep.bus
        self.bus.announce(CLIENT)
        self._believed = Latest(self.bus, ROBOT_POSE)
        self.clocks: Clocks = self._lockstep.clocks
        self._also: Callable[[], None] = lambda: None
        self._wait(SETTLES)

    @property
    def station(self) -> Station:
        """The simulation itself."""
        return self._lockstep.station

    def localise(self, near: FloorPose) -> None:
        """Have the base find where it is.

        Raises:
            SystemFailure: it does not.
        """
        goal = LocaliseGoal(hint=near)
        status = self._do(LOCALISE.name, goal.model_dump(mode="json"), within=10.0)
        if status is None or status.result is None:
            raise SystemFailure(f"the base does not know where it is: {status}")

    def drive(self, goal: FloorPose, *, within: float, also: Callable[[], None]) -> GoalStatus | None:
        """Drive; ``also`` is called after each period. None: not done within so many robot seconds.

        As a tree would, it localises and drives again after a reflex took the wheels: somebody has run into
        the base.
        """
        self._also = also
        asked = DriveGoal(poses=(goal,), position_tolerance=0.05, yaw_tolerance=0.1)
        until = robot_seconds(self.clocks) + within
        try:
            while (left := until - robot_seconds(self.clocks)) > 0.0:
                status = self._do(DRIVE.name, asked.model_dump(mode="json"), within=left)
                if status is None or not _again(status):
                    return status
                self._wait(AGAIN_AFTER)
                self._localise_again(min(left, AGAIN_WITHIN))
            return None
        finally:
            self._also = lambda: None

    def _localise_again(self, within: float) -> None:
        """Find the place anew, near where the base believes to be: it may have been pushed."""
        believed = self._believed.refresh()
        hint = None if believed is None else believed.base_in_map
        self._do(LOCALISE.name, LocaliseGoal(hint=hint).model_dump(mode="json"), within=within)

    def close(self) -> None:
        """End it."""
        self._lockstep.close()

    def _do(self, action: str, goal: dict[str, object], *, within: float) -> GoalStatus | None:
        self._goals += 1
        heard = Latest(self.bus, status_topic(action))
        sent = SendGoal.model_validate(
            {"goal_id": f"crossing/{action}/{self._goals}", "client": CLIENT, "goal": goal}
        )
        pending = goal_service(action).query(self.bus, sent)
        until = robot_seconds(self.clocks) + within
        try:
            while robot_seconds(self.clocks) < until:
                self._step()
                answer = pending.poll()
                if answer is not None:
                    taken = goal_service(action).decode_answer(answer)
                    if taken.state.terminal:
                        return taken
                done = next((each for each in heard.take() if each.state.terminal), None)
                if done is not None:
                    return done
            return None
        finally:
            heard.close()

    def _wait(self, seconds: float) -> None:
        until = robot_seconds(self.clocks) + seconds
        while robot_seconds(self.clocks) < until:
            self._step()

    def _step(self) -> None:
        if self._ticks % TELLS_EVERY == 0 and (now := self.clocks.robot()) is not None:
            for hand in self._description.end_effectors:
                folded = ArmStatus(
                    stamp=now,
                    group=hand.group,
                    state=ArmState.ARM_IDLE,
                    extent=self._description.footprint_radius - 0.02,
                )
                arm_status(hand.group).publish(self.bus, folded)
        self._ticks += 1
        self._lockstep.step()
        self._also()


def _again(status: GoalStatus) -> bool:
    again = {FailureKind.OVERRIDDEN, FailureKind.NOT_LOCALISED}
    return status.failure is not None and status.failure.kind in again
