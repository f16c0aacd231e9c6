"""What a task's tree is built with and what it leaves behind."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from py_trees.behaviour import Behaviour

from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import Progress
from tandem.skills.ports.world import Sighting, WorldState
from tandem.trees.clients import Clients
from tandem.trees.dialogue import Dialogue
from tandem.trees.failure_log import FailureLog
from tandem.trees.knowledge import Knowledge
from tandem.trees.resources import Resources
from tandem.trees.task_notes import TaskNotes


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
    wind_down: Behaviour | None = None
    """What is still done after a cancel, once all is at rest; set by a builder that was asked for it."""
    paused_for: float = 0.0
    """Robot seconds that the task has stood paused so far; ``seconds`` leaves them out."""
    closing: Callable[[], dict[str, str]] | None = None
    """Says at the end where everything is: evidence of the task's failure. The task's builder sets it."""
    result: Callable[[], Message | None] | None = None
    """Says at the end what the task has found or done, also when it fails. The task's builder sets it."""
    board: object | None = None
    """What the tree's leaves hand to each other, as it is told to who looks on. The builder may set it."""
    notes: TaskNotes = field(default_factory=TaskNotes)
    """What outlives a restart of the executive."""
    dialogue: Dialogue = field(default_factory=Dialogue)
    """What is asked of an operator."""
    open_doors: dict[str, None] = field(default_factory=dict)
    """The nodes at work that may be interrupted (``tandem.trees.behaviours.interruptible``)."""
    _progress: Progress = field(default_factory=Progress)
    failures: FailureLog = field(init=False)
    """What went wrong, and what was done about it."""

    def __post_init__(self) -> None:
        """Begin with no failure."""
        self.failures = FailureLog(self.clocks)

    @property
    def interruptible(self) -> bool:
        """Whether another task may take over now."""
        return bool(self.open_doors)

    @property
    def seconds(self) -> float:
        """Robot seconds for the timers of trees: they stand while the task is paused."""
        return robot_seconds(self.clocks) - self.paused_for

    @property
    def site(self) -> Site:
        """What was known beforehand."""
        return self.knowledge.site

    def called(self, item: int) -> str:
        """Return what people are told of an item: "item 29 (tea)"."""
        return f"item {self.site.called(item)}"

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
