"""What a task's tree is built with and what it leaves behind."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from py_trees.behaviour import Behaviour

from skills.ports.clocks import Clocks
from skills.ports.failure import Failure
from skills.ports.site import Site
from skills.ports.tasks import Attempt, Progress
from skills.ports.world import Sighting, WorldState
from trees.clients import Clients
from trees.knowledge import Knowledge
from trees.resources import Resources


def _taken_in(world: WorldState, sighting: Sighting) -> bool:
    fact = world.item(sighting.item)
    return fact is not None and (fact.held is not None or fact.seen.seconds >= sighting.stamp.seconds)


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
    """What is still done after a cancel, once all is at rest: the task's builder sets it when it was asked to."""
    _progress: Progress = field(default_factory=Progress)

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

    def failure(self) -> Failure | None:
        """Return the last failure, with those before it as its causes, newest first; None without any."""
        if not self.failures:
            return None
        *before, last = self.failures
        return last.model_copy(update={"causes": (*last.causes, *reversed(before[-8:]))})

    def enter(self, phase: str, fraction: float) -> None:
        """Say which phase the task is in and how far it is; it never runs backwards."""
        self._progress = Progress(phase=phase, fraction=max(fraction, self._progress.fraction))

    @property
    def progress(self) -> Progress:
        """The phase, and how far the task is."""
        return self._progress
