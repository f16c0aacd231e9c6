"""The people in the room: all walkers, and whom they, and robots that a script drives, have touched."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.sim.walker import Walker
from tandem.sim.walker_body import WalkerBody

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence

    from tandem.sim.body import RobotBody
    from tandem.sim.people import Person
    from tandem.sim.world import World

MOVES: Final = (0.02, 0.05)
"""m/s and rad/s from which on a robot moves."""
OVER: Final = 0.5
"""Seconds without touching after which a contact is over."""
PURPOSE: Final = 6
"""Tells the people's chance from that of the robots' sensors."""


@dataclass(frozen=True)
class PersonTouch:
    """A contact of a person, or of a robot that a script drives, with a robot: when it began (robot seconds).

    ``stood`` is for how many seconds the robot had stood still then; 0 while it moved.
    """

    at: float
    person: str
    robot: str
    stood: float


class Crowd:
    """Moves the people; a watcher of the physics notes what they touch.

    Args:
        world: the room, with its robots.
        people: who is in it.
        period: seconds between two steps.
        seed: of all that is left to chance; each person has its own.
        scripted: names of the robots that a script drives.
    """

    def __init__(
        self,
        world: World,
        people: Sequence[Person],
        *,
        period: float,
        seed: int,
        scripted: Collection[str] = (),
    ) -> None:
        self._world, self._period, self._now = world, period, 0.0
        self._scripted = frozenset(scripted)
        self.walkers: dict[str, Walker] = {}
        self._last: dict[tuple[str, str], float] = {}
        self._moved: dict[str, float] = {}
        for number, person in enumerate(people):
            (x, y), (x1, y1) = person.path[0], person.path[1]
            body = WalkerBody(world.physics, x=x, y=y, yaw=math.atan2(y1 - y, x1 - x))
            before = tuple(self.walkers.values())
            self.walkers[person.name] = Walker(
                person,
                body,
                period,
                np.random.default_rng((seed, PURPOSE, number)),
                robots=self._robots,
                others=lambda before=before: [each.body.place for each in before],  # type: ignore[misc]
                waiting=lambda before=before, name=person.name: [  # type: ignore[misc]
                    each.body.place
                    for each in self.walkers.values()
                    if each not in before and each.person.name != name
                ],
            )
            world.join(person.name, body)
        if people or self._scripted:
            world.physics.watchers.append(self._look)

    def step(self) -> None:
        """Have everybody go on by a period."""
        self._now += self._period
        for walker in self.walkers.values():
            walker.step()

    def close(self) -> None:
        """Note no more contacts."""
        if self._look in self._world.physics.watchers:
            self._world.physics.watchers.remove(self._look)

    def _robots(self) -> dict[int, tuple[float, float]]:
        return {robot.body: robot.base_pose()[0][:2] for robot in self._world.robots.values()}

    def _look(self) -> None:
        now = self._now
        for name, robot in self._world.robots.items():
            if name in self._scripted:
                continue
            touched = [p for p, each in self.walkers.items() if each.body.touches(robot.body) > 0.0]
            touched += self._robots_at(robot)
            for person in touched:
                self._note(now, person, name)
            # Who is pushed does not move by itself.
            pushed = any(pair[1] == name and now - at < OVER for pair, at in self._last.items())
            (vx, vy, _), (_, _, turning) = self._world.physics.body_velocity(robot.body)
            if not pushed and (math.hypot(vx, vy) > MOVES[0] or abs(turning) > MOVES[1]):
                self._moved[name] = now

    def _robots_at(self, robot: RobotBody) -> list[str]:
        """Return the names of the robots that a script drives and that touch another one."""
        if not self._scripted:
            return []
        scripted = {self._world.robots[name].body: name for name in self._scripted}
        contacts = self._world.physics.contacts(robot.body)
        return sorted({scripted[c.body_b] for c in contacts if c.force > 0.0 and c.body_b in scripted})

    def _note(self, now: float, person: str, robot: str) -> None:
        pair = (person, robot)
        if now - self._last.get(pair, -math.inf) > OVER:
            stood = round(now - self._moved.get(robot, 0.0), 3)
            self._world.touches.append(PersonTouch(round(now, 3), person, robot, stood))
        self._last[pair] = now
