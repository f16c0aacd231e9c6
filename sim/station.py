"""The whole stand-in for a robot in a room: physics, robot, world, sensors and the sim's own controls.

One node. It is the only place that knows all parts of the sim; everything else knows its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.sim.body import RobotBody
from tandem.sim.camera import HeadCamera, Studio
from tandem.sim.controls import Controls
from tandem.sim.defects import check_faults
from tandem.sim.faulty_link import FaultyLink
from tandem.sim.hardware import Hardware, Sensor
from tandem.sim.laser import Laser
from tandem.sim.model import RobotModel
from tandem.sim.parts import LaserSensorNode
from tandem.sim.physics import Physics
from tandem.sim.render import InlineRenderer, PainterSettings, Renderer, WorkerRenderer
from tandem.sim.robots import registry
from tandem.sim.room import Room
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.scene import build_scene
from tandem.sim.trouble import Trouble
from tandem.sim.truth import Truth, read_truth
from tandem.sim.world import World, spawn
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import Source


@dataclass(frozen=True)
class StationSettings:
    """How the stand-in runs.

    ``boot`` names this start of the hardware; ``beside`` draws pictures in a process of their own;
    ``waits`` has the hardware wait for its followers; ``gui`` shows pybullet's window.
    """

    boot: str
    seed: int
    beside: bool = False
    waits: bool = False
    gui: bool = False


class Station:
    """A ``Node``: one step is one period of the hardware.

    Args:
        bus: the hardware's keys, and the sim's own.
        site: the furniture.
        scenario: where things truly are.
        settings: how it runs.

    Raises:
        ScenarioError: when the scenario does not fit the site.
    """

    name = "hardware"

    def __init__(self, bus: Bus, site: Site, scenario: Scenario, settings: StationSettings) -> None:
        self._site, self._settings = site, settings
        self._sites = {site.name, scenario.site}  # what the site may be called: a file's path with it
        self._link = FaultyLink(bus)
        self._boots = 0
        self.physics = Physics(gui=settings.gui)
        self._robot = scenario.robot
        self._check(scenario)
        self.model: RobotModel = registry.robot_model(scenario.robot)
        self.scenario = scenario
        self.world, self.body = self._fill(scenario)
        painter = PainterSettings(urdf=self.model.physics_urdf)
        renderer: Renderer = WorkerRenderer(painter) if settings.beside else InlineRenderer(painter)
        self.studio = Studio(self.world, self.body, renderer, noise=scenario.noise, seed=settings.seed)
        if settings.beside:
            self.studio.warm_up()
        self.hardware = Hardware(
            self._link,
            self.body,
            boot=settings.boot,
            noise=scenario.noise,
            rng=np.random.default_rng((settings.seed, 1)),
            sensors=self._sensors(settings.seed),
            waits=settings.waits,
        )
        self.trouble = Trouble(bus, self._link, self.hardware, self._room(), scenario.faults)
        self.controls = Controls(
            bus, site, self.world, self.body, self.studio, reset=self.reset, fault=self.trouble.ask
        )

    @property
    def cameras(self) -> tuple[HeadCamera, ...]:
        """The robot's cameras, as they are since the last reset."""
        return self._cameras

    @property
    def boot(self) -> str:
        """The name of this start of the hardware; another one after a reset."""
        return self.hardware.now.boot

    @property
    def silent(self) -> bool:
        """Whether a fault keeps the hardware's clock from being heard."""
        return self.trouble.silent

    def step(self) -> bool:
        """Break what is to break, let one period pass, then do what the sim was asked."""
        self.trouble.step()
        self.hardware.step()
        self.controls.step(self.hardware.now)
        return False

    def reset(self, seed: int, scenario: Scenario | None = None) -> None:
        """Begin anew: everything where the scenario has it, under another boot.

        Raises:
            ScenarioError: when the scenario is for another site, or does not fit; then nothing has changed.
        """
        if scenario is not None:
            self._check(scenario)
            self.scenario = scenario
        self._boots += 1
        self.physics.clear()
        self.world, self.body = self._fill(self.scenario)
        self.studio.restart(self.world, self.body, noise=self.scenario.noise, seed=seed)
        self.hardware.restart(
            self.body,
            boot=f"{self._settings.boot}.{self._boots}",
            noise=self.scenario.noise,
            rng=np.random.default_rng((seed, 1)),
            sensors=self._sensors(seed),
        )
        self.trouble.restart(self._room(), self.scenario.faults)
        self.controls.restart(self.world, self.body)

    def truth(self) -> Truth:
        """Return how things truly are: for tests and reports."""
        return read_truth(self.world, self.body, self.hardware.now)

    def close(self) -> None:
        """End the controls, the hardware, the renderer and the physics."""
        self.controls.close()
        self.hardware.close()
        self.studio.close()
        self.physics.close()

    def _check(self, scenario: Scenario) -> None:
        if scenario.site not in self._sites:
            expected = f"expected {self._site.name}, found {scenario.site}"
            raise ScenarioError(f"{scenario.name}: site: {expected}; another site needs another start")
        if scenario.robot != self._robot:
            expected = f"expected {self._robot}, found {scenario.robot}"
            raise ScenarioError(f"{scenario.name}: robot: {expected}; another robot needs another start")
        build_scene(self._site, scenario)
        robot = registry.robot_model(scenario.robot).description
        check_faults(scenario.faults, robot, source=Source(scenario.name))

    def _fill(self, scenario: Scenario) -> tuple[World, RobotBody]:
        world = spawn(self.physics, self._site, scenario)
        world.settle()
        start = scenario.start
        body = RobotBody(
            self.physics, self.model, x=start.x, y=start.y, yaw=start.yaw, positions=self._home()
        )
        return world, body

    def _room(self) -> Room:
        return Room(self._site, self.world, self.body)

    def _home(self) -> dict[str, float]:
        description = self.model.description
        return {
            joint: position
            for posture in description.postures
            if posture.name == "home"
            for joint, position in zip(
                description.group(posture.group).joints, posture.positions, strict=True
            )
        }

    def _sensors(self, seed: int) -> tuple[Sensor, ...]:
        description, noise = self.model.description, self.scenario.noise
        rng = np.random.default_rng((seed, 2))
        lasers = [
            LaserSensorNode(self._link, each, Laser(self.body, each, sigma=noise.laser_sigma, rng=rng).scan)
            for each in description.lasers
        ]
        self._cameras = tuple(
            HeadCamera(self._link, self.studio, self.body, each, rate=self.scenario.camera_rate)
            for each in description.cameras
        )
        return (*lasers, *self._cameras)
