"""Occupied space as a message: the cells of a lattice over the site, packed. Read without numpy.

``cells`` is base64 of the numbers of the occupied cells: unsigned 32-bit integers, little-endian, rising.
Cell number ``x + nx * (y + ny * z)`` of the ``shape`` (nx, ny, nz) is a cube of ``resolution`` metres, whose
lowest corner lies ``(x, y, z) * resolution`` from ``origin`` along the map's axes. ``skills.ports.lattice``
reads it with numpy; in plain Python ``Occupancy.numbers`` does.
"""

from __future__ import annotations

import base64
import binascii
import sys
from array import array
from collections.abc import Iterable
from enum import StrEnum
from typing import Annotated, Final, Literal

from pydantic import Field, model_validator

from tandem.skills.ports.message import Count, Message, RobotTime, Vector3

FORMAT: Final = 1
"""The version of the packing."""
MOST_CELLS: Final = 10_000
"""Cells in a message: 53 kB of text, below the 64 kB from which on a stopped reader is felt. It is 25 m2 of
surfaces that no site file names."""
LARGEST: Final = 2**32
"""Cells of a lattice: their numbers have 32 bits."""
Edge = Annotated[float, Field(ge=0.01, le=1.0)]
Cells = Annotated[int, Field(ge=1, le=1_000_000)]


class OccupancySetting(Message):
    """Whether and how occupied space is measured from depth: ``occupancy`` of a site file."""

    rate: Annotated[float, Field(gt=0.0, le=30.0)] = 1.0
    """Pictures a second. 1 suits a weak machine; a camera that gives fewer sets the pace."""
    resolution: Annotated[float, Field(ge=0.02, le=0.5)] = 0.05
    """Edge of a cell (m)."""
    range: Annotated[float, Field(ge=0.5, le=10.0)] = 4.0
    """Metres along the optical axis up to which depth fills and frees cells."""
    replaces_clutter: bool = True
    """The cells stand for what is unknown, and boxes of clutter are left out of the planning scene."""


class Occupancy(Message):
    """Space that is occupied by what no site file and no tag explains. Owner: perception. On change.

    A cell is kept until a picture looks through it. A new reader is told too.
    """

    format: Literal[1] = FORMAT
    stamp: RobotTime
    version: Count
    """Rises with each change of the cells."""
    origin: Vector3
    """The lowest corner of cell 0 (m, in the map)."""
    shape: tuple[Cells, Cells, Cells]
    """Cells along x, y and z."""
    resolution: Edge
    """Edge of a cell (m)."""
    cells: Annotated[str, Field(max_length=MOST_CELLS * 16 // 3 + 4)] = ""
    problem: str = ""
    """Why the last picture changed nothing; empty while pictures are good."""

    @model_validator(mode="after")
    def _readable(self) -> Occupancy:
        nx, ny, nz = self.shape
        if nx * ny * nz > LARGEST:
            raise ValueError(f"shape: expected at most {LARGEST} cells, found {nx * ny * nz}")
        last = -1
        for number in self.numbers():
            if number <= last:
                raise ValueError(f"cells: expected rising numbers, found {number} after {last}")
            last = number
        if last >= nx * ny * nz:
            raise ValueError(f"cells: expected numbers below {nx * ny * nz}, found {last}")
        return self

    def numbers(self) -> array[int]:
        """Return the numbers of the occupied cells, rising.

        Raises:
            ValueError: when the cells are not base64 of whole numbers.
        """
        return unpack(self.cells)

    def corners(self) -> Iterable[tuple[float, float, float]]:
        """Give the lowest corner of each occupied cell (m, in the map)."""
        nx, ny, _ = self.shape
        x0, y0, z0 = self.origin
        for number in self.numbers():
            rest, x = divmod(number, nx)
            z, y = divmod(rest, ny)
            yield x0 + x * self.resolution, y0 + y * self.resolution, z0 + z * self.resolution


class MapEdit(StrEnum):
    """What becomes of the map of occupied space."""

    SAVE = "SAVE"
    """It is written beside the site file, and read from there at each start."""
    CLEAR = "CLEAR"
    """It is empty; what stands there is seen again."""
    CLEAR_SAVED = "CLEAR_SAVED"
    """Likewise, and the saved file is deleted."""


class EditMap(Message):
    """Save or clear the map of occupied space; ``by`` names the client."""

    edit: MapEdit
    by: Annotated[str, Field(max_length=200)]


class MapEdited(Message):
    """What came of an edit."""

    done: bool
    cells: Count = 0
    """Occupied cells before it."""
    path: str = ""
    """The file, on the robot's computer; empty: there is none."""
    reason: str = ""
    """Why it was not done."""


class SavedMap(Message):
    """The file of a saved map."""

    site: str
    """Name of the site that it is a map of."""
    occupancy: Occupancy


def pack(numbers: Iterable[int]) -> str:
    """Return rising cell numbers as ``cells`` has them."""
    made = array(_U32, numbers)
    if sys.byteorder == "big":
        made.byteswap()
    return base64.b64encode(made.tobytes()).decode("ascii")


def unpack(cells: str) -> array[int]:
    """Return the numbers in ``cells``.

    Raises:
        ValueError: when it is not base64 of whole numbers.
    """
    try:
        packed = base64.b64decode(cells, validate=True)
    except (binascii.Error, ValueError) as error:
        raise ValueError(f"cells: expected base64, found something else: {error}") from None
    if len(packed) % 4:
        raise ValueError(f"cells: expected four bytes a cell, found {len(packed)} bytes")
    made = array(_U32)
    made.frombytes(packed)
    if sys.byteorder == "big":
        made.byteswap()
    return made


_U32: Final = next(code for code in "IL" if array(code).itemsize == 4)  # noqa: PLR2004
