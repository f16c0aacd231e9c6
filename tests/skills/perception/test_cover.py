"""The views of a look around: all furniture within reach is shown, and nothing twice without need."""

from __future__ import annotations

import numpy as np

from tandem.skills import site
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.perception import cover
from tandem.skills.perception.aim import Aim
from tandem.skills.perception.cover import ViewsJob, further_views, surface_points
from tandem.skills.ports.pose import FloorPose
from tests.skills.perception.stage import DESCRIPTION

LAB = site.load("lab")
FURNITURE = tuple(box_in_map(box) for each in LAB.furniture for box in each.boxes)
WEST = FloorPose(x=0.0, y=0.2, yaw=0.3)
JOINTS = {"torso_lift_joint": 0.3}
AIM = Aim(DESCRIPTION)
WITHIN = 1.15


def job(base: FloorPose = WEST, *, seen_from: tuple[tuple[float, ...], ...] = ()) -> ViewsJob:
    return ViewsJob(AIM, DESCRIPTION.camera, FURNITURE, base, JOINTS, WITHIN, seen_from)


def test_points_are_on_tops_within_reach_and_above_them() -> None:
    points = surface_points(FURNITURE, WEST, WITHIN)
    assert set(np.round(points[:, 2], 3)) == {0.71, 0.86}, "the table's top, not its legs under it"
    assert np.hypot(points[:, 0] - WEST.x, points[:, 1] - WEST.y).max() <= WITHIN
    assert points[:, 0].max() > 1.0
    assert len(np.unique(points, axis=0)) == len(points)


def test_a_view_of_one_end_of_the_table_is_followed_by_views_of_the_rest() -> None:
    """The item is at the table's south-west corner; the mug, 0.4 m beside the picture, was swept away."""
    first = AIM.at((0.5, -0.35, 0.74), JOINTS)
    task = job(seen_from=(first,))
    views = further_views(task)
    points = surface_points(FURNITURE, WEST, WITHIN)
    mug = np.array([(0.80, 0.45, 0.76), (0.45, 0.85, 0.76)])
    assert not cover._shows(task, first, mug).all()
    assert np.any([cover._shows(task, head, mug) for head in views], axis=0).all()
    shown = np.any([cover._shows(task, head, points) for head in (first, *views)], axis=0)
    possible = np.any([cover._shows(task, head, points) for head in AIM.lattice(cover.LATTICE)], axis=0)
    assert (possible & ~shown).sum() < cover.LEAST
    assert 1 <= len(views) <= cover.MOST


def test_what_was_shown_is_not_looked_at_again() -> None:
    task = job(seen_from=further_views(job()))
    assert further_views(task) == ()


def test_far_from_furniture_nothing_is_looked_at() -> None:
    assert further_views(job(FloorPose(x=-1.2, y=1.0, yaw=0.0))) == ()
