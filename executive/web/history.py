"""The ledger's tasks with filters that the executive has not: kind, item, kind of failure, text.

Ended tasks don't change. So they are asked for once, newest first, and kept as long as the server lives.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, Final

from pydantic import Field, JsonValue

from tandem.executive.client.aio import AsyncClient
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import PAGE, TaskState, TaskStatus

SHOWN: Final = 50
"""Tasks on a page."""


class Filter(Message):
    """Which tasks are wanted; what is empty lets all pass."""

    state: str = ""
    kind: str = ""
    item: str = ""
    failure: str = ""
    """A kind of failure."""
    text: Annotated[str, Field(max_length=200)] = ""
    """Somewhere in the id, the request, or the failure's words."""
    since: float = 0.0
    """UTC seconds."""
    until: float = 0.0
    """UTC seconds; 0: until now."""
    page: Annotated[int, Field(ge=0, le=100_000)] = 0

    def passes(self, status: TaskStatus) -> bool:
        """Say whether a task is one of them."""
        failure = "" if status.failure is None else str(status.failure.reason.kind)
        return (
            self.state in {"", str(status.state)}
            and self.kind in {"", status.kind}
            and (not self.item or self.item in _items(status.request))
            and (not self.failure or failure == self.failure)
            and status.accepted_at >= self.since
            and (not self.until or status.accepted_at <= self.until)
            and (not self.text or self.text.casefold() in _words(status))
        )


class Past:
    """What is known of the ledger's tasks."""

    def __init__(self) -> None:
        self._known: dict[str, TaskStatus] = {}
        self._order: list[str] = []  # newest first
        self._complete = False

    async def refresh(self, client: AsyncClient) -> None:
        """Ask for what is new; errors as the client's."""
        found: dict[str, TaskStatus] = {}
        before = 0
        open_ones = {task for task, status in self._known.items() if not status.state.terminal}
        while True:
            page = await client.history(before=before, limit=PAGE)
            met = [each for each in page.tasks if each.task in self._known]
            found |= {each.task: each for each in page.tasks}
            open_ones -= found.keys()
            before = page.more
            known_from_here = met and self._complete and not open_ones
            if not before or known_from_here:
                break
        older = [task for task in self._order if task not in found]
        self._order = [*found, *older] if before else list(found)
        self._known = {task: found.get(task) or self._known[task] for task in self._order}
        self._complete = True

    def answer(self, wanted: Filter) -> dict[str, JsonValue]:
        """Return a page of the tasks that pass, with counts of all that do."""
        passing = [self._known[task] for task in self._order if wanted.passes(self._known[task])]
        start = wanted.page * SHOWN
        return {
            "tasks": [each.model_dump(mode="json") for each in passing[start : start + SHOWN]],
            "count": len(passing),
            "pages": -(-len(passing) // SHOWN),
            "states": dict(_counted(str(each.state) for each in passing)),
            "failures": dict(
                _counted(str(each.failure.reason.kind) for each in passing if each.failure is not None)
            ),
            "kinds": [_of_kind(kind, passing) for kind, _ in _counted(each.kind for each in passing)],
        }


def _of_kind(kind: str, tasks: list[TaskStatus]) -> dict[str, JsonValue]:
    own = [each for each in tasks if each.kind == kind]
    well = [each for each in own if each.state is TaskState.SUCCEEDED]
    decided = [each for each in own if each.state in {TaskState.SUCCEEDED, TaskState.FAILED}]
    took = sorted(seconds for each in well if (seconds := _took(each)) is not None)
    return {
        "kind": kind,
        "count": len(own),
        "succeeded": len(well),
        "decided": len(decided),
        "median": took[len(took) // 2] if took else None,
    }


def _took(status: TaskStatus) -> float | None:
    if status.started is None or status.ended is None:
        return None
    return status.ended.since(status.started)


def _counted(words: Iterable[str]) -> list[tuple[str, int]]:
    counts: dict[str, int] = {}
    for word in words:
        counts[word] = counts.get(word, 0) + 1
    return sorted(counts.items(), key=lambda each: (-each[1], each[0]))


def _items(request: dict[str, JsonValue]) -> set[str]:
    named = (request.get(name) for name in ("item", "left", "right"))
    many = request.get("items")
    return {str(each) for each in (*named, *(many if isinstance(many, list) else ())) if each is not None}


def _words(status: TaskStatus) -> str:
    failure = "" if status.failure is None else f"{status.failure.where} {status.failure.message}"
    return f"{status.task} {status.request} {failure}".casefold()
