"""What is asked of an executive that has nothing to do begins with its acceptance: one commit keeps both."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from py_trees.behaviour import Behaviour
from surroundings import WAIT as KIND
from surroundings import Skill, Surroundings, WaitRequest, build

from tandem.executive.ledger.memory import MemoryLedger
from tandem.executive.ledger.port import Entry, LedgerError
from tandem.executive.trials.campaigns.crash_points import CrashLedger, CrashPoints
from tandem.skills.ports.action import goal_service
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, TREE, CancelTask, TaskState, TaskStatus
from tandem.skills.wire.memory import Kind
from tandem.trees.context import TreeContext

S = TaskState
NUDGING = {"task": "wait", "item": 29, "weight": 2.0}
SENT = f"query {goal_service('test/nudge').key}"
SHOWN = f"put {TREE.key}"


def observed() -> tuple[Surroundings, CrashPoints]:
    """Return an executive, and the points that it passes: what is kept and what is sent."""
    points = CrashPoints()
    here = Surroundings(ledger=lambda: CrashLedger(MemoryLedger(), points))

    def hear(kind: Kind, key: str, _: bytes) -> None:
        points.passing(f"{kind} {key}")

    here.hub.watch(hear)
    return here, points


def test_two_commits_stand_before_the_first_goal_and_none_between_that_and_the_tree() -> None:
    here, points = observed()
    Skill(here)
    here.ask(NUDGING)
    passed = [each for each in points.passed if each.startswith("after keeping") or each in {SENT, SHOWN}]
    assert passed == [
        "after keeping request and RUNNING",
        "after keeping goal of test/nudge",
        SENT,
        SHOWN,
    ]


def test_that_it_runs_is_kept_before_its_tree_is_built() -> None:
    here, points = observed()
    built_after: list[str] = []

    def watched(request: WaitRequest, context: TreeContext) -> Behaviour:
        built_after.extend(points.passed)
        return build(request, context)

    here.executive._kinds["wait"] = replace(KIND, build=watched)
    here.ask(NUDGING)
    assert "after keeping request and RUNNING" in built_after


def test_it_is_told_as_queued_and_then_as_running() -> None:
    here, _ = observed()
    here.ask(NUDGING)
    first, then = here.told()[:2]
    assert (first.state, first.begun, then.state, then.begun) == (S.QUEUED, 0, S.RUNNING, 1)


def test_one_that_is_cancelled_in_the_step_that_takes_it_sends_no_goal() -> None:
    here, points = observed()
    here.bus.query(REQUEST, json.dumps({**NUDGING, "id": "mine"}).encode())
    TASK_CANCEL.query(here.bus, CancelTask(task="mine"))
    here.step(3)
    assert here.told()[-1].state is S.CANCELED
    assert SENT not in points.passed


def test_of_several_only_the_next_one_begins() -> None:
    here, _ = observed()
    for priority in (0, 5, 0):
        here.bus.query(REQUEST, json.dumps({**NUDGING, "priority": priority}).encode())
    here.step()
    assert [each.state for each in here.executive.book.all()] == [S.QUEUED, S.RUNNING, S.QUEUED]


class Full(MemoryLedger):
    """A ledger that has no room for a task that runs."""

    def change(self, status: TaskStatus, at: float) -> None:
        if status.state is S.RUNNING:
            raise LedgerError("the disk is full")
        super().change(status, at)


class Unsynced(MemoryLedger):
    """A ledger whose disk keeps no request."""

    def __init__(self) -> None:
        super().__init__()
        self.entered = False

    def enter(self, entry: Entry) -> None:
        self.entered = True
        super().enter(entry)

    def commit(self) -> None:
        if self.entered:
            raise LedgerError("the disk is full")


@pytest.mark.parametrize("ledger", [Full, Unsynced])
def test_what_can_not_be_kept_is_refused_and_does_not_begin(ledger: type[MemoryLedger]) -> None:
    here = Surroundings(ledger=ledger)
    refused = here.ask(NUDGING)
    assert (refused.accepted, refused.problems[0].code) == (False, "NOT_KEPT")
    assert here.executive.idle
    assert not here.executive.book.all()
    assert not here.told()
