"""Patrol: visit places in order, again and again, and give way on the way."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.watching import Watching
from tandem.trees.closing import where_robot_is
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.needs import Needs
from tandem.trees.places import MapX, MapY, Tolerance, outside
from tandem.trees.rounds import Place, Rounds, Visit
from tandem.trees.subtrees.travel import get_there, take_up
from tandem.trees.task import TaskType

SETS_OUT: Final = 0.05
"""Fraction of the task at which it sets out."""


class Corner(Message):
    """A place in the map."""

    x: MapX
    y: MapY


class PatrolRequest(Message):
    """Visit the corners in order, so many times."""

    task: Literal["patrol"] = "patrol"
    corners: Annotated[
        tuple[Corner, ...],
        Field(
            min_length=1,
            max_length=50,
            examples=[[{"x": 0.0, "y": 0.0}, {"x": -1.0, "y": 0.0}]],
            description="places in the map, in order",
        ),
    ]
    rounds: Annotated[Count, Field(ge=1, le=1000, description="how often all corners are visited")] = 1
    tolerance: Tolerance = 0.15


class PatrolResult(Message):
    """Which corners were visited, and how often a reflex took the base."""

    visited: Count
    visits: tuple[Visit, ...]
    """The newest 50, oldest first."""
    overridden: Count
    """How often a reflex took the base from a goal."""
    reflexes: dict[str, Count]
    """The same, by reflex."""
    replans: Count
    """Goals sent after the first for a corner."""
    reactive: float
    """Robot seconds for which a reflex had the base."""


def problems(asked: PatrolRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    return tuple(
        problem
        for number, corner in enumerate(asked.corners)
        for problem in outside(corner.x, corner.y, site, f"corners.{number}.")
    )


def build(asked: PatrolRequest, context: TreeContext) -> Behaviour:
    """Return the tree. A corner that it can't get to ends the task."""
    corners = tuple(Place(each.x, each.y) for each in asked.corners)
    rounds = Rounds(context, corners, asked.rounds, asked.tolerance)

    def result() -> PatrolResult:
        notes, counts = rounds.notes, rounds.course.counts()
        return PatrolResult(
            visited=notes.visited,
            visits=notes.visits,
            overridden=counts.overridden,
            reflexes=counts.reflexes,
            replans=counts.replans,
            reactive=counts.reactive,
        )

    def begin() -> str:
        share = rounds.notes.visited / rounds.all
        context.enter("patrol", SETS_OUT + (1.0 - SETS_OUT) * share)
        return rounds.turn_to_next()

    context.result, context.closing = result, lambda: where_robot_is(context)
    visit = Sequence(
        "visit a corner",
        memory=True,
        children=[
            Note("next corner", begin),
            get_there(context, rounds.course),
            Note("corner is visited", rounds.arrive),
        ],
    )
    every = Selector(
        "corners visited",
        memory=True,
        children=[
            Check("all corners visited?", lambda: rounds.over),
            Each("every corner", visit, lambda: rounds.over, rounds.all),
        ],
    )
    way = Watching("on the way", every, rounds.course.watch)
    return Sequence(
        "patrol",
        memory=True,
        children=[
            Phase("request", context, take_up(context), begins=0.0, ends=SETS_OUT),
            Phase("patrol", context, way, begins=SETS_OUT, ends=1.0),
        ],
    )


TASK = TaskType(
    name="patrol",
    summary="Visit places in order, again and again; give way on the way.",
    request=PatrolRequest,
    problems=problems,
    build=build,
    waits=unheard,
    result=PatrolResult,
    needs=Needs(drive=True, place=True),
)
