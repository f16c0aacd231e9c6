"""One robot of the simulated world: its body, its hardware, its faults, the sim's controls on its keys."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.sim.body import RobotBody
from tandem.sim.camera import HeadCamera
from tandem.sim.controls import Controls
from tandem.sim.faulty_link import FaultyLink
from tandem.sim.hardware import Hardware, Sensor
from tandem.sim.laser import Laser
from tandem.sim.parts import LaserSensorNode
from tandem.sim.robots import registry
from tandem.sim.room import Room
from tandem.sim.sensing import others_in, sensor_nodes
from tandem.sim.told_together import ToldTogether
from tandem.sim.trouble import Trouble
from tandem.sim.wanderer import Wanderer

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from tandem.sim.camera import Studio
    from tandem.sim.controls import Resetter
    from tandem.sim.faults import Fault
    from tandem.sim.model import RobotModel
    from tandem.sim.physics import Physics
    from tandem.sim.scenario import Scenario
    from tandem.sim.starts import RobotStart
    from tandem.sim.world import World
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.hardware import Answer
    from tandem.skills.ports.site import Site


DEEP: Final = 0.0005
"""Metres by which links may be in each other when the robot enters: nobody sees so little pushed apart."""


def enter(physics: Physics, world: World, start: RobotStart, number: int) -> RobotBody:
    """Put a robot into the world, in its posture ``home``; ``number`` counts the robots from 0."""
    model, at = registry.robot_model(start.robot), start.start
    body = RobotBody(
        physics,
        model,
        x=at.x,
        y=at.y,
        yaw=at.yaw,
        positions=_home(model),
        name=start.name,
        number=number,
    )
    for depth, first, second in body.overlaps():
        if depth > DEEP:
            raise registry.RobotError(
                f"robot {start.robot!r}: {first!r} and {second!r} are {depth:.3f} m in each other at home,"
                " and the physics would push them apart. If they always touch, name them in touching_links;"
                " else expected another posture 'home'"
            )
    world.admit(body)
    return body


@dataclass(frozen=True)
class Setting:
    """What a robot is in since the last reset.

    ``boot`` names this start of all hardware in the world, which has one clock.
    """

    scenario: Scenario
    world: World
    body: RobotBody
    boot: str
    seed: int


class StationedRobot:
    """The station steps its parts: those of all robots act, the physics passes, and all tell.

    Args:
        bus: the robot's keys.
        start: what the scenario says of it.
        number: counts the robots from 0.
        site: sizes of items, heights of furniture.
        studio: draws its pictures.
        setting: what it begins in.
        waits: say in the clock that the hardware waits for its followers.
        resting_period: seconds between two messages of clock and states while the robot rests.
        reset: begins the whole sim anew.
        fault: has a fault happen to this robot, or to the one that it names.
    """

    def __init__(
        self,
        bus: Bus,
        start: RobotStart,
        number: int,
        *,
        site: Site,
        studio: Studio,
        setting: Setting,
        waits: bool,
        resting_period: float | None,
        reset: Resetter,
        fault: Callable[[Fault], Answer],
    ) -> None:
        self.name, self.drives = start.name, start.drives
        self._number, self._site, self._studio = number, site, studio
        self._link = FaultyLink(bus)
        self._told = ToldTogether(self._link)
        self.body, self._seed = setting.body, setting.seed
        self.model: RobotModel = self.body.model
        noise = setting.scenario.noise
        self.hardware = Hardware(
            self._told,
            self.body,
            boot=setting.boot,
            noise=noise,
            rng=self._rng(1),
            sensors=self._sensors(setting.scenario, setting.world),
            waits=waits,
            resting_period=resting_period,
        )
        room = Room(site, setting.world, self.body)
        self.trouble = Trouble(bus, self._link, self.hardware, room, self._faults(setting.scenario))
        self.controls = Controls(bus, site, setting.world, self.body, studio, reset=reset, fault=fault)
        self._driver = self._wanderer(setting.world)

    @property
    def silent(self) -> bool:
        """Whether a fault keeps the hardware's clock from being heard."""
        return self.trouble.silent

    def drive(self) -> None:
        """Have the script that drives it, if one does, command the wheels."""
        if self._driver is not None:
            self._driver.step()

    def restart(self, setting: Setting) -> None:
        """Begin anew, with another body in another world."""
        self.body, self._seed = setting.body, setting.seed
        self.hardware.restart(
            self.body,
            boot=setting.boot,
            noise=setting.scenario.noise,
            rng=self._rng(1),
            sensors=self._sensors(setting.scenario, setting.world),
        )
        self.trouble.restart(Room(self._site, setting.world, self.body), self._faults(setting.scenario))
        self.controls.restart(setting.world, self.body)
        self._driver = self._wanderer(setting.world)

    def close(self) -> None:
        """End the controls and the hardware."""
        self.controls.close()
        self.hardware.close()

    def _wanderer(self, world: World) -> Wanderer | None:
        if self.drives != "wander":
            return None
        return Wanderer(self.body, self.hardware.base, world, self._rng(3))

    def _faults(self, scenario: Scenario) -> tuple[Fault, ...]:
        """Return the scenario's faults that this robot is meant by."""
        first = scenario.first.name
        return tuple(each for each in scenario.faults if (each.robot or first) == self.name)

    def _sensors(self, scenario: Scenario, world: World) -> tuple[Sensor, ...]:
        self.cameras: tuple[HeadCamera, ...] = ()
        if self.drives != "executive":
            return ()  # nobody hears them
        description, noise, rng = self.model.description, scenario.noise, self._rng(2)
        lasers = [
            LaserSensorNode(self._told, each, Laser(self.body, each, sigma=noise.laser_sigma, rng=rng).scan)
            for each in description.lasers
        ]
        self.cameras = tuple(
            HeadCamera(self._told, self._studio, self.body, each, rate=scenario.camera_rate)
            for each in description.cameras
        )
        others = sensor_nodes(
            self._told,
            self.body,
            noise=noise,
            ranging=self._rng(4),
            posing=self._rng(5),
            falling=self._rng(6),
            others=lambda: others_in(world, self.body),
        )
        return (*lasers, *others, *self.cameras)

    def _rng(self, purpose: int) -> np.random.Generator:
        """Return the source of chance for a purpose; each robot has its own."""
        mine: Sequence[int] = (self._number,) if self._number else ()
        return np.random.default_rng((self._seed, purpose, *mine))


def _home(model: RobotModel) -> dict[str, float]:
    description = model.description
    return {
        joint: position
        for posture in description.postures
        if posture.name == "home"
        for joint, position in zip(description.group(posture.group).joints, posture.positions, strict=True)
    }
