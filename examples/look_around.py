"""Look around: a task. Put this file into ``trees/tasks/`` and the executive takes its requests."""
# ruff: noqa: INP001 - an example: a file of its own

from __future__ import annotations

from typing import Annotated, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.actions.perception import LOOK, LookGoal
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.act import Act
from tandem.trees.behaviours.phase import Phase
from tandem.trees.conditions.localised import localised
from tandem.trees.context import TreeContext
from tandem.trees.leaves.localise import localise
from tandem.trees.leaves.rotate import rotate
from tandem.trees.subtrees.arms_in import tuck
from tandem.trees.task import TaskType


class LookAroundRequest(Message):
    """Turn on the spot and look, so that it is known what stands around."""

    task: Literal["look_around"] = "look_around"
    views: Annotated[int, Field(ge=1, le=12, description="how many, 30 degrees apart")] = 12


def problems(asked: LookAroundRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site: nothing can."""
    del asked, site
    return ()


def build(asked: LookAroundRequest, context: TreeContext) -> Behaviour:
    """Return the tree. Each node has a name of its own, the same for every request alike."""
    where = Selector("know where I am", memory=True, children=[localised(context), localise(context)])
    steps: list[Behaviour] = [where, tuck(context, "before looking"), look("look ahead", context)]
    for view in range(2, asked.views + 1):
        steps += [rotate(f"turn to view {view}", context), look(f"look at view {view}", context)]
    views = Sequence("all views", memory=True, children=steps)
    return Phase("look_around", context, views, begins=0.0, ends=1.0)


def look(name: str, context: TreeContext) -> Behaviour:
    """Return a leaf that ends when what it saw has become part of what is believed."""
    return Act(
        name,
        context,
        LOOK,
        LookGoal,
        resources=("head",),
        believed=lambda result: context.believes(result.sightings),
    )


TASK = TaskType(
    name="look_around",
    summary="Turn on the spot and look.",
    request=LookAroundRequest,
    problems=problems,
    build=build,
)
