"""Have all arms tucked in: whoever is out comes in, one after the other."""

from __future__ import annotations

from dataclasses import dataclass

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.note import Note
from tandem.trees.conditions.arm_tucked import arms_tucked, tucked
from tandem.trees.conditions.hand_full import hand_full
from tandem.trees.context import TreeContext
from tandem.trees.leaves.open_hand import open_hand
from tandem.trees.leaves.retreat import retreat
from tandem.trees.leaves.tuck_arm import tuck_arm


@dataclass(eq=False)
class _Turn:
    """Whose turn it is to come in."""

    side: HandName


def tuck(context: TreeContext, where: str) -> Behaviour:
    """Return the subtree that tucks in what is out; ``where`` in the tree makes its names unique."""
    turn = _Turn(next(iter(context.knowledge.hands), ""))
    return _in_turn(context, where, turn, tuck_arm(f"{where}: tuck arm", context, lambda: turn.side))


def free_and_tuck(context: TreeContext, where: str) -> Behaviour:
    """Return the subtree that tucks all arms in whatever they are at.

    An arm that can't be tucked in as it is opens its hand, unless that holds something, draws back and is
    tucked in then: fingers may be around an item that nobody has grasped yet.
    """
    turn = _Turn(next(iter(context.knowledge.hands), ""))

    def side() -> HandName:
        return turn.side

    hand = Selector(
        f"{where}: hand free or full",
        memory=True,
        children=[
            hand_full(f"{where}: hand full?", context, side),
            open_hand(f"{where}: open hand", context, side),
        ],
    )
    free = Sequence(
        f"{where}: free arm",
        memory=True,
        children=[
            hand,
            retreat(f"{where}: draw hand back", context, side),
            tuck_arm(f"{where}: tuck arm then", context, side),
        ],
    )
    ways = Selector(
        f"{where}: arm in", memory=True, children=[tuck_arm(f"{where}: tuck arm", context, side), free]
    )
    return _in_turn(context, where, turn, ways)


def _in_turn(context: TreeContext, where: str, turn: _Turn, way: Behaviour) -> Behaviour:
    def whose() -> str:
        turn.side = next((side for side in context.knowledge.hands if not tucked(context, side)), turn.side)
        return f"the {turn.side} arm"

    def done() -> bool:
        return all(tucked(context, side) for side in context.knowledge.hands)

    one = Sequence(f"{where}: next arm in", memory=True, children=[Note(f"{where}: whose turn", whose), way])
    return Selector(
        f"{where}: arms in",
        memory=True,
        children=[
            arms_tucked(f"{where}: arms tucked?", context),
            Each(f"{where}: one arm after the other", one, done, len(context.knowledge.hands)),
        ],
    )
