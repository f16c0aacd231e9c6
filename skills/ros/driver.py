"""The hardware's side of a ROS robot: one node that serves the hardware's keys and speaks ROS."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.skills.ports import keys
from tandem.skills.ports.endpoint import Endpoint, answering, endpoint
from tandem.skills.ports.fencing import Grantor
from tandem.skills.ports.hardware import Answer, Clock, Stop, StopRelease, StopState
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ros.inputs import Hearing, inputs_of
from tandem.skills.ros.mapping import missing
from tandem.skills.ros.node import RosNode
from tandem.skills.ros.stamps import periods_in
from tandem.skills.ros.wheels import Wheels

if TYPE_CHECKING:
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.hardware import BaseVelocity
    from tandem.skills.ports.robot_description import RobotDescription
    from tandem.skills.ros.cdr import Codec
    from tandem.skills.ros.link import Link
    from tandem.skills.ros.mapping import RosMap

STOP_EVERY: Final = 1.0
"""Robot seconds between two messages of the stop's state when nothing changes."""
TOPICS_WITHIN: Final = 5.0
"""Robot seconds after the start at which topics that nobody publishes are named in the log."""
UNMOVED: Final = Answer(accepted=False, reason="the role ros moves no joints; it drives the base only")
log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Times:
    """The host's clocks."""

    monotonic: Callable[[], float]
    utc: Callable[[], float]


class RosHardware:
    """A ``Node``: a robot out of ROS topics. Its clock is the host's, from its start.

    Args:
        bus: the hardware's keys.
        link: ROS's side.
        made: the map, checked.
        robot: its description.
        codec: of the map's release.
        boot: names this start.
        times: the host's clocks.
    """

    name = "hardware"

    def __init__(
        self,
        bus: Bus,
        link: Link,
        made: RosMap,
        robot: RobotDescription,
        codec: Codec,
        *,
        boot: str,
        times: Times,
    ) -> None:
        self._bus, self._map, self._robot, self._boot, self._times = bus, made, robot, boot, times
        self._began = times.monotonic()
        self._tick = 0
        self._stop = StopState(stopped=False)
        self._stop_told = float("-inf")
        bus.ear.know(robot)
        self._node = RosNode(link, bus.ear, made.domain, made.node, codec)
        self._inputs = inputs_of(made, Hearing(bus, self._node, robot))
        self._wheels: Wheels | None = None
        if made.cmd_vel is not None and robot.drive is not None:
            publisher = self._node.publisher(made.cmd_vel.topic, made.cmd_vel.type)
            self._wheels = Wheels(publisher, codec, robot.drive, robot.base_frame, times.utc)
        self._velocity: keys.Latest[BaseVelocity] = keys.Latest(bus, keys.BASE_VELOCITY)
        self._grantor = Grantor(bus, boot, times.monotonic)
        self._served = Endpoints(bus, times.monotonic, (*self._own_endpoints(), *self._refusing()))
        if lacks := missing(made, robot):
            log.warning("the map has no topic for: %s; these stay silent", ", ".join(lacks))
        self._looked = False

    @property
    def now(self) -> RobotTime:
        """The robot's clock."""
        return RobotTime(boot=self._boot, seconds=round(self._passed(), 6))

    @property
    def due(self) -> float:
        """Host seconds until the next tick."""
        return self._began + (self._tick + 1) * self._robot.period - self._times.monotonic()

    def step(self) -> bool:
        """Hear both sides; tell what has come, and the clock when its time has come."""
        self._grantor.step()
        more = self._served.step()
        self._obey()
        now = self.now
        for each in self._inputs:
            each.step(now)
        if self._passed() - self._stop_told >= STOP_EVERY:
            self._tell_stop()
        if not self._looked and self._passed() > TOPICS_WITHIN:
            self._look()
        self._tell_clock()
        return more

    def close(self) -> None:
        """Leave the base standing, and stop serving."""
        if self._wheels is not None:
            self._wheels.close(self._times.monotonic())
        self._velocity.close()
        self._served.close()

    def _passed(self) -> float:
        """Return the seconds since the start."""
        return self._times.monotonic() - self._began

    def _obey(self) -> None:
        at = self._times.monotonic()
        for command in self._velocity.take():
            refusal = self._grantor.refuse(command)
            if refusal is not None:
                self._bus.ear.refuse(keys.BASE_VELOCITY.key, Reason.FENCED, refusal.reason)
            elif not self._stop.stopped and self._wheels is not None:
                self._wheels.command(command, at)
        if self._wheels is not None:
            self._wheels.step(at, stopped=self._stop.stopped)

    def _tell_clock(self) -> None:
        passed = periods_in(self._passed(), self._robot.period)
        if passed > self._tick:  # a host that was busy for a while has lost ticks, not time
            self._tick = passed
            stamp = RobotTime(boot=self._boot, seconds=round(passed * self._robot.period, 6))
            keys.CLOCK.publish(self._bus, Clock(stamp=stamp, tick=passed))

    def _look(self) -> None:
        self._looked = True
        for each in self._map.inputs:
            if why := self._node.lacks(each.topic, each.type):
                log.warning("topic %s (%s): %s", each.topic, each.type, why)

    def _own_endpoints(self) -> tuple[Endpoint, ...]:
        return (
            *self._grantor.endpoints(),
            endpoint(keys.STOP, lambda call: self._on_stop(call.document), unread=_unread),
            answering(keys.STOP_RELEASE, self._on_release),
            answering(keys.DESCRIPTION, lambda _: self._robot),
        )

    def _refusing(self) -> tuple[Endpoint, ...]:
        """Return what a robot with joints serves all the same: each is answered, and none moves."""
        groups = [each.name for each in self._robot.groups]
        goals = [answering(keys.group_goal(name), lambda _: UNMOVED) for name in groups]
        cancels = [answering(keys.group_cancel(name), lambda _: Answer(accepted=True)) for name in groups]
        hands = [answering(keys.gripper_command(side), lambda _: UNMOVED) for side in self._robot.hands]
        return (*goals, *cancels, *hands)

    def _on_stop(self, stop: Stop) -> StopState:
        return self._set_stop(StopState(stopped=True, by=stop.by, reason=stop.reason))

    def _on_release(self, release: StopRelease) -> StopState:
        return self._set_stop(StopState(stopped=False, by=release.by, reason=release.reason))

    def _set_stop(self, state: StopState) -> StopState:
        changed, self._stop = state != self._stop, state
        if state.stopped and self._wheels is not None:
            self._wheels.halt(self._times.monotonic())
        if changed:
            self._tell_stop()
        return state

    def _tell_stop(self) -> None:
        keys.STOP_STATE.publish(self._bus, self._stop)
        self._stop_told = self._passed()


def _unread() -> Stop:
    """Return what an unreadable stop is taken for: better a stop without a name than none."""
    return Stop(by="unknown", reason="a stop that could not be read")
