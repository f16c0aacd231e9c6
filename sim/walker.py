"""A person who walks along a drawn path: an actor of the room, as the script of ``sim.wanderer`` is.

It stops, turns round, and gives way to a robot in a share of its meetings only, all by a seeded chance. Who
gives way stands until the robot has gone by. Who bumps into something stops, and turns round after a while.
It has no sensors: the physics tells it where the robots and the other people are.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.skills.geometry.poses import wrap

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    import numpy as np

    from tandem.sim.people import Person
    from tandem.sim.walker_body import WalkerBody

    Place = tuple[float, float]

ACCELERATION: Final = 1.2
"""m/s2: people take about a second to reach their pace, and to leave it."""
CORNER: Final = 0.25
"""m/s at a corner of a right angle or more; in between, what is left of the pace."""
LOOK_EVERY: Final = 0.1
"""Seconds between two looks around."""
STEER_EVERY: Final = 0.02
"""Seconds between two commands to the motors."""
MEETS: Final = 1.3
"""Metres between the axes from which on somebody ahead is met."""
PARTS: Final = 1.6
"""Metres from which on a meeting is over."""
AHEAD: Final = math.radians(60.0)
"""To either side of the way: what is there is ahead."""
GIVES_UP: Final = 6.0
"""Seconds after which who gives way turns round instead."""
PAUSE: Final = (0.8, 3.0)
"""Seconds of a stop of one's own accord: least and most."""
STARTLED: Final = 1.5
"""Seconds for which a person stands who has bumped into something."""
OTHERS: Final = 0.9
"""Metres between the axes of two people from which on the later one of the file waits."""
CLOSE: Final = 0.55
"""Metres from another person who waits at which somebody comes to rest and turns: two bodies, and a foot."""
OFF: Final = 0.10
"""Metres off its place from which on a person gets back there before it goes on."""
STEER: Final = 2.0
"""m/s for each metre off the path."""


class Walker:
    """Moves one person. Call ``step`` once a period.

    Args:
        person: path and habits.
        body: what is moved.
        period: seconds between two steps.
        rng: source of its whims.
        robots: returns where the axes of the robots are (m, in map), by their bodies in the physics.
        others: returns where the people are that this one waits for.
        waiting: returns where those are who wait for this one.
    """

    def __init__(
        self,
        person: Person,
        body: WalkerBody,
        period: float,
        rng: np.random.Generator,
        *,
        robots: Callable[[], dict[int, Place]],
        others: Callable[[], Iterable[Place]],
        waiting: Callable[[], Iterable[Place]],
    ) -> None:
        self.person, self.body = person, body
        self._period, self._rng = period, rng
        self._robots, self._others, self._waiting = robots, others, waiting
        self._now = self._until_look = self._until_steer = 0.0
        self._leg, self._onward, self._way = 0, 1, 0.0
        """The piece of the path, 1 or -1 along it, and the metres walked of the piece."""
        self._pace = 0.0
        self._stands_until = person.after
        self._turns_after = False
        self._met: dict[int, bool] = {}
        """The robots it is meeting, by body, and whether it gives way to them."""
        self._waits_since: float | None = None
        self._waits = False
        self._done = self._touched = False

    def step(self) -> None:
        """Let a period pass; look around and command the motors when it is time."""
        self._now += self._period
        self._until_look -= self._period
        self._until_steer -= self._period
        if self._until_look <= 0.0:
            self._until_look += LOOK_EVERY
            self._look()
        if self._until_steer <= 0.0:
            self._until_steer += STEER_EVERY
            self._walk(STEER_EVERY)

    def _look(self) -> None:
        x, y = self.body.place
        robots = self._robots()
        self._meet(x, y, robots)
        gives_way = any(self._met.get(robot, False) and self._ahead(x, y, at) for robot, at in robots.items())
        crowded = any(math.dist((x, y), at) < OTHERS and self._ahead(x, y, at) for at in self._others())
        self._waits = gives_way or crowded
        if not self._waits:
            self._waits_since = None
        elif self._waits_since is None:
            self._waits_since = self._now
        elif self._now - self._waits_since > GIVES_UP:
            self._waits_since = None
            self._turn()
        near = CLOSE + self._pace**2 / (2.0 * ACCELERATION)
        blocked = any(math.dist((x, y), at) < near and self._ahead(x, y, at) for at in self._waiting())
        if blocked and not self._turns_after:
            self._stand(STARTLED, turns=True)
        self._follow_whims()

    def _meet(self, x: float, y: float, robots: dict[int, Place]) -> None:
        """Decide, once a meeting, whether to give way."""
        for robot, at in robots.items():
            distance = math.dist((x, y), at)
            if distance > PARTS:
                self._met.pop(robot, None)
            elif robot not in self._met and distance < MEETS and self._ahead(x, y, at):
                self._met[robot] = bool(self._rng.random() < self.person.gives_way)

    def _follow_whims(self) -> None:
        stop, turn = self._rng.random(2) < (self.person.stops * LOOK_EVERY, self.person.turns * LOOK_EVERY)
        if self._now < self._stands_until or self._done:
            return
        if stop:
            self._stand(float(self._rng.uniform(*PAUSE)), turns=False)
        elif turn and self.person.then == "back":
            self._stand(0.0, turns=True)

    def _stand(self, seconds: float, *, turns: bool) -> None:
        self._stands_until = max(self._stands_until, self._now + seconds)
        self._turns_after = self._turns_after or turns

    def _turn(self) -> None:
        """Walk the way back."""
        self._onward, self._way = -self._onward, self._length(self._leg) - self._way

    def _ahead(self, x: float, y: float, at: Place, within: float = AHEAD) -> bool:
        (ux, uy), bearing = self._direction(), math.atan2(at[1] - y, at[0] - x)
        return abs(wrap(bearing - math.atan2(uy, ux))) < within

    def _walk(self, seconds: float) -> None:
        touched = [at for robot, at in self._robots().items() if self.body.touches(robot) > 0.0]
        touches = bool(touched)
        if touches and not self._touched:
            bumps = any(self._ahead(*self.body.place, at, within=math.pi / 2) for at in touched)
            self._stand(STARTLED, turns=bumps)
            self._pace = 0.0
        self._touched = touches
        standing = self._now < self._stands_until or self._waits or self._done
        wanted = 0.0 if standing or self._turns_after else self._allowed()
        self._pace += min(max(wanted - self._pace, -ACCELERATION * seconds), ACCELERATION * seconds)
        if self._turns_after and self._pace <= 0.0 and self._now >= self._stands_until:
            self._turns_after = False
            self._turn()
        x, y = self.body.place
        px, py = self._point()
        off = math.dist((x, y), (px, py))
        if off > OFF:
            self._pace = 0.0
        self._go_on(self._pace * seconds)
        (ux, uy) = self._direction()
        held = (touches and standing) or (self._pace == 0.0 and (standing or off <= OFF))
        vx = 0.0 if held else self._pace * ux + STEER * (px - x)
        vy = 0.0 if held else self._pace * uy + STEER * (py - y)
        self.body.move(vx, vy, math.atan2(uy, ux), seconds)

    def _allowed(self) -> float:
        """Return the speed (m/s) from which the pace at the next corner can still be reached."""
        left = self._length(self._leg) - self._way
        return min(self.person.speed, math.sqrt(self._corner() ** 2 + 2.0 * ACCELERATION * left))

    def _corner(self) -> float:
        """Return the pace (m/s) at the end of the present piece."""
        following = self._leg + self._onward
        if not 0 <= following < len(self.person.path) - 1:
            return 0.05 if self.person.then == "back" else 0.0
        (ax, ay), (bx, by) = self._direction(), self._direction(following)
        angle = math.acos(min(max(ax * bx + ay * by, -1.0), 1.0))
        return max(CORNER, self.person.speed * (1.0 - angle / (math.pi / 2)))

    def _go_on(self, way: float) -> None:
        self._way += way
        while self._way >= self._length(self._leg) - 1e-3:
            following = self._leg + self._onward
            if 0 <= following < len(self.person.path) - 1:
                self._way, self._leg = max(self._way - self._length(self._leg), 0.0), following
            elif self.person.then == "stay":
                self._way, self._done = self._length(self._leg), True
                return
            else:
                self._onward, self._way, self._pace = -self._onward, 0.0, 0.0
                return

    def _ends(self, leg: int) -> tuple[Place, Place]:
        ends = self.person.path[leg], self.person.path[leg + 1]
        return ends if self._onward > 0 else (ends[1], ends[0])

    def _length(self, leg: int) -> float:
        return math.dist(*self._ends(leg))

    def _direction(self, leg: int | None = None) -> Place:
        (x0, y0), (x1, y1) = self._ends(self._leg if leg is None else leg)
        length = math.dist((x0, y0), (x1, y1))
        return (x1 - x0) / length, (y1 - y0) / length

    def _point(self) -> Place:
        (x, y), (ux, uy) = self._ends(self._leg)[0], self._direction()
        return x + self._way * ux, y + self._way * uy
