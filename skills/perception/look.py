"""Look: point the head, take pictures, tell which tags are where and what else stands there."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeAlias

import numpy as np

from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import invert, to_pose, transform
from tandem.skills.perception import clutter, cover
from tandem.skills.perception.aim import Aim
from tandem.skills.perception.arms import Arms
from tandem.skills.perception.camera import Camera
from tandem.skills.perception.camera_frames import JointHistory, RobotPoseHistory
from tandem.skills.perception.cover import ViewsJob, further_views
from tandem.skills.perception.detectors import Detector
from tandem.skills.perception.eye import WORK_AFTER, Eye, Steps
from tandem.skills.perception.head import SETTLE, Head
from tandem.skills.perception.head_view import HeadView
from tandem.skills.perception.jobs import ClutterJob, Shot, TagsFound, find_clutter
from tandem.skills.perception.merge import merge
from tandem.skills.perception.rigid import Matrix
from tandem.skills.perception.session import Canceled, LookError, Session
from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute, Job
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import STOP_STATE, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import ActionType, Command, Run, Slice, canceled, failed, succeeded
from tandem.skills.ports.world import CLUTTER, SCENE, SIGHTINGS, Box, Clutter, Sighting, Sightings

WHERE: Final = "perception/look"
Views: TypeAlias = tuple[tuple[float, ...], ...]
"""Positions of the head (rad)."""


@dataclass
class _Looking(HeadView):
    """One run."""

    goal: LookGoal
    sightings: list[Sighting] = field(default_factory=list)
    points: Matrix = field(default_factory=lambda: np.zeros((0, 3)))
    shown: list[Box] = field(default_factory=list)
    boxes: int = 0
    stamp: RobotTime | None = None
    hidden: set[int] = field(default_factory=set)
    """Items whose place the last view that showed it showed covered."""
    heads: list[tuple[float, ...]] = field(default_factory=list)
    """Positions of the head from which a picture was to be taken."""
    short: float = 0.0
    """Radians by which the head stopped short in a view that the goal names."""

    def positions(self) -> dict[str, float]:
        """Return where the joints are, by name."""
        newest = self.joints.newest
        assert newest is not None
        return dict(zip(newest.names, newest.positions, strict=True))

    def found(self) -> bool:
        return any(each.item == self.goal.item for each in self.sightings)


class Look:
    """The skill behind ``perception/look``.

    Args:
        bus: where hardware and keeper are.
        clocks: robot time.
        description: the robot's: its head, its camera and where that is mounted.
        site: the items' tags and sizes, and the furniture.
        compute: who reads the pictures.
        detectors: what recognises items in them, by name; tags when there is none.
        taken: is given the last picture of each view.
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
        taken: Callable[[Shot], None] | None = None,
    ) -> None:
        self._taken = taken
        self._bus, self._clocks, self._site, self._compute = bus, clocks, site, compute
        self._aim, self._arms, self._lens = Aim(description), Arms(description), description.camera
        self._eye = Eye(bus, description, site, compute, detectors=detectors)
        self._body_radius = description.footprint_radius
        self._sizes = {each.item: each.size for each in site.items}
        self._furniture = tuple(box_in_map(box) for each in site.furniture for box in each.boxes)
        self._stop, self._scene = Latest(bus, STOP_STATE), Latest(bus, SCENE, depth=4)

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
                message="expected a point or at least one tilt",
                where=WHERE,
            )
        return None

    def run(self, goal: LookGoal, goal_id: str) -> Run[LookFeedback, LookResult]:
        """Look, from one head position after the other."""
        looking = _Looking(
            session=Session(self._clocks, self._stop),
            camera=Camera(self._bus, self._lens.name),
            joints=JointHistory(self._bus),
            robot=RobotPoseHistory(self._bus),
            goal=goal,
            head=Head(self._bus, self._aim.group, goal_id),
        )
        looking.session.refresh = looking.refresh
        try:
            return (yield from self._look(looking))
        finally:
            looking.close()

    def _look(self, looking: _Looking) -> Run[LookFeedback, LookResult]:
        try:
            yield from self._eye.know_where(looking)
            yield from self._views(looking)
        except Canceled:
            looking.camera.close()
            yield from looking.head.come_to_rest(looking.session)
            return canceled()
        except LookError as error:
            return failed(error.failure.model_copy(update={"where": WHERE}))
        return succeeded(self._result(looking))

    def _views(self, looking: _Looking) -> Steps:
        """Take all views; the last one's pictures are read while the head turns to the next.

        Where else to look is found out while the pictures of the point looked at are taken.
        """
        goal, reading = looking.goal, _nothing()
        choices: list[Job[Views]] = []

        def choose() -> None:
            if goal.at is not None and goal.around > 0.0:
                choices.append(self._choice(looking))

        for number in range(1 if goal.at is not None else len(goal.tilts)):
            yield from reading
            if looking.found():
                break
            target = self._target(looking, number)
            reading = yield from self._one_view(looking, target, goal.pictures, there=choose)
            looking.short = max(looking.short, looking.head.short)
        if goal.around > 0.0:
            choice = choices[-1] if choices else self._choice(looking)
            reading = yield from self._look_around(looking, reading, choice)
        yield from reading

    def _choice(self, looking: _Looking) -> Job[Views]:
        """Have the further head positions chosen that show furniture near by."""
        robot = looking.robot.newest
        assert robot is not None
        job = ViewsJob(
            aim=self._aim,
            camera=self._lens,
            furniture=self._furniture,
            base_in_map=robot.base_in_map,
            joints=looking.positions(),
            within=min(looking.goal.around, self._arms.reach),
            seen_from=tuple(looking.heads),
        )
        return self._compute.submit(further_views, job, cost=cover.COST)

    def _look_around(
        self, looking: _Looking, reading: Steps, choice: Job[Views]
    ) -> Generator[LookFeedback | Slice, Command, Steps]:
        """Take a picture from each further head position."""
        if not (yield from looking.session.until(choice.done, WORK_AFTER)):
            raise LookError(FailureKind.TIMED_OUT, "the further views were not chosen in time")
        for head in choice.result():
            reading = yield from self._one_view(looking, head, 1, meanwhile=reading)
        return reading

    def _one_view(
        self,
        looking: _Looking,
        head: tuple[float, ...],
        pictures: int,
        *,
        meanwhile: Steps | None = None,
        there: Callable[[], None] | None = None,
    ) -> Generator[LookFeedback | Slice, Command, Steps]:
        """Point the head and take the pictures; return what is left to do: to read them and tell.

        ``meanwhile`` is done while the head turns, ``there`` called once it is there.
        """
        session = looking.session
        looking.heads.append(head)
        yield from looking.head.move(session, looking.joints, head, meanwhile)
        if there is not None:
            there()
        after, standing = session.stamp.plus(SETTLE), self._eye.standing(looking.sightings)
        taken: list[tuple[RobotTime, Shot, Job[TagsFound]]] = []
        for _ in range(pictures):
            stamp, shot = yield from self._eye.shot(looking, after)
            after = stamp.plus(1e-6)
            taken.append((stamp, shot, self._eye.reading(shot, standing)))
        looking.camera.close()
        return self._read(looking, taken)

    def _read(self, looking: _Looking, taken: list[tuple[RobotTime, Shot, Job[TagsFound]]]) -> Steps:
        """Take in what the pictures of one view show, and publish it."""
        session = looking.session
        seen: list[Sighting] = []
        missed: list[int] = []
        for stamp, _, job in taken:
            found = yield from self._eye.found(looking, job)
            seen.extend(found.sightings)
            missed.extend(found.absent)
            looking.hidden.difference_update((*found.absent, *found.unread))
            looking.hidden.update(found.hidden)
            session.pictures += 1
            looking.stamp = stamp
        view = merge(seen, self._sizes)
        looking.sightings.extend(view)
        session.seen = tuple(sorted({each.item for each in looking.sightings}))
        assert looking.stamp is not None
        # Only what every picture shows to be gone is gone.
        absent = tuple(sorted(item for item in set(missed) if missed.count(item) == len(taken)))
        SIGHTINGS.publish(self._bus, Sightings(stamp=looking.stamp, sightings=view, absent=absent))
        _, shot, _ = taken[-1]
        if self._taken is not None:
            self._taken(shot)
        if looking.goal.clutter:
            yield from self._measure(looking, shot)

    def _target(self, looking: _Looking, number: int) -> tuple[float, ...]:
        goal = looking.goal
        if goal.at is None:
            return self._aim.tilted(goal.tilts[number])
        newest = looking.robot.newest
        assert newest is not None
        return self._aim.at(transform(invert(to_pose(newest.base_in_map)), goal.at), looking.positions())

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
        return clutter.Known(
            furniture=self._furniture,
            items=(
                *(box for _, box in self._eye.standing(looking.sightings)),
                *self._eye.doubles(looking.sightings),
            ),
            segments=self._arms.segments(looking.positions()),
            body_radius=self._body_radius,
        )

    def _believed(self) -> tuple[Box, ...]:
        scene = self._scene.refresh()
        return () if scene is None else tuple(each.box for each in scene.objects if each.kind == "clutter")

    def _result(self, looking: _Looking) -> LookResult:
        seen = {each.item for each in looking.sightings}
        return LookResult(
            found=looking.goal.item is None or looking.found(),
            sightings=merge(looking.sightings, self._sizes),
            hidden=tuple(sorted(looking.hidden - seen)),
            clutter=looking.boxes,
            head_short=looking.short,
        )


def _nothing() -> Steps:
    """Do nothing: no picture has been taken."""
    yield from ()
