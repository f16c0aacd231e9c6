"""The hardware node: one period of physics and control a step, and all of the hardware's messages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Protocol

from tandem.sim.diverging import require_sound
from tandem.sim.parts import BasePart, Gate, GroupPart, HandPart, Part
from tandem.sim.rest import Rest
from tandem.skills.ports import keys
from tandem.skills.ports.endpoint import Endpoint, answering, endpoint
from tandem.skills.ports.fencing import Grantor
from tandem.skills.ports.hardware import Clock, JointStates, Stop, StopRelease, StopState
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.serving import Endpoints

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from tandem.sim.body import RobotBody
    from tandem.sim.scenario import Noise
    from tandem.skills.ports.bus import Bus

STOP_EVERY: Final = 100
"""Periods between two messages of the stop's state when nothing changes."""


class Sensor(Protocol):
    """A camera, a laser, ...: publishes by itself when its time has come."""

    @property
    def rests(self) -> bool:
        """Whether it measures only when states are told, while the robot rests."""
        ...

    def step(self, now: RobotTime) -> None:
        """Do what is due; called once a period, after the physics."""
        ...


class Hardware:
    """A robot's hardware over a physics world. Each ``step`` is one period of ``description.period`` seconds.

    In lockstep the runner steps it once a period; in a process the runner paces it. The order within a step
    is: hear, control, physics, tell; the clock is told last, so that what belongs to a tick has come before.

    Args:
        bus: the hardware's keys.
        body: the robot, in its physics.
        boot: names this start of the hardware.
        noise: the sensors' errors.
        rng: source of the odometry's errors.
        sensors: what else publishes; each is stepped once a period.
        waits: say in the clock that the hardware waits for its followers.
        resting_period: seconds between two messages of clock and states while the robot rests.
    """

    name = "hardware"

    def __init__(
        self,
        bus: Bus,
        body: RobotBody,
        *,
        boot: str,
        noise: Noise,
        rng: np.random.Generator,
        sensors: Sequence[Sensor] = (),
        waits: bool = False,
        resting_period: float | None = None,
    ) -> None:
        self._bus = bus
        self._waits = waits
        self._resting_period = resting_period
        self._steps = 0  # counted on over a restart: the host's time, as far as rates are concerned
        self.grantor = Grantor(bus, boot)
        self._own = self._serve(
            *self.grantor.endpoints(),
            endpoint(keys.STOP, lambda call: self._on_stop(call.document), unread=_unread),
            answering(keys.STOP_RELEASE, self._on_release),
            answering(keys.DESCRIPTION, lambda _: self._description),
        )
        self._parts_served = self._serve()
        self.stop_state = StopState(stopped=False)
        self._parts: list[Part] = []
        self.restart(body, boot=boot, noise=noise, rng=rng, sensors=sensors)

    def restart(
        self,
        body: RobotBody,
        *,
        boot: str,
        noise: Noise,
        rng: np.random.Generator,
        sensors: Sequence[Sensor] = (),
    ) -> None:
        """Begin anew with another body: the clock at zero, under another boot id, no stop set."""
        for part in self._parts:
            part.close()
        self._parts_served.close()
        description = body.model.description.model_copy(update={"resting_period": self._resting_period})
        self._body = body
        self._boot = boot
        self.grantor.restart(boot)
        self._tick = 0
        self._period = description.period
        self.physics_steps = round(description.period / body.physics.time_step)
        self.description = description
        self._rest = Rest(description.period, description.resting_period)
        self._description = description.model_dump_json().encode()
        self._bus.ear.know(description)
        self._sensors = tuple(sensors)
        gate = Gate(stopped=lambda: self.stop_state.stopped, refuse=self.grantor.refuse)
        wheels = body.model.wheels
        self.bases = tuple(
            BasePart(self._bus, body, each, gate, noise=noise, rng=rng)
            for each in (() if wheels is None else (wheels,))
        )
        self.groups = {group.name: GroupPart(self._bus, body, group, gate) for group in description.groups}
        self.hands = {
            hand.side: HandPart(self._bus, body, hand, description.end_effector(hand.side), gate)
            for hand in body.model.hands
        }
        self._parts = [*self.groups.values(), *self.hands.values(), *self.bases]
        taking: tuple[GroupPart | HandPart, ...] = (*self.groups.values(), *self.hands.values())
        self._parts_served = self._serve(*(each for part in taking for each in part.endpoints()))
        self._joints = tuple(
            [joint for group in description.groups for joint in group.joints]
            + [joint for effector in description.end_effectors for joint in effector.gripper.joints]
        )
        self.set_stop(StopState(stopped=False))

    @property
    def now(self) -> RobotTime:
        """The hardware's clock."""
        return RobotTime(boot=self._boot, seconds=round(self._tick * self._period, 6))

    @property
    def tick(self) -> int:
        """Periods since the boot."""
        return self._tick

    @property
    def sensors(self) -> Sequence[Sensor]:
        """What publishes by itself: cameras, lasers, sonars, ..."""
        return self._sensors

    @property
    def base(self) -> BasePart:
        """The base that drives; LookupError when it is fixed."""
        if not self.bases:
            raise LookupError(f"{self.description.name} has a fixed base")
        return self.bases[0]

    def step(self) -> bool:
        """Hear what was asked, control and simulate one period, and tell what happened.

        For a robot alone in its physics. Where several share one, all ``act``, the physics passes a
        ``period`` once, and all ``tell``.
        """
        self.act()
        self._body.physics.step(self.physics_steps)
        self.tell()
        return False

    def act(self) -> None:
        """Hear what was asked, and set the motors for the coming period."""
        self._steps += 1
        self._hear()
        for part in self._parts:
            part.act(self._period)

    def tell(self) -> None:
        """Count the period that the physics has passed, and tell what happened in it."""
        self._tick += 1
        self._tell()

    def hear(self) -> None:
        """Answer what was asked without letting time pass: for a runner that waits."""
        self._hear()

    def _hear(self) -> None:
        self.grantor.step()
        self._own.step()
        self._parts_served.step()
        for part in self._parts:
            part.listen()

    def _on_stop(self, stop: Stop) -> StopState:
        self.set_stop(StopState(stopped=True, by=stop.by, reason=stop.reason))
        return self.stop_state

    def _on_release(self, release: StopRelease) -> StopState:
        self.set_stop(StopState(stopped=False, by=release.by, reason=release.reason))
        return self.stop_state

    def _serve(self, *served: Endpoint) -> Endpoints:
        return Endpoints(self._bus, lambda: self._steps * self._period, served)

    def set_stop(self, state: StopState) -> None:
        """Set the stop, so that all comes to rest and stays there, or release it; tell when it changed."""
        changed = state != self.stop_state
        self.stop_state = state
        if state.stopped:
            for part in self._parts:
                part.halt()
        if changed:
            keys.STOP_STATE.publish(self._bus, state)

    def _tell(self) -> None:
        now = self.now
        streams = self._rest.tells(self._tick, moving=not all(part.rests for part in self._parts))
        if streams:
            readings = self._body.read(self._joints)
            require_sound(self._body, self._joints, readings)
            states = JointStates(
                stamp=now,
                names=self._joints,
                positions=tuple(reading.position for reading in readings),
                velocities=tuple(reading.velocity for reading in readings),
                efforts=tuple(reading.effort for reading in readings),
            )
            keys.JOINT_STATES.publish(self._bus, states)
        for part in self._parts:
            part.tell(now, self._tick, streams=streams)
        for sensor in self._sensors:
            if streams or not sensor.rests:
                sensor.step(now)
        if self._tick % STOP_EVERY == 0:
            keys.STOP_STATE.publish(self._bus, self.stop_state)
        if streams:
            keys.CLOCK.publish(self._bus, Clock(stamp=now, tick=self._tick, waits=self._waits))

    def close(self) -> None:
        """Bring the robot to rest, as far as one period goes, and stop serving. Closing twice is allowed."""
        for part in self._parts:
            part.halt()
            part.close()
        self._parts = []
        self._own.close()
        self._parts_served.close()


def _unread() -> Stop:
    """Return what an unreadable stop is taken for: better a stop without a name than none."""
    return Stop(by="unknown", reason="a stop that could not be read")
