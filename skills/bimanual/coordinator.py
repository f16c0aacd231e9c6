"""The coordination as a node: what is seen goes in, the right of way goes out, at the joints' rate."""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

from skills.bimanual.alone import Alone
from skills.bimanual.coordination import Coordination, Mode, Situation, Stage
from skills.bimanual.observer import ArmObserver
from skills.bimanual.way import clear, joined, straight, thinned
from skills.kinematics.clearance import ArmsClearance
from skills.kinematics.described import by_name, carried
from skills.kinematics.follow import PoseFollower
from skills.kinematics.hulls import RobotHulls
from skills.kinematics.transforms import Array
from skills.ports.actions.approach import GOAL_RADIUS
from skills.ports.actions.bimanual import CROSSING, RIGHT_OF_WAY, Order, RightOfWay
from skills.ports.bus import Bus
from skills.ports.hardware import ArmsCrossing, CancelMotion, JointStates, RobotDescription
from skills.ports.keys import JOINT_STATES, Latest, group_cancel
from skills.ports.world import SCENE, SIDES, Side

PERIOD: Final = 0.05
"""Robot seconds between two messages without a change."""


class Coordinator:
    """Tells ``skill/bimanual/right_of_way``; a ``Node``.

    Args:
        bus: the reflex, the arms.
        description: the robot.
        how: its parameters of giving way.
        hulls: its bodies, for the eager mode.
    """

    name = "bimanual/coordination"

    def __init__(self, bus: Bus, description: RobotDescription, how: ArmsCrossing, hulls: RobotHulls) -> None:
        self._bus, self._description, self._hulls = bus, description, hulls
        self._joints, self._scene = Latest(bus, JOINT_STATES), Latest(bus, SCENE, depth=4)
        self._crossing = Latest(bus, CROSSING)
        self._arms: dict[Side, ArmObserver] = {
            side: ArmObserver(bus, description, how, side) for side in SIDES
        }
        self._alone, self.coordination, self._phi = Alone(), Coordination(), how.phi
        self.coordinating = False
        """Whether somebody has asked for it."""
        self.seen: Situation | None = None
        self._looked_at: float | None = None
        self._told: RightOfWay | None = None
        self._sweep: Generator[None, None, bool] | None = None
        self._clear, self._swept_in = False, Stage.CLEAR

    @property
    def _eager(self) -> bool:
        return self.coordinating and self.coordination.mode == "eager"

    def begin(self, mode: Mode, phi: float | None = None) -> None:
        """Coordinate from now on; episodes count on.

        Args:
            mode: see the state machine. Eager, it is the true clearance alone that stops the arms.
            phi: robot seconds by which the follower goes back at each risk; those of a sample unless given.
        """
        episode = max(self._alone.episode, self.coordination.episode)
        stride = 1 if phi is None else max(1, round(phi / self._phi))
        self.coordination = Coordination(mode=mode, episode=episode, stride=stride)
        self.coordinating = True

    def end(self) -> None:
        """Leave both arms to themselves."""
        episode = max(self._alone.episode, self.coordination.episode)
        self._alone, self.coordinating = Alone(episode=episode), False

    def step(self) -> bool:
        """With each new message of the joints: see, rule, tell."""
        joints, crossing = self._joints.refresh(), self._crossing.refresh()
        if joints is None or crossing is None or joints.stamp.seconds == self._looked_at:
            return False
        self._looked_at = joints.stamp.seconds
        left, right = (self._arms[side].look(joints) for side in SIDES)
        self.seen = Situation(
            now=joints.stamp.seconds,
            risk=crossing.near if self._eager else crossing.risk,
            clearance=crossing.clearance,
            left=left,
            right=right,
            way_is_clear=self._way_is_clear(joints),
        )
        if self.coordinating:
            self.coordination = self.coordination.after(self.seen)
        else:
            was, self._alone = self._alone, self._alone.after(self.seen)
            if self._alone.stopping and not was.stopping:
                self._brake()
        self._tell(joints)
        return False

    def close(self) -> None:
        """End the subscriptions."""
        self._joints.close()
        self._scene.close()
        self._crossing.close()
        for arm in self._arms.values():
            arm.close()

    def _brake(self) -> None:
        """Have the hardware stop both arms at once; their skills hear of it by the order."""
        for arm in self._arms.values():
            group_cancel(arm.group).query(self._bus, CancelMotion())

    def _tell(self, joints: JointStates) -> None:
        state = self.coordination if self.coordinating else self._alone
        orders = state.orders
        going = all(order.order is Order.GO for order in orders)
        message = RightOfWay(
            stamp=joints.stamp,
            episode=state.episode,
            open=self.coordination.open if self.coordinating else not going,
            leader=self.coordination.leader if self.coordinating and self.coordination.open else None,
            orders=orders,
        )
        told = self._told
        same = told is not None and told.model_copy(update={"stamp": message.stamp}) == message
        if told is None or not same or message.stamp.seconds - told.stamp.seconds >= PERIOD - 1e-6:
            RIGHT_OF_WAY.publish(self._bus, message)
            self._told = message

    def _way_is_clear(self, joints: JointStates) -> bool:
        """Return the last sweep's verdict, and go on with the one that runs."""
        state = self.coordination
        if self._swept_in is not state.stage:
            self._sweep, self._clear, self._swept_in = None, False, state.stage
        if not self._eager or not self._waits_for_a_way(state):
            self._sweep, self._clear = None, False
            return False
        if self._sweep is None:
            self._sweep = self._new_sweep(joints, state)
        try:
            next(self._sweep)
        except StopIteration as stop:
            self._sweep, self._clear = None, stop.value
        return self._clear

    def _waits_for_a_way(self, state: Coordination) -> bool:
        """Say whether one of the arms waits, and has told which way it would go."""
        leads = self._arms[state.leader].approach
        told = leads is not None and leads.active
        return state.stage is Stage.LEADING or (state.stage is Stage.BACKING and told)

    def _new_sweep(self, joints: JointStates, state: Coordination) -> Generator[None, None, bool]:
        scene = self._scene.refresh()
        positions = by_name(joints.names, joints.positions)
        held = () if scene is None else carried(scene, self._description)
        bodies = ArmsClearance(self._hulls, self._description, positions, held)
        yield
        follower = self._arms[state.follower]
        # One that goes back gets no nearer to the leader's way than it is.
        stays = [follower.q] if state.stage is Stage.BACKING else self._remaining(joints, state.follower)
        ways = {state.leader: self._announced(joints, state.leader), state.follower: stays}
        yield
        return (yield from clear(bodies, ways["left"], ways["right"]))

    def _announced(self, joints: JointStates, side: Side) -> list[Array]:
        arm, told = self._arms[side], self._arms[side].approach
        if told is not None and told.active and told.goal_in_base is not None:
            way = straight(self._follower(joints, side), arm.q, told.goal_in_base, GOAL_RADIUS)
            return [arm.q, *way[1::2], *way[-1:]]
        return [arm.q, *joined(arm.q, arm.safe_at)]

    def _remaining(self, joints: JointStates, side: Side) -> list[Array]:
        arm, told = self._arms[side], self._arms[side].approach
        recorded = thinned(arm.ahead())
        way = [arm.q, *recorded]
        if told is not None and told.goal_in_base is not None:
            way += straight(self._follower(joints, side), way[-1], told.goal_in_base, GOAL_RADIUS)
        return way

    def _follower(self, joints: JointStates, side: Side) -> PoseFollower:
        arm = self._arms[side]
        return PoseFollower(
            self._hulls.robot,
            arm.joints,
            by_name(joints.names, joints.positions),
            frame=self._description.end_effector(side).frame,
            limits=self._hulls.robot.limits(arm.joints),
        )
