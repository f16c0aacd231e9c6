"""Who walks about: people out of the laser's scans alone. Owner of ``world/people``.

What no map explains and is as wide as legs or a body becomes a track; scans are matched to tracks by the
nearest neighbour. A track counts as a person once it has walked: the legs of furniture never do. From then on
it is one, also while standing, until scans have not shown it for a while.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from tandem.skills.base.floor import BoolArray, FloatArray, compose, invert, points_in
from tandem.skills.base.localiser import Localiser, PlacedScan
from tandem.skills.base.map import SiteMap
from tandem.skills.base.people.person_track import STANDS, Track
from tandem.skills.base.people.segments import Candidate, candidates
from tandem.skills.base.people.still import StillPlaces
from tandem.skills.base.scan import ScanGeometry
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.sensors import LaserSensor
from tandem.skills.ports.world import PEOPLE, People, TrackedPerson

GATE: Final = 0.55
"""Metres between where a person is expected and what is seen, at the most: a step, and a change of mind."""
STRANGERS_GATE: Final = 0.28
"""Likewise of what is no person yet: less than from one leg of a chair to the next."""
SINGLE: Final = 0.10
STRANGER: Final = 0.15
FURNITURE: Final = 0.30
"""Metres by which a single leg, a track that is no person yet, and what stands where somebody walks by
count as farther away."""
SWALLOWED: Final = 0.45
"""Metres around a track within which what is left over is a part of it: the other leg."""
LOST: Final = 3
"""Scans in a row that have not shown a thing that is no person yet, after which it is forgotten."""
HIDDEN: Final = 2.0
"""Robot seconds for which a person is believed in who may be hidden."""
STOOD_HIDDEN: Final = 10.0
"""Likewise of one who stood when they were seen last: the laser may look elsewhere."""
GONE: Final = 0.5
"""Robot seconds after which a person is gone where the laser looks through their place."""
THROUGH: Final = 0.35
"""Metres beyond a place to which a beam must pass to have looked through it."""
TRUSTED_FIT: Final = 0.4
"""Share of beams that the map explains, below which a scan says nothing. Three people hide a good part."""
LONGEST: Final = 1.0
"""Robot seconds between two scans after which all are forgotten."""
LATELY: Final = 20.0
"""Robot seconds after somebody was there for which they may be near still, unseen or taken for a thing."""
RADIUS: Final = 0.25
"""Metres around a person's axis: trunk and swinging legs."""
STILL_RADIUS: Final = 0.20
"""The same of somebody who stands, their legs side by side."""
RING: Final = 24
"""Points around somebody who stands: 20 cm apart in the widest berth, so that no base gets in between."""
SETTLED: Final = 1.0
"""Robot seconds after which somebody who stands is in the way as a thing is."""


class Tracker:
    """The monitor of people; a ``Node`` that follows the localiser's scans.

    Args:
        bus: where ``world/people`` goes.
        sensor: the laser.
        site_map: what explains a hit.
        localiser: scans with the pose at which they were taken.
    """

    def __init__(self, bus: Bus, sensor: LaserSensor, site_map: SiteMap, localiser: Localiser) -> None:
        self._bus, self._map, self._localiser = bus, site_map, localiser
        self._geometry = ScanGeometry(sensor, site_map.laser_in_base)
        self._tracks: list[Track] = []
        self._still = StillPlaces()
        self._born = 0
        self._alone = math.inf
        self.number = 0
        """Counts the scans."""
        self.stamp: RobotTime | None = None
        """When the newest scan was taken."""

    @property
    def name(self) -> str:
        """The node's name."""
        return "base/people"

    @property
    def people(self) -> tuple[Track, ...]:
        """Everybody who is known, as of the newest scan."""
        return tuple(track for track in self._tracks if track.walked)

    @property
    def moving(self) -> tuple[Track, ...]:
        """Everybody who is known, and what may be somebody who has just set out."""
        return tuple(track for track in self._tracks if track.walked or track.suspect)

    @property
    def walking(self) -> tuple[Track, ...]:
        """Those who walk, or have just stopped: they will not stay where they are."""
        return tuple(track for track in self.people if track.speed >= STANDS or track.stood < SETTLED)

    @property
    def lately(self) -> bool:
        """Whether somebody is, or was a moment ago, about."""
        return self._alone < LATELY

    def hides(self, points: FloatArray) -> BoolArray:
        """Say which points, shape (n, 2), are on somebody who walks: no thing stands there."""
        on = np.zeros(len(points), dtype=np.bool_)
        for track in self.walking:
            on |= np.hypot(points[:, 0] - track.state[0], points[:, 1] - track.state[1]) < SWALLOWED
        return on

    def rings(self, berth: float = STILL_RADIUS) -> FloatArray:
        """Return points, shape (n, 2), around those who stand: a plan goes around the whole of them.

        Args:
            berth: metres from their axes.
        """
        turns = np.linspace(0.0, 2 * math.pi, RING, endpoint=False)
        ring = berth * np.stack((np.cos(turns), np.sin(turns)), axis=1)
        walking = {track.id for track in self.walking}
        still = [track.place for track in self.people if track.id not in walking]
        return np.concatenate([ring + place for place in still]) if still else np.empty((0, 2))

    def near(self, x: float, y: float, within: float) -> Track | None:
        """Return the person nearest to a place in map, if there is one within so many metres."""
        there = [(math.dist(track.place, (x, y)), track) for track in self.people]
        distance, track = min(there, key=lambda each: each[0], default=(math.inf, None))
        return track if distance <= within else None

    def step(self) -> bool:
        """Take the localiser's newest scan, if it is new."""
        placed = self._localiser.placed
        if placed is None or placed.number == self.number:
            return False
        self.number = placed.number
        passed = None if self.stamp is None else placed.points.stamp.since(self.stamp)
        self.stamp = placed.points.stamp
        if passed is None or not 0.0 < passed < LONGEST:
            self._tracks.clear()
            self._still.clear()
        else:
            trusted = self._localiser.localised and placed.fit >= TRUSTED_FIT
            bounds, still = self._map.bounds, self._still.holds
            self._follow(placed, passed, candidates(placed, bounds, still) if trusted else ())
        self._alone = 0.0 if self.people else self._alone + max(passed or 0.0, 0.0)
        self._tell(placed.points.stamp)
        return False

    def close(self) -> None:
        """Nothing to leave."""

    def _follow(self, placed: PlacedScan, seconds: float, seen: Sequence[Candidate]) -> None:
        for track in self._tracks:
            track.predict(seconds)
        self._still.see((part for each in seen for part in each.parts), seconds)
        left = self._matched(seen)
        for each in left:
            if all(math.dist((each.x, each.y), track.place) > SWALLOWED for track in self._tracks):
                self._born += 1
                self._tracks.append(Track.of(self._born, each))
        self._tracks = [track for track in self._tracks if not self._over(track, placed)]

    def _matched(self, seen: Sequence[Candidate]) -> list[Candidate]:
        """Give each track the nearest that is left; return what nobody has."""
        pairs = sorted(
            (distance + self._doubt(track, each), t, c)
            for t, track in enumerate(self._tracks)
            for c, each in enumerate(seen)
            if (distance := math.dist((each.x, each.y), track.place))
            < (GATE if track.walked else STRANGERS_GATE)
        )
        matched: set[int] = set()
        taken: set[int] = set()
        for far, t, c in pairs:
            if far < GATE and t not in matched and c not in taken:
                matched.add(t)
                taken.add(c)
                still = any(self._still.holds(*part) for part in seen[c].parts)
                self._tracks[t].update(seen[c], still=still)
        for t, track in enumerate(self._tracks):
            track.misses += t not in matched
        return [each for c, each in enumerate(seen) if c not in taken]

    def _doubt(self, track: Track, seen: Candidate) -> float:
        """Return by how many metres what is seen counts as farther from a track."""
        passes = track.walked and track.speed >= STANDS
        still = passes and all(self._still.holds(*part) for part in seen.parts)
        return SINGLE * (not seen.paired) + STRANGER * (not track.walked) + FURNITURE * still

    def _over(self, track: Track, placed: PlacedScan) -> bool:
        if not track.walked:
            return track.misses >= LOST
        if track.unseen > (STOOD_HIDDEN if track.stood > SETTLED else HIDDEN):
            return True
        return track.unseen > GONE and self._looked_through(track, placed)

    def _looked_through(self, track: Track, placed: PlacedScan) -> bool:
        laser = compose(placed.base_in_map, self._map.laser_in_base)
        in_laser = points_in(invert(laser), np.array([track.place]))
        beam = round(float(self._geometry.beam_of(in_laser)[0]))
        ranges = placed.points.all_ranges
        if not 2 <= beam < len(ranges) - 2:  # noqa: PLR2004 - its neighbours on both sides
            return False
        distance = float(np.hypot(*in_laser[0]))
        # A beam without an echo says nothing.
        return bool(np.all(ranges[beam - 2 : beam + 3] > distance + THROUGH))

    def _tell(self, stamp: RobotTime) -> None:
        told = tuple(
            TrackedPerson(
                id=track.id,
                x=track.place[0],
                y=track.place[1],
                vx=track.velocity[0],
                vy=track.velocity[1],
                position_sigma=track.sigma,
                radius=RADIUS,
                unseen=track.unseen,
            )
            for track in self.people
        )
        PEOPLE.publish(self._bus, People(stamp=stamp, people=told))
