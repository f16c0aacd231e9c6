"""What is wrong with a picture on its way out of the camera: covered, or the same as before."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.ports.image import RgbdImage, decode, encode


def darken(payload: bytes) -> bytes:
    """Return the picture as with a covered lens: black, and no depth measured."""
    image = decode(payload)
    return encode(RgbdImage(image.header, np.zeros_like(image.colour), np.zeros_like(image.depth)))


@dataclass(eq=False)
class Freeze:
    """Shows the first picture that it was given from then on, under the stamps of the others."""

    _kept: RgbdImage | None = None

    def __call__(self, payload: bytes) -> bytes:
        """Return the kept picture with this one's header."""
        image = decode(payload)
        if self._kept is None:
            self._kept = image
        return encode(RgbdImage(image.header, self._kept.colour, self._kept.depth))
