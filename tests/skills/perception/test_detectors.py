"""Tags are one detector; others read the same pictures. One that raises costs what it would have seen."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from tandem.skills.geometry.poses import angle_between, distance
from tandem.skills.perception import tags
from tandem.skills.perception.detectors import TAGS, Detection, Detector, detectors, plugged
from tandem.skills.perception.jobs import Shot, TagJob, find_tags
from tandem.skills.ports.image import RgbdImage, encode
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.site import SiteItem
from tandem.skills.site import load
from tests.fakes.examples import example
from tests.fakes.packages import Installed
from tests.skills.perception.pictures import Face, picture, tag_at

ITEMS = tuple(each for each in load("lab").items if each.item in {29, 42})


def sees_42(image: RgbdImage, items: tuple[SiteItem, ...], up: Vector3) -> tuple[Detection, ...]:
    """See item 42 before the camera, and one that the site does not know."""
    assert up == (0.0, 0.0, 1.0)
    assert image.depth.ndim == 2
    found = Detection(42, Pose(position=(0.0, 0.0, 1.0)), distance=1.0, quality=0.5, position_sigma=0.01)
    stranger = Detection(500, found.tag_in_camera, distance=1.0, quality=0.5, position_sigma=0.01)
    return (found, stranger) if items else ()


def raises(image: RgbdImage, items: tuple[SiteItem, ...], up: Vector3) -> tuple[Detection, ...]:
    """Have no model."""
    raise OSError(f"no model for {len(items)} items, {image.depth.shape}, {up}")


def read(*chosen: Detector) -> tuple[list[int], int]:
    image = picture((Face(29, tag_at(1.0, 0.2, 0.4), 0.048),), np.random.default_rng(1), samples=3)
    shot = Shot(encode(image), Pose(), FloorPose(x=0, y=0, yaw=0))
    found = find_tags(TagJob(shot, ITEMS, detectors=chosen))
    return [each.item for each in found.sightings], len(found.troubles)


@pytest.mark.parametrize(
    ("chosen", "items", "troubles"),
    [
        ((tags.of_items,), [29], 0),
        ((tags.of_items, sees_42), [29, 42], 0),
        ((raises, tags.of_items), [29], 1),
    ],
)
def test_each_detector_adds_what_it_sees(
    chosen: tuple[Detector, ...], items: list[int], troubles: int
) -> None:
    assert read(*chosen) == (items, troubles)


def test_where_none_can_read_a_picture_the_reason_is_told() -> None:
    with pytest.raises(OSError, match="no model for 2 items"):
        read(raises)


def test_those_of_other_packages_come_after_tags(installed: Installed) -> None:
    source = "def colours(image, items, up):\n    return ()\nLAMBDA = lambda image, items, up: ()\n"
    entries = {"colours": "colours:colours", "lambda_": "colours:LAMBDA", "tags": "colours:colours"}
    installed.add("somebody", {"colours": source}, {"tandem.detectors": entries})
    assert list(detectors()) == [TAGS, "colours"]
    assert list(detectors(None)) == [TAGS]
    assert [each.plugin.name for each in plugged().broken] == ["lambda_", "tags"]


def test_an_item_without_a_tag_is_none_of_the_tags() -> None:
    plain = SiteItem(item=600, name="mug", size=(0.06, 0.06, 0.06))
    assert tags.sizes_of((*ITEMS, plain)) == {each.item: each.tag_size for each in ITEMS}


def test_a_detector_of_ones_own_tells_an_item_of_name_shape_and_colour() -> None:
    mug = SiteItem(item=600, name="mug", size=(0.08, 0.08, 0.08), colour=(0.9, 0.1, 0.1))
    face = tag_at(1.0, 0.3, 0.0, right=0.1)
    drawn = picture((Face(29, face, 0.8 * mug.size[1]),), np.random.default_rng(1), samples=3)
    red = np.where(drawn.depth[:, :, None] < 2000, np.array((200, 20, 20)), drawn.colour).astype(np.uint8)
    by_colour = example("by_colour").by_colour
    up_in_map = Pose(orientation=(-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)))  # looks along map's y
    shot = Shot(encode(replace(drawn, colour=red)), up_in_map, FloorPose(x=0, y=0, yaw=0))
    found = find_tags(TagJob(shot, (*ITEMS, mug), detectors=(tags.of_items, by_colour)))
    (seen,) = found.sightings
    assert seen.item == 600
    assert distance(seen.tag_in_camera, face) < 0.005
    assert angle_between(seen.tag_in_camera.orientation, face.orientation) < math.radians(3.0)
    assert found.troubles == ()
