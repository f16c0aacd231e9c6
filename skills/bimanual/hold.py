"""What both arms do together, period by period: each hand goes to its pose, and the squeeze is kept.

It goes on between two goals: what is between the hands must not fall while the tree thinks. It lets go of
the arms when it is told to, when somebody else moves one of them, or when a reflex takes one.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from tandem.skills.bimanual.lead import LedArm
from tandem.skills.bimanual.object_frame import Span, span
from tandem.skills.bimanual.squeeze import Grasp
from tandem.skills.geometry.poses import rotate, subtract
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.actions.approach import ApproachStatus, approach_status
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.hardware import GroupStatus, JointStates, MotionState, Wrench
from tandem.skills.ports.keys import JOINT_STATES, STOP_STATE, Latest, group_setpoint, group_status, wrench
from tandem.skills.ports.message import HandName, RobotTime, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.reflex import PipelineState, pipeline_state
from tandem.skills.ports.robot_description import RobotDescription

LONGEST: Final = 0.05
"""Seconds that count at the most as one period, whatever was missed."""
_NOTHING: Final[Vector3] = (0.0, 0.0, 0.0)


class TwoArms:
    """Leads both hands; a ``Node``.

    Args:
        bus: the hardware.
        clocks: robot time.
        description: the robot.
        hulls: its bodies.
    """

    name = "bimanual/hold"

    def __init__(self, bus: Bus, clocks: Clocks, description: RobotDescription, hulls: RobotHulls) -> None:
        self._bus, self._clocks, self._robot = bus, clocks, hulls.robot
        self._joints, self._stop = Latest(bus, JOINT_STATES), Latest(bus, STOP_STATE)
        self._wrenches: dict[HandName, Latest[Wrench]] = {side: Latest(bus, wrench(side)) for side in PAIR}
        self.arms = tuple(LedArm(description, hulls.robot, side) for side in PAIR)
        self._status: list[Latest[GroupStatus]] = [Latest(bus, group_status(arm.group)) for arm in self.arms]
        self._approaches: list[Latest[ApproachStatus]] = [
            Latest(bus, approach_status(arm.group)) for arm in self.arms
        ]
        self._pipelines = [Latest(bus, pipeline_state(arm.group)) for arm in self.arms]
        self._at: RobotTime | None = None
        self._bare: dict[HandName, Vector3] = dict.fromkeys(PAIR, _NOTHING)
        self.aims: tuple[Pose, Pose] | None = None
        """Where both tools shall be, in the base, left first; None while the arms are not led."""
        self.span: Span | None = None
        """Set while both hands are around something: then ``middle`` and the squeeze lead them."""
        self.middle: Pose | None = None
        self.grasp = Grasp()
        self.wanted = 0.0
        """Newtons of each hand; 0 while nothing is squeezed."""

    @property
    def ready(self) -> bool:
        """Whether joints and both wrists have been heard."""
        return self._joints.value is not None and all(self._wrenches[side].value for side in PAIR)

    @property
    def stopped(self) -> bool:
        """Whether the hardware's stop is set."""
        return self._stop.value is not None and self._stop.value.stopped

    @property
    def leading(self) -> bool:
        """Whether both arms are led."""
        return self.aims is not None

    @property
    def taken(self) -> PipelineState | None:
        """What the pipeline of an arm told last, if a reflex has that arm."""
        told = (pipeline.value for pipeline in self._pipelines)
        return next((state for state in told if state is not None and state.reflex), None)

    def tools(self) -> tuple[Pose, Pose]:
        """Return both tools in the base as the joints tell, left first. Only when ``ready``."""
        left, right = self._robot.poses([arm.frame for arm in self.arms], self._positions())
        return left, right

    def engage(self) -> None:
        """Lead both hands, which stay where they are for now. Only when ``ready``."""
        positions = self._positions()
        for side in PAIR:
            self._wrenches[side].refresh()
        for arm in self.arms:
            arm.begin(positions)
        self.aims, self.span, self.middle = self.tools(), None, None
        self.grasp, self.wanted = Grasp(), 0.0

    def embrace(self) -> None:
        """Take what is between the hands for the thing to be held; what the wrists feel now is none of it.

        Raises:
            HandsApartError: they don't point at each other.
        """
        assert self.aims is not None, "engage first"
        self.span = span(*self.aims)
        self.middle, self.grasp = self.span.middle_in_base, Grasp()
        for side in PAIR:
            told = self._wrenches[side].value
            self._bare[side] = _NOTHING if told is None else told.force

    def disengage(self) -> None:
        """Let go of the arms: they hold where they are."""
        self.aims, self.span, self.middle, self.wanted = None, None, None, 0.0

    @property
    def forces(self) -> tuple[float, float]:
        """Newtons with which the left and the right hand press towards the middle."""
        if self.span is None:
            return 0.0, 0.0
        left = rotate(self.span.left_in_middle.orientation, self._felt("left"))[1]
        right = rotate(self.span.right_in_middle.orientation, self._felt("right"))[1]
        return left, -right

    @property
    def load(self) -> float:
        """Newtons of what the hands carry, as the wrists tell: the vertical part of both."""
        if self.aims is None:
            return 0.0
        left, right = self.aims
        return -(
            rotate(left.orientation, self._felt("left"))[2]
            + rotate(right.orientation, self._felt("right"))[2]
        )

    def _felt(self, side: HandName) -> Vector3:
        told = self._wrenches[side].value
        return _NOTHING if told is None else subtract(told.force, self._bare[side])

    def step(self) -> bool:
        """With each new message of the joints: press, and tell both arms where to be."""
        joints = self._joints.refresh()
        self._stop.refresh()
        for pipeline in self._pipelines:
            pipeline.refresh()
        for told in self._wrenches.values():
            if self.leading or told.value is None:  # else nobody asks what the wrists feel
                told.refresh()
        if self._somebody_else():
            self.disengage()
        if joints is None or joints.stamp == self._at:
            return False
        passed = None if self._at is None else joints.stamp.since(self._at)
        period, self._at = LONGEST if passed is None else min(LONGEST, passed), joints.stamp
        if not self.leading or self.stopped or period <= 0.0:
            return False
        if self.span is not None and self.middle is not None:
            if self.wanted > 0.0:
                self.grasp = self.grasp.pressed(self.forces, self.wanted, period)
            self.aims = self.span.tools(self.middle, self.grasp.inwards)
        self._lead(period)
        return False

    def _somebody_else(self) -> bool:
        """Say whether one of the arms is moved by somebody else, or taken by a reflex."""
        goals = [status.refresh() for status in self._status]
        approaches = [status.refresh() for status in self._approaches]
        moved = any(goal is not None and goal.state is MotionState.ACTIVE for goal in goals)
        approached = any(each is not None and each.active for each in approaches)
        return moved or approached or self.taken is not None

    def _lead(self, period: float) -> None:
        now = self._clocks.robot()
        if self.aims is None or now is None:
            return
        for arm, aim in zip(self.arms, self.aims, strict=True):
            group_setpoint(arm.group).publish(self._bus, arm.towards(aim, period, now))

    def strayed(self) -> tuple[float, HandName]:
        """Return by how many radians an arm is off what it was told, and which arm it is: the worse one."""
        positions = self._positions()
        return max((arm.strayed(positions), arm.side) for arm in self.arms)

    def held_middle(self) -> Pose | None:
        """Return where the hands' middle is as the joints tell, in the base."""
        if self.span is None:
            return None
        left, right = self.tools()
        return self.span.middle(left, right)

    def close(self) -> None:
        """End the subscriptions."""
        self._joints.close()
        self._stop.close()
        for side in PAIR:
            self._wrenches[side].close()
        for status, approaching in zip(self._status, self._approaches, strict=True):
            status.close()
            approaching.close()
        for pipeline in self._pipelines:
            pipeline.close()

    def _positions(self) -> Mapping[str, float]:
        joints: JointStates | None = self._joints.value
        assert joints is not None, "wait until ready"
        return dict(zip(joints.names, joints.positions, strict=True))
