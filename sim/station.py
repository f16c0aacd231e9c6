"""The whole stand-in for robots in a room: physics, robots, world, sensors and the sim's own controls.

One node. It is the only place that knows all parts of the sim; everything else knows its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

from tandem.sim.body import RobotBody
from tandem.sim.camera import HeadCamera, Studio
from tandem.sim.controls import Controls
from tandem.sim.crowd import Crowd
from tandem.sim.defects import check_faults
from tandem.sim.faults import Fault
from tandem.sim.hardware import Hardware
from tandem.sim.model import RobotModel
from tandem.sim.physics import Physics
from tandem.sim.render import InlineRenderer, PainterSettings, Renderer, WorkerRenderer
from tandem.sim.robots import registry
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.scene import build_scene
from tandem.sim.stationed import Setting, StationedRobot, enter
from tandem.sim.trouble import Trouble
from tandem.sim.truth import Truth, read_truth
from tandem.sim.world import World, spawn
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import Answer
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import Source
from tandem.skills.wire.memory import MemoryBus


@dataclass(frozen=True)
class StationSettings:
    """How the stand-in runs.

    ``boot`` names this start of the hardware; ``beside`` draws pictures in a process of their own;
    ``waits`` has the hardware wait for its followers; ``gui`` shows pybullet's window. With a
    ``resting_period`` (seconds) a robot that rests tells its clock and states no more often than that.
    """

    boot: str
    seed: int
    beside: bool = False
    waits: bool = False
    resting_period: float | None = None
    gui: bool = False


class Station:
    """A ``Node``: one step is one period of the hardware of all robots, which have one clock.

    ``body``, ``model``, ``hardware``, ``trouble`` and ``controls`` are those of the first robot.

    Args:
        buses: the hardware's keys, and the sim's own: a bus for the only robot, or one for each by its name.
            A robot that a script drives needs none.
        site: the furniture.
        scenario: where things truly are.
        settings: how it runs.

    Raises:
        ScenarioError: when the scenario does not fit the site.
    """

    name = "hardware"

    def __init__(
        self, buses: Bus | Mapping[str, Bus], site: Site, scenario: Scenario, settings: StationSettings
    ) -> None:
        self._site, self._settings = site, settings
        self._sites = {site.name, scenario.site}  # what the site may be called: a file's path with it
        self._boots = 0
        self.physics = Physics(gui=settings.gui)
        self._cast = _cast_of(scenario)
        self._check(scenario)
        self.scenario = scenario
        models = (registry.robot_model(each.robot) for each in scenario.placed)
        painter = PainterSettings(urdfs=tuple(model.physics_urdf for model in models))
        # First of all: a renderer beside loads its own world while this process makes the one that moves.
        renderer: Renderer = WorkerRenderer(painter) if settings.beside else InlineRenderer(painter)
        try:
            self.world, bodies = self._fill(scenario)
        except BaseException:
            renderer.close()
            raise
        self.crowd = self._people(scenario, settings.seed)
        self.studio = Studio(self.world, bodies, renderer, noise=scenario.noise, seed=settings.seed)
        if settings.beside:
            self.studio.warm_up()
        self.robots: dict[str, StationedRobot] = {}
        for number, (start, body) in enumerate(zip(scenario.placed, bodies, strict=True)):
            self.robots[start.name] = StationedRobot(
                _bus_of(start.name, buses),
                start,
                number,
                site=site,
                studio=self.studio,
                setting=Setting(scenario, self.world, body, settings.boot, settings.seed),
                waits=settings.waits,
                resting_period=settings.resting_period,
                reset=self.reset,
                fault=partial(self._fault, start.name),
            )
        self._first = self.robots[scenario.first.name]

    @property
    def body(self) -> RobotBody:
        """As it is since the last reset."""
        return self._first.body

    @property
    def model(self) -> RobotModel:
        """What the first robot is."""
        return self._first.model

    @property
    def hardware(self) -> Hardware:
        """Of the first robot."""
        return self._first.hardware

    @property
    def trouble(self) -> Trouble:
        """Of the first robot."""
        return self._first.trouble

    @property
    def controls(self) -> Controls:
        """On the first robot's keys."""
        return self._first.controls

    @property
    def cameras(self) -> tuple[HeadCamera, ...]:
        """The robots' cameras, as they are since the last reset."""
        return tuple(camera for robot in self.robots.values() for camera in robot.cameras)

    @property
    def boot(self) -> str:
        """The name of this start of the hardware; another one after a reset."""
        return self.hardware.now.boot

    @property
    def silent(self) -> bool:
        """Whether a fault keeps a clock of the hardware from being heard."""
        return any(robot.silent for robot in self.robots.values())

    def step(self) -> bool:
        """Break what is to break, let one period pass, then do what the sim was asked."""
        robots = tuple(self.robots.values())
        for robot in robots:
            robot.trouble.step()
        for robot in robots:
            robot.drive()
            robot.hardware.act()
        self.crowd.step()
        self.physics.step(self.hardware.physics_steps)
        for robot in robots:
            robot.hardware.tell()
        for robot in robots:
            robot.controls.step(robot.hardware.now)
        return False

    def hear(self) -> None:
        """Have the hardware of all robots answer what was asked, without letting time pass."""
        for robot in self.robots.values():
            robot.hardware.hear()

    def reset(self, seed: int, scenario: Scenario | None = None) -> None:
        """Begin anew: everything where the scenario has it, under another boot.

        Raises:
            ScenarioError: when the scenario is for another site, or does not fit; then nothing has changed.
        """
        if scenario is not None:
            self._check(scenario)
            self.scenario = scenario
        self._boots += 1
        self.crowd.close()
        self.physics.clear()
        self.world, bodies = self._fill(self.scenario)
        self.crowd = self._people(self.scenario, seed)
        self.studio.restart(self.world, bodies, noise=self.scenario.noise, seed=seed)
        boot = f"{self._settings.boot}.{self._boots}"
        for robot, body in zip(self.robots.values(), bodies, strict=True):
            robot.restart(Setting(self.scenario, self.world, body, boot, seed))

    def truth(self, robot: str | None = None) -> Truth:
        """Return how things truly are, as the keys of a robot tell it (the first): for tests and reports."""
        asked = self._first if robot is None else self.robots[robot]
        return read_truth(self.world, asked.body, asked.hardware.now)

    def close(self) -> None:
        """End the controls, the hardware, the renderer and the physics."""
        for robot in self.robots.values():
            robot.close()
        self.studio.close()
        self.physics.close()

    def _fault(self, asked: str, fault: Fault) -> Answer:
        """Have a fault happen to the robot that it names, or to that whose keys were asked."""
        name = asked if fault.robot is None else fault.robot
        if name not in self.robots:
            expected = f"expected one of {', '.join(self.robots)}, found {name}"
            return Answer(accepted=False, reason=f"robot: {expected}")
        return self.robots[name].trouble.ask(fault)

    def _check(self, scenario: Scenario) -> None:
        if scenario.site not in self._sites:
            expected = f"expected {self._site.name}, found {scenario.site}"
            raise ScenarioError(f"{scenario.name}: site: {expected}; another site needs another start")
        if (found := _cast_of(scenario)) != self._cast:
            expected = f"expected {', '.join(self._cast)}, found {', '.join(found)}"
            raise ScenarioError(f"{scenario.name}: robot: {expected}; another robot needs another start")
        build_scene(self._site, scenario)
        described = {
            name: registry.robot_model(robot).description for name, robot in scenario.robots_by_name.items()
        }
        if len({each.period for each in described.values()}) > 1:
            periods = ", ".join(f"{name} {each.period:g}" for name, each in described.items())
            raise ScenarioError(f"{scenario.name}: robots: expected one period (s) for all, found {periods}")
        for index, each in enumerate(scenario.placed):
            if each.drives == "wander" and described[each.name].drive is None:
                where = scenario.path_of(index, "drives")
                raise ScenarioError(f"{scenario.name}: {where}: expected executive: {each.robot} can't drive")
        check_faults(scenario.faults, described, source=Source(scenario.name))

    def _people(self, scenario: Scenario, seed: int) -> Crowd:
        period = registry.robot_model(scenario.first.robot).description.period
        scripted = tuple(each.name for each in scenario.placed if each.drives != "executive")
        return Crowd(self.world, scenario.people, period=period, seed=seed, scripted=scripted)

    def _fill(self, scenario: Scenario) -> tuple[World, tuple[RobotBody, ...]]:
        world = spawn(self.physics, self._site, scenario)
        world.settle()
        bodies = tuple(
            enter(self.physics, world, start, number) for number, start in enumerate(scenario.placed)
        )
        return world, bodies


def _cast_of(scenario: Scenario) -> tuple[str, ...]:
    """Return in words which robots there are: a reset can't change that."""
    return tuple(
        each.robot if scenario.start is not None else f"{each.name} ({each.robot}, {each.drives})"
        for each in scenario.placed
    )


def _bus_of(name: str, buses: Bus | Mapping[str, Bus]) -> Bus:
    """Return a robot's bus; what nobody gives one has one that nobody hears."""
    if not isinstance(buses, Mapping):
        return buses
    return buses.get(name) or MemoryBus()
