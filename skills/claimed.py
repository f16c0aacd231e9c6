"""A skill that has a resource while its goal runs: taken before it begins, given back however it ends."""

from __future__ import annotations

from typing import Generic

from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.skill import ActionType, F, G, R, Run, Skill, failed


class Claimed(Generic[G, F, R]):
    """Has a skill claim a pipeline with each goal.

    When a reflex takes the resource, the skill's run is closed at once: it stops what it moves, and sends
    nothing any more. The action server ends the goal as OVERRIDDEN once the reflex has given it back.

    Args:
        skill: what moves the resource, and comes to rest when its run is closed.
        pipeline: of the resource.
    """

    def __init__(self, skill: Skill[G, F, R], pipeline: Pipeline) -> None:
        self._skill, self._pipeline = skill, pipeline

    @property
    def action(self) -> ActionType[G, F, R]:
        """The skill's contract."""
        return self._skill.action

    @property
    def period(self) -> float:
        """The skill's, in robot seconds."""
        return self._skill.period

    def check(self, goal: G) -> Failure | None:
        """Refuse while another action, or a reflex, has the resource; else as the skill does."""
        return self._pipeline.busy(self.action.name) or self._skill.check(goal)

    def run(self, goal: G, goal_id: str) -> Run[F, R]:
        """Do as the skill does, with the resource."""
        run, pipeline, action = self._skill.run(goal, goal_id), self._pipeline, self.action.name
        busy = pipeline.busy(action)
        if busy is not None:
            run.close()
            return failed(busy)
        pipeline.claim(action, run.close)
        try:
            return (yield from run)
        finally:
            pipeline.release(action)
