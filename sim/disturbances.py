"""What a run did to the room: which things moved, and what the robot touched. For tests and reports only.

The truth at one moment can't tell this: a hand that swept past has left no contact behind.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from tandem.sim.scene import item_name
from tandem.skills.geometry.poses import rotate

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tandem.sim.body import RobotBody
    from tandem.sim.physics import Contact
    from tandem.sim.scene import SceneBody
    from tandem.sim.world import World
    from tandem.skills.ports.message import Quaternion, Vector3

MOVED: Final = 0.01
"""Metres from which a thing counts as moved. The physics' own settling stays below 1 mm."""
FALLEN: Final = math.radians(30.0)
"""Tilt from which a thing counts as fallen over; what stands on an edge rests at 0 or at 90 degrees."""


@dataclass(frozen=True)
class Touch:
    """A link of the robot touched something: first ``at`` (robot seconds), for how long, and how hard."""

    link: str
    what: str
    at: float
    seconds: float
    force: float
    """The largest, N."""

    def __str__(self) -> str:
        """Return it in words."""
        return (
            f"{self.link} touches {self.what} at {self.at:.2f} s, for {self.seconds:.2f} s, "
            f"with up to {self.force:.1f} N"
        )


@dataclass(frozen=True)
class Shift:
    """A thing was moved: farther than ``MOVED`` at ``at`` (robot seconds), by ``metres`` in the end."""

    name: str
    at: float
    metres: float
    """The largest distance from where it stood."""
    tilt: float
    """The largest, rad."""
    robots_doing: bool
    """Whether the robot, or what it held, has touched it."""

    def __str__(self) -> str:
        """Return it in words."""
        how = "falls over and moves" if self.tilt > FALLEN else "moves"
        who = "" if self.robots_doing else ", untouched by the robot"
        return f"{self.name} {how} by {self.metres:.3f} m, from {self.at:.2f} s on{who}"


@dataclass(eq=False)
class _Watched:
    """A thing, where it was put, and what has become of it."""

    body: SceneBody
    position: Vector3
    up: Vector3
    metres: float = 0.0
    tilt: float = 0.0
    moved_at: float | None = None

    def see(self, position: Vector3, orientation: Quaternion, seconds: float) -> None:
        self.metres = max(self.metres, math.dist(position, self.position))
        cosine = sum(a * b for a, b in zip(_up(orientation), self.up, strict=True))
        self.tilt = max(self.tilt, math.acos(max(-1.0, min(1.0, cosine))))
        if self.moved_at is None and (self.metres > MOVED or self.tilt > FALLEN):
            self.moved_at = seconds


@dataclass(eq=False)
class Disturbances:
    """Looks at the things once a period (call ``step`` after it), and at contacts after each physics step.

    A thing that the sim's controls put elsewhere is watched anew from there: a person did that.

    Args:
        world: whose things are watched.
        robot: whose contacts are.
        item: the item that the robot is to move; its own moves are nobody's business here.
    """

    world: World
    robot: RobotBody
    item: int
    _watched: dict[str, _Watched] = field(default_factory=dict)
    _before: list[_Watched] = field(default_factory=list)
    """Things as they were until a person put them elsewhere."""
    _touches: dict[tuple[str, str], Touch] = field(default_factory=dict)
    _disturbed: set[str] = field(default_factory=set)
    """What the robot, or what it held, has touched."""
    _now: float = 0.0

    def __post_init__(self) -> None:
        """Take the links' names, and watch from now on."""
        self.world.physics.watchers.append(self._look_at_contacts)
        self._links = {index: name for name, index in self.robot.link_index.items()}

    def step(self, seconds: float) -> None:
        """Look at where the things are now, in robot seconds."""
        self._now = seconds
        for name in self.world.movable():
            if name == item_name(self.item):
                continue
            body = self.world.bodies[name]
            watched = self._watched.get(name)
            if watched is None or watched.body is not body:
                if watched is not None:
                    self._before.append(watched)
                watched = _Watched(body, body.pose.position, _up(body.pose.orientation))
                self._watched[name] = watched
            watched.see(*self.world.physics.body_pose(self.world.id_of(name)), seconds)

    def shifts(self) -> tuple[Shift, ...]:
        """Return the things that have been moved by more than ``MOVED`` or have fallen over."""
        shifts = [self._shift(each) for each in (*self._before, *self._watched.values())]
        return tuple(sorted((each for each in shifts if each is not None), key=lambda each: each.at))

    def touches(self) -> tuple[Touch, ...]:
        """Return the contacts of the robot with what can't move (furniture, a person), in order."""
        return tuple(sorted(self._touches.values(), key=lambda each: each.at))

    def close(self) -> None:
        """Watch no longer."""
        self.world.physics.watchers.remove(self._look_at_contacts)

    def _look_at_contacts(self) -> None:
        physics, names = self.world.physics, self.world.names_with_robots()
        touching = [
            (contact, names[contact.body_b])
            for contact in physics.contacts(self.robot.body)
            if contact.force > 0.0 and contact.body_b != self.robot.body
        ]
        self._note_touches(touching)
        if any(what == item_name(self.item) for _, what in touching):
            beyond = physics.contacts(self.world.id_of(item_name(self.item)))
            touching += [
                (contact, names[contact.body_b])
                for contact in beyond
                if contact.force > 0.0 and contact.body_b != self.robot.body
            ]
        self._disturbed.update(what for _, what in touching)

    def _note_touches(self, touching: Iterable[tuple[Contact, str]]) -> None:
        forces: dict[tuple[str, str], float] = {}
        for contact, what in touching:
            if what in self.world.bodies and self.world.bodies[what].mass == 0.0:
                pair = (self._links[contact.link_a], what)
                forces[pair] = forces.get(pair, 0.0) + contact.force
        for pair, force in forces.items():
            before = self._touches.get(pair, Touch(*pair, at=self._now, seconds=0.0, force=0.0))
            seconds = before.seconds + self.world.physics.time_step
            self._touches[pair] = Touch(*pair, at=before.at, seconds=seconds, force=max(before.force, force))

    def _shift(self, watched: _Watched) -> Shift | None:
        if watched.moved_at is None:
            return None
        name = watched.body.name
        robots_doing = name in self._disturbed
        return Shift(name, watched.moved_at, watched.metres, watched.tilt, robots_doing=robots_doing)


def _up(orientation: Quaternion) -> Vector3:
    return rotate(orientation, (0.0, 0.0, 1.0))
