"""The lab's plan: room enough to drive, spots free of furniture, slots apart and within reach."""

from __future__ import annotations

import itertools
import math

import pytest

from tandem.skills.ports.site import Site, SiteBox
from tandem.skills.site import load


@pytest.fixture(scope="module")
def lab() -> Site:
    return load("lab")


def clearance(box: SiteBox, x: float, y: float) -> float:
    """Metres from a point to an unturned box in plan."""
    assert box.yaw == 0.0
    dx = max(0.0, abs(x - box.centre[0]) - box.size[0] / 2)
    dy = max(0.0, abs(y - box.centre[1]) - box.size[1] / 2)
    return math.hypot(dx, dy)


def test_spots_and_home_keep_off_the_furniture(lab: Site) -> None:
    boxes = [box for piece in lab.furniture for box in piece.boxes]
    for pose in (lab.home, *(spot.pose for spot in lab.spots)):
        assert min(clearance(box, pose.x, pose.y) for box in boxes) >= 0.45


def test_slots_lie_on_the_depot_near_its_edge_and_apart(lab: Site) -> None:
    depot = lab.depots[0]
    top = next(piece for piece in lab.furniture if piece.name == "depot").boxes[0]
    edge = top.centre[0] + top.size[0] / 2
    assert len(depot.slots) >= 6
    for slot in depot.slots:
        assert slot.position[2] == pytest.approx(top.centre[2] + top.size[2] / 2)
        assert 0.05 <= edge - slot.position[0] <= 0.25
        assert abs(slot.position[1] - top.centre[1]) <= top.size[1] / 2 - 0.05
    for a, b in itertools.combinations(depot.slots, 2):
        assert math.dist(a.position, b.position) >= 0.15


def test_a_tag_with_its_margin_fills_the_smallest_face(lab: Site) -> None:
    assert len(lab.items) >= 8
    for item in lab.items:
        assert item.tag_size == pytest.approx(0.8 * min(item.size))
        assert all(0.05 <= edge <= 0.07 for edge in item.size)
