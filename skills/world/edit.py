"""Edit: the trees tell what they did to the world - added, attached, detached, removed, forgotten."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.actions.world import EDIT, EditFeedback, EditGoal, EditResult, SceneEdit
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.skill import ActionType, Run, failed, succeeded
from tandem.skills.ports.world import Placed
from tandem.skills.world.beliefs import Saved
from tandem.skills.world.keeper import Keeper

WHERE: Final = "world/edit"


class Edit:
    """The skill behind ``world/edit``. An edit that contradicts what is believed is refused.

    The same edit twice is no contradiction: a tree that starts again in the middle repeats its last one.

    Args:
        keeper: whose beliefs are edited.
    """

    period: Final = 0.1

    def __init__(self, keeper: Keeper) -> None:
        self._keeper = keeper

    @property
    def action(self) -> ActionType[EditGoal, EditFeedback, EditResult]:
        """The contract it fulfils."""
        return EDIT

    def check(self, goal: EditGoal) -> Failure | None:
        """Say what the edit contradicts, or None."""
        if self._keeper.beliefs.site.item(goal.item) is None:
            return _refusal(goal, FailureKind.ITEM_UNKNOWN, f"the site has no item {goal.item}")
        checks = {
            SceneEdit.ADD: self._check_add,
            SceneEdit.ATTACH: self._check_attach,
            SceneEdit.DETACH: self._check_detach,
            SceneEdit.REMOVE: self._check_in_no_hand,
            SceneEdit.FORGET: self._check_in_no_hand,
            SceneEdit.SELECT: self._check_select,
        }
        return checks[goal.edit](goal)

    def run(self, goal: EditGoal, goal_id: str) -> Run[EditFeedback, EditResult]:  # noqa: ARG002 - the contract's
        """Do the edit at once; it is journaled before it is published."""
        yield EditFeedback()
        refusal = self.check(goal)
        if refusal is not None:
            return failed(refusal)
        if not self._is_done(goal):
            before = self._keeper.beliefs.saved()
            refusal = self._apply(goal) or self._store(goal, before)
            if refusal is not None:
                return failed(refusal)
            self._keeper.publish()
        return succeeded(EditResult(version=self._keeper.beliefs.version))

    def _store(self, goal: EditGoal, before: Saved) -> Failure | None:
        """Write the edit down; if that fails it has not happened."""
        try:
            self._keeper.keep()
        except OSError as error:
            self._keeper.beliefs.restore(before)
            return _refusal(goal, FailureKind.NOT_STORED, f"the edit could not be written down: {error}")
        return None

    def _apply(self, goal: EditGoal) -> Failure | None:
        beliefs, now = self._keeper.beliefs, self._keeper.clocks.robot()
        if now is None:
            return _refusal(goal, FailureKind.NOT_READY, "the hardware's clock has not been heard yet")
        if goal.edit is SceneEdit.ADD:
            beliefs.add(goal.item)
        elif goal.edit is SceneEdit.REMOVE:
            beliefs.remove(goal.item)
        elif goal.edit is SceneEdit.FORGET:
            beliefs.forget(goal.item)
        elif goal.edit is SceneEdit.SELECT and goal.near is not None:
            beliefs.select(goal.item, goal.near)
        elif goal.edit is SceneEdit.ATTACH and goal.side is not None and goal.item_in_tool is not None:
            beliefs.attach(goal.item, goal.side, goal.item_in_tool, now)
            self._keeper.attached(goal.side, now)
        else:
            beliefs.detach(goal.item, goal.item_in_map, _placed(goal), now)
        return None

    def _is_done(self, goal: EditGoal) -> bool:
        """Whether a detach was done before: the item lies in that very slot."""
        slot = self._keeper.beliefs.slot_of(goal.item)
        return goal.edit is SceneEdit.DETACH and slot is not None and slot == _placed(goal)

    def _check_add(self, goal: EditGoal) -> Failure | None:
        if self._keeper.beliefs.item(goal.item) is None:
            return _refusal(goal, FailureKind.NOT_READY, f"item {goal.item} has not been seen yet")
        return None

    def _check_attach(self, goal: EditGoal) -> Failure | None:
        if goal.side is None or goal.item_in_tool is None:
            return _refusal(goal, FailureKind.INVALID_GOAL, "attach needs side and item_in_tool")
        if goal.side not in self._keeper.hands:
            known = ", ".join(self._keeper.hands)
            return _refusal(goal, FailureKind.INVALID_GOAL, f"no hand {goal.side!r}; there are {known}")
        other = self._keeper.beliefs.in_hand(goal.side)
        if other is not None and other.item != goal.item:
            message = f"the {goal.side} hand holds item {other.item}"
            return _refusal(goal, FailureKind.HAND_FULL, message, holds=other.item)
        side = self._keeper.beliefs.hand_of(goal.item)
        if side is not None and side != goal.side:
            return _refusal(goal, FailureKind.INVALID_GOAL, f"item {goal.item} is in the {side} hand")
        return None

    def _check_detach(self, goal: EditGoal) -> Failure | None:
        if (goal.depot is None) != (goal.slot is None):
            return _refusal(goal, FailureKind.INVALID_GOAL, "depot and slot go together")
        if goal.depot is not None and goal.slot is not None:
            refusal = self._check_slot(goal, goal.depot, goal.slot)
            if refusal is not None:
                return refusal
        side = self._keeper.beliefs.hand_of(goal.item)
        if side is None and not self._is_done(goal):
            return _refusal(goal, FailureKind.INVALID_GOAL, f"item {goal.item} is in no hand")
        if side is not None and goal.side is not None and goal.side != side:
            return _refusal(goal, FailureKind.INVALID_GOAL, f"item {goal.item} is in the {side} hand")
        return None

    def _check_slot(self, goal: EditGoal, name: str, slot: int) -> Failure | None:
        site = self._keeper.beliefs.site
        depot = site.depot(name)
        if depot is None:
            there = ", ".join(each.name for each in site.depots)
            return _refusal(goal, FailureKind.DESTINATION_UNKNOWN, f"no depot {name!r}; there are {there}")
        if not 0 <= slot < len(depot.slots):
            message = f"{name} has slots 0 to {len(depot.slots) - 1}, not {slot}"
            return _refusal(goal, FailureKind.INVALID_GOAL, message)
        other = self._keeper.beliefs.in_slot(name, slot)
        if other is not None and other != goal.item:
            message = f"slot {slot} of {name} holds item {other}"
            return _refusal(goal, FailureKind.DESTINATION_FULL, message, holds=other)
        return None

    def _check_select(self, goal: EditGoal) -> Failure | None:
        if goal.near is None:
            return _refusal(goal, FailureKind.INVALID_GOAL, "select needs near")
        if not self._keeper.beliefs.those(goal.item):
            return _refusal(goal, FailureKind.NOT_READY, f"item {goal.item} has not been seen yet")
        return self._check_in_no_hand(goal)

    def _check_in_no_hand(self, goal: EditGoal) -> Failure | None:
        side = self._keeper.beliefs.hand_of(goal.item)
        if side is not None:
            return _refusal(goal, FailureKind.INVALID_GOAL, f"item {goal.item} is in the {side} hand")
        return None


def _placed(goal: EditGoal) -> Placed | None:
    if goal.depot is None or goal.slot is None:
        return None
    return Placed(item=goal.item, depot=goal.depot, slot=goal.slot)


def _refusal(goal: EditGoal, kind: FailureKind, message: str, **evidence: int) -> Failure:
    facts: dict[str, str | float | int | bool] = {"edit": goal.edit.value, "item": goal.item, **evidence}
    return Failure(kind=kind, message=message, where=WHERE, evidence=facts)
