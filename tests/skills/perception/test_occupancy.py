"""Occupied space out of depth images of known boxes."""

from dataclasses import replace

import numpy as np
import pytest

from tandem.skills.geometry.poses import about, compose, invert, to_pose, transform
from tandem.skills.perception.clutter import Known
from tandem.skills.perception.jobs import Shot
from tandem.skills.perception.occupancy import MapJob, integrate, read_picture
from tandem.skills.ports.image import encode
from tandem.skills.ports.lattice import Lattice
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.world import Box
from tests.skills.perception.pictures import HEIGHT, WIDTH, header
from tests.skills.perception.solids import scene
from tests.skills.perception.stage import DESCRIPTION, URDF, Chain

BASE = FloorPose(x=0.1, y=0.05, yaw=0.05)
CAMERA = Chain.from_urdf(URDF, DESCRIPTION.base_frame, "optical").pose({"pan": 0.0, "tilt": -0.4})
TABLE = Box(size=(0.9, 1.2, 0.04), pose=Pose(position=(1.3, 0.0, 0.69)))
CARTON = Box(size=(0.2, 0.3, 0.3), pose=Pose(position=(1.2, 0.2, 0.86), orientation=about((0, 0, 1), 0.5)))
BEHIND = Box(size=(0.1, 0.1, 0.1), pose=Pose(position=(1.6, 0.32, 0.76)))
LATTICE = Lattice.over((-2.0, -3.0, 6.0, 3.0), 1.7, 0.05)
NOTHING = np.zeros(0, np.int64)


def looked(
    boxes: tuple[Box, ...], occupied: np.ndarray = NOTHING, known: Known | None = None, seed: int = 1
) -> np.ndarray:
    image = scene(header(), compose(to_pose(BASE), CAMERA), boxes, np.random.default_rng(seed))
    job = MapJob(
        Shot(encode(image), CAMERA, BASE), LATTICE, occupied, known or Known((TABLE,), ()), (WIDTH, HEIGHT)
    )
    found = read_picture(job)
    assert not found.problem
    return found.occupied


def away(numbers: np.ndarray, box: Box) -> np.ndarray:
    """Return how far (m) the centres of the cells are outside of a box."""
    local = np.array([transform(invert(box.pose), tuple(each)) for each in LATTICE.centres(numbers)])
    return np.linalg.norm(np.maximum(np.abs(local) - np.array(box.size) / 2, 0.0), axis=1)


def test_what_stands_on_the_table_fills_cells_and_table_and_floor_do_not() -> None:
    assert len(looked((TABLE,))) == 0
    found = looked((TABLE, CARTON))
    assert len(found) > 50
    assert away(found, CARTON).max() < 0.06


def test_what_is_gone_is_freed_by_looking_through_and_what_is_hidden_is_kept() -> None:
    hidden = looked((TABLE, BEHIND))
    assert len(hidden)
    both = looked((TABLE, CARTON), hidden)
    assert set(hidden.tolist()) <= set(both.tolist())
    assert set(looked((TABLE, BEHIND), both, seed=2).tolist()) <= {
        *hidden.tolist(),
        *looked((TABLE, BEHIND), seed=2).tolist(),
    }
    assert len(looked((TABLE,), both, seed=3)) == 0


def test_what_the_picture_does_not_show_is_kept() -> None:
    aside = LATTICE.numbers(np.array([[1.0, 2.5, 0.8], [-1.0, 0.0, 0.8], [5.5, 0.0, 0.5]]))
    assert set(aside.tolist()) <= set(looked((TABLE,), np.sort(aside)).tolist())


def test_a_cell_that_is_hit_is_not_carved_in_the_same_picture() -> None:
    low = Box(size=(2.5, 1.0, 0.12), pose=Pose(position=(2.6, 0.0, 0.06)))
    first = looked((low,), known=Known((), ()))
    again = looked((low,), first, Known((), ()), seed=2)
    assert len(first) > 300
    assert np.isin(first, again).mean() > 0.97


@pytest.mark.parametrize(
    "known",
    [
        Known((TABLE,), (CARTON,)),
        Known((TABLE, CARTON), ()),
        Known((TABLE,), (), segments=(((1.1, 0.15, 0.7), (1.1, 0.15, 1.2)),)),
    ],
    ids=["an item", "furniture", "an arm"],
)
def test_what_is_known_fills_nothing_but_is_looked_past(known: Known) -> None:
    assert len(looked((TABLE, CARTON), known=known)) < 0.6 * len(looked((TABLE, CARTON)))


def test_an_item_that_is_recognised_later_gives_its_cells_back() -> None:
    before = looked((TABLE, CARTON))
    assert len(looked((TABLE, CARTON), before, Known((TABLE,), (CARTON,)))) == 0


DEPTH = np.full((HEIGHT, WIDTH), 1.5)


@pytest.mark.parametrize(
    ("depth", "words"),
    [
        (np.zeros_like(DEPTH), "found zeros"),
        (np.full_like(DEPTH, np.nan), "found no number"),
        (np.full_like(DEPTH, np.inf), "found no number"),
        (DEPTH[:480, :640], "expected a depth image of 1280 x 720, found 640 x 480"),
    ],
    ids=["zeros", "NaN", "infinity", "another size"],
)
def test_a_depth_image_that_proves_nothing_changes_nothing_and_is_told(depth: np.ndarray, words: str) -> None:
    occupied = LATTICE.numbers(np.array([[1.0, 0.0, 0.9]]))
    job = MapJob(Shot(b"", CAMERA, BASE), LATTICE, occupied, Known((), ()), (WIDTH, HEIGHT))
    found = integrate(job, header(), depth)
    assert words in found.problem
    assert found.occupied.tolist() == occupied.tolist()
    assert "expected an RGB-D payload" in read_picture(job).problem


def test_pixels_without_a_measurement_neither_fill_nor_free() -> None:
    occupied = LATTICE.numbers(np.array([[1.0, 0.05, 0.9]]))
    job = MapJob(Shot(b"", CAMERA, BASE), LATTICE, occupied, Known((), ()), (WIDTH, HEIGHT))
    wall, hole = np.full_like(DEPTH, 5.0), np.full_like(DEPTH, 5.0)
    hole[100:, 300:900] = np.nan
    assert len(integrate(job, header(), wall).occupied) == 0
    assert integrate(job, header(), hole).occupied.tolist() == occupied.tolist()
    assert len(integrate(replace(job, range=0.5), header(), wall).occupied) == 1
