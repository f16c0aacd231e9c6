"""Inspect: drive to each search spot, look around there, and tell which items were seen, and where."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.recovery import Recovery
from tandem.trees.behaviours.remember import afterwards
from tandem.trees.closing import where_robot_is
from tandem.trees.conditions.at_pose import at_any
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.inspection import Inspection, InspectResult
from tandem.trees.leaves.look_round import look_round
from tandem.trees.leaves.rotate import ALL_AROUND, rotate
from tandem.trees.needs import Needs
from tandem.trees.recovery_kinds import another_way_helps
from tandem.trees.subtrees.arms_in import free_and_tuck
from tandem.trees.subtrees.home import home_at_last
from tandem.trees.subtrees.recovery_steps import let_pass, localise_again, wait_back
from tandem.trees.subtrees.request import know_where, ready
from tandem.trees.subtrees.see_the_way import see_the_way
from tandem.trees.subtrees.travel import drive_and_give_way
from tandem.trees.task import TaskType

WITHIN: Final = 240.0
"""Robot seconds for one spot, after which nothing is tried again there."""
BEGINS, ENDS = 0.05, 0.90
"""Fractions of the task between which the spots are visited."""

SpotName = Annotated[str, Field(max_length=64)]


class InspectRequest(Message):
    """Look around from the site's search spots and tell what is where."""

    task: Literal["inspect"] = "inspect"
    spots: Annotated[
        tuple[SpotName, ...] | None,
        Field(min_length=1, max_length=100, description="names of search spots, in order; default: all"),
    ] = None


def problems(asked: InspectRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    names = [spot.name for spot in site.spots]
    if not names:
        return (Problem(path="spots", expected="a site with search spots", found="none"),)
    wanted = asked.spots or ()
    return tuple(
        Problem(
            path=f"spots.{place}", expected=f"one of the site's spots, once: {', '.join(names)}", found=name
        )
        for place, name in enumerate(wanted)
        if name not in names or name in wanted[:place]
    )


def build(asked: InspectRequest, context: TreeContext) -> Behaviour:
    """Return the tree. A spot to which there is no way is left out, and the task fails at its end."""
    at = Inspection(context, asked.spots or tuple(spot.name for spot in context.site.spots))
    context.result, context.closing = at.result, lambda: where_robot_is(context)
    take_up = Sequence("take up request", memory=True, children=[ready(context), know_where(context)])
    every = Each("every spot", _spot(context, at), lambda: not at.left, len(at.spots))
    look = Sequence(
        "look from the spots",
        memory=True,
        children=[
            free_and_tuck(context, "before inspecting"),
            Selector("spots visited", memory=True, children=[_all_done(at), every]),
            Decide("nothing left out?", context, lambda: _verdict(at)),
        ],
    )
    return Sequence(
        "inspect",
        memory=True,
        children=[
            Phase("request", context, take_up, begins=0.0, ends=BEGINS),
            afterwards(
                "inspect and go home",
                context,
                Phase("inspect", context, look, begins=BEGINS, ends=ENDS),
                Phase("home", context, home_at_last(context), begins=ENDS, ends=1.0),
            ),
        ],
    )


def _spot(context: TreeContext, at: Inspection) -> Behaviour:
    def begin() -> str:
        spot = at.turn_to_next()
        done = 1.0 - len(at.left) / len(at.spots)
        context.enter("inspect", BEGINS + (ENDS - BEGINS) * done)
        return spot

    def poses() -> tuple[FloorPose, ...]:
        return tuple(spot.pose for spot in context.site.spots if spot.name == at.spot)

    there = Selector(
        "be at the spot",
        memory=True,
        children=[
            at_any("at the spot?", context, poses),
            drive_and_give_way("drive to spot", context, poses),
        ],
    )
    turn = Sequence(
        "turn and look",
        memory=True,
        children=[rotate("turn 30 degrees", context), look_round("look on", context, at.saw)],
    )
    look = Sequence(
        "look around",
        memory=True,
        children=[
            there,
            look_round("look ahead", context, at.saw),
            Each("up to 360 degrees", turn, lambda: False, ALL_AROUND - 1),
            Note("spot is done", at.finish_spot),
        ],
    )
    steps = (
        wait_back("spot", context),
        localise_again("spot", context),
        let_pass("spot", context, seconds=5.0, times=2),
        *see_the_way("spot", context),
    )
    return Sequence(
        "inspect a spot",
        memory=True,
        children=[
            Note("next spot", begin),
            Selector(
                "spot done or left out",
                memory=True,
                children=[
                    Recovery("get a look around", context, look, steps, within=WITHIN),
                    Sequence(
                        "leave out what has no way to it",
                        memory=True,
                        children=[
                            Check("only no way there?", lambda: another_way_helps(context.failures.last())),
                            Note("leave the spot out", at.miss_spot),
                        ],
                    ),
                ],
            ),
        ],
    )


def _all_done(at: Inspection) -> Behaviour:
    """Return the condition that a tree which begins anew after a restart asks first."""
    return Check("all spots visited?", lambda: not at.left)


def _verdict(at: Inspection) -> str | Failure:
    missed = at.notes.missed
    if not missed:
        return f"{len(at.spots)} spots"
    first = missed[0]
    names = ", ".join(each.spot for each in missed)
    return Failure(
        kind=first.kind,
        message=f"{len(missed)} of {len(at.spots)} spots are left out ({names}): {first.message}",
        evidence={"missed": names},
    )


TASK = TaskType(
    name="inspect",
    summary="Look around from the search spots; tell which items are where.",
    request=InspectRequest,
    problems=problems,
    build=build,
    waits=unheard,
    result=InspectResult,
    needs=Needs(drive=True, camera=True),
)
