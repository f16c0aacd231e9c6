"""Turn the head: point the camera where it will be needed, while the base is still on its way there."""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

from tandem.skills.geometry.poses import invert, to_pose, transform
from tandem.skills.perception.aim import Aim
from tandem.skills.perception.camera_frames import JointHistory
from tandem.skills.perception.eye import POSE_AFTER
from tandem.skills.perception.head import Head
from tandem.skills.perception.session import Canceled, LookError, Session
from tandem.skills.ports.actions.perception import TURN_HEAD, LookFeedback, TurnHeadGoal, TurnHeadResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import STOP_STATE, Latest
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.skill import ActionType, Command, Run, Slice, canceled, failed, succeeded

WHERE: Final = "perception/turn_head"


class TurnHead:
    """The skill behind ``perception/turn_head``; a camera that nothing turns is where it should be.

    Args:
        bus: where the hardware is.
        clocks: robot time.
        description: the robot's: its head, and where the camera is mounted.
    """

    period: Final = 0.02

    def __init__(self, bus: Bus, clocks: Clocks, description: RobotDescription) -> None:
        self._bus, self._clocks, self._aim = bus, clocks, Aim(description)
        self._stop = Latest(bus, STOP_STATE)

    @property
    def action(self) -> ActionType[TurnHeadGoal, LookFeedback, TurnHeadResult]:
        """The contract it fulfils."""
        return TURN_HEAD

    def check(self, goal: TurnHeadGoal) -> Failure | None:  # noqa: ARG002
        """Refuse nothing: a point out of the head's reach is looked at as nearly as can be."""
        return None

    def run(self, goal: TurnHeadGoal, goal_id: str) -> Run[LookFeedback, TurnHeadResult]:
        """Turn the head, and come to rest."""
        session, joints = Session(self._clocks, self._stop), JointHistory(self._bus)
        head = Head(self._bus, self._aim.group, goal_id)

        def refresh() -> None:
            joints.refresh()
            head.refresh()

        session.refresh = refresh
        try:
            end = yield from self._turn(session, joints, head, goal)
            return succeeded(TurnHeadResult(positions=end))
        except Canceled:
            yield from head.come_to_rest(session)
            return canceled()
        except LookError as error:
            return failed(error.failure.model_copy(update={"where": WHERE}))
        finally:
            head.close()
            joints.close()

    def _turn(
        self, session: Session, joints: JointHistory, head: Head, goal: TurnHeadGoal
    ) -> Generator[LookFeedback | Slice, Command, tuple[float, ...]]:
        if not (yield from session.until(lambda: joints.newest is not None, POSE_AFTER)):
            raise LookError(FailureKind.HARDWARE_LOST, f"no joint states within {POSE_AFTER} s")
        assert joints.newest is not None
        known = dict(zip(joints.newest.names, joints.newest.positions, strict=True))
        end = self._aim.at(transform(invert(to_pose(goal.base)), goal.at), known)
        yield from head.move(session, joints, end)
        return joints.newest.position_of(self._aim.group.joints)
