"""Which recovery takes which kind of failure: the table behind the page of failures.

Read from the conditions over kinds themselves; in the order in which they are asked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.conditions.kinds.another_grasp_helps import another_grasp_helps
from tandem.trees.conditions.kinds.another_slot_helps import another_slot_helps
from tandem.trees.conditions.kinds.another_stand_helps import another_stand_helps
from tandem.trees.conditions.kinds.another_view_helps import another_view_helps
from tandem.trees.conditions.kinds.another_way_helps import another_way_helps
from tandem.trees.conditions.kinds.fetching_again_helps import fetching_again_helps
from tandem.trees.conditions.kinds.localising_helps import localising_helps
from tandem.trees.conditions.kinds.looking_again_helps import looking_again_helps
from tandem.trees.conditions.kinds.searching_again_helps import searching_again_helps
from tandem.trees.conditions.kinds.trying_again_helps import trying_again_helps
from tandem.trees.conditions.kinds.waiting_helps import waiting_helps

_STEPS: Final[tuple[tuple[Callable[[Failure], bool], str], ...]] = (
    (waiting_helps, "wait until it is back"),
    (localising_helps, "find out where I am"),
    (another_way_helps, "another way: wait, then other stands"),
    (another_view_helps, "look at it from another stand"),
    (looking_again_helps, "look around again"),
    (another_grasp_helps, "draw back, grasp another way"),
    (searching_again_helps, "go home and search again"),
    (another_slot_helps, "another slot"),
    (another_stand_helps, "with the item in the hand: another stand, then begin from home"),
    (fetching_again_helps, "lost on the way: fetch it again"),
    (trying_again_helps, "when letting go: once more"),
)


def _of(kind: FailureKind) -> str:
    failure = Failure(kind=kind, message="")
    return "; ".join(words for helps, words in _STEPS if helps(failure))


RECOVERIES: Final[Mapping[FailureKind, str]] = MappingProxyType({kind: _of(kind) for kind in FailureKind})
"""In words; empty where nothing is tried and the task ends, at home."""
