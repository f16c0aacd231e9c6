"""What a branch shares with its task, and what is its own."""

from __future__ import annotations

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.site import load
from tandem.testing import TreeBench
from tandem.trees.branch import branch


def test_no_goal_of_a_branch_has_the_number_of_one_before_a_restart() -> None:
    context = TreeBench(load("lab"), items={}).context
    context.notes.goals_before = {"left arm: grasp": 2}
    assert branch(context, "left arm").notes.next_attempt("left arm: grasp") == 3


def test_a_failure_of_one_branch_is_the_tasks_and_not_the_others() -> None:
    context = TreeBench(load("lab"), items={}).context
    left, right = branch(context, "left arm"), branch(context, "right arm")
    failure = Failure(kind=FailureKind.NO_PATH, message="no way")
    left.failures.add(failure)
    assert context.failures.last() == failure
    assert right.failures.last() != failure
