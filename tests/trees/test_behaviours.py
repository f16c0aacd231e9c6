"""Each behaviour alone: a tree of one or two nodes, and a clock."""

from __future__ import annotations

import pytest
from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.executive.trials.exploration.worlds import fetch_worlds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.behaviours.again import Again
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.give_up import GiveUp
from tandem.trees.behaviours.give_way import FREE_WITHIN, REFLEX, GiveWay
from tandem.trees.behaviours.guarded import Guarded
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.pause import Pause
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.context import TreeContext
from tandem.trees.leaves.drive import drive

K = FailureKind
S, F, R = Status.SUCCESS, Status.FAILURE, Status.RUNNING


class Script(Behaviour):
    """Does what it is told, one status a tick; each FAILURE is a failure of this kind."""

    def __init__(
        self, name: str, context: TreeContext, *statuses: Status, kind: FailureKind = K.NO_IK
    ) -> None:
        super().__init__(name)
        self._context, self._statuses, self._kind, self.ticks = context, list(statuses), kind, 0

    def update(self) -> Status:
        self.ticks += 1
        status = self._statuses.pop(0) if len(self._statuses) > 1 else self._statuses[0]
        if status is F:
            self._context.failures.add(Failure(kind=self._kind, message=self.name))
        return status


@pytest.fixture
def bench() -> TreeBench:
    return TreeBench(load("lab"), items={}, step=0.1)


def play(bench: TreeBench, root: Behaviour, most: int = 100) -> list[Status]:
    """Tick until the end; return the statuses."""
    seen = []
    for _ in range(most):
        bench.clocks.advance(0.1)
        root.tick_once()
        seen.append(root.status)
        if root.status is not R:
            break
    return seen


def always(_: Failure) -> bool:
    return True


def recovery(context: TreeContext, main: Behaviour, *steps: RecoveryStep, within: float = 100.0) -> Recovery:
    return Recovery("recovery", context, main, steps, within=within)


def test_recovery_asks_the_cheap_step_first_and_the_dear_one_when_that_is_used_up(bench: TreeBench) -> None:
    context = bench.context
    main = Script("main", context, F, F, F, S)
    cheap, dear = Script("cheap repair", context, S), Script("dear repair", context, S)
    tree = recovery(
        context, main, RecoveryStep("cheap", always, 2, cheap), RecoveryStep("dear", always, 1, dear)
    )
    assert play(bench, tree)[-1] is S
    assert [(each.recovery, each.times) for each in context.failures.attempts] == [
        ("cheap", 1),
        ("cheap", 2),
        ("dear", 1),
    ]


def test_recovery_gives_up_when_all_is_used_up(bench: TreeBench) -> None:
    context = bench.context
    tree = recovery(
        context, Script("main", context, F), RecoveryStep("step", always, 2, Note("repair", lambda: ""))
    )
    assert play(bench, tree)[-1] is F
    assert [each.recovery for each in context.failures.attempts] == ["step", "step", ""]


def test_recovery_hands_over_to_the_next_step_when_a_repair_fails(bench: TreeBench) -> None:
    context = bench.context
    bad, good = Script("bad repair", context, F), Script("good repair", context, S)
    tree = recovery(
        context,
        Script("main", context, F, S),
        RecoveryStep("bad", always, 1, bad),
        RecoveryStep("good", always, 1, good),
    )
    assert play(bench, tree)[-1] is S
    assert good.ticks == 1


def test_recovery_repairs_nothing_that_no_step_takes(bench: TreeBench) -> None:
    context = bench.context
    repair = Script("repair", context, S)
    tree = recovery(context, Script("main", context, F), RecoveryStep("never", lambda _: False, 5, repair))
    assert play(bench, tree) == [F]
    assert repair.ticks == 0


def test_recovery_is_bounded_in_robot_time(bench: TreeBench) -> None:
    context = bench.context
    slow = RecoveryStep("slow", always, 100, Pause("pause", context, 3.0))
    tree = recovery(context, Script("main", context, F), slow, within=5.0)
    assert play(bench, tree, most=1000)[-1] is F
    assert bench.clocks.seconds < 8.0


def test_what_a_recovery_below_has_given_up_is_not_tried_above_in_the_same_way(bench: TreeBench) -> None:
    context = bench.context
    main = Script("main", context, F)
    below = Recovery(
        "below", context, main, (RecoveryStep("again below", always, 2, Note("n1", lambda: "")),), within=99.0
    )
    above = Recovery(
        "above",
        context,
        below,
        (RecoveryStep("again above", always, 2, Note("n2", lambda: "")),),
        within=99.0,
    )
    assert play(bench, above)[-1] is F
    assert main.ticks == 3


def test_guarded_stops_its_child_and_fails_with_the_reason(bench: TreeBench) -> None:
    context, child, holds = bench.context, Script("child", bench.context, R), [True]
    lost = Failure(kind=K.GRASP_LOST, message="fell")
    tree = Guarded("guard", context, child, holds=lambda: holds[0], otherwise=lambda: lost)
    assert play(bench, tree, most=3) == [R, R, R]
    holds[0] = False
    assert play(bench, tree, most=3) == [F]
    assert child.status is Status.INVALID
    assert context.failures.last().kind is K.GRASP_LOST


def test_a_failure_is_told_as_the_recovery_concludes_it(bench: TreeBench) -> None:
    context = bench.context
    tree = Recovery(
        "recovery",
        context,
        Script("main", context, F),
        (),
        within=1.0,
        conclude=lambda failure: Failure(kind=K.ITEM_UNREACHABLE, message="", causes=(failure,)),
    )
    assert play(bench, tree) == [F]
    assert [each.kind for each in context.failures.last().chain()] == [K.ITEM_UNREACHABLE, K.NO_IK]


class AtWork(Script):
    """Has a skill at work, which needs a moment to come to rest when it is cancelled."""

    def initialise(self) -> None:
        self._leaf = drive("drive", self._context, lambda: (FloorPose(x=1.0, y=0.0, yaw=0.0),))

    def update(self) -> Status:
        self._leaf.tick_once()
        return self._leaf.status

    def terminate(self, new_status: Status) -> None:
        self._leaf.stop(new_status)


def test_guarded_waits_for_rest_before_it_fails(bench: TreeBench) -> None:
    context, holds = bench.context, [True]
    bench.robot.leaf_faults["drive"] = Fault(hangs=True)
    lost = Failure(kind=K.GRASP_LOST, message="fell")
    tree = Guarded(
        "guard", context, AtWork("child", context, R), holds=lambda: holds[0], otherwise=lambda: lost
    )
    bench.root = tree
    for _ in range(5):
        bench.step()
    holds[0] = False
    seen = [bench.step() for _ in range(10)]
    assert seen[0] is R
    assert seen[seen.index(F) - 1] is R
    assert bench.robot.busy == ()


def test_a_resource_is_free_when_its_goal_ended_unseen(bench: TreeBench) -> None:
    context = bench.context
    leaf = drive("drive", context, lambda: (FloorPose(x=1.0, y=0.0, yaw=0.0),))
    leaf.tick_once()
    assert context.resources.holder("base") is not None
    for _ in range(5):  # the goal ends, and the leaf is not ticked
        bench.clocks.advance(0.1)
        bench.robot.step()
        context.poll()
    assert context.quiet
    leaf.stop(Status.INVALID)
    assert context.resources.holder("base") is None


def test_wait_for_takes_at_least_its_time(bench: TreeBench) -> None:
    never = Failure(kind=K.TIMED_OUT, message="never")
    tree = WaitFor("wait", bench.context, lambda: True, lambda: never, patience=5.0, at_least=1.0)
    assert len(play(bench, tree)) == 11


@pytest.mark.parametrize(("for_a_process", "last"), [(False, F), (True, R)])
def test_who_waits_for_a_process_is_not_hurried_by_a_robot_faster_than_real_time(
    bench: TreeBench, monkeypatch: pytest.MonkeyPatch, last: Status, *, for_a_process: bool
) -> None:
    monkeypatch.setattr(bench.clocks, "monotonic", lambda: bench.clocks.seconds / 10)
    never = Failure(kind=K.SKILL_LOST, message="not yet")
    tree = WaitFor(
        "wait", bench.context, lambda: False, lambda: never, patience=5.0, for_a_process=for_a_process
    )
    assert play(bench, tree, most=60)[-1] is last
    assert play(bench, tree, most=600)[-1] is F


def test_timers_stand_while_the_task_is_paused(bench: TreeBench) -> None:
    tree = Pause("pause", bench.context, 1.0)
    play(bench, tree, most=5)
    bench.clocks.advance(100.0)
    bench.context.paused_for += 100.0
    assert play(bench, tree, most=3) == [R, R, R]


def test_again_stops_at_a_kind_that_does_not_allow_it(bench: TreeBench) -> None:
    child = Script("child", bench.context, F, kind=K.CAMERA_SILENT)
    tree = Again("again", bench.context, child, 9, lambda failure: failure.kind is K.ITEM_NOT_FOUND)
    assert play(bench, tree) == [F]


@pytest.mark.parametrize(("statuses", "times", "last"), [((F, F, S), 3, S), ((F, F, S), 2, F)])
def test_again_counts(bench: TreeBench, statuses: tuple[Status, ...], times: int, last: Status) -> None:
    tree = Again("again", bench.context, Script("child", bench.context, *statuses), times, always)
    assert play(bench, tree)[-1] is last


def test_each_goes_on_until_nothing_is_left(bench: TreeBench) -> None:
    child = Script("child", bench.context, S)
    tree = Each("each", child, lambda: child.ticks == 2, 5)
    assert play(bench, tree) == [R, S]


def test_pause_takes_its_time(bench: TreeBench) -> None:
    assert len(play(bench, Pause("pause", bench.context, 1.0))) == 11


def test_give_up_says_why(bench: TreeBench) -> None:
    tree = GiveUp("give up", bench.context, lambda: Failure(kind=K.ITEM_NOT_FOUND, message="nowhere"))
    assert play(bench, tree) == [F]
    assert bench.context.failures.last().where == "give up"


@pytest.mark.parametrize(("busy", "last"), [(5.0, S), (FREE_WITHIN + 1.0, F)])
def test_a_drive_waits_for_the_base_until_its_patience_ends(
    bench: TreeBench, busy: float, last: Status
) -> None:
    context = bench.context
    taken = Failure(kind=K.OVERRIDDEN, message="took", evidence={REFLEX: "bumper"})

    class Overridden(Script):
        def update(self) -> Status:
            status = super().update()
            if status is F:
                context.failures.add(taken)
            return status

    child, start = Overridden("drive", context, F, S), context.seconds
    tree = GiveWay(
        "give way",
        context,
        child,
        lambda _: None,
        settles=False,
        free=lambda: context.seconds - start > busy,
    )
    assert play(bench, tree, most=1000)[-1] is last
    assert child.ticks == (2 if last is S else 1)


def test_a_leaf_says_how_far_its_skill_is_in_words_and_no_lists() -> None:
    bench, said = fetch_worlds()["in view"](), set[str]()
    bench.robot.leaf_faults["pre-grasp", 1] = Fault(late=1.0)
    while bench.step() is Status.RUNNING:
        assert bench.root is not None
        said |= {node.feedback_message for node in bench.root.iterate()}
    assert "running: phase MOVING, progress 0.00" in said, "the corners of its way are left out"
