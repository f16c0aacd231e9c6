"""The coordination as a node: what is seen goes in, the right of way goes out, at the joints' rate."""

from __future__ import annotations

import math
from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.bimanual.announced import CREEP, NEXT, Announced
from tandem.skills.bimanual.coordination import FIELD_ROOM, Coordination, Mode, Situation, Stage
from tandem.skills.bimanual.observer import ArmObserver
from tandem.skills.bimanual.uncoordinated_stop import UncoordinatedStop
from tandem.skills.bimanual.way import MARGIN, clear
from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.described import by_name, carried
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.bimanual import CROSSING, PAIR, RIGHT_OF_WAY, Order, RightOfWay
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import CancelMotion, JointStates
from tandem.skills.ports.keys import JOINT_STATES, Latest, group_cancel
from tandem.skills.ports.message import HandName, RobotTime, RobotTimer
from tandem.skills.ports.robot_description import ArmsCrossing, RobotDescription
from tandem.skills.ports.world import SCENE

PERIOD: Final = 0.05
"""Robot seconds between two messages without a change, while the arms are told what to do."""
CLOSED_PERIOD: Final = 0.5
"""The same while they are left to themselves: nobody asks how old that is."""
REACTION: Final = 0.03
"""Robot seconds from a message of the joints to an arm's braking: three periods."""

ALLOWANCE: Final = 0.01
"""Metres more than the follower may keep, that the next part of its way must leave before it goes on."""


@dataclass(frozen=True)
class Leads:
    """The leader's way, as joint positions (n,), and the bodies as they were when it was looked at."""

    bodies: ArmsClearance
    way: list[Array]


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
        self._arms: dict[HandName, ArmObserver] = {
            side: ArmObserver(bus, description, how, side) for side in PAIR
        }
        self._uncoordinated, self.coordination, self._phi = UncoordinatedStop(), Coordination(), how.phi
        self.coordinating = False
        """Whether somebody has asked for it."""
        self.seen: Situation | None = None
        self._looked_at: RobotTime | None = None
        self._timer = RobotTimer()
        self._told: RightOfWay | None = None
        self._sweep: Generator[None, None, bool] | None = None
        self._clear: bool | None = None
        """The last sweep's verdict; None before there is one."""
        self._swept_in = Stage.CLEAR
        self._ways = Announced(description, hulls, self._arms)
        self._leads: Leads | None = None

    @property
    def _eager(self) -> bool:
        return self.coordinating and self.coordination.mode == "eager"

    def begin(self, mode: Mode, phi: float | None = None) -> None:
        """Coordinate from now on; episodes count on.

        Args:
            mode: see the state machine. Eager, it is the true clearance alone that stops the arms.
            phi: robot seconds by which the follower goes back at each risk; those of a sample unless given.
        """
        episode = max(self._uncoordinated.episode, self.coordination.episode)
        stride = 1 if phi is None else max(1, round(phi / self._phi))
        self.coordination = Coordination(mode=mode, episode=episode, stride=stride)
        self.coordinating = True

    def end(self) -> None:
        """Leave both arms to themselves."""
        episode = max(self._uncoordinated.episode, self.coordination.episode)
        self._uncoordinated, self.coordinating = UncoordinatedStop(episode=episode), False

    def step(self) -> bool:
        """With each new message of the joints: see, rule, tell."""
        joints, crossing = self._joints.refresh(), self._crossing.refresh()
        if joints is None or crossing is None or joints.stamp == self._looked_at:
            return False
        self._looked_at = joints.stamp
        left, right = (self._arms[side].look(joints) for side in PAIR)
        self._look_ahead(joints)
        self.seen = Situation(
            now=self._timer.read(joints.stamp),
            risk=crossing.near if self._eager else crossing.risk,
            clearance=crossing.clearance,
            left=left,
            right=right,
            way_is_clear=self._clear is True,
            ways_cross=self.coordination.stage is Stage.CLEAR and self._clear is False,
            room=self._room(self.coordination),
        )
        if self.coordinating:
            self.coordination = self.coordination.after(self.seen)
        else:
            was, self._uncoordinated = self._uncoordinated, self._uncoordinated.after(self.seen)
            if self._uncoordinated.stopping and not was.stopping:
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
        state = self.coordination if self.coordinating else self._uncoordinated
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
        passed = None if told is None else message.stamp.since(told.stamp)
        period = PERIOD if message.open else CLOSED_PERIOD
        if not same or passed is None or passed >= period - 1e-6:
            RIGHT_OF_WAY.publish(self._bus, message)
            self._told = message

    def _look_ahead(self, joints: JointStates) -> None:
        """Go on with the sweep that runs; its verdict holds until the next one's, or the stage is another."""
        state = self.coordination
        if self._swept_in is not state.stage:
            self._sweep, self._clear, self._swept_in = None, None, state.stage
        if not self._eager or not self._worth_looking(state):
            self._sweep, self._clear, self._leads = None, None, None
            return
        if (
            state.open and self._arms[state.leader].waits
        ):  # perhaps for the other one: the reflex sees to both
            self._sweep, self._clear, self._leads = None, True, None
            return
        if self._sweep is None:
            self._sweep = self._new_sweep(joints, state)
        try:
            next(self._sweep)
        except StopIteration as stop:
            self._sweep, self._clear = None, stop.value

    def _worth_looking(self, state: Coordination) -> bool:
        """Say whether there are two ways, and somebody whom they would make wait or go on."""
        left, right = (self._arms[side] for side in PAIR)
        if state.stage is Stage.CLEAR:
            told = [arm.goal_at is not None for arm in (left, right) if arm.approaching]
            return bool(told) and all(told) and not any(arm.back_home for arm in (left, right))
        if state.stage is Stage.BACKING:
            return self._arms[state.leader].approaching
        return state.stage in {Stage.LEADING, Stage.SHARING}

    def _new_sweep(self, joints: JointStates, state: Coordination) -> Generator[None, None, bool]:
        """Look whether the one that asks could go on beside the other: see ``Situation``."""
        scene = self._scene.refresh()
        positions = by_name(joints.names, joints.positions)
        held = () if scene is None else carried(scene, self._description)
        bodies = ArmsClearance(self._hulls, self._description, positions, held)
        full = set() if scene is None else {each.attached_to for each in scene.objects}
        yield
        leader, follower = state.leader, state.follower
        leads = self._ways.whole(joints, leader, holds=leader in full)
        yield
        if state.stage is Stage.CLEAR:
            follows = self._ways.whole(joints, follower, holds=follower in full)
        elif state.stage is Stage.BACKING:  # one that goes back gets no nearer to the leader's way than it is
            follows = [self._arms[follower].q]
        else:
            self._leads = Leads(bodies, leads)
            count = NEXT if self._arms[leader].approaching else CREEP
            follows = self._ways.next(joints, follower, count)
        yield
        ways = {leader: leads, follower: follows}
        margin = FIELD_ROOM + ALLOWANCE if self._arms[leader].approaching else MARGIN
        return (yield from clear(bodies, ways["left"], ways["right"], margin))

    def _room(self, state: Coordination) -> float:
        """Return the metres between the leader's way and where the follower would stop."""
        if self._leads is None or state.stage is not Stage.SHARING:
            return math.inf
        bodies, way = self._leads.bodies, self._leads.way
        speeds = np.concatenate([self._arms[side].speeds for side in PAIR])
        rest = bodies.to_rest(speeds, REACTION)
        half = len(self._arms["left"].q)
        follower = self._arms[state.follower].q + (rest[:half] if state.follower == "left" else rest[half:])
        pairs = [(each, follower) if state.leader == "left" else (follower, each) for each in way]
        return min(bodies.at(np.concatenate(pair)).distance for pair in pairs)
