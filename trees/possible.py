"""Which statuses a node can have at all: what tests of a tree should have seen of it."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import FailureIsSuccess, Inverter

from tandem.skills.ports.tasks import NodeStatus
from tandem.trees.behaviours.act import Act, Lasting
from tandem.trees.behaviours.barrier import Meet
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.give_up import GiveUp
from tandem.trees.behaviours.guarded import Guarded
from tandem.trees.behaviours.meanwhile import Meanwhile
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.pause import Pause
from tandem.trees.behaviours.recovery import Allowance, Recovery
from tandem.trees.behaviours.remember import Remember, Verdict
from tandem.trees.behaviours.side_by_side import SideBySide
from tandem.trees.behaviours.take_turns import InTurn
from tandem.trees.behaviours.wait_for import WaitFor

Seen = frozenset[NodeStatus]
"""Statuses; INVALID stands for "interrupted while it was RUNNING"."""

_S, _F, _R, _I = NodeStatus.SUCCESS, NodeStatus.FAILURE, NodeStatus.RUNNING, NodeStatus.INVALID
_ALL: Final[Seen] = frozenset((_S, _F, _R, _I))
_AT_ONCE: Final[Seen] = frozenset((_S, _F))
_LEAVES: Final[tuple[tuple[type[Behaviour], Seen], ...]] = (
    (Lasting, frozenset((_F, _R, _I))),
    (Act, _ALL),
    (WaitFor, _ALL),
    (Meet, _ALL),
    (Pause, frozenset((_S, _R, _I))),
    (Check, _AT_ONCE),
    (Decide, _AT_ONCE),
    (Allowance, _AT_ONCE),
    (Verdict, _AT_ONCE),
    (Note, frozenset((_S,))),
    (GiveUp, frozenset((_F,))),
)


def possible(node: Behaviour) -> Seen:  # noqa: PLR0911 - one way out for each kind of node
    """Return the statuses that a node can have; all of them for a kind of node that isn't known here."""
    below = [possible(child) for child in node.children]
    for kind, statuses in _LEAVES:
        if isinstance(node, kind):
            return statuses
    lasting = frozenset((_R, _I)) if any(_R in each for each in below) else frozenset()
    if isinstance(node, (Sequence, SideBySide)):
        return (
            lasting | _if(_S, all(_S in each for each in below)) | _if(_F, any(_F in each for each in below))
        )
    if isinstance(node, Selector):
        return (
            lasting | _if(_S, any(_S in each for each in below)) | _if(_F, all(_F in each for each in below))
        )
    if isinstance(node, Recovery):
        return lasting | (below[0] & _AT_ONCE)
    if isinstance(node, (Meanwhile, InTurn)):
        return frozenset((_R, _I)) | (below[0] & _AT_ONCE)
    if isinstance(node, (FailureIsSuccess, Remember)):
        return lasting | {_S}
    if isinstance(node, Inverter):
        return lasting | _if(_S, _F in below[0]) | _if(_F, _S in below[0])
    if isinstance(node, Guarded):
        return _ALL
    return below[0] if below else _ALL


def _if(status: NodeStatus, can: bool) -> Seen:  # noqa: FBT001 - reads as the condition it is
    return frozenset((status,)) if can else frozenset()
