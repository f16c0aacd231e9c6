"""Put the item down in its slot of the depot: order-picking paper, III-D.2, Fig. 7, eq. 3.

While it is carried the hand is watched: when the item is lost, what is under way is stopped. The base's
recovery is the order-picking paper's (III-A.4): the distance to the goal is changed, at most twice.
"""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import FailureIsSuccess

from tandem.skills.grasping.tag_grasps import proximity_poses
from tandem.skills.grasping.turns import to_place
from tandem.skills.ports.actions.gripper import Grip, GripGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.guarded import Guarded
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.side_by_side import SideBySide
from tandem.trees.board import FetchBoard
from tandem.trees.branch import branch
from tandem.trees.conditions.item_left import item_left
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import no_longer_held
from tandem.trees.leaves.bind_slot import bind_slot
from tandem.trees.leaves.edit_scene import detach, remove_from_scene
from tandem.trees.leaves.grip import grip_with
from tandem.trees.leaves.look_at_slot import look_at_slot
from tandem.trees.leaves.place_above import place_above, place_candidates, ways_to_place
from tandem.trees.leaves.put_down import put_down
from tandem.trees.leaves.slot_is_free import slot_is_free
from tandem.trees.leaves.survey import Reach
from tandem.trees.leaves.withdraw import withdraw
from tandem.trees.recovery_kinds import another_slot_helps, another_stand_helps, trying_again_helps
from tandem.trees.subtrees.arms_in import free_and_tuck
from tandem.trees.subtrees.home import home
from tandem.trees.subtrees.recovery_steps import a_moment, another_way, localise_again, wait_back
from tandem.trees.subtrees.see_the_way import see_the_way
from tandem.trees.subtrees.stand import stand_near, unknown

WITHIN: Final = 300.0
"""Robot seconds after which nothing is tried again."""
LEAVE_WITHIN: Final = 120.0
"""Robot seconds after which drawing back is not tried again. The item lies by then: this bounds how long a
hand stays beside it."""
STANDS: Final = 2
"""How often another stand is tried, as often as for the base in the order-picking paper (III-A.4)."""
STARTS: Final = 1
"""How often it is begun anew from home, where all stands may be tried again: each costs a drive with the
item."""
LEAVES: Final = 2
"""How often letting go and drawing back are tried again, each time a moment (``A_MOMENT``) later. The item
lies: more of them only keep the hand beside it longer."""


def place(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree: SUCCESS when the item lies in its slot and the hand is closed and tucked in."""
    carry = Guarded(
        "while the item is in the hand",
        context,
        Sequence(
            "bring item to slot",
            memory=True,
            children=[
                slot_is_free("slot not known to be taken", context, board),
                approach_slot(context, board),
                place_above(context, board),
                put_down(context, board),
            ],
        ),
        holds=lambda: _in_hand(context, board),
        otherwise=lambda: no_longer_held(context, board.item, board.chosen_side()),
    )
    others = len(board.depot(context).slots) - 1
    steps = (
        wait_back("place", context),
        localise_again("place", context),
        another_way("place", context, board),
        *see_the_way("place", context, board.avoid.clear),
        RecoveryStep("place: another slot", another_slot_helps, others, _another_slot(context, board)),
        RecoveryStep("place: another stand", another_stand_helps, STANDS, _another_stand(context, board)),
        RecoveryStep("place: begin from home", another_stand_helps, STARTS, _from_home(context, board)),
    )
    main = Sequence("place item", memory=True, children=[carry, _leave_item(context, board)])
    return Recovery(
        "get rid of item",
        context,
        main,
        steps,
        within=WITHIN,
        conclude=lambda failure: _unreachable(context, board, failure),
    )


def approach_slot(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree that brings the base into the slot's neighbourhood."""

    def reach(side: HandName, _: int) -> Reach | Failure:
        ways, description = ways_to_place(context, board, side), context.knowledge.description
        if isinstance(ways, Failure) or description is None:
            return ways if isinstance(ways, Failure) else unknown(context, board.item)
        slot, hand = board.chosen_slot(context), description.end_effector(side)
        bases = proximity_poses(slot.position, slot.facing, hand.work_point, hand.work_heading)
        return Reach(bases=bases, candidates=place_candidates(ways), turn=to_place(slot.position))

    def look(name: str) -> Behaviour:
        return Sequence(
            f"{name}, and see",
            memory=True,
            children=[
                look_at_slot(name, context, board),
                slot_is_free(f"{name}: slot free", context, board),
            ],
        )

    return stand_near(
        "slot",
        context,
        board,
        reach,
        touch_support=True,
        unreachable=FailureKind.DESTINATION_UNREACHABLE,
        look=look,
        sight=lambda: board.chosen_slot(context).position,
    )


def _leave_item(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Let go, if that has not been done, and draw back; what follows may be done again without harm."""
    put = Sequence(
        "let item go",
        memory=True,
        children=[
            grip_with("let go", context, board, lambda: GripGoal(grip=Grip.OPEN)),
            detach(context, board),
        ],
    )
    main = Sequence(
        "leave item",
        memory=True,
        children=[
            Selector("item left", memory=True, children=[item_left(context, board), put]),
            withdraw(context, board),
            # An obstacle until the arm is in: a tuck that is planned without it may knock it over.
            _close_and_tuck(context, board),
            remove_from_scene(context, board),
        ],
    )
    steps = (
        wait_back("leave", context),
        RecoveryStep("leave: once more", trying_again_helps, LEAVES, a_moment("leave", context)),
    )
    return Recovery("get away from item", context, main, steps, within=LEAVE_WITHIN)


def _close_and_tuck(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Close the empty hand while the arms come in: the way is planned for the hand as wide as it was."""
    hand, arm = branch(context, "gripper"), branch(context, "arm")
    return SideBySide(
        "close and tuck",
        context,
        (
            (hand, grip_with("close empty", hand, board, lambda: GripGoal(grip=Grip.CLOSE))),
            (arm, free_and_tuck(arm, "after place")),
        ),
    )


def _another_slot(context: TreeContext, board: FetchBoard) -> Behaviour:
    def note() -> str:
        if board.slot is not None:
            board.slots_taken.add(board.slot)
        board.avoid.clear()
        return f"taken: {', '.join(str(slot) for slot in sorted(board.slots_taken))}"

    return Sequence(
        "place: take another slot",
        memory=True,
        children=[
            Note("place: note the slot is taken", note),
            bind_slot("place: bind another slot", context, board),
        ],
    )


def _another_stand(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Take another stand; the arm is tucked in before the base moves."""

    def note() -> str:
        if context.knowledge.robot is not None:
            board.avoid.append(context.knowledge.robot.base_in_map)
        return f"{len(board.avoid)} stands are not tried again"

    return Note("place: avoid this stand", note)


def _from_home(context: TreeContext, board: FetchBoard) -> Behaviour:
    def note() -> str:
        board.avoid.clear()
        return "all stands are tried again"

    return Sequence(
        "place: from home",
        memory=True,
        children=[
            FailureIsSuccess("place: home if there is a way", home(context, "place: home")),
            Note("place: begin anew", note),
        ],
    )


def _in_hand(context: TreeContext, board: FetchBoard) -> bool:
    """Say whether the item is believed to be in the hand; what is not known yet is not lost."""
    world = context.knowledge.world
    held = None if world is None else world.in_hand(board.chosen_side())
    return world is None or (held is not None and held.item == board.item)


def _unreachable(context: TreeContext, board: FetchBoard, failure: Failure) -> Failure:
    """Return what is told when all that helps with the item in the hand has been tried."""
    if failure.kind is FailureKind.SLOT_TAKEN:
        full = f"no slot of {board.destination} is free for {context.called(board.item)}"
        return Failure(
            kind=FailureKind.DESTINATION_FULL, message=full, where=failure.where, causes=(failure,)
        )
    if failure.kind is FailureKind.DESTINATION_UNREACHABLE or not another_stand_helps(failure):
        return failure
    return Failure(
        kind=FailureKind.DESTINATION_UNREACHABLE,
        message=f"{context.called(board.item)} could not be put down; the last was {failure.kind}",
        where=failure.where,
        evidence=failure.evidence,
        causes=(failure,),
    )
