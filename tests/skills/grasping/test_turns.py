"""How far a hand may be turned about an item: as far as the open fingers have room for its corners."""

from __future__ import annotations

import math

import pytest

from tandem.skills.geometry.poses import compose, distance, from_rpy
from tandem.skills.grasping.item_frames import item_in_map, tag_of_item
from tandem.skills.grasping.tag_grasps import grasp
from tandem.skills.grasping.turns import MOST, to_grasp
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import RING, BoxShape, CylinderShape

AT = (0.5, 0.2, 0.8)


def wide(box: BoxShape, angle: float) -> float:
    return box.size[1] * math.cos(angle) + box.size[0] * math.sin(angle)


@pytest.mark.parametrize("box", [BoxShape((0.06, 0.06, 0.06)), BoxShape((0.14, 0.05, 0.1))])
def test_a_turned_box_still_fits_between_the_open_fingers(box: BoxShape) -> None:
    most = to_grasp(AT, box, 0.2).most
    assert 0.0 < most <= MOST
    assert wide(box, most) <= box.size[1] + 0.0101


def test_a_hand_that_hardly_opens_further_than_the_box_takes_it_straight() -> None:
    assert to_grasp(AT, BoxShape((0.06, 0.06, 0.06)), 0.065).most == 0.0


def test_the_sides_of_a_cylinder_are_no_farther_apart_than_it_may_be_turned() -> None:
    assert to_grasp(AT, CylinderShape(0.033, 0.09), 0.085).most == pytest.approx(math.pi / RING)


def test_a_turned_grasp_meets_the_item_where_it_is_and_holds_it_as_before() -> None:
    tag = tag_of_item(Pose(position=AT, orientation=from_rpy(0.0, 0.0, 0.3)), 0.06)
    way = grasp(tag, 0.06, 0.8, back=0.01)
    turned = way.turned(0.15)
    assert distance(compose(turned.grasp, turned.item_in_tool), item_in_map(tag, 0.06)) < 1e-9
    assert turned.item_in_tool == way.item_in_tool
    assert distance(turned.pre_grasp, way.pre_grasp) > 0.01
