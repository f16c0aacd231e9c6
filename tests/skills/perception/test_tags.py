"""Poses of tags against rendered truth."""

import math
from itertools import product

import numpy as np
import pytest

from tandem.skills.geometry.poses import angle_between, distance, rotate
from tandem.skills.perception import corners, tag_pose, tags
from tandem.skills.perception.rigid import rotation_of
from tests.skills.perception.pictures import FOCAL, HEIGHT, WIDTH, Face, picture, rotation, tag_at

SIZES = {29: 0.048, 7: 0.048}


def true_corners(face: Face) -> np.ndarray:
    half = face.tag_size / 2
    square = np.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]])
    points = square @ rotation(face.tag_in_camera).T + np.array(face.tag_in_camera.position)
    middle = np.array([(WIDTH - 1) / 2, (HEIGHT - 1) / 2])
    return FOCAL * points[:, :2] / points[:, 2:] + middle


@pytest.mark.parametrize("away", [0.6, 1.0, 1.6])
def test_edges_give_corners_within_a_tenth_of_a_pixel(away: float) -> None:
    face = Face(29, tag_at(away, 0.5, 0.3, right=0.05), 0.048)
    image = picture((face,), np.random.default_rng(2))
    grey = np.ascontiguousarray(image.colour[:, :, 0])
    (_, guess), *_ = tags.detect(grey)
    refined = corners.refine(grey, guess)
    assert refined is not None
    assert np.abs(refined[0] - true_corners(face)).max() < 0.1


@pytest.mark.parametrize("roll", [-0.03, -0.02, -0.01, 0.01, 0.02, 0.03])
def test_corners_of_a_large_tag_are_within_the_reach_of_their_refinement(roll: float) -> None:
    face = Face(29, tag_at(0.4, 0.0, 0.95, down=0.08, roll=roll), 0.16)
    grey = np.ascontiguousarray(picture((face,), np.random.default_rng(2), samples=2).colour[:, :, 0])
    ((_, guess),) = tags.detect(grey)
    assert np.abs(guess - true_corners(face)).max() < 4.0
    assert corners.refine(grey, guess) is not None


def test_a_tag_with_a_hidden_edge_is_not_refined() -> None:
    face = Face(29, tag_at(0.8, 0.0, 0.3), 0.048)
    grey = picture((face,), np.random.default_rng(2)).colour[:, :, 0].copy()
    guess = true_corners(face)
    grey[:, int(guess[:, 0].max()) - 8 :] = 120
    assert corners.refine(grey, guess) is None


def test_the_position_is_within_2_mm_at_1_m_up_to_45_degrees() -> None:
    rng = np.random.default_rng(3)
    errors = []
    for yaw, pitch in product((-0.78, -0.4, 0.0, 0.4, 0.78), (0.2, 0.5)):
        truth = tag_at(1.0, yaw, pitch, right=0.1, down=-0.05)
        up = rotate(truth.orientation, (0.0, 1.0, 0.0))
        (seen,) = tags.find(picture((Face(29, truth, 0.048),), rng, samples=4), SIZES, up)
        errors.append(distance(seen.tag_in_camera, truth))
        assert angle_between(seen.tag_in_camera.orientation, truth.orientation) < math.radians(2.0)
    assert np.median(errors) < 0.002
    assert max(errors) < 0.005


def test_the_axes_are_those_of_the_tag_frame() -> None:
    """Seen head-on and upright: x to the right of the picture, y up, z towards the camera."""
    truth = tag_at(0.8, 0.0, 0.0)
    (seen,) = tags.find(picture((Face(29, truth, 0.048),), np.random.default_rng(1)), SIZES)
    turn = rotation_of(seen.tag_in_camera)
    assert turn[:, 0] == pytest.approx([1, 0, 0], abs=0.03)
    assert turn[:, 1] == pytest.approx([0, -1, 0], abs=0.03)
    assert turn[:, 2] == pytest.approx([0, 0, -1], abs=0.03)
    assert turn[:, 0] == pytest.approx(np.cross(turn[:, 1], turn[:, 2]))


@pytest.mark.parametrize("yaw", [-0.6, -0.3, 0.3, 0.6])
def test_that_items_stand_upright_settles_which_of_two_poses(yaw: float) -> None:
    """Corners moved towards the mirrored pose mislead the picture alone, not the prior."""
    truth = tag_at(2.0, yaw, 0.4)
    face = Face(29, truth, 0.048)
    rng = np.random.default_rng(5)
    up = np.array(rotate(truth.orientation, (0.0, 1.0, 0.0)))
    header = picture((), rng).header
    for _ in range(20):
        disturbed = true_corners(face) + rng.normal(0.0, 0.25, (4, 2))
        found = tag_pose.estimate(header, disturbed, 0.048, None, up)
        assert found is not None
        assert angle_between(found.tag_in_camera.orientation, truth.orientation) < math.radians(25.0)


def test_depth_fixes_the_range_of_a_far_tag() -> None:
    truth = tag_at(2.0, 0.3, 0.4)
    face = Face(29, truth, 0.048)
    rng = np.random.default_rng(6)
    image = picture((face,), rng)
    points, pixels = tags.depth_image.inside(
        image.header, image.depth, true_corners(face), shrink=0.1, limit=150
    )
    with_depth, without = [], []
    for _ in range(20):
        disturbed = true_corners(face) + rng.normal(0.0, 0.25, (4, 2))
        for errors, measured in ((with_depth, tag_pose.DepthPoints(points, pixels)), (without, None)):
            found = tag_pose.estimate(image.header, disturbed, 0.048, measured)
            assert found is not None
            errors.append(distance(found.tag_in_camera, truth))
    assert np.median(with_depth) < 0.004
    assert np.median(without) > 0.010


def test_a_tag_of_another_size_than_the_depth_says_is_none_of_ours() -> None:
    image = picture((Face(29, tag_at(1.0, 0.2, 0.3), 0.030),), np.random.default_rng(1))
    assert tags.find(image, SIZES) == ()


def test_unknown_tags_and_empty_rooms_give_nothing() -> None:
    image = picture((Face(100, tag_at(0.8, 0.2, 0.3), 0.048),), np.random.default_rng(1))
    assert tags.find(image, SIZES) == ()
    noise = np.random.default_rng(1).integers(0, 255, (720, 1280, 3), dtype=np.uint8)
    assert tags.find(type(image)(image.header, noise, image.depth), SIZES) == ()


def test_quality_falls_with_angle_and_distance() -> None:
    rng = np.random.default_rng(1)

    def quality(away: float, yaw: float) -> float:
        (seen,) = tags.find(picture((Face(29, tag_at(away, yaw, 0.2), 0.048),), rng, samples=3), SIZES)
        return seen.quality

    assert quality(0.7, 0.2) > quality(0.7, 1.0)
    assert quality(0.7, 0.2) > quality(2.2, 0.2)


def test_two_faces_of_one_item_are_told_best_first() -> None:
    near = Face(29, tag_at(1.0, 0.3, 0.3, right=-0.05), 0.048)
    aslant = Face(29, tag_at(1.0, -1.0, 0.3, right=0.05), 0.048)
    first, second = tags.find(picture((near, aslant), np.random.default_rng(1)), SIZES)
    assert first.quality > second.quality
    assert distance(first.tag_in_camera, near.tag_in_camera) < 0.005
