"""Get to a place on wheels, and give way: what tasks share that move the base and nothing else."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import BASE
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.give_way import FREE_WITHIN, REFLEX, WAITED, GiveWay
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.context import TreeContext
from tandem.trees.course import Course, Target
from tandem.trees.leaves.drive import drive
from tandem.trees.leaves.go import go
from tandem.trees.leaves.localise import localise
from tandem.trees.recovery_kinds import localising_helps
from tandem.trees.subtrees.recovery_steps import let_pass, wait_back
from tandem.trees.subtrees.request import ready
from tandem.trees.subtrees.see_the_way import see_the_way

POSE_WITHIN: Final = 3.0
"""Robot seconds in which a pose sensor tells where the robot is."""
WITHIN: Final = 900.0
"""Robot seconds on the way to one place after which nothing is tried again."""
PASSERS_BY: Final = 6
"""How often in a row reflexes may take the base from a drive that has other ways, before it has got nearer:
one who passes by has it taken once to three times."""
KNOWS: Final = 2
"""How often it is tried again to find out where the robot is."""


def take_up(context: TreeContext) -> Behaviour:
    """Return the subtree: the robot is ready and knows where it is."""
    return Sequence(
        "take up request",
        memory=True,
        children=[
            ready(context),
            Recovery(
                "know where I am",
                context,
                _know("request", context),
                (wait_back("request", context),),
                within=WITHIN,
            ),
        ],
    )


def base_is_free(
    name: str, context: TreeContext, course: Course, *, or_else: Callable[[], bool] = lambda: False
) -> WaitFor:
    """Return the leaf that waits until no reflex has the base, and says which has it and why.

    It also ends when ``or_else`` holds, after which nobody needs the base.
    """

    def free() -> bool:
        return or_else() or course.free()

    def otherwise() -> Failure:
        taken = context.knowledge.base_taken
        state = context.knowledge.base_reflex
        why = () if state is None or state.why is None else (state.why,)
        return Failure(
            kind=FailureKind.OVERRIDDEN,
            message=f"waits: {taken}" if taken else f"waits a moment before the {BASE} is asked again",
            evidence={WAITED: FREE_WITHIN, **({} if state is None else {REFLEX: state.reflex})},
            causes=why,
        )

    return WaitFor(name, context, free, otherwise, patience=FREE_WITHIN)


def get_there(context: TreeContext, course: Course) -> Behaviour:
    """Return the subtree: SUCCESS when the robot is at the course's target, whatever took the base meanwhile.

    After each reflex it waits until the base is free, and goes on from where it is.
    """
    be_there = Selector(
        "be there",
        memory=True,
        children=[Check("there already?", course.there), go("go", context, course)],
    )
    way = Sequence(
        "when the base is free",
        memory=True,
        children=[base_is_free("base is free", context, course), be_there],
    )
    return Recovery(
        "get there",
        context,
        GiveWay("give way, and plan again", context, way, course.held_up),
        (
            wait_back("go", context),
            know_again("go", context),
            let_pass("go", context, seconds=2.0, times=3),
            *see_the_way("go", context),
        ),
        within=WITHIN,
    )


def drive_and_give_way(
    name: str,
    context: TreeContext,
    poses: Callable[[], tuple[FloorPose, ...] | Failure],
    *,
    serves: Callable[[], int | None] = lambda: None,
) -> Behaviour:
    """Return the subtree: a drive to one of some poses that goes on after a reflex has had the base.

    When reflexes take it again and again without progress, other ways may help: what is above decides.
    """
    course = Course(context, Target(math.inf, math.inf, None, 0.0), most=PASSERS_BY)

    def aimed() -> tuple[FloorPose, ...] | Failure:
        found = poses()
        if not isinstance(found, Failure) and (found[0].x, found[0].y) != (course.target.x, course.target.y):
            course.aim(Target(found[0].x, found[0].y, None, 0.0))
        return found

    def enough(failure: Failure) -> Failure | None:
        return failure if course.held_up(failure) is not None else None

    way = drive(name, context, aimed, serves=serves)
    return GiveWay(f"{name}, giving way", context, way, enough, settles=False, free=course.free)


def know_again(where: str, context: TreeContext) -> RecoveryStep:
    """Return the recovery "find out where the robot is", by whichever sensor tells it."""
    return RecoveryStep(f"{where}: find out where I am", localising_helps, KNOWS, _know(where, context))


def _know(where: str, context: TreeContext) -> Behaviour:
    def otherwise() -> Failure:
        robot = context.knowledge.robot
        why = "" if robot is None or not robot.reason else f": {robot.reason}"
        return Failure(kind=FailureKind.NOT_LOCALISED, message=f"no sensor tells where the robot is{why}")

    def has_laser() -> bool:
        robot = context.knowledge.description
        return robot is not None and bool(robot.lasers)

    by_laser = Sequence(
        f"{where}: by laser",
        memory=True,
        children=[
            Check(f"{where}: has a laser?", has_laser),
            localise(context, f"{where}: localise"),
        ],
    )
    return Selector(
        f"{where}: where am I",
        memory=True,
        children=[
            WaitFor(
                f"{where}: pose is known",
                context,
                lambda: context.knowledge.robot_localised,
                otherwise,
                patience=POSE_WITHIN,
            ),
            by_laser,
        ],
    )
