"""The camera's picture for all who look on: asked for once, however many they are."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from tandem.executive.client.aio import AsyncClient

KEPT: Final = 0.7
"""Host seconds for which a picture serves the next viewer, too: drawing one costs a simulation much."""


@dataclass(frozen=True)
class Shot:
    """A picture, and when it came (host seconds)."""

    jpeg: bytes
    """Empty: the camera sent none."""
    came: float


class Camera:
    """Asks perception for the head camera's next picture.

    Args:
        monotonic: seconds of the host.
    """

    def __init__(self, monotonic: Callable[[], float] = time.monotonic) -> None:
        self._monotonic = monotonic
        self._asking = asyncio.Lock()
        self._shot: Shot | None = None

    async def picture(self, client: AsyncClient) -> tuple[bytes, float]:
        """Return a JPEG (empty: there is none) and its age in host seconds; errors as the client's."""
        async with self._asking:
            if self._shot is None or self._monotonic() - self._shot.came > KEPT:
                jpeg = await client.camera()
                self._shot = Shot(jpeg, self._monotonic())
            return self._shot.jpeg, self._monotonic() - self._shot.came
