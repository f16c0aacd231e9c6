"""Pick one item with each hand: two-arm thesis, 4.1.2 and 4.3, uncoordinated bimanual.

Asynchronous unless asked otherwise: the first hand that is before its item picks, the other waits before its
own until the first is safe. With ``parallel_pick`` both wait for each other there, and grasp together.
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence
from pydantic import Field

from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.barrier import Barrier, Meet, Member
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.side_by_side import SideBySide
from tandem.trees.behaviours.take_turns import InTurn, Turn
from tandem.trees.branch import Branch, branch
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.hand_requests import hand_problems, item_problems
from tandem.trees.item_number import ItemNumber
from tandem.trees.leaves.coordinate import Mode
from tandem.trees.leaves.hand.still_held import still_held
from tandem.trees.leaves.within_reach import within_reach
from tandem.trees.needs import Needs
from tandem.trees.subtrees.hand_pick import Method, hand_pick
from tandem.trees.subtrees.two_arms import take_up, watched, where_hands_are
from tandem.trees.task import TaskType

HOW: Final = "how the hands approach their items; the others are baselines"


class PickTwoRequest(Message):
    """Pick an item with the left hand and one with the right."""

    task: Literal["pick_two"] = "pick_two"
    left: ItemNumber
    right: ItemNumber
    parallel_pick: Annotated[bool, Field(description="grasp both at once; else one after the other")] = False
    mode: Annotated[Mode, Field(description="when the waiting arm continues")] = "eager"
    method: Annotated[Method, Field(description=HOW)] = "apf_rrtconnect"
    sequential: Annotated[bool, Field(description="one arm moves after the other, as a baseline")] = False


def problems(asked: PickTwoRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site, or itself."""
    found = [
        *item_problems(site, "left", asked.left),
        *item_problems(site, "right", asked.right),
        *hand_problems(site, "left", asked.left, "left"),
        *hand_problems(site, "right", asked.right, "right"),
    ]
    if asked.left == asked.right:
        found.append(
            Problem(path="right", expected="another item than the left hand's", found=str(asked.right))
        )
    if asked.parallel_pick and asked.sequential:
        expected = "false with sequential: one after the other is not together"
        found.append(Problem(path="parallel_pick", expected=expected, found="true"))
    return tuple(found)


def build(asked: PickTwoRequest, context: TreeContext) -> Behaviour:
    """Return the tree."""
    boards = (HandBoard("left", asked.left), HandBoard("right", asked.right))
    context.board = boards
    context.closing = lambda: where_hands_are(context, boards)
    hands = tuple((branch(context, board.who), board) for board in boards)
    picks = _together(asked, context, hands) if asked.parallel_pick else _in_turns(asked, context, hands)
    return Sequence(
        "pick_two",
        memory=True,
        children=[
            Phase("request", context, take_up(context, boards), begins=0.0, ends=0.10),
            within_reach("items are within reach", context, boards),
            Phase("pick", context, watched(context, picks, boards, mode=asked.mode), begins=0.10, ends=1.0),
            # The first has waited for the second with its item in the hand.
            *(still_held("in hand at the end?", context, board) for board in boards),
        ],
    )


Hands = tuple[tuple[Branch, HandBoard], ...]


def _in_turns(asked: PickTwoRequest, context: TreeContext, hands: Hands) -> Behaviour:
    """One picks while the other waits before its item; or, in sequence, where it stands."""
    turn = Turn()

    def pick(at: Branch, board: HandBoard) -> Behaviour:
        def in_turn(what: Behaviour) -> Behaviour:
            return InTurn(f"{board.who}: in its turn", turn, board.who, what)

        if asked.sequential:
            return in_turn(hand_pick(at, board, asked.method))
        eager = asked.mode == "eager"
        return hand_pick(at, board, asked.method, arranged=in_turn, retreat_apart=eager)

    return SideBySide("both hands pick", context, tuple((at, pick(at, board)) for at, board in hands))


def _together(asked: PickTwoRequest, context: TreeContext, hands: Hands) -> Behaviour:
    """Both wait for each other before their items."""
    barrier = Barrier(*(board.who for _, board in hands))

    def pick(at: Branch, board: HandBoard) -> Behaviour:
        def behind(grasp: Behaviour) -> Behaviour:
            meet = Meet(f"{board.who}: wait for the other", at, barrier, board.who)
            return Sequence(f"{board.who}: both, then grasp", memory=True, children=[meet, grasp])

        def member(tried: Behaviour) -> Behaviour:
            return Member(f"{board.who}: for both", at, tried, barrier, board.who)

        return hand_pick(at, board, asked.method, arranged=behind, member=member)

    both = SideBySide("both hands pick", context, tuple((at, pick(at, board)) for at, board in hands))
    return Sequence(
        "both hands together", memory=True, children=[Note("set up the barrier", barrier.reset), both]
    )


TASK = TaskType(
    name="pick_two",
    summary="Pick one item with each hand.",
    request=PickTwoRequest,
    problems=problems,
    build=build,
    waits=unheard,
    needs=Needs(named=PAIR, camera=True),
)
