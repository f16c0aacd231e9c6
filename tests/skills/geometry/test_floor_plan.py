"""The site from above, against points that were laid out by hand."""

import math

import pytest

from tandem.skills.geometry.floor_plan import FloorPlan
from tandem.skills.ports.site import Furniture, Site, SiteBox
from tandem.skills.site import load


def site(*boxes: SiteBox) -> Site:
    furniture = Furniture(name="table", boxes=boxes)
    return load("lab").model_copy(update={"furniture": (furniture,), "bounds": (-3.0, -3.0, 3.0, 3.0)})


TURNED = SiteBox(size=(2.0, 1.0, 0.7), centre=(0.0, 0.0, 0.35), yaw=math.pi / 2)


@pytest.mark.parametrize(
    ("x", "y", "room"),
    [
        (0.9, 0.0, 0.4),  # beside the long edge, which lies along y
        (0.0, 1.6, 0.6),
        (0.8, 1.4, 0.5),  # off a corner: 3-4-5
        (0.2, 0.2, 0.0),  # within
        (2.75, 0.0, 0.25),  # the wall is nearer
    ],
)
def test_room_is_the_distance_to_what_is_nearest(x: float, y: float, room: float) -> None:
    assert FloorPlan(site(TURNED)).room(x, y) == pytest.approx(room)


def test_a_disc_fits_where_there_is_room_for_its_radius() -> None:
    plan = FloorPlan(load("lab"))
    points = [(0.25 * i, 0.25 * j) for i in range(-12, 13) for j in range(-12, 13)]
    fits = [plan.has_room(x, y, 0.35) for x, y in points]
    assert fits == [plan.room(x, y) >= 0.35 for x, y in points]
    assert 0 < sum(fits) < len(fits)
