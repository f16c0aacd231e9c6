"""Look: point the head, take pictures, tell which tags are where and what else stands there."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from skills.perception import clutter, tags
from skills.perception.aim import Aim
from skills.perception.arms import Arms
from skills.perception.blind import BlindCheck
from skills.perception.camera import Camera
from skills.perception.frames import CameraMount, JointHistory, RobotPoseHistory
from skills.perception.head import Head
from skills.perception.jobs import ClutterJob, Shot, TagJob, TagsFound, find_clutter, find_tags
from skills.perception.merge import merge
from skills.perception.rigid import Matrix
from skills.perception.session import WHERE, Canceled, LookError, Session
from skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.compute import Compute
from skills.ports.failure import Failure, FailureKind
from skills.ports.geometry import compose, invert, to_pose, transform
from skills.ports.grasping import item_in_map
from skills.ports.hardware import RgbdHeader, RobotDescription
from skills.ports.image import decode
from skills.ports.keys import STOP_STATE, Latest
from skills.ports.message import RobotTime
from skills.ports.site import Site
from skills.ports.skill import ActionType, Command, Run, Slice, canceled, failed, succeeded
from skills.ports.world import CLUTTER, SCENE, SIGHTINGS, WORLD, Box, Clutter, Sighting, Sightings

POSE_AFTER: Final = 1.0
"""Robot seconds for joints and the robot's pose to be heard."""
SETTLE: Final = 0.05
"""Robot seconds between the head's rest and the picture: what still swings, settles."""
WORK_AFTER: Final = 20.0
"""Robot seconds for a worker to read a picture: its first start takes a while."""
BLIND_AFTER: Final = 1.5
"""Robot seconds for which a look waits for a picture that shows something, once one did not."""
REST_AFTER: Final = 3.0
"""Robot seconds for the head to come to rest after a cancel."""

Steps = Generator[LookFeedback | Slice, Command, None]


@dataclass
class _Looking:
    """One run."""

    goal: LookGoal
    session: Session
    head: Head
    camera: Camera
    joints: JointHistory
    robot: RobotPoseHistory
    sightings: list[Sighting] = field(default_factory=list)
    points: Matrix = field(default_factory=lambda: np.zeros((0, 3)))
    shown: list[Box] = field(default_factory=list)
    boxes: int = 0
    stamp: RobotTime | None = None

    def found(self) -> bool:
        return any(each.item == self.goal.item for each in self.sightings)

    def close(self) -> None:
        self.camera.close()
        self.head.close()
        self.joints.close()
        self.robot.close()


class Look:
    """The skill behind ``perception/look``.

    Args:
        bus: where hardware and keeper are.
        clocks: robot time.
        description: the robot's: its head, its camera and where that is mounted.
        site: the items' tags and sizes, and the furniture.
        compute: who reads the pictures.
    """

    period: Final = 0.02

    def __init__(
        self, bus: Bus, clocks: Clocks, description: RobotDescription, site: Site, compute: Compute
    ) -> None:
        self._bus, self._clocks, self._site, self._compute = bus, clocks, site, compute
        self._aim, self._arms, self._mount = Aim(description), Arms(description), CameraMount(description)
        self._body_radius = description.footprint_radius
        self._sizes = tuple((each.item, each.tag_size) for each in site.items)
        self._furniture = tuple(box.box() for each in site.furniture for box in each.boxes)
        self._stop, self._blind = Latest(bus, STOP_STATE), BlindCheck()
        self._scene, self._world = Latest(bus, SCENE, depth=4), Latest(bus, WORLD, depth=4)

    @property
    def action(self) -> ActionType[LookGoal, LookFeedback, LookResult]:
        """The contract it fulfils."""
        return LOOK

    def check(self, goal: LookGoal) -> Failure | None:
        """Refuse items that the site does not know, and goals that look nowhere."""
        if goal.item is not None and self._site.item(goal.item) is None:
            known = ", ".join(str(each.item) for each in self._site.items)
            return Failure(
                kind=FailureKind.ITEM_UNKNOWN,
                message=f"no item {goal.item}; there are {known}",
                where=WHERE,
                evidence={"item": goal.item},
            )
        if goal.at is None and not goal.tilts:
            return Failure(
                kind=FailureKind.INVALID_GOAL,
                message="a point or at least one tilt was expected",
                where=WHERE,
            )
        return None

    def run(self, goal: LookGoal, goal_id: str) -> Run[LookFeedback, LookResult]:
        """Look, from one head position after the other."""
        joints, robot = JointHistory(self._bus), RobotPoseHistory(self._bus)
        head = Head(self._bus, self._aim.group, goal_id)

        def refresh() -> None:
            for inbox in (joints, robot, head):
                inbox.refresh()

        session = Session(self._clocks, self._stop, refresh)
        looking = _Looking(goal, session, head, Camera(self._bus), joints, robot)
        try:
            return (yield from self._look(looking))
        finally:
            looking.close()

    def _look(self, looking: _Looking) -> Run[LookFeedback, LookResult]:
        try:
            yield from self._know_where(looking)
            for number in range(1 if looking.goal.at is not None else len(looking.goal.tilts)):
                yield from self._one_view(looking, number)
                if looking.found():
                    break
        except Canceled:
            yield from _come_to_rest(looking)
            return canceled()
        except LookError as error:
            return failed(error.failure)
        return succeeded(self._result(looking))

    def _know_where(self, looking: _Looking) -> Steps:
        """Wait for the joints and for a pose that is localised."""
        yield from looking.session.breathe()
        heard = yield from looking.session.until(lambda: looking.joints.newest is not None, POSE_AFTER)
        if not heard:
            raise LookError(FailureKind.HARDWARE_LOST, f"no joint states within {POSE_AFTER} s")

        def localised() -> bool:
            newest = looking.robot.newest
            return newest is not None and newest.localised

        if not (yield from looking.session.until(localised, POSE_AFTER)):
            raise LookError(FailureKind.NOT_LOCALISED, "the robot's pose in the map is not known")

    def _one_view(self, looking: _Looking, number: int) -> Steps:
        """Point the head, take the pictures, publish what they show."""
        goal, session = looking.goal, looking.session
        newest = looking.joints.newest
        assert newest is not None
        positions = dict(zip(newest.names, newest.positions, strict=True))
        yield from looking.head.move(session, looking.joints, self._target(looking, number, positions))
        after = session.now + SETTLE
        seen: list[Sighting] = []
        missed: list[int] = []
        shot: Shot | None = None
        for taken in range(goal.pictures):
            stamp, shot = yield from self._shot(looking, after)
            if taken + 1 == goal.pictures:
                looking.camera.close()
            after = stamp.seconds + 1e-6
            found = yield from self._read(looking, shot)
            seen.extend(found.sightings)
            missed.extend(found.absent)
            session.pictures += 1
            looking.stamp = stamp
        view = merge(seen)
        looking.sightings.extend(view)
        session.seen = tuple(sorted({each.item for each in looking.sightings}))
        assert looking.stamp is not None
        # Only what every picture shows to be gone is gone.
        absent = tuple(sorted(item for item in set(missed) if missed.count(item) == goal.pictures))
        SIGHTINGS.publish(self._bus, Sightings(stamp=looking.stamp, sightings=view, absent=absent))
        if goal.clutter and shot is not None:
            yield from self._measure(looking, shot)

    def _target(self, looking: _Looking, number: int, positions: dict[str, float]) -> tuple[float, ...]:
        goal = looking.goal
        if goal.at is None:
            return self._aim.tilted(goal.tilts[number])
        newest = looking.robot.newest
        assert newest is not None
        return self._aim.at(transform(invert(to_pose(newest.base_in_map)), goal.at), positions)

    def _shot(
        self, looking: _Looking, after: float
    ) -> Generator[LookFeedback | Slice, Command, tuple[RobotTime, Shot]]:
        """Return the next picture that shows something, with its time.

        Raises:
            LookError: CAMERA_BLIND when all that come are dark or stand still.
        """
        session = looking.session
        blind_since: float | None = None
        while True:
            header, payload = yield from looking.camera.picture(session, after)
            shot = yield from self._placed(looking, header, payload)
            camera_in_map = compose(to_pose(shot.base_in_map), shot.camera_in_base)
            wrong = self._blind.wrong(decode(payload), camera_in_map)
            if not wrong:
                return header.stamp, shot
            blind_since = session.now if blind_since is None else blind_since
            waited = session.now - blind_since
            if waited >= BLIND_AFTER:
                raise LookError(FailureKind.CAMERA_BLIND, wrong, waited_s=waited)
            after = header.stamp.seconds + 1e-6

    def _placed(
        self, looking: _Looking, header: RgbdHeader, payload: bytes
    ) -> Generator[LookFeedback | Slice, Command, Shot]:
        """Say where the picture was taken from; wait until joints and pose of that moment are heard."""

        def shot() -> Shot | None:
            positions = looking.joints.positions(header.stamp)
            base = looking.robot.base_in_map(header.stamp)
            if positions is None or base is None:
                return None
            return Shot(payload, self._mount.camera_in_base(positions), base)

        if not (yield from looking.session.until(lambda: shot() is not None, POSE_AFTER)):
            raise LookError(
                FailureKind.NOT_LOCALISED,
                "the robot's pose at the picture's time is not known",
                stamp_s=header.stamp.seconds,
            )
        placed = shot()
        assert placed is not None
        return placed

    def _read(self, looking: _Looking, shot: Shot) -> Generator[LookFeedback | Slice, Command, TagsFound]:
        job = self._compute.submit(
            find_tags, TagJob(shot, self._sizes, self._standing(looking)), cost=tags.COST
        )
        if not (yield from looking.session.until(job.done, WORK_AFTER)):
            raise LookError(FailureKind.TIMED_OUT, "the picture was not read in time")
        return job.result()

    def _measure(self, looking: _Looking, shot: Shot) -> Steps:
        """Measure the clutter of this view; all views of a look make one set of boxes."""
        job = self._compute.submit(
            find_clutter,
            ClutterJob(shot, self._known(looking), self._believed(), looking.points),
            cost=clutter.COST,
        )
        if not (yield from looking.session.until(job.done, WORK_AFTER)):
            raise LookError(FailureKind.TIMED_OUT, "the clutter was not measured in time")
        found = job.result()
        looking.points, looking.boxes = found.points, len(found.boxes)
        looking.shown.extend(each for each in found.shown if each not in looking.shown)
        assert looking.stamp is not None
        CLUTTER.publish(self._bus, Clutter(stamp=looking.stamp, boxes=found.boxes, view=tuple(looking.shown)))

    def _known(self, looking: _Looking) -> clutter.Known:
        """Gather what explains points: furniture, items seen now or before, and the robot."""
        positions = looking.joints.newest
        assert positions is not None
        return clutter.Known(
            furniture=self._furniture,
            items=tuple(box for _, box in self._standing(looking)),
            segments=self._arms.segments(dict(zip(positions.names, positions.positions, strict=True))),
            body_radius=self._body_radius,
        )

    def _standing(self, looking: _Looking) -> tuple[tuple[int, Box], ...]:
        """Return the boxes of the items that stand upright, as seen in this look or believed, by item."""
        poses = {}
        world = self._world.refresh()
        if world is not None:
            poses = {fact.item: fact.tag_in_map for fact in world.items if fact.held is None}
        poses |= {each.item: each.tag_in_map for each in looking.sightings}
        boxes = []
        for number, tag_in_map in sorted(poses.items()):
            item = self._site.item(number)
            if item is None:
                continue
            try:
                boxes.append((number, Box(size=item.size, pose=item_in_map(tag_in_map, item.size[0]))))
            except ValueError:
                continue
        return tuple(boxes)

    def _believed(self) -> tuple[Box, ...]:
        scene = self._scene.refresh()
        return () if scene is None else tuple(each.box for each in scene.objects if each.kind == "clutter")

    def _result(self, looking: _Looking) -> LookResult:
        return LookResult(
            found=looking.goal.item is None or looking.found(),
            sightings=merge(looking.sightings),
            clutter=looking.boxes,
        )


def _come_to_rest(looking: _Looking) -> Steps:
    """Stop the head; a second cancel changes nothing."""
    looking.camera.close()
    looking.head.halt()
    end = looking.session.now + REST_AFTER
    while not looking.head.at_rest and looking.session.now < end:
        yield LookFeedback(pictures=looking.session.pictures, seen=looking.session.seen)
        looking.head.refresh()
