"""Go to: get to a place, give way to whatever a reflex sees, and stay there for a while if asked."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence
from pydantic import Field

from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.stay import Stay
from tandem.trees.behaviours.watching import Watching
from tandem.trees.closing import where_robot_is
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.course import Course, Target
from tandem.trees.needs import Needs
from tandem.trees.places import MapX, MapY, Tolerance, outside
from tandem.trees.subtrees.travel import get_there, take_up
from tandem.trees.task import TaskType

RETURNS: Final = 10_000
"""How often it goes back at the most while it stays."""
ARRIVES: Final = 0.05
"""Fraction of the task at which it sets out."""


class GoToRequest(Message):
    """Go to a place in the map; with `stay`, hold it for so many robot seconds."""

    task: Literal["go_to"] = "go_to"
    x: MapX
    y: MapY
    yaw: Annotated[
        float | None, Field(ge=-7.0, le=7.0, description="rad in the map; default: any heading will do")
    ] = None
    tolerance: Tolerance = 0.15
    stay: Annotated[
        float,
        Field(ge=0.0, le=86400.0, description="robot seconds to hold the place; 0: it ends on arrival"),
    ] = 0.0


class GoToResult(Message):
    """Where the robot ended, and what came in between."""

    base_in_map: FloorPose
    position_error: float
    """Metres from the place."""
    overridden: Count
    """How often a reflex took the base from a goal."""
    reflexes: dict[str, Count]
    """The same, by reflex."""
    replans: Count
    """Goals sent after the first."""
    returns: Count
    """How often it went back to its place while it stayed there."""
    reactive: float
    """Robot seconds for which a reflex had the base."""


def problems(asked: GoToRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    return outside(asked.x, asked.y, site)


def build(asked: GoToRequest, context: TreeContext) -> Behaviour:
    """Return the tree. After a restart of the executive a stay begins anew."""
    course = Course(context, Target(x=asked.x, y=asked.y, yaw=asked.yaw, tolerance=asked.tolerance))
    stay = Stay("stay", context, asked.stay, course)

    def result() -> GoToResult | None:
        robot, away, counts = context.knowledge.robot, course.away(), course.counts()
        if robot is None or away is None:
            return None
        return GoToResult(
            base_in_map=robot.base_in_map,
            position_error=away,
            overridden=counts.overridden,
            reflexes=counts.reflexes,
            replans=counts.replans,
            returns=stay.left,
            reactive=counts.reactive,
        )

    context.result, context.closing = result, lambda: where_robot_is(context)
    there = Each(
        "hold the place",
        Sequence("go there and stay", memory=True, children=[get_there(context, course), stay]),
        stay.over,
        RETURNS,
    )
    return Sequence(
        "go_to",
        memory=True,
        children=[
            Phase("request", context, take_up(context), begins=0.0, ends=ARRIVES),
            Phase("go", context, Watching("on the way", there, course.watch), begins=ARRIVES, ends=1.0),
        ],
    )


TASK = TaskType(
    name="go_to",
    summary="Go to a place, give way on the way there, and stay if asked.",
    request=GoToRequest,
    problems=problems,
    build=build,
    waits=unheard,
    result=GoToResult,
    needs=Needs(drive=True, place=True),
)
