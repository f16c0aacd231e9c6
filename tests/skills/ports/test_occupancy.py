"""Occupied space as a message: packed, read, and refused when it is wrong."""

import numpy as np
import pytest
from pydantic import ValidationError

from tandem.skills.ports.lattice import OUTSIDE, Lattice, centres_of, numbers_of, packed
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import Occupancy, pack

LATTICE = Lattice.over((-1.0, -2.0, 3.0, 2.0), 1.7, 0.05)


def message(cells: str) -> Occupancy:
    return Occupancy(
        stamp=RobotTime(boot="b", seconds=1.0),
        version=1,
        origin=LATTICE.origin,
        shape=LATTICE.shape,
        resolution=LATTICE.resolution,
        cells=cells,
    )


def test_a_point_lies_in_the_cell_whose_centre_is_nearest() -> None:
    points = np.random.default_rng(1).uniform((-1.0, -2.0, 0.0), (3.0, 2.0, 1.7), (200, 3))
    assert np.abs(LATTICE.centres(LATTICE.numbers(points)) - points).max() <= 0.025 + 1e-9
    assert LATTICE.numbers(np.array([[3.1, 0.0, 0.5], [0.0, 0.0, -0.01]])).tolist() == [OUTSIDE, OUTSIDE]


def test_what_is_packed_is_read_with_numpy_and_without() -> None:
    numbers = np.array([0, 7, 80, 80 * 80 * 33])
    told = message(packed(numbers))
    assert packed(numbers) == pack(numbers.tolist())
    assert numbers_of(told).tolist() == numbers.tolist() == list(told.numbers())
    corners = np.array(list(told.corners()))
    assert centres_of(told) == pytest.approx(corners + 0.025)
    assert Occupancy.model_validate_json(told.model_dump_json()) == told


@pytest.mark.parametrize(
    ("cells", "words"),
    [
        ("%%%%", "base64"),
        ("AAA=", "four bytes a cell"),
        (pack([5, 4]), "rising"),
        (pack([5, 5]), "rising"),
        (pack([80 * 80 * 34]), "below 217600, found 217600"),
    ],
)
def test_cells_that_are_none_are_refused_with_the_reason(cells: str, words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        message(cells)


def test_a_lattice_with_too_many_cells_is_refused() -> None:
    with pytest.raises(ValueError, match="expected a larger one"):
        Lattice.over((-500.0, -500.0, 500.0, 500.0), 1.7, 0.02)
