"""Those that wait: by priority, then by arrival; each from its earliest start on, until its latest."""

from __future__ import annotations

from bisect import insort
from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from typing import Final

from tandem.executive.service.intake.request_parser import Asked

NEVER: Final = float("inf")


@dataclass(frozen=True, order=True)
class Waiting:
    """One task in the queue."""

    rank: tuple[int, int]
    """Its priority, turned round, and its number: the smallest comes first."""
    task: str = field(compare=False)
    asked: Asked = field(compare=False)
    begun: bool = field(compare=False, default=False)
    """Whether it has begun before: then it does not expire."""

    @property
    def priority(self) -> int:
        """Its priority."""
        return -self.rank[0]

    @property
    def not_before(self) -> float:
        """UTC seconds of its earliest start."""
        return self.asked.envelope.not_before or 0.0

    @property
    def expires(self) -> float:
        """UTC seconds of its latest start; one that has begun has none."""
        last = None if self.begun else self.asked.envelope.expires
        return NEVER if last is None else last


class TaskQueue:
    """An ordered list: a thousand wait at the most, and one that is taken up again keeps its place."""

    def __init__(self) -> None:
        self._waiting: list[Waiting] = []
        self._by_task: dict[str, Waiting] = {}
        self._kinds: Counter[str] = Counter()
        self._first_end = NEVER
        """No later than the first latest start; so that a look costs nothing while nothing can be late."""

    def __len__(self) -> int:
        return len(self._waiting)

    def __iter__(self) -> Iterator[Waiting]:
        return iter(self._waiting)

    def put(self, task: str, asked: Asked, priority: int, number: int, *, begun: bool = False) -> None:
        """Put a task in at its place."""
        entry = Waiting((-priority, number), task, asked, begun)
        insort(self._waiting, entry)
        self._by_task[task] = entry
        self._kinds[asked.kind.name] += 1
        self._first_end = min(self._first_end, entry.expires)

    def find(self, task: str) -> Waiting | None:
        """Return a task that waits; None when it does not."""
        return self._by_task.get(task)

    @property
    def kinds(self) -> tuple[str, ...]:
        """The names of the kinds of those that wait."""
        return tuple(self._kinds)

    def ready(self, earliest: float, latest: float, held: Collection[str] = ()) -> Waiting | None:
        """Return the one whose turn it is; None when none may start yet.

        Args:
            earliest: UTC seconds before which it surely isn't.
            latest: UTC seconds after which it surely isn't.
            held: names of kinds of which none may start.
        """
        return next(
            (
                each
                for each in self
                if each.not_before <= earliest and each.expires >= latest and each.asked.kind.name not in held
            ),
            None,
        )

    def remove(self, task: str) -> Waiting | None:
        """Take a task out; None when it does not wait."""
        found = self.find(task)
        if found is not None:
            self._waiting.remove(found)
            self._discount(found)
        return found

    def rank(self, task: str, priority: int) -> bool:
        """Give a task another priority; False when it does not wait."""
        found = self.remove(task)
        if found is not None:
            self.put(task, found.asked, priority, found.rank[1], begun=found.begun)
        return found is not None

    def take_late(self, earliest: float) -> tuple[Waiting, ...]:
        """Take out those whose latest start has surely gone by (``earliest``: see ``ready``)."""
        if earliest <= self._first_end:
            return ()
        late = tuple(each for each in self._waiting if each.expires < earliest)
        self._waiting = [each for each in self._waiting if each.expires >= earliest]
        for each in late:
            self._discount(each)
        self._first_end = min((each.expires for each in self._waiting), default=NEVER)
        return late

    def _discount(self, gone: Waiting) -> None:
        del self._by_task[gone.task]
        name = gone.asked.kind.name
        self._kinds[name] -= 1
        if not self._kinds[name]:
            del self._kinds[name]
