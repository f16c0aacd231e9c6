"""What a real RGB-D camera does to a perfect picture: grain in the colour, noise and steps in the depth."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tandem.sim.scenario import Noise

DEPTH_RANGE: Final = (0.25, 8.0)
"""Metres between which the depth camera measures."""

TILE: Final = 2048
"""Edge of the square of noise that pictures are cut from: drawing it anew for each takes too long."""


class SensorNoise:
    """Noise for pictures of any size up to ``TILE``.

    The depth's standard deviation is ``depth_sigma`` z^2, as that of triangulation with a fixed error in
    disparity (Khoshelham and Elberink 2012, equation 8); the disparity comes in steps of ``depth_quantum``.
    """

    def __init__(self) -> None:
        self._tile = np.random.default_rng(0).standard_normal((TILE, TILE), dtype=np.float32)
        self._grain = np.zeros((TILE, TILE), dtype=np.int16)
        self._grain_sigma = 0.0

    def apply(
        self, colour: NDArray[np.uint8], depth: NDArray[np.float32], noise: Noise, rng: np.random.Generator
    ) -> tuple[NDArray[np.uint8], NDArray[np.uint16]]:
        """Return noisy colour, and noisy depth in mm.

        Args:
            colour: (height, width, 3) RGB.
            depth: (height, width) metres along the optical axis, inf where there is nothing.
            noise: how much.
            rng: says which.
        """
        return self._colour(colour, noise, rng), self._depth(depth, noise, rng)

    def _colour(self, colour: NDArray[np.uint8], noise: Noise, rng: np.random.Generator) -> NDArray[np.uint8]:
        if noise.image_sigma == 0.0:
            return colour
        if noise.image_sigma != self._grain_sigma:
            self._grain_sigma = noise.image_sigma
            self._grain = np.rint(self._tile * noise.image_sigma).astype(np.int16)
        height, width, channels = colour.shape
        noisy = colour.astype(np.int16)
        for channel in range(channels):
            noisy[:, :, channel] += self._grain[_window(height, width, rng)]
        return np.clip(noisy, 0, 255).astype(np.uint8)

    def _depth(
        self, depth: NDArray[np.float32], noise: Noise, rng: np.random.Generator
    ) -> NDArray[np.uint16]:
        height, width = depth.shape
        measured = (depth >= DEPTH_RANGE[0]) & (depth <= DEPTH_RANGE[1])
        z = np.where(measured, depth, np.float32(1.0))
        if noise.depth_sigma > 0.0:
            z = z + np.float32(noise.depth_sigma) * z * z * self._tile[_window(height, width, rng)]
        if noise.depth_quantum > 0.0:
            step = np.float32(noise.depth_quantum)
            z = 1.0 / (np.rint(1.0 / (z * step)) * step)
        millimetres = np.rint(z * 1000.0)
        return np.where(measured, millimetres, 0.0).astype(np.uint16)


def _window(height: int, width: int, rng: np.random.Generator) -> tuple[slice, slice]:
    row, column = int(rng.integers(0, TILE - height + 1)), int(rng.integers(0, TILE - width + 1))
    return slice(row, row + height), slice(column, column + width)
