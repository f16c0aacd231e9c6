"""How hands take a cylinder: from all around, about its axis, and a box as ever."""

from __future__ import annotations

import math

import pytest

from tandem.skills.geometry.poses import about, compose, distance, rotate, subtract
from tandem.skills.grasping.hand_grasps import MOST_AWAY, item_grasps
from tandem.skills.grasping.item_frames import face, item_in_map, tag_of_item
from tandem.skills.grasping.tag_grasps import APPROACH, PITCHES, grasps_on
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import RING, BoxShape, CylinderShape

TIN = CylinderShape(0.033, 0.09)
CARTON = BoxShape((0.066, 0.066, 0.09))
AT = Pose(position=(1.0, 2.0, 0.75), orientation=about((0, 0, 1), 0.4))
TAG = tag_of_item(AT, 0.066)


def ahead(tool: Pose) -> Vector3:
    return rotate(tool.orientation, (1.0, 0.0, 0.0))


def heading(tool: Pose) -> int:
    x, y, _ = ahead(tool)
    return round(math.degrees(math.atan2(y, x))) % 360


def test_all_quarters_together_take_a_cylinder_from_a_whole_ring() -> None:
    ways = [way for turns in range(4) for way in grasps_on(face(TAG, 0.066, turns), TIN, PITCHES, None)]
    assert len({heading(way.grasp) for way in ways}) == RING
    assert len(ways) == RING * len(PITCHES)


def test_the_seen_side_comes_first_with_each_pitch() -> None:
    ways = grasps_on(TAG, TIN, PITCHES, None)
    assert ways[: len(PITCHES)] == grasps_on(TAG, CARTON, PITCHES, None)


@pytest.mark.parametrize("number", range(3 * len(PITCHES)))
def test_each_way_goes_for_the_axis_from_before_it_and_knows_where_the_item_is_then(number: int) -> None:
    way = grasps_on(TAG, TIN, PITCHES, None)[number]
    assert way.grasp.position == pytest.approx(AT.position)
    back = subtract(way.pre_grasp.position, way.grasp.position)
    assert math.hypot(back[0], back[1]) == pytest.approx(APPROACH + TIN.radius)
    x, y, _ = ahead(way.grasp)
    assert back[0] * x + back[1] * y < 0.0
    item = compose(way.grasp, way.item_in_tool)
    assert distance(item, AT) == pytest.approx(0.0, abs=1e-9)
    assert rotate(item.orientation, (0, 0, 1)) == pytest.approx((0, 0, 1))


def test_a_deep_item_is_taken_before_its_middle_from_each_side() -> None:
    ways = grasps_on(TAG, TIN, (0.0,), 0.02)
    assert [round(math.dist(way.grasp.position, AT.position), 4) for way in ways] == [0.015] * 3


def test_one_hand_of_two_is_offered_the_ring_but_for_what_lies_behind() -> None:
    ways = item_grasps(TIN, math.pi)
    offs = [min(abs(heading(way.tool_in_item) - 180), 180) for way in ways]
    assert max(offs) <= math.degrees(MOST_AWAY)
    assert offs == sorted(offs)
    assert len({way.face for way in ways}) == 7
    assert [way.pitch for way in ways[: len(PITCHES)]] == list(PITCHES)


def test_a_box_is_offered_by_its_faces() -> None:
    assert [way.face for way in item_grasps(CARTON, math.pi)[:: len(PITCHES)]] == [0, 1, 3]


def test_the_item_is_behind_a_label_as_behind_a_face() -> None:
    assert item_in_map(TAG, 0.066).position == pytest.approx(AT.position)
