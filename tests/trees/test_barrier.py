"""The barrier, turns, things side by side and meanwhile: each with scripts for children, a tick at a time."""

from __future__ import annotations

import pytest
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.site import load
from tandem.trees.behaviours.barrier import Barrier, Meet, Member
from tandem.trees.behaviours.meanwhile import Meanwhile
from tandem.trees.behaviours.side_by_side import SideBySide
from tandem.trees.behaviours.take_turns import InTurn, Turn
from tandem.trees.branch import branch
from tandem.trees.context import TreeContext
from tandem.trees.leaves.coordinate import coordinate

K = FailureKind
S, F, R, GONE = Status.SUCCESS, Status.FAILURE, Status.RUNNING, Status.INVALID
LEFT, RIGHT = "left arm", "right arm"


class Script(Behaviour):
    """Does what it is told, one status a tick, the last for ever; a FAILURE is a failure of its kind."""

    def __init__(self, name: str, context: TreeContext, statuses: str, kind: FailureKind = K.NO_IK) -> None:
        super().__init__(name)
        self._context, self._left, self._kind, self.ticks = context, list(statuses), kind, 0
        self.stopped = False

    def update(self) -> Status:
        self.ticks += 1
        status = {"S": S, "F": F, "R": R}[self._left.pop(0) if len(self._left) > 1 else self._left[0]]
        if status is F:
            self._context.failures.add(Failure(kind=self._kind, message=f"{self.name} failed"))
        return status

    def terminate(self, new_status: Status) -> None:
        self.stopped = self.stopped or new_status is GONE


@pytest.fixture
def bench() -> TreeBench:
    return TreeBench(load("lab"), items={}, step=0.1)


def play(root: Behaviour, most: int = 30) -> int:
    """Tick to the end; return how many ticks it took."""
    for tick in range(1, most + 1):
        root.tick_once()
        if root.status is not R:
            return tick
    return most


class Two:
    """Both arms walk up to a barrier, meet, and go on."""

    def __init__(
        self, context: TreeContext, before: tuple[str, str], after: tuple[str, str] = ("S", "S")
    ) -> None:
        self.context, self.barrier = context, Barrier(LEFT, RIGHT)
        self.after: dict[str, Script] = {}
        rows = zip((LEFT, RIGHT), before, after, strict=True)
        self.root = SideBySide("both", context, tuple(self._arm(*row) for row in rows))

    def _arm(self, who: str, before: str, after: str):  # type: ignore[no-untyped-def]  # noqa: ANN202
        at = branch(self.context, who)
        self.after[who] = Script(f"{who}: after", at, after, K.GRASP_EMPTY)
        steps = [
            Script(f"{who}: before", at, before),
            Meet(f"{who}: meet", at, self.barrier, who),
            self.after[who],
        ]
        walk = Sequence(f"{who}: walk", memory=True, children=steps)
        return at, Member(f"{who}: member", at, walk, self.barrier, who)


@pytest.mark.parametrize(
    ("before", "ticks"), [(("S", "RRRS"), 5), (("RRRS", "S"), 4), (("S", "S"), 2), (("RS", "RS"), 3)]
)
def test_both_go_on_when_the_later_one_is_there(
    bench: TreeBench, before: tuple[str, str], ticks: int
) -> None:
    two = Two(bench.context, before)
    assert play(two.root) == ticks
    assert two.root.status is S
    assert all(script.ticks == 1 for script in two.after.values())


@pytest.mark.parametrize(("before", "who", "waits"), [(("F", "S"), LEFT, RIGHT), (("S", "RRF"), RIGHT, LEFT)])
def test_one_that_fails_before_lets_the_other_go_with_that_failure(
    bench: TreeBench, before: tuple[str, str], who: str, waits: str
) -> None:
    two = Two(bench.context, before)
    play(two.root)
    assert two.root.status is F
    assert two.after[waits].ticks == 0, "it must not go on alone"
    told = bench.context.failures.last()
    assert (told.kind, told.evidence["failed"]) == (K.NO_IK, f"{LEFT} and {RIGHT}")
    assert told.message == f"{who}: before failed"
    (other,) = [each for each in told.chain() if each.kind is K.OTHER_ARM_FAILED]
    assert other.evidence["failed"] == who


def test_one_that_fails_after_leaves_the_other_to_its_end(bench: TreeBench) -> None:
    two = Two(bench.context, ("S", "S"), after=("F", "RRRS"))
    play(two.root)
    assert two.root.status is F
    assert two.after[RIGHT].ticks == 4
    assert bench.context.failures.last().evidence["failed"] == LEFT


def test_one_that_has_nothing_to_wait_for_is_not_waited_for(bench: TreeBench) -> None:
    barrier = Barrier(LEFT, RIGHT)
    done = Member("done", bench.context, Script("done already", bench.context, "S"), barrier, LEFT)
    done.tick_once()
    meet = Meet("meet", bench.context, barrier, RIGHT)
    meet.tick_once()
    assert meet.status is S


def test_one_that_is_called_away_is_waited_for_again(bench: TreeBench) -> None:
    barrier = Barrier(LEFT, RIGHT)
    left, right = (Meet(f"{who}: meet", bench.context, barrier, who) for who in (LEFT, RIGHT))
    left.tick_once()
    left.stop(GONE)
    right.tick_once()
    assert (right.status, barrier.missing()) == (R, (LEFT,))
    assert barrier.reset() == "left arm and right arm will wait for each other"


@pytest.mark.parametrize(
    ("left", "right", "order"),
    [
        ("RRS", "RS", ["left", "left", "left", "right", "right"]),
        ("F", "RS", ["left", "right", "right"]),
        ("S", "S", ["left", "right"]),
    ],
)
def test_who_comes_first_goes_first_however_it_ends(
    bench: TreeBench, left: str, right: str, order: list[str]
) -> None:
    turn, seen = Turn(), []
    scripts = {"left": Script("left", bench.context, left), "right": Script("right", bench.context, right)}
    roots = [InTurn(f"{who} in turn", turn, who, script) for who, script in scripts.items()]
    for _ in range(8):
        for root in roots:
            if root.status in {S, F}:
                continue
            root.tick_once()
            if root.decorated.status is not GONE:
                seen.append(root.decorated.name)
    assert seen == order
    assert turn.holder is None


def test_one_that_is_called_away_gives_its_turn_or_its_place_back(bench: TreeBench) -> None:
    turn = Turn()
    first, second, third = (
        InTurn(f"{who} in turn", turn, who, Script(who, bench.context, "RS")) for who in ("a", "b", "c")
    )
    for root in (first, second, third):
        root.tick_once()
    assert second.feedback_message == "waits until the a is done"
    second.stop(GONE)
    first.stop(GONE)
    assert turn.holder == "c"
    third.tick_once()
    assert third.decorated.status is R


def test_things_side_by_side_all_come_to_their_end(bench: TreeBench) -> None:
    branches = {who: branch(bench.context, who) for who in (LEFT, RIGHT)}
    scripts = [Script(who, at, "F" if who == LEFT else "RRRS") for who, at in branches.items()]
    root = SideBySide("both", bench.context, tuple(zip(branches.values(), scripts, strict=True)))
    assert play(root) == 4
    assert (root.status, scripts[1].stopped) == (F, False)
    assert bench.context.failures.last().message == "left arm failed"
    root.stop(GONE)
    root.tick_once()
    assert [script.ticks for script in scripts] == [2, 5], "it begins anew"


def test_what_goes_on_meanwhile_is_stopped_and_at_rest_at_the_end(bench: TreeBench) -> None:
    at = branch(bench.context, "coordination")
    beside = coordinate("coordinate", at, "eager")
    main = Script("main", bench.context, "RRRRRS")
    bench.root = Meanwhile("meanwhile", bench.context, main, beside)
    ended = [bench.step() for _ in range(12)]
    assert ended.index(S) > 5, "it waits for the rest"
    assert beside.status is GONE
    assert bench.context.quiet
    assert bench.robot.busy == ()


@pytest.mark.parametrize("how", ["F", "S"])
def test_what_goes_on_meanwhile_may_end_before(bench: TreeBench, how: str) -> None:
    beside = Script("beside", branch(bench.context, "beside"), how)
    root = Meanwhile("meanwhile", bench.context, Script("main", bench.context, "RRS"), beside)
    assert play(root) == 3
    assert (root.status, beside.ticks) == (S, 1)
    root.tick_once()
    assert beside.ticks == 2, "it begins anew"
