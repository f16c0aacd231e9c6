"""Track: tell the tags of each picture while others move, until cancelled.

The object recorder (two-arm thesis, Algorithm 1) is the keeper's: here a tag that is not seen is simply not
told, and an item is absent only where several pictures in a row look through the place where it stood, or
show that in the open without the tag. An arm before it ends that; so it is hidden then, and not gone.

The head follows with its gaze what the goal says (``gaze.py``). While it moves, no picture is read: a real
camera's pictures smear, and its stamp and that of the joints never agree wholly.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Generator, Mapping
from dataclasses import dataclass, field
from typing import Final

from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import angle_between, compose, to_pose
from tandem.skills.perception.aim import Aim
from tandem.skills.perception.camera import Camera
from tandem.skills.perception.camera_frames import JointHistory, RobotPoseHistory
from tandem.skills.perception.detectors import Detector
from tandem.skills.perception.eye import Eye, Steps
from tandem.skills.perception.gaze import Gaze
from tandem.skills.perception.head import SETTLE, Head
from tandem.skills.perception.head_view import HeadView
from tandem.skills.perception.jobs import Shot, TagsFound
from tandem.skills.perception.merge import things
from tandem.skills.perception.session import Canceled, LookError, Session
from tandem.skills.ports.actions.perception import TRACK, LookFeedback, TrackGoal, TrackResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import STOP_STATE, Latest
from tandem.skills.ports.message import Quaternion, RobotTime, RobotTimer, Vector3
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import ActionType, Command, Run, Slice, canceled, failed
from tandem.skills.ports.world import SIGHTINGS, Sighting, Sightings

WHERE: Final = "perception/track"
GONE_AFTER: Final = 2
"""Pictures in a row that miss an item at its place before it is told to be absent."""
VIEWS: Final = 54
"""Head positions that are weighed in one slice, and the robot seconds that it is charged."""
VIEWS_COST: Final = 0.002
MUCH_WORSE: Final = 0.5
"""Of the best face's quality: below it, an item's other face is told than before."""


@dataclass
class _Tracking(HeadView):
    """One run."""

    goal: TrackGoal
    gaze: Gaze
    missed: Counter[int] = field(default_factory=Counter)
    timer: RobotTimer = field(default_factory=RobotTimer)
    """Robot seconds as its pictures count them."""


class Track:
    """The skill behind ``perception/track``.

    Args:
        bus: where hardware and keeper are.
        clocks: robot time.
        description: the robot's: its head, its camera and where that is mounted.
        site: the items' tags and sizes.
        compute: who reads the pictures.
        detectors: what recognises items in them, by name; tags when there is none.
    """

    period: Final = 0.02

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        description: RobotDescription,
        site: Site,
        compute: Compute,
        *,
        detectors: Mapping[str, Detector] | None = None,
    ) -> None:
        self._bus, self._clocks, self._site = bus, clocks, site
        self._eye, self._stop = (
            Eye(bus, description, site, compute, detectors=detectors),
            Latest(bus, STOP_STATE),
        )
        self._faces: dict[int, Quaternion] = {}
        self._places: dict[int, Vector3] = {}
        self._aim, self._lens = Aim(description), description.camera
        self._surfaces = tuple(box_in_map(box) for each in site.furniture for box in each.boxes)

    @property
    def action(self) -> ActionType[TrackGoal, LookFeedback, TrackResult]:
        """The contract it fulfils."""
        return TRACK

    def check(self, goal: TrackGoal) -> Failure | None:
        """Refuse items that the site does not know."""
        strangers = [item for item in (*goal.items, *goal.gaze) if self._site.item(item) is None]
        if not strangers:
            return None
        known = ", ".join(str(each.item) for each in self._site.items)
        return Failure(
            kind=FailureKind.ITEM_UNKNOWN,
            message=f"no item {strangers[0]}; there are {known}",
            where=WHERE,
            evidence={"item": strangers[0]},
        )

    def run(self, goal: TrackGoal, goal_id: str) -> Run[LookFeedback, TrackResult]:
        """Read one picture after the other."""
        self._faces, self._places = {}, {}
        view = _Tracking(
            session=Session(self._clocks, self._stop),
            camera=Camera(self._bus, self._lens.name),
            joints=JointHistory(self._bus),
            robot=RobotPoseHistory(self._bus),
            goal=goal,
            head=Head(self._bus, self._aim.group, goal_id),
            gaze=Gaze(self._lens, self._surfaces),
        )
        view.session.refresh = view.refresh
        try:
            yield from self._eye.know_where(view)
            yield from self._follow(view)
        except Canceled:
            view.camera.close()
            yield from view.head.come_to_rest(view.session)
            return canceled()
        except LookError as error:
            return failed(error.failure.model_copy(update={"where": WHERE}))
        finally:
            view.close()
        raise AssertionError("it follows until it is cancelled or fails")

    def _follow(self, view: _Tracking) -> Steps:
        after = view.session.stamp
        while True:
            stamp, shot = yield from self._eye.shot(view, after)
            after = stamp.plus(1e-6)
            found = yield from self._eye.read(view, shot, self._eye.standing())
            before = view.missed
            missing = (*found.absent, *found.unread)
            view.missed = Counter({item: before[item] + 1 for item in missing})
            gone = tuple(item for item, pictures in view.missed.items() if pictures >= GONE_AFTER)
            found = TagsFound(found.sightings, gone)
            self._tell(view, stamp, found)
            if view.goal.gaze and (yield from self._turned(view, stamp, shot, found)):
                after = view.session.stamp.plus(SETTLE)

    def _turned(
        self, view: _Tracking, stamp: RobotTime, shot: Shot, found: TagsFound
    ) -> Generator[LookFeedback | Slice, Command, bool]:
        """Turn the head to where it sees more of what it follows; say whether it had to."""
        gaze, now = view.gaze, view.timer.read(stamp)
        facts = {fact.item: fact for fact in self._eye.facts()}
        held = {item for item, fact in facts.items() if fact.held is not None}
        followed = set(view.goal.gaze) - held
        gaze.keep(followed)
        # Best first; a known place that is told again here was not seen again.
        told = {each.item: each.tag_in_map for each in reversed(found.sightings)}
        for item in sorted(followed):
            fact = facts.get(item)
            if item in told:
                gaze.see(item, told[item], self._seen_edge(item), now)
            elif fact is not None and not gaze.knows(item):
                gaze.see(item, fact.tag_in_map, self._seen_edge(item), now)
        camera_in_map = compose(to_pose(shot.base_in_map), shot.camera_in_base)
        gaze.look(camera_in_map, found.absent, now)
        newest = view.joints.newest
        if newest is None or not gaze.lacks(camera_in_map, now):
            return False
        joints = dict(zip(newest.names, newest.positions, strict=True))
        here = tuple(joints[name] for name in self._aim.group.joints), camera_in_map
        best, end, lattice = gaze.clearly(camera_in_map, now), here[0], self._aim.lattice()
        for first in range(0, len(lattice), VIEWS):
            views = [
                (head, compose(to_pose(shot.base_in_map), self._aim.camera_in_base(head, joints)))
                for head in lattice[first : first + VIEWS]
            ]
            best, end = max((best, end), gaze.best(views, here, now))
            yield from view.session.breathe(VIEWS_COST)
        if end == here[0]:
            return False
        yield from view.head.move(view.session, view.joints, end)
        return True

    def _seen_edge(self, item: int) -> float:
        known = self._site.item(item)
        assert known is not None, "a goal with an item that the site does not know is refused"
        return known.seen_edge

    def _same_faces(self, sightings: tuple[Sighting, ...]) -> list[Sighting]:
        """Return what is seen of each item's face that was told last, unless another is seen much better.

        An item that stands edgewise shows two faces about equally well; told in turns, it would seem to spin.
        Of several things with one number the one nearest to where it was told last is told so, and then the
        others by their best face.
        """
        told, doubles = dict[int, Sighting](), list[Sighting]()
        for item in sorted({each.item for each in sightings}):
            faces, *others = self._things(item, sightings)
            doubles += [max(other, key=lambda each: each.quality) for other in others]
            best = max(faces, key=lambda each: each.quality)
            last = self._faces.get(item)
            near = best if last is None else min(faces, key=lambda each: _between(each, last))
            told[item] = near if near.quality >= MUCH_WORSE * best.quality else best
        self._faces = {item: each.tag_in_map.orientation for item, each in told.items()} | {
            item: face for item, face in self._faces.items() if item not in told
        }
        self._places |= {item: each.tag_in_map.position for item, each in told.items()}
        return [*(told[item] for item in sorted(told)), *doubles]

    def _things(self, number: int, sightings: tuple[Sighting, ...]) -> list[list[Sighting]]:
        """Return a number's sightings by thing, first that which was followed so far."""
        item = self._site.item(number)
        assert item is not None, "only tags of the site's items are read"
        found = things([each for each in sightings if each.item == number], item.size)
        last = self._places.get(number)
        if last is None:
            return found
        return sorted(
            found, key=lambda thing: min(math.dist(each.tag_in_map.position, last) for each in thing)
        )

    def _tell(self, view: _Tracking, stamp: RobotTime, found: TagsFound) -> None:
        """Publish what was asked for."""
        wanted = set(view.goal.items or (each.item for each in self._site.items))
        seen = tuple(each for each in self._same_faces(found.sightings) if each.item in wanted)
        view.session.pictures += 1
        view.session.seen = tuple(each.item for each in seen)
        absent = tuple(sorted(wanted.intersection(found.absent)))
        SIGHTINGS.publish(self._bus, Sightings(stamp=stamp, sightings=seen, absent=absent))


def _between(sighting: Sighting, face: Quaternion) -> float:
    return angle_between(sighting.tag_in_map.orientation, face)
