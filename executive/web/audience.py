"""Hears the robot while somebody looks on, and tells all who do. Without viewers nothing is done."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable
from typing import Final

from tandem.executive.client.errors import ClientError
from tandem.executive.web.feed import TICK, Feed
from tandem.executive.web.robot import Ears, Robot
from tandem.executive.web.viewers import MOST, Told, Update, Viewer

AGAIN_AFTER: Final = 1.0
"""Host seconds after which a router that did not answer is tried again."""
LINGER: Final = 2.0
"""Host seconds without viewers after which the ears are closed; a page loaded anew finds them open."""
_LOG = logging.getLogger(__name__)


class FullError(Exception):
    """There are as many viewers as there may be."""


class Audience:
    """Who looks on.

    Args:
        robot: whom they look at.
        monotonic: seconds of the host.
    """

    def __init__(self, robot: Robot, monotonic: Callable[[], float] = time.monotonic) -> None:
        self._robot, self._monotonic = robot, monotonic
        self._viewers: list[Viewer] = []
        self._work: asyncio.Task[None] | None = None
        self._feed: Feed | None = None
        self._link: Update = {"link": ""}
        self._heard = False

    @property
    def hears(self) -> bool:
        """Whether the bus is listened to."""
        return self._feed is not None

    def enter(self) -> Viewer:
        """Add a viewer; FullError when there are too many."""
        if len(self._viewers) >= MOST:
            raise FullError(f"{MOST} pages are open; close one of them")
        viewer = Viewer({**self._link} if self._feed is None else {**self._link, **self._feed.whole()})
        self._viewers.append(viewer)
        if self._work is None or self._work.done():
            self._work = asyncio.create_task(self._hear())
        return viewer

    def leave(self, viewer: Viewer) -> None:
        """Take a viewer out."""
        self._viewers.remove(viewer)

    async def close(self) -> None:
        """Stop hearing."""
        if self._work is not None:
            self._work.cancel()
            await asyncio.gather(self._work, return_exceptions=True)

    async def _hear(self) -> None:
        while self._viewers:
            try:
                ears = await self._robot.listen()
            except ClientError as error:
                self._tell_link(str(error))
                await asyncio.sleep(AGAIN_AFTER)
                continue
            try:
                await self._hear_by(ears)
            finally:
                self._feed = None
                ears.close()

    async def _hear_by(self, ears: Ears) -> None:
        feed = self._feed = Feed(
            ears.bus, self._monotonic, ears.commons, self._robot.options.robot, age=ears.age
        )
        knowing: asyncio.Task[None] | None = None
        self._tell_link("")
        there, empty_since, turn = False, None, self._monotonic()
        if self._heard:
            self._tell({**self._link, **feed.whole()})  # what is known is of another end
        self._heard = True
        try:
            while not ears.over():
                now = self._monotonic()
                empty_since = None if self._viewers else now if empty_since is None else empty_since
                if empty_since is not None and now - empty_since > LINGER:
                    return
                came, there = feed.executive_there and not there, feed.executive_there
                if came and (knowing is None or knowing.done()):
                    knowing = asyncio.create_task(self._know(feed))
                more = ears.turn()
                self._tell({**more, **feed.poll()})
                turn = max(turn + TICK, now)
                await asyncio.sleep(turn - now)
        finally:
            if knowing is not None:
                knowing.cancel()
            feed.close()

    async def _know(self, feed: Feed) -> None:
        """Ask an executive that has come what there is, and the hardware who it is."""
        try:
            client = await self._robot.client()
            tasks, tree = await client.tasks(), await client.tree()
            self._tell(feed.know(tasks, tree if tree.task else None))
            feed.describe(await client.description())
        except ClientError as error:
            _LOG.info("not known yet: %s", error)

    def _tell_link(self, words: str) -> None:
        self._link = {"link": words}
        self._tell(self._link)

    def _tell(self, update: Update) -> None:
        if update:
            told = Told(update)
            for viewer in self._viewers:
                viewer.tell(told)
