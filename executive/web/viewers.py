"""Who looks on: each is told at its own pace, and what it has not read yet is one update, never a queue.

An update is an object of parts. A part named in ``MERGED`` is itself an object, of which the newer values
count; any other part is replaced. So a viewer that is frozen costs the memory of one whole picture, and goes
on with how things are now.
"""

from __future__ import annotations

import asyncio
import json
from collections.abc import Mapping
from functools import cached_property
from typing import Final

from pydantic import JsonValue

Update = dict[str, JsonValue]
MERGED: Final = frozenset({"tasks", "nodes", "joints", "reflexes", "pipelines", "robots", "hands", "lasers"})
MOST: Final = 32
"""Viewers at once."""


def merge(older: Update, newer: Mapping[str, JsonValue]) -> None:
    """Add the newer update to the older one."""
    if "whole" in newer:
        older.clear()  # it was of another end
    if "tree" in newer:
        older.pop("nodes", None)  # they were changes of the tree before
    for part, value in newer.items():
        known = older.get(part)
        if part in MERGED and isinstance(known, dict) and isinstance(value, dict):
            older[part] = {**known, **value}
        else:
            older[part] = value


class Told:
    """An update that all viewers are told. It becomes text once, for all who have read what was before it."""

    def __init__(self, update: Update) -> None:
        self.update = update

    @cached_property
    def text(self) -> str:
        """As it is sent."""
        return as_text(self.update)


def as_text(update: Update) -> str:
    """Return an update as it is sent."""
    return json.dumps(update, separators=(",", ":"))


class Viewer:
    """One page that is open, and what it has not been told yet."""

    def __init__(self, first: Update) -> None:
        self._pending: Update = first
        self._only: Told | None = None
        """What is pending, if that is one update that all are told."""
        self._news = asyncio.Event()
        self._news.set()

    def tell(self, told: Told) -> None:
        """Have it told when it is ready to hear."""
        if self._only is None and not self._pending:
            self._only = told
        else:
            if self._only is not None:
                merge(self._pending, self._only.update)
                self._only = None
            merge(self._pending, told.update)
        self._news.set()

    async def next(self) -> str:
        """Wait for news, and take all of it, as text."""
        await self._news.wait()
        self._news.clear()
        taken, only, self._pending, self._only = self._pending, self._only, {}, None
        return as_text(taken) if only is None else only.text
