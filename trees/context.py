"""What a task's tree is built with and what it leaves behind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeVar

from py_trees.behaviour import Behaviour
from pydantic import JsonValue, ValidationError

from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import Attempt, Progress, Question
from tandem.skills.ports.world import Sighting, WorldState
from tandem.trees.clients import Clients
from tandem.trees.knowledge import Knowledge
from tandem.trees.resources import Resources

M = TypeVar("M", bound=Message)
ATTEMPTS: Final = 32
"""Attempts that are kept."""
CAUSES: Final = 8
"""Earlier failures that a task's failure tells."""


def _taken_in(world: WorldState, sighting: Sighting) -> bool:
    return any(
        fact.held is not None or sighting.stamp.is_after(fact.seen) is False
        for fact in world.those(sighting.item)
    )


@dataclass(eq=False)
class TreeContext:
    """One task's surroundings. ``task`` is its id; goals are named ``task/node/attempt`` after it."""

    task: str
    clients: Clients
    knowledge: Knowledge
    clocks: Clocks
    resources: Resources = field(default_factory=Resources)
    failures: list[Failure] = field(default_factory=list)
    """Each failure of a leaf, in order; also those that a recovery has mended."""
    attempts: list[Attempt] = field(default_factory=list)
    """What went wrong so far and what was done about it, in order; the newest 32."""
    wind_down: Behaviour | None = None
    """What is still done after a cancel, once all is at rest; set by a builder that was asked for it."""
    paused_for: float = 0.0
    """Robot seconds that the task has stood paused so far; ``seconds`` leaves them out."""
    verdict: Failure | None = None
    """Why the task's main part failed; what failed afterwards, on the way home, comes second."""
    exhausted: tuple[Failure | None, frozenset[Callable[[Failure], bool]]] = (None, frozenset())
    """The failure that a recovery gave up last, and the conditions whose repairs it had tried."""
    closing: Callable[[], dict[str, str]] | None = None
    """Says at the end where everything is: evidence of the task's failure. The task's builder sets it."""
    goals_before: Mapping[str, int] = field(default_factory=dict)
    """The number of the last goal of each node, from before this tree began (once more)."""
    notes: dict[str, JsonValue] = field(default_factory=dict)
    """What ``keep`` noted, by name; also by the tree of before a restart."""
    question: Question | None = None
    """What the tree asks an operator now."""
    answers: dict[str, str] = field(default_factory=dict)
    """What was answered, by the node that asked, until it takes the answer."""
    answers_before: dict[str, str] = field(default_factory=dict)
    """What had been answered before a restart, and not been taken."""
    open_doors: dict[str, None] = field(default_factory=dict)
    """The nodes at work that may be interrupted (``tandem.trees.behaviours.interruptible``)."""
    _numbered: dict[str, int] = field(default_factory=dict)
    _progress: Progress = field(default_factory=Progress)

    @property
    def interruptible(self) -> bool:
        """Whether another task may take over now."""
        return bool(self.open_doors)

    def next_attempt(self, node: str) -> int:
        """Return the number of a node's next goal; none comes twice in a task, not even after a restart."""
        number = self._numbered.get(node, self.goals_before.get(node, 0)) + 1
        self._numbered[node] = number
        return number

    def keep(self, name: str, what: Message) -> None:
        """Note what this tree or its wind-down must know after a restart; on disk before the next goal."""
        self.notes[name] = what.model_dump(mode="json")

    def kept(self, name: str, model: type[M]) -> M | None:
        """Return what was kept; None when nothing was, or by a release with another model."""
        try:
            return model.model_validate(self.notes[name]) if name in self.notes else None
        except ValidationError:
            return None

    @property
    def seconds(self) -> float:
        """Robot seconds for the timers of trees: they stand while the task is paused."""
        return robot_seconds(self.clocks) - self.paused_for

    @property
    def site(self) -> Site:
        """What was known beforehand."""
        return self.knowledge.site

    def poll(self) -> bool:
        """Take in what has arrived; return whether the tree has a reason to be ticked."""
        believed = self.knowledge.refresh()
        return self.clients.poll() or believed

    @property
    def quiet(self) -> bool:
        """Whether no goal of a skill is unfinished."""
        return self.clients.quiet

    def believes(self, sightings: Iterable[Sighting]) -> bool:
        """Say whether the keeper has taken in all these sightings of items that stand somewhere."""
        world = self.knowledge.world
        return world is not None and all(_taken_in(world, sighting) for sighting in sightings)

    def failed(self, failure: Failure) -> None:
        """Keep a leaf's failure."""
        self.failures.append(failure)

    def last_failure(self) -> Failure:
        """Return the newest failure: the reason of what has just failed."""
        if self.failures:
            return self.failures[-1]
        return Failure(kind=FailureKind.SKILL_CRASHED, message="a part of the tree failed without a reason")

    def attempted(self, failure: Failure) -> None:
        """Note what went wrong; the recovery that takes it says so next."""
        kept = self.attempts
        if kept and not kept[-1].recovery and kept[-1].failure in failure.chain():
            kept = kept[:-1]  # given up below, and told here once more
        self.attempts = [*kept[1 - ATTEMPTS :], Attempt(at=self.clocks.robot(), failure=failure)]

    def recovering(self, recovery: str, times: int) -> None:
        """Note which recovery takes what went wrong last, and how often it has been tried by now."""
        last = self.attempts[-1].model_copy(update={"recovery": recovery, "times": times})
        self.attempts = [*self.attempts[:-1], last]

    def failure(self) -> Failure | None:
        """Return why the task failed: its main part's failure or else the last; with what came before.

        The causes are the newest different ones, newest first.
        """
        if not self.failures:
            return None
        head = self.verdict or self.failures[-1]
        seen, causes = {(head.kind, head.where)}, list[Failure]()
        for each in reversed(self.failures):
            if (each.kind, each.where) not in seen:
                seen.add((each.kind, each.where))
                causes.append(each)
        return head.model_copy(update={"causes": (*head.causes, *causes[:CAUSES])})

    def with_places(self, failure: Failure) -> Failure:
        """Add to a failure's evidence where everything is, as the task's builder tells it."""
        places = {} if self.closing is None else self.closing()
        return failure.model_copy(update={"evidence": {**failure.evidence, **places}})

    def enter(self, phase: str, fraction: float) -> None:
        """Say which phase the task is in and how far it is; it never runs backwards."""
        self._progress = Progress(phase=phase, fraction=max(fraction, self._progress.fraction))

    @property
    def progress(self) -> Progress:
        """The phase, and how far the task is."""
        return self._progress
