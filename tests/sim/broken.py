"""The rig of a robot and an item, with faults."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from benchmarks.rig import GRASP, GRASP_POINT, LIFT, Rig
from tandem.sim.controls import FAULTS
from tandem.sim.faults import Fault, FaultEvent
from tandem.sim.faulty_link import FaultyLink
from tandem.sim.hardware import Hardware
from tandem.sim.room import Room
from tandem.sim.scenario import Noise
from tandem.sim.scene import Label, SceneBody
from tandem.sim.things import BoxShape
from tandem.sim.trouble import Trouble
from tandem.sim.world import World
from tandem.skills.ports import keys
from tandem.skills.ports.pose import Pose
from tandem.skills.site import load

SIZE = 0.06


class FaultyRig(Rig):
    """A rig whose item is item 29 of the lab, and whose hardware can be broken."""

    def __init__(self, *faults: Fault, start: dict[str, tuple[float, ...]] | None = None) -> None:
        super().__init__(start=start)
        self.hardware.close()
        link = FaultyLink(self.bus)
        rng = np.random.default_rng(1)
        self.hardware = Hardware(link, self.body, boot="rig", noise=Noise(), rng=rng)
        for body in (self.floor, self.item):
            self.physics.remove(body)
        self.world = World(self.physics)
        item = SceneBody(
            name="item_29",
            shape=BoxShape(size=(SIZE, SIZE, SIZE)),
            pose=Pose(position=GRASP_POINT),
            mass=0.1,
            friction=0.9,
            colour=(1.0, 1.0, 1.0),
            label=Label(29, 0.048),
        )
        self.item = self.world.put(item)
        room = Room(load("lab"), self.world, self.body)
        self.trouble = Trouble(self.bus, link, self.hardware, room, faults)
        self._told = keys.Latest(self.bus, FAULTS)
        self.events: list[FaultEvent] = []

    def ticks(self, count: int) -> None:
        """Let periods pass."""
        for _ in range(count):
            self.trouble.step()
            self.hardware.step()
        self.events += self._told.take()

    def phases(self) -> list[tuple[str, str]]:
        """Return the kind and the phase of each event so far."""
        return [(event.kind, event.phase) for event in self.events]

    def height(self) -> float:
        """Return the height of the item's centre in metres."""
        return self.physics.body_pose(self.item)[0][2]

    def lift(self, to: Sequence[float] = LIFT) -> None:
        """Grasp the item and lift it."""
        self.grip(0.09)
        self.move("arm_left", GRASP, 1.0)
        self.grip(0.0)
        self.move("arm_left", to, 1.0)
