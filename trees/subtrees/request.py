"""Take up a request: check it against what is known, bind arm and slot, before anything moves."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.world import WorldState
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.board import FetchBoard
from tandem.trees.conditions.localised import localised
from tandem.trees.context import TreeContext
from tandem.trees.leaves.bind_slot import bind_slot
from tandem.trees.leaves.localise import localise
from tandem.trees.recovery_kinds import localising_helps
from tandem.trees.subtrees.recovery_steps import a_moment, wait_back

WITHIN: Final = 120.0
"""Robot seconds after which localising is not tried again."""
PATIENCE: Final = 10.0
"""Seconds, of the robot and of the host, to wait for skills that have not been heard yet."""
LOCALISES: Final = 2
"""How often it is tried again to find out where the robot is, before anything moves."""


def request(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree."""
    return Sequence(
        "take up request",
        memory=True,
        children=[
            ready(context),
            _bind_arm(context, board),
            bind_slot("bind slot", context, board),
            know_where(context),
        ],
    )


def know_where(context: TreeContext) -> Behaviour:
    """Return the subtree that ends when the robot knows its pose in the map; it is tried more than once."""
    again = RecoveryStep("request: once more", localising_helps, LOCALISES, a_moment("request", context))
    return localised_by(context, (wait_back("request", context), again), within=WITHIN)


def localised_by(context: TreeContext, steps: tuple[RecoveryStep, ...], *, within: float) -> Behaviour:
    """Return the subtree that localises unless that is done, with what is tried when it fails.

    Args:
        context: of the task.
        steps: what is tried then.
        within: robot seconds after which nothing more is tried.
    """
    return Selector(
        "know where I am",
        memory=True,
        children=[
            localised(context),
            Recovery(
                "get localised",
                context,
                localise(context),
                steps,
                within=within,
            ),
        ],
    )


def ready(context: TreeContext, name: str = "robot is ready", *, patience: float = PATIENCE) -> WaitFor:
    """Return the leaf that waits until all has been heard that a task needs, and no stop is set."""

    def otherwise() -> Failure:
        if context.knowledge.stopped.stopped:
            stop = context.knowledge.stopped
            return Failure(kind=FailureKind.HARDWARE_STOPPED, message=f"stopped by {stop.by}: {stop.reason}")
        missing = ", ".join(context.knowledge.missing())
        return Failure(kind=FailureKind.NOT_READY, message=f"not heard yet: {missing}")

    def heard() -> bool:
        return not context.knowledge.missing() and not context.knowledge.stopped.stopped

    return WaitFor(name, context, heard, otherwise, patience=patience, for_a_process=True)


def _bind_arm(context: TreeContext, board: FetchBoard) -> Decide:
    def decide() -> str | Failure:
        world = context.knowledge.world or _nothing()
        item = board.site_item(context)
        hands = tuple(hand for hand in context.knowledge.hands if item.is_for(hand))
        wanted = (board.wanted_arm,) if board.wanted_arm is not None else hands
        holding = next((hand.side for hand in world.held if hand.item == board.item), None)
        if holding is not None:
            board.side, board.sides, board.allowed = holding, (holding,), wanted
            return f"the {holding} hand holds {context.called(board.item)} already"
        free = tuple(side for side in wanted if world.in_hand(side) is None)
        if not free:
            held = ", ".join(f"{hand.side}: {context.called(hand.item)}" for hand in world.held)
            return Failure(
                kind=FailureKind.HAND_FULL, message=f"no free hand for {context.called(board.item)} ({held})"
            )
        board.side, board.sides, board.allowed = free[0], free, free
        return f"{' or '.join(free)} arm for {context.called(board.item)}"

    return Decide("bind arm", context, decide)


def _nothing() -> WorldState:
    raise AssertionError("the robot is ready only when the world has been heard")
