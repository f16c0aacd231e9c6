"""Follow: keep at a distance from another robot for a while, and give way meanwhile."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.actions.base import FollowSource
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.whereabouts import Following
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.give_way import GiveWay
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.recovery import Recovery
from tandem.trees.behaviours.watching import Watching
from tandem.trees.closing import where_robot_is
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.follow import follow
from tandem.trees.needs import Needs
from tandem.trees.pursuit import Pursuit
from tandem.trees.subtrees.recovery_steps import let_pass, wait_back
from tandem.trees.subtrees.travel import base_is_free, know_again, take_up
from tandem.trees.task import TaskType

SETS_OUT: Final = 0.05
"""Fraction of the task at which it begins to follow."""
GOALS: Final = 10_000
"""How many goals a pursuit has at the most."""


class FollowRequest(Message):
    """Follow another robot at a distance between the two centres, for so many robot seconds."""

    task: Literal["follow"] = "follow"
    robot: Annotated[
        str, Field(min_length=1, max_length=64, examples=["r2"], description="name of the robot to follow")
    ]
    distance: Annotated[float, Field(ge=0.3, le=10.0, description="m between the centres")] = 1.3
    seconds: Annotated[float, Field(ge=1.0, le=86400.0, description="robot seconds")] = 60.0
    source: Annotated[
        FollowSource,
        Field(description="how the other is found: a sensor sees it, or it tells where it believes to be"),
    ] = FollowSource.SENSOR


class FollowedResult(Message):
    """For how long the other robot was seen."""

    seconds: float
    """Robot seconds for which it was followed, those included in which a reflex had the base."""
    seen: float
    """Robot seconds of these for which the other was seen."""
    share: Annotated[float, Field(ge=0.0, le=1.0)]
    """``seen`` of ``seconds``."""
    overridden: Count
    """How often a reflex took the base from a goal."""
    reflexes: dict[str, Count]
    """The same, by reflex."""
    reactive: float
    """Robot seconds for which a reflex had the base."""


def problems(_: FollowRequest, __: Site) -> tuple[Problem, ...]:
    """Return nothing: whether there is such a robot, only a sensor tells."""
    return ()


def misfits(asked: FollowRequest, robot: RobotDescription) -> tuple[Problem, ...]:
    """Return that a robot without a sensor for others can only go by what they tell."""
    if asked.source is FollowSource.BELIEF or robot.robot_sensors:
        return ()
    expected = f"{FollowSource.BELIEF}: {robot.name} has no sensor for other robots"
    return (Problem(path="source", expected=expected, found=asked.source),)


def follows(asked: FollowRequest) -> Following:
    """Return whom, and how far behind."""
    return Following(robot=asked.robot, distance=asked.distance)


def build(asked: FollowRequest, context: TreeContext) -> Behaviour:
    """Return the tree. After a restart of the executive the time begins anew."""
    pursuit = Pursuit(context, asked.seconds)

    def result() -> FollowedResult:
        counts, seen = pursuit.course.counts(), min(pursuit.seen, pursuit.spent)
        return FollowedResult(
            seconds=round(pursuit.spent, 2),
            seen=round(seen, 2),
            share=seen / pursuit.spent if pursuit.spent else 0.0,
            overridden=counts.overridden,
            reflexes=counts.reflexes,
            reactive=counts.reactive,
        )

    context.result, context.closing = result, lambda: where_robot_is(context)
    after = Sequence(
        "when the base is free",
        memory=True,
        children=[
            base_is_free("base is free", context, pursuit.course, or_else=lambda: pursuit.over),
            Selector(
                "follow for the rest",
                memory=True,
                children=[
                    Check("time is over?", lambda: pursuit.over),
                    follow("follow it", context, pursuit, asked.robot, asked.distance, source=asked.source),
                ],
            ),
        ],
    )
    keep = Recovery(
        "keep following",
        context,
        Each(
            "until the time is over",
            GiveWay("give way, and follow again", context, after, pursuit.held_up),
            lambda: pursuit.over,
            GOALS,
        ),
        (
            wait_back("follow", context),
            know_again("follow", context),
            let_pass("follow", context, seconds=2.0, times=3),
        ),
        within=asked.seconds,
    )
    return Sequence(
        "follow",
        memory=True,
        children=[
            Phase("request", context, take_up(context), begins=0.0, ends=SETS_OUT),
            Phase(
                "follow it", context, Watching("on its way", keep, pursuit.watch), begins=SETS_OUT, ends=1.0
            ),
        ],
    )


TASK = TaskType(
    name="follow",
    summary="Follow another robot at a distance; give way meanwhile.",
    request=FollowRequest,
    problems=problems,
    build=build,
    waits=unheard,
    result=FollowedResult,
    needs=Needs(drive=True, place=True),
    misfits=misfits,
    follows=follows,
)
