"""The head's camera as a run uses it: pictures with the place that they were taken from, and their tags.

What ``perception/look`` and ``perception/track`` share. The camera is pointed elsewhere.
"""

from __future__ import annotations

import logging
from collections.abc import Generator, Iterable, Mapping
from dataclasses import dataclass
from typing import Final

from tandem.skills.geometry.poses import compose, to_pose
from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.perception import tags
from tandem.skills.perception.blind import BlindCheck
from tandem.skills.perception.camera import Camera
from tandem.skills.perception.camera_frames import CameraMount, JointHistory, RobotPoseHistory
from tandem.skills.perception.detectors import Detector
from tandem.skills.perception.detectors import detectors as builtin
from tandem.skills.perception.jobs import Shot, TagJob, TagsFound, find_tags
from tandem.skills.perception.session import LookError, Session
from tandem.skills.ports.actions.perception import LookFeedback
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.compute import Compute, Job
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import decode
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import Command, Slice
from tandem.skills.ports.world import WORLD, Box, ItemFact, Sighting

POSE_AFTER: Final = 1.0
"""Robot seconds for joints and the robot's pose to be heard."""
WORK_AFTER: Final = 20.0
"""Robot seconds for a worker to read a picture: its first start takes a while."""
BLIND_AFTER: Final = 1.5
"""Robot seconds for which a run waits for a picture that shows something, once one did not."""

_LOG = logging.getLogger(__name__)
Steps = Generator[LookFeedback | Slice, Command, None]


@dataclass
class View:
    """What one run sees with."""

    session: Session
    camera: Camera
    joints: JointHistory
    robot: RobotPoseHistory

    def refresh(self) -> None:
        """Take in where joints and robot are."""
        self.joints.refresh()
        self.robot.refresh()

    def close(self) -> None:
        """End the subscriptions."""
        self.camera.close()
        self.joints.close()
        self.robot.close()


class Eye:
    """Takes and reads pictures for one skill.

    Args:
        bus: where hardware and keeper are.
        description: the robot's: its camera and where that is mounted.
        site: the items' tags and sizes.
        compute: who reads the pictures.
        detectors: what recognises items in them, by name; tags when there is none.
    """

    def __init__(
        self,
        bus: Bus,
        description: RobotDescription,
        site: Site,
        compute: Compute,
        *,
        detectors: Mapping[str, Detector] | None = None,
    ) -> None:
        self._site, self._compute = site, compute
        self._detectors = tuple((detectors or builtin(None)).values())
        self._troubles: set[str] = set()
        self._mount, self._blind = CameraMount(description), BlindCheck()
        self._world = Latest(bus, WORLD, depth=4)

    def know_where(self, view: View) -> Steps:
        """Wait for the joints and for a pose that is localised.

        Raises:
            LookError: HARDWARE_LOST or NOT_LOCALISED when they don't come.
        """
        yield from view.session.breathe()
        heard = yield from view.session.until(lambda: view.joints.newest is not None, POSE_AFTER)
        if not heard:
            raise LookError(FailureKind.HARDWARE_LOST, f"no joint states within {POSE_AFTER} s")

        def localised() -> bool:
            newest = view.robot.newest
            return newest is not None and newest.localised

        if not (yield from view.session.until(localised, POSE_AFTER)):
            raise LookError(FailureKind.NOT_LOCALISED, "the robot's pose in the map is not known")

    def shot(
        self, view: View, after: RobotTime
    ) -> Generator[LookFeedback | Slice, Command, tuple[RobotTime, Shot]]:
        """Return the next picture not before ``after`` that shows something, with its time.

        Raises:
            LookError: CAMERA_BLIND when all that come are dark or stand still.
        """
        session = view.session
        blind_since: float | None = None
        while True:
            header, payload = yield from view.camera.picture(session, after)
            shot = yield from self._placed(view, header, payload)
            camera_in_map = compose(to_pose(shot.base_in_map), shot.camera_in_base)
            wrong = self._blind.wrong(decode(payload), camera_in_map)
            if not wrong:
                return header.stamp, shot
            blind_since = session.now if blind_since is None else blind_since
            waited = session.now - blind_since
            if waited >= BLIND_AFTER:
                raise LookError(FailureKind.CAMERA_BLIND, wrong, waited_s=waited)
            after = header.stamp.plus(1e-6)

    def read(
        self, view: View, shot: Shot, standing: tuple[tuple[int, Box], ...]
    ) -> Generator[LookFeedback | Slice, Command, TagsFound]:
        """Return the picture's tags, and which of the items that are believed to stand it shows gone.

        Raises:
            LookError: TIMED_OUT when the worker does not come back.
        """
        return (yield from self.found(view, self.reading(shot, standing)))

    def reading(self, shot: Shot, standing: tuple[tuple[int, Box], ...]) -> Job[TagsFound]:
        """Have a picture read, beside whatever comes next; ``found`` tells what it shows."""
        job = TagJob(shot, self._site.items, standing, self._detectors)
        return self._compute.submit(find_tags, job, cost=tags.COST)

    def found(self, view: View, job: Job[TagsFound]) -> Generator[LookFeedback | Slice, Command, TagsFound]:
        """Wait until a picture is read; return what it shows.

        Raises:
            LookError: TIMED_OUT when the worker does not come back.
        """
        if not (yield from view.session.until(job.done, WORK_AFTER)):
            raise LookError(FailureKind.TIMED_OUT, "the picture was not read in time")
        found = job.result()
        for trouble in found.troubles:
            if trouble not in self._troubles:  # it comes with each picture
                _LOG.error("a detector raised %s", trouble)
                self._troubles.add(trouble)
        return found

    def facts(self) -> tuple[ItemFact, ...]:
        """Return what is believed of the items."""
        world = self._world.refresh()
        return () if world is None else world.items

    def standing(self, sightings: Iterable[Sighting] = ()) -> tuple[tuple[int, Box], ...]:
        """Return the boxes of the items that stand upright, as seen in this run or believed, by item."""
        poses = {fact.item: fact.tag_in_map for fact in self.facts() if fact.held is None}
        poses |= {each.item: each.tag_in_map for each in sightings}
        boxes = []
        for number, tag_in_map in sorted(poses.items()):
            item = self._site.item(number)
            stands = None if item is None else standing_in_map(tag_in_map, item)
            if item is not None and stands is not None:
                boxes.append((number, Box(size=item.size, pose=stands)))
        return tuple(boxes)

    def doubles(self, sightings: Iterable[Sighting] = ()) -> tuple[Box, ...]:
        """Return the boxes of all upright things whose number ``standing`` tells only one of."""
        world = self._world.refresh()
        tags = [(each.item, each.tag_in_map) for each in sightings]
        tags += [(each.item, each.tag_in_map) for each in (() if world is None else world.doubles)]
        boxes = []
        for number, tag_in_map in tags:
            item = self._site.item(number)
            stands = None if item is None else standing_in_map(tag_in_map, item)
            if item is not None and stands is not None:
                boxes.append(Box(size=item.size, pose=stands))
        return tuple(boxes)

    def _placed(
        self, view: View, header: RgbdHeader, payload: bytes
    ) -> Generator[LookFeedback | Slice, Command, Shot]:
        """Say where the picture was taken from; wait until joints and pose of that moment are heard."""

        def shot() -> Shot | None:
            positions = view.joints.positions(header.stamp)
            base = view.robot.base_in_map(header.stamp)
            if positions is None or base is None:
                return None
            return Shot(payload, self._mount.camera_in_base(positions), base)

        if not (yield from view.session.until(lambda: shot() is not None, POSE_AFTER)):
            raise LookError(
                FailureKind.NOT_LOCALISED,
                "the robot's pose at the picture's time is not known",
                stamp_s=header.stamp.seconds,
            )
        placed = shot()
        assert placed is not None
        return placed
