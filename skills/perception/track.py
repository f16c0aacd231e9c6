"""Track: tell the tags of each picture while others move, until cancelled.

The object recorder (document 002, Algorithm 1) is the keeper's: here a tag that is not seen is simply not
told, and an item is absent only where several pictures in a row look through the place where it stood. An
arm before it ends the look through; so it is hidden then, and not gone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator
from typing import Final

from skills.perception.camera import Camera
from skills.perception.eye import Eye, View
from skills.perception.frames import JointHistory, RobotPoseHistory
from skills.perception.jobs import TagsFound
from skills.perception.session import Canceled, LookError, Session
from skills.ports.actions.perception import TRACK, LookFeedback, TrackGoal, TrackResult
from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.compute import Compute
from skills.ports.failure import Failure, FailureKind
from skills.ports.geometry import angle_between
from skills.ports.hardware import RobotDescription
from skills.ports.keys import STOP_STATE, Latest
from skills.ports.message import Quaternion, RobotTime
from skills.ports.site import Site
from skills.ports.skill import ActionType, Command, Run, Slice, canceled, failed
from skills.ports.world import SIGHTINGS, Sighting, Sightings

WHERE: Final = "perception/track"
GONE_AFTER: Final = 3
"""Pictures in a row that look through an item's place before it is told to be absent."""
MUCH_WORSE: Final = 0.5
"""Of the best face's quality: below it, an item's other face is told than before."""


class Track:
    """The skill behind ``perception/track``.

    Args:
        bus: where hardware and keeper are.
        clocks: robot time.
        description: the robot's: its camera and where that is mounted.
        site: the items' tags and sizes.
        compute: who reads the pictures.
    """

    period: Final = 0.02

    def __init__(
        self, bus: Bus, clocks: Clocks, description: RobotDescription, site: Site, compute: Compute
    ) -> None:
        self._bus, self._clocks, self._site = bus, clocks, site
        self._eye, self._stop = Eye(bus, description, site, compute), Latest(bus, STOP_STATE)
        self._faces: dict[int, Quaternion] = {}

    @property
    def action(self) -> ActionType[TrackGoal, LookFeedback, TrackResult]:
        """The contract it fulfils."""
        return TRACK

    def check(self, goal: TrackGoal) -> Failure | None:
        """Refuse items that the site does not know."""
        strangers = [item for item in goal.items if self._site.item(item) is None]
        if not strangers:
            return None
        known = ", ".join(str(each.item) for each in self._site.items)
        return Failure(
            kind=FailureKind.ITEM_UNKNOWN,
            message=f"no item {strangers[0]}; there are {known}",
            where=WHERE,
            evidence={"item": strangers[0]},
        )

    def run(self, goal: TrackGoal, goal_id: str) -> Run[LookFeedback, TrackResult]:  # noqa: ARG002 - the contract's
        """Read one picture after the other."""
        self._faces = {}
        view = View(
            session=Session(self._clocks, self._stop),
            camera=Camera(self._bus),
            joints=JointHistory(self._bus),
            robot=RobotPoseHistory(self._bus),
        )
        view.session.refresh = view.refresh
        try:
            yield from self._eye.know_where(view)
            yield from self._follow(goal, view)
        except Canceled:
            return canceled()
        except LookError as error:
            return failed(error.failure.model_copy(update={"where": WHERE}))
        finally:
            view.close()
        raise AssertionError("it follows until it is cancelled or fails")

    def _follow(self, goal: TrackGoal, view: View) -> Generator[LookFeedback | Slice, Command, None]:
        after = view.session.now
        looked_through: Counter[int] = Counter()
        while True:
            stamp, shot = yield from self._eye.shot(view, after)
            after = stamp.seconds + 1e-6
            found = yield from self._eye.read(view, shot, self._eye.standing())
            looked_through = Counter({item: looked_through[item] + 1 for item in found.absent})
            gone = tuple(item for item, pictures in looked_through.items() if pictures >= GONE_AFTER)
            self._tell(goal, view, stamp, TagsFound(found.sightings, gone))

    def _same_faces(self, sightings: tuple[Sighting, ...]) -> list[Sighting]:
        """Return what is seen of each item's face that was told last, unless another is seen much better.

        An item that stands edgewise shows two faces about equally well; told in turns, it would seem to spin.
        """
        told = {}
        for item in sorted({each.item for each in sightings}):
            faces = [each for each in sightings if each.item == item]
            best = max(faces, key=lambda each: each.quality)
            last = self._faces.get(item)
            near = best if last is None else min(faces, key=lambda each: _between(each, last))
            told[item] = near if near.quality >= MUCH_WORSE * best.quality else best
        self._faces = {item: each.tag_in_map.orientation for item, each in told.items()} | {
            item: face for item, face in self._faces.items() if item not in told
        }
        return [told[item] for item in sorted(told)]

    def _tell(self, goal: TrackGoal, view: View, stamp: RobotTime, found: TagsFound) -> None:
        """Publish what was asked for."""
        wanted = set(goal.items or (each.item for each in self._site.items))
        seen = tuple(each for each in self._same_faces(found.sightings) if each.item in wanted)
        view.session.pictures += 1
        view.session.seen = tuple(each.item for each in seen)
        absent = tuple(sorted(wanted.intersection(found.absent)))
        SIGHTINGS.publish(self._bus, Sightings(stamp=stamp, sightings=seen, absent=absent))


def _between(sighting: Sighting, face: Quaternion) -> float:
    return angle_between(sighting.tag_in_map.orientation, face)
