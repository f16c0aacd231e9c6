"""The ledger's tasks with filters that the executive has not: kind, item, failure, node, label, week, text.

Ended tasks don't change. So they are asked for once, newest first, and kept; of each the document as it was
told, and what filters and counts need. As many are kept as a ledger keeps, and no more than fit into
``ROOM``: a server may live for years.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Annotated, Final, TypeVar

from pydantic import Field, JsonValue

from tandem.executive.client.aio import AsyncClient
from tandem.executive.client.errors import UnknownTaskError
from tandem.executive.security.links import utc
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import PAGE, TaskState, TaskStatus

K = TypeVar("K")
DAY: Final = 86_400
"""Seconds."""
SHOWN: Final = 50
"""Tasks on a page."""
LATELY: Final = 20
"""Tasks that are asked for first, once the others are known: most often no more are new."""
MOST: Final = 20_000
"""Ended tasks that are kept, the newest: as many as a ledger keeps (``Policy.keep_tasks``)."""
ROOM: Final = 128 << 20
"""Characters of documents that are kept: 20,000 have 24 MB (``PAGE``), but one request may have 64 kB."""
TOLD: Final = 40
"""Rows of each table of counts, and labels that are offered."""
SUCCEEDED, FAILED = str(TaskState.SUCCEEDED), str(TaskState.FAILED)
OPEN: Final = tuple(state for state in TaskState if not state.terminal)


class Filter(Message):
    """Which tasks are wanted; what is empty lets all pass."""

    state: str = ""
    kind: str = ""
    item: str = ""
    """Its name or its number, whichever the request has."""
    failure: str = ""
    """A kind of failure."""
    where: str = ""
    """The node or skill that the failure names."""
    label: str = ""
    """A label's name, or ``name=value``."""
    week: str = ""
    """Of acceptance, in UTC, such as ``2026-W48``."""
    text: Annotated[str, Field(max_length=200)] = ""
    """Somewhere in the id, the request, or the failure's words."""
    since: float = 0.0
    """UTC seconds."""
    days: Annotated[float, Field(ge=0, le=100_000)] = 0.0
    """Accepted in so many days before now, by this host's clock: a tablet's may be wrong. 0: at any time."""
    until: float = 0.0
    """UTC seconds; 0: until now."""
    page: Annotated[int, Field(ge=0, le=100_000)] = 0


@dataclass(frozen=True)
class Known:
    """What is kept of a task."""

    document: str
    """Its status as JSON."""
    state: str
    """As text: an enum's hash is a call, which is slow for thousands."""
    terminal: bool
    kind: str
    accepted: float
    week: str
    items: frozenset[str]
    labels: frozenset[str]
    failure: str
    where: str
    words: str
    took: float | None
    """Robot seconds."""

    def passes(self, wanted: Filter, items: frozenset[str]) -> bool:
        """Say whether it is one of those; ``items`` is all that the wanted item is called."""
        return (
            wanted.state in {"", self.state}
            and wanted.kind in {"", self.kind}
            and wanted.failure in {"", self.failure}
            and wanted.where in {"", self.where}
            and wanted.week in {"", self.week}
            and (not items or not items.isdisjoint(self.items))
            and (not wanted.label or wanted.label in self.labels)
            and self.accepted >= wanted.since
            and (not wanted.until or self.accepted <= wanted.until)
            and (not wanted.text or wanted.text.casefold() in self.words)
        )


class Past:
    """What is known of the ledger's tasks, newest first."""

    def __init__(self, now: Callable[[], float] = utc, most: int = MOST, room: int = ROOM) -> None:
        self._now, self._most, self._room = now, most, room
        self._known: dict[str, Known] = {}
        self._left_out = False  # whether there are older ones
        self._answered: tuple[Filter, list[Known], str] | None = None

    async def refresh(self, client: AsyncClient) -> None:
        """Ask for what is new; errors as the client's."""
        changed = await self._open_ones(client)
        found: dict[str, Known] = {}
        before, limit = 0, LATELY if self._known else PAGE
        while True:
            page = await client.history(before=before, limit=limit)
            met = any(each.task in self._known for each in page.tasks)
            found |= {each.task: known(each) for each in page.tasks}
            before, limit = page.more, PAGE
            if not before or met or len(found) >= self._most:
                break
        self._left_out |= bool(before) and not met
        changed |= found
        if any(self._known.get(task) != each for task, each in changed.items()) or not before:
            older = {task: each for task, each in self._known.items() if task not in found} if before else {}
            again = {task: changed[task] for task in older if task in changed}
            self._known = self._newest({**found, **older, **again})
            self._answered = None

    def _newest(self, known: Mapping[str, Known]) -> dict[str, Known]:
        """Return the newest that ended, as many as there is room for, and all that have not ended."""
        ended, room = 0, self._room
        kept = {}
        for task, each in known.items():
            room -= len(each.document)
            if each.terminal:
                ended += 1
                if ended > self._most or room < 0:
                    self._left_out = True
                    continue
            kept[task] = each
        return kept

    async def _open_ones(self, client: AsyncClient) -> dict[str, Known]:
        """Ask again how those stand that had not ended."""
        open_once = [task for task, each in self._known.items() if not each.terminal]
        found: dict[str, Known] = {}
        before = 0
        while open_once:
            page = await client.history(states=OPEN, before=before)
            found |= {each.task: known(each) for each in page.tasks if each.task in self._known}
            before = page.more
            if not before:
                break
        for task in open_once:
            if task not in found:
                with suppress(UnknownTaskError):
                    found[task] = known(await client.status(task))
        return found

    def answer(self, wanted: Filter, also: Iterable[str] = ()) -> str:
        """Return a page of the tasks that pass, with counts of all that do, as JSON.

        Args:
            wanted: which tasks.
            also: what the wanted item is called besides.
        """
        asked = wanted.model_copy(update={"page": 0})
        if self._answered is None or self._answered[0] != asked:  # else it is another page of the same
            items = frozenset(filter(None, (wanted.item, *also)))
            days = {"since": max(wanted.since, self._now() - wanted.days * DAY)} if wanted.days else {}
            passes = wanted.model_copy(update=days)
            passing = [each for each in self._known.values() if each.passes(passes, items)]
            self._answered = asked, passing, json.dumps(_counts(passing))
        _, passing, counts = self._answered
        start = wanted.page * SHOWN
        tasks = ",".join(each.document for each in passing[start : start + SHOWN])
        older = json.dumps(self._left_out)
        return f'{{"tasks":[{tasks}],"left_out":{older},{counts[1:]}'


def _counts(passing: Sequence[Known]) -> dict[str, JsonValue]:
    return {
        "count": len(passing),
        "pages": -(-len(passing) // SHOWN),
        "states": dict(_counted(each.state for each in passing)),
        "failures": dict(_counted(each.failure for each in passing if each.failure)),
        "kinds": _by_kind(passing),
        "weeks": _by_week(passing),
        "nodes": _by_node(passing),
        "labels": [*(label for label, _ in _counted(_labelled(passing))[:TOLD])],
    }


def known(status: TaskStatus) -> Known:
    """Return what is kept of a task."""
    failure = None if status.failure is None else status.failure.reason
    said = "" if status.failure is None else f"{status.failure.where} {status.failure.message}"
    return Known(
        document=status.model_dump_json(),
        state=str(status.state),
        terminal=status.state.terminal,
        kind=status.kind,
        accepted=status.accepted_at,
        week=week_of(status.accepted_at),
        items=frozenset(_items(status.request)),
        labels=frozenset(_labels(status.request)),
        failure="" if failure is None else str(failure.kind),
        where="" if failure is None else failure.where,
        words=f"{status.task} {status.request} {said}".casefold(),
        took=None if status.started is None or status.ended is None else status.ended.since(status.started),
    )


def week_of(utc: float) -> str:
    """Return the ISO week of UTC seconds."""
    year, week, _ = datetime.fromtimestamp(utc, UTC).isocalendar()
    return f"{year}-W{week:02d}"


def _by_kind(tasks: Iterable[Known]) -> list[JsonValue]:
    grouped = _grouped((each.kind, each) for each in tasks)
    ordered = sorted(grouped.items(), key=lambda each: (-len(each[1]), each[0]))
    return [{"kind": kind, **_figures(own)} for kind, own in ordered]


def _by_week(tasks: Iterable[Known]) -> list[JsonValue]:
    """Return the newest weeks, of each the kinds by name."""
    grouped = _grouped(((each.week, each.kind), each) for each in tasks)
    ordered = sorted(grouped.values(), key=lambda own: own[0].kind)
    newest = sorted(ordered, key=lambda own: own[0].week, reverse=True)[:TOLD]
    return [{"week": own[0].week, "kind": own[0].kind, **_figures(own)} for own in newest]


def _by_node(tasks: Iterable[Known]) -> list[JsonValue]:
    counts = Counter((each.failure, each.where) for each in tasks if each.failure)
    ordered = sorted(counts.items(), key=lambda each: (-each[1], each[0]))[:TOLD]
    return [{"failure": failure, "where": where, "count": count} for (failure, where), count in ordered]


def _figures(tasks: Sequence[Known]) -> dict[str, JsonValue]:
    well = [each for each in tasks if each.state == SUCCEEDED]
    took = sorted(each.took for each in well if each.took is not None)
    return {
        "count": len(tasks),
        "succeeded": len(well),
        "decided": len(well) + sum(each.state == FAILED for each in tasks),
        "median": took[len(took) // 2] if took else None,
    }


def _grouped(tasks: Iterable[tuple[K, Known]]) -> dict[K, list[Known]]:
    grouped: dict[K, list[Known]] = {}
    for name, each in tasks:
        grouped.setdefault(name, []).append(each)
    return grouped


def _counted(words: Iterable[str]) -> list[tuple[str, int]]:
    return sorted(Counter(words).items(), key=lambda each: (-each[1], each[0]))


def _labelled(tasks: Iterable[Known]) -> Iterable[str]:
    return (label for each in tasks for label in each.labels if "=" in label)


def _labels(request: dict[str, JsonValue]) -> Iterable[str]:
    labels = request.get("labels")
    if isinstance(labels, dict):
        for name, value in labels.items():
            yield name
            yield f"{name}={value}"


def _items(request: dict[str, JsonValue]) -> set[str]:
    named = (request.get(name) for name in ("item", "left", "right"))
    many = request.get("items")
    return {str(each) for each in (*named, *(many if isinstance(many, list) else ())) if each is not None}
