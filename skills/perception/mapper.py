"""Keeps the map of occupied space: pictures at the rate that the site wants, and those of every look.

It listens to the camera only until a picture comes, since a camera renders only while somebody listens.
Pictures that were taken while the camera swung are left out: they smear, and their stamp never agrees wholly
with that of the joints.
"""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np

from tandem.skills import map_file
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import angle_between, compose, to_pose
from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.perception.arms import Arms
from tandem.skills.perception.blind import Sight
from tandem.skills.perception.camera_frames import CameraMount, JointHistory, RobotPoseHistory
from tandem.skills.perception.clutter import Known
from tandem.skills.perception.jobs import Shot
from tandem.skills.perception.occupancy import COST, MapJob, Mapped, read_picture
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute, Job
from tandem.skills.ports.endpoint import Problems, endpoint
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.image import header_of
from tandem.skills.ports.keys import Latest, rgbd
from tandem.skills.ports.lattice import Lattice, Numbers, packed
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import (
    EditMap,
    MapEdit,
    MapEdited,
    Occupancy,
    OccupancySetting,
    SavedMap,
)
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.problems import in_words
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import OCCUPANCY, OCCUPANCY_EDIT, OCCUPANCY_NOW, PEOPLE, WORLD, Box, WorldState

BODY: Final = 0.25
"""Metres about a person's legs, as the laser has them, that the rest of the body and a step until the picture
may take."""
TRACKED_WITHIN: Final = 1.0
"""Robot seconds between the scan of a person and the picture: later the person is elsewhere, and a base that
has gone silent leaves no hole in the map. A scan comes ten times a second."""
TALL: Final = 2.0
"""Metres: no person is higher."""
KEEPS_LISTENING: Final = 4.0
"""Pictures a second from which on the camera is listened to all the time: it gives five."""
PLACED_WITHIN: Final = 1.0
"""Robot seconds after a picture within which joints and pose of its moment must be heard."""
NOT_PLACED: Final = (
    "it is not known where the camera was: the robot is not localised, or its joints are silent"
)
SWINGS: Final = 0.03
"""Radians that the camera may turn in ``BEFORE`` seconds: the picture is off by 3 mm a metre then."""
BEFORE: Final = 0.1
"""Robot seconds before a picture from which on the camera must have been as good as still."""
REST: Final = 0.3
"""Robot seconds to wait after a picture that was left out."""
OFFERED: Final = 4
"""Pictures of looks that wait, at the most."""

log = logging.getLogger(__name__)


class Mapper:
    """Measures occupied space and tells it on each change; a ``Node``.

    Args:
        bus: where hardware, base and keeper are.
        clocks: robot time.
        description: the robot: its camera, its arms and its size.
        site: its furniture, items and bounds.
        setting: how often, how finely and how far.
        compute: who reads the pictures.
        saved: the file of the saved map, which is read now if there is one; None: it is saved nowhere.

    Raises:
        DocumentError: when that file is wrong.
    """

    name: Final = "perception/mapper"

    def __init__(  # noqa: PLR0917 - as all of perception's nodes
        self,
        bus: Bus,
        clocks: Clocks,
        description: RobotDescription,
        site: Site,
        setting: OccupancySetting,
        compute: Compute,
        saved: Path | None = None,
    ) -> None:
        self._bus, self._clocks, self._site, self._setting = bus, clocks, site, setting
        self._compute, self._radius = compute, description.footprint_radius
        self._lens = description.camera
        self._mount, self._arms = CameraMount(description), Arms(description)
        self._furniture = tuple(box_in_map(box) for each in site.furniture for box in each.boxes)
        self._lattice = Lattice.of_site(site, setting)
        self._joints, self._robot = JointHistory(bus), RobotPoseHistory(bus)
        self._world, self._people = Latest(bus, WORLD, depth=4), Latest(bus, PEOPLE, depth=4)
        self._inbox: Heard[RgbdHeader] | None = None
        self._picture: tuple[RobotTime, bytes] | None = None
        self._offers: deque[Shot] = deque(maxlen=OFFERED)
        self._job: Job[Mapped] | None = None
        self._after: RobotTime | None = None
        self._saved = saved
        start = None if saved is None else map_file.load(saved, site.name, self._lattice)
        self._occupied: Numbers = np.zeros(0, np.int64) if start is None else start
        self._sight: Sight | None = None
        self._problem, self._version, self._told = "", 1, 0
        self._there = frozenset[str]()
        self._endpoints = Endpoints(
            bus,
            clocks.monotonic,
            (
                endpoint(OCCUPANCY_NOW, lambda _: self._now()),
                endpoint(OCCUPANCY_EDIT, lambda call: self._edit(call.document), refuse=_refused),
            ),
        )

    @property
    def occupied(self) -> Numbers:
        """The numbers of the occupied cells, rising."""
        return self._occupied

    @property
    def lattice(self) -> Lattice:
        """The cells."""
        return self._lattice

    def offer(self, shot: Shot) -> None:
        """Take in a picture that was taken for something else."""
        self._offers.append(shot)

    def clear(self) -> None:
        """Forget all that is occupied; what stands there is seen again."""
        self._job = None
        self._adopt(Mapped(np.zeros(0, np.int64)))

    def step(self) -> bool:
        """Take a picture when it is time, have it read, and tell what has changed."""
        now, more = self._clocks.robot(), self._endpoints.step()
        self._joints.refresh()
        self._robot.refresh()
        if now is None:
            return more
        if self._job is not None and self._job.done():
            self._adopt(self._job.result())
            self._job = None
        if self._job is None:
            self._listen(now)
            shot = self._offers.popleft() if self._offers else self._placed(now)
            if shot is not None:
                self._job = self._compute.submit(read_picture, self._about(shot), cost=COST)
        self._tell(now)
        return more

    def close(self) -> None:
        """End the subscriptions."""
        self._hush()
        self._joints.close()
        self._robot.close()
        self._world.close()
        self._people.close()
        self._endpoints.close()

    def _listen(self, now: RobotTime) -> None:
        """Listen to the camera while a picture is due, and keep the newest."""
        due = self._after is None or now.is_after(self._after) is not False
        if self._inbox is None and due and self._picture is None:
            self._inbox = Heard(self._bus, rgbd(self._lens.name), header_of, depth=1)
        if self._inbox is None:
            return
        pictures = self._inbox.take()
        if pictures and due:
            _, header, payload = pictures[-1]
            self._picture = (header.stamp, payload)
            self._after = now.plus(1.0 / self._setting.rate - 1e-6)
            if self._setting.rate < KEEPS_LISTENING:
                self._hush()

    def _placed(self, now: RobotTime) -> Shot | None:
        """Return the picture with where it was taken from, once that is known."""
        if self._picture is None:
            return None
        stamp, payload = self._picture
        positions, base = self._joints.positions(stamp), self._robot.base_in_map(stamp)
        if positions is None or base is None:
            if not stamp.is_fresh(now, PLACED_WITHIN):
                self._picture = None
                self._adopt(Mapped(self._occupied, NOT_PLACED))
            return None
        self._picture = None
        if self._swings(stamp):
            self._after = now.plus(REST)
            return None
        return Shot(payload, self._mount.camera_in_base(positions), base)

    def _swings(self, stamp: RobotTime) -> bool:
        poses = []
        for at in (stamp, stamp.plus(-BEFORE)):
            positions, base = self._joints.positions(at), self._robot.base_in_map(at)
            if positions is None or base is None:
                return False
            poses.append(compose(to_pose(base), self._mount.camera_in_base(positions)))
        return angle_between(poses[0].orientation, poses[1].orientation) > SWINGS

    def _about(self, shot: Shot) -> MapJob:
        stamp, world = header_of(shot.payload).stamp, self._world.refresh()
        positions = self._joints.positions(stamp) or {}
        items = () if world is None else (*self._standing(world), *self._held(world, shot, positions))
        known = Known(
            self._furniture,
            (*items, *self._tracked(stamp)),
            self._arms.segments(positions) if positions else (),
            self._radius,
        )
        size = (self._lens.width, self._lens.height)
        return MapJob(shot, self._lattice, self._occupied, known, size, self._setting.range, self._sight)

    def _standing(self, world: WorldState) -> tuple[Box, ...]:
        found = []
        for fact in (*world.items, *world.doubles):
            stands = None if fact.held is not None else standing_in_map(fact.tag_in_map, fact)
            if stands is not None:
                found.append(Box(size=fact.size, pose=stands))
        return tuple(found)

    def _tracked(self, stamp: RobotTime) -> tuple[Box, ...]:
        """Return the room of the people whom the base tracks, at a picture's time: they don't stay there."""
        heard = self._people.refresh()
        people = () if heard is None or not heard.stamp.is_fresh(stamp, TRACKED_WITHIN) else heard.people
        return tuple(
            Box(
                size=(2 * (each.radius + BODY), 2 * (each.radius + BODY), TALL),
                pose=Pose(position=(each.x, each.y, TALL / 2), orientation=(0.0, 0.0, 0.0, 1.0)),
            )
            for each in people
        )

    def _held(self, world: WorldState, shot: Shot, positions: Mapping[str, float]) -> tuple[Box, ...]:
        base, hands = to_pose(shot.base_in_map), self._arms.hands(positions)
        return tuple(
            Box(size=item.size, pose=compose(compose(base, hands[held.side]), held.item_in_tool))
            for held in world.held
            if held.side in hands and (item := self._site.item(held.item)) is not None
        )

    def _adopt(self, found: Mapped) -> None:
        before, self._sight = self._sight, found.sight or self._sight
        if before is None and found.sight is not None:
            # One picture alone may stand still since before the robot moved: it counts once another came.
            self._after, found = None, replace(found, occupied=self._occupied)
        if found.problem and found.problem != self._problem:
            log.warning("a depth image changes nothing in the map: %s", found.problem)
        if found.problem != self._problem or not np.array_equal(found.occupied, self._occupied):
            self._version += 1
        self._occupied, self._problem = found.occupied, found.problem

    def _tell(self, now: RobotTime) -> None:
        there = self._bus.alive()
        came, self._there = not there <= self._there, there
        if self._version == self._told and not came:
            return
        self._told = self._version
        OCCUPANCY.publish(self._bus, self._message(now))

    def _message(self, now: RobotTime) -> Occupancy:
        return Occupancy(
            stamp=now,
            version=self._version,
            origin=self._lattice.origin,
            shape=self._lattice.shape,
            resolution=self._lattice.resolution,
            cells=packed(self._occupied),
            problem=self._problem,
        )

    def _now(self) -> Occupancy | None:
        now = self._clocks.robot()
        return None if now is None else self._message(now)

    def _edit(self, asked: EditMap) -> MapEdited:
        now, cells, path = self._clocks.robot(), len(self._occupied), self._saved
        log.warning("map of occupied space: %s by %s", asked.edit, asked.by)
        if asked.edit is not MapEdit.SAVE:
            self.clear()
        try:
            if asked.edit is MapEdit.SAVE:
                if path is None or now is None:
                    return MapEdited(done=False, reason="this robot keeps no files (no --data)")
                map_file.save(path, SavedMap(site=self._site.name, occupancy=self._message(now)))
            elif asked.edit is MapEdit.CLEAR_SAVED and path is not None:
                path.unlink(missing_ok=True)
        except OSError as error:
            return MapEdited(done=False, path=str(path), reason=str(error))
        return MapEdited(done=True, cells=cells, path="" if path is None else str(path))

    def _hush(self) -> None:
        if self._inbox is not None:
            self._inbox.close()
            self._inbox = None


def _refused(problems: Problems) -> MapEdited:
    return MapEdited(done=False, reason=in_words(problems))
