"""Looks at the simulation itself during a fetch: where the robot is, and how all stands for a picture."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final, Literal

from tandem.executive.trials.picking.settings import Point
from tandem.skills.geometry.poses import to_floor
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.world import SCENE, PlanningScene

if TYPE_CHECKING:
    from tandem.executive.system.systems import LockstepSystem
    from tandem.sim.render_world import Snapshot

POINT_EVERY: Final = 10
"""Periods between two points of the path: 0.1 s, in which the robot turns by 9 degrees at the most."""
SHOT_EVERY: Final = 20
"""Periods between two snapshots: 0.2 s, shorter than each step of the arm or hand that a figure shows."""
Known = Literal["not", "there", "held"]
"""What the planning scene has of the item: nothing, a thing that stands there, a thing in the hand."""


@dataclass(frozen=True)
class Shot:
    """How all stood at a moment, seconds from the request on; nothing is drawn yet."""

    at: float
    known: Known
    snapshot: Snapshot


@dataclass(eq=False)
class Witness:
    """A node beside the caller.

    Args:
        system: what is watched.
        item: that is fetched.
        shoots: whether snapshots are kept.
    """

    system: LockstepSystem
    item: int
    shoots: bool
    path: list[Point] = field(default_factory=list)
    shots: list[Shot] = field(default_factory=list)
    name: str = "witness"

    def __post_init__(self) -> None:
        """Listen; time counts from now on."""
        self._scene: Latest[PlanningScene] = Latest(self.system.bus, SCENE)
        self._began, self._periods = robot_seconds(self.system.clocks), 0

    def step(self) -> bool:
        """Look, when it is time."""
        at = round(robot_seconds(self.system.clocks) - self._began, 3)
        station = self.system.lockstep.station
        if self._periods % POINT_EVERY == 0:
            floor = to_floor(station.truth().base_in_map)
            self.path.append(Point(at=at, x=round(floor.x, 3), y=round(floor.y, 3), yaw=round(floor.yaw, 3)))
        if self.shoots and self._periods % SHOT_EVERY == 0:
            self.shots.append(Shot(at, self._known(), station.studio.snapshot()))
        self._periods += 1
        return False

    def close(self) -> None:
        """Stop listening."""
        self._scene.close()

    def _known(self) -> Known:
        scene = self._scene.refresh()
        objects = () if scene is None else scene.objects
        mine = next((each for each in objects if each.item == self.item), None)
        if mine is None:
            return "not"
        return "there" if mine.attached_to is None else "held"
