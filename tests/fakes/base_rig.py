"""A planar robot with the base's parts on one bus, and a skill run to its end against it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import process_time
from typing import TypeVar

import numpy as np

from tandem.skills.base.process import Base, assemble
from tandem.skills.ports.actions.arm import ArmState, ArmStatus, arm_status
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import Command, Outcome, Run, Slice, failed
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.planar_robot import PlanarClocks, PlanarNoise, PlanarRobot, describe

F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)


@dataclass
class Rig:
    """Steps everything in one thread; ``longest`` is the longest step of the base's parts (s)."""

    robot: PlanarRobot
    base: Base
    bus: MemoryBus
    arm_state: ArmState = ArmState.ARM_IDLE
    extent: float = 0.3
    longest: float = 0.0

    @property
    def now(self) -> float:
        return self.robot.clocks.seconds

    def tick(self) -> None:
        """One period of the hardware, then the monitors."""
        self.robot.step()
        if self.robot.tick % 10 == 0:
            for hand in self.robot.description.end_effectors:
                status = ArmStatus(
                    stamp=self.robot.clocks.robot(),
                    group=hand.group,
                    state=self.arm_state,
                    extent=self.extent,
                )
                arm_status(hand.group).publish(self.bus, status)
        start = process_time()
        people = () if self.base.people is None else (self.base.people,)
        base = self.base
        cliffs = () if base.cliffs is None else (base.cliffs,)
        for node in (base.localiser, *people, *cliffs, base.obstacles, base.board, base.reflexes):
            node.step()
        self.longest = max(self.longest, process_time() - start)

    def wait(self, seconds: float) -> None:
        until = self.now + seconds
        while self.now < until - 1e-9:
            self.tick()

    def run(
        self,
        run: Run[F, R],
        command: Callable[[float], Command] = lambda _: Command.GO_ON,
        limit: float = 120.0,
    ) -> Outcome[R]:
        """Run a skill to its end; ``command`` gets the seconds since the start, at each resumption."""
        begun, pipeline = self.now, self.base.board.pipeline
        mark = pipeline.mark()
        try:
            next(run)
            while True:
                self.tick()
                overridden = pipeline.taken_since(mark, "rig")
                if overridden is not None:  # as the server does
                    run.close()
                    while pipeline.override is not None:
                        self.tick()
                    return failed(overridden)
                while True:
                    start = process_time()
                    yielded = run.send(command(self.now - begun))
                    self.longest = max(self.longest, process_time() - start)
                    if not isinstance(yielded, Slice):
                        break
                if self.now - begun > limit:
                    raise AssertionError(f"not at its end after {limit} s, at {self.robot.truth}")
        except StopIteration as stop:
            outcome: Outcome[R] = stop.value
            return outcome


def make_rig(
    site: Site,
    start: FloorPose,
    *,
    seed: int = 1,
    noise: PlanarNoise | None = None,
    description: RobotDescription | None = None,
    localised: bool = True,
) -> Rig:
    """Return a rig at rest; ``localised`` starts the localiser at the true pose."""
    bus, clocks = MemoryBus(), PlanarClocks()
    described = description or describe()
    robot = PlanarRobot(
        bus, clocks, described, site, np.random.default_rng(seed), start, noise or PlanarNoise()
    )
    rig = Rig(robot, assemble(bus, clocks, described, site), bus)
    rig.wait(0.5)
    if localised:
        assert rig.base.localiser.initialise(robot.truth, robot.clocks.robot(), (0.03, 0.02))
        rig.wait(0.5)
    return rig
