"""A camera's picture for all who look on: asked for once, however many they are."""

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
    """Asks perception for the next picture of a camera.

    Args:
        monotonic: seconds of the host.
    """

    def __init__(self, monotonic: Callable[[], float] = time.monotonic) -> None:
        self._monotonic = monotonic
        self._asking = asyncio.Lock()
        self._shots: dict[str, Shot] = {}

    async def picture(self, client: AsyncClient, name: str = "") -> tuple[bytes, float]:
        """Return a JPEG (empty: there is none) and its age in host seconds; errors as the client's.

        Args:
            client: who asks.
            name: the camera's; empty: the first.
        """
        async with self._asking:
            now = self._monotonic()
            self._shots = {each: shot for each, shot in self._shots.items() if now - shot.came <= KEPT}
            if name not in self._shots:
                jpeg = await client.camera(name)
                self._shots[name] = Shot(jpeg, self._monotonic())
            shot = self._shots[name]
            return shot.jpeg, self._monotonic() - shot.came
