"""Explores a task's tree with mocked skills: each leaf fails in each way, is interrupted; the task must end.

Breadth first: a plan is a world and some leaves that fail; whatever leaves ran under it are made to fail in
turn, on top of it. So recoveries are reached, then recoveries that fail, and so on. No physics, no chance.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Final

from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.tasks import NodeStatus
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.behaviours.act import Act
from tandem.trees.possible import Seen, possible

STEPS_WITHIN: Final = 40_000
"""Ticks in which every task must have ended."""
LOST_FOR: Final = 100
"""Ticks for which a lost skill is gone, where it comes back."""

Make = Callable[[], TreeBench]
"""Makes a bench with the task started; worlds differ in what is where."""


@dataclass(frozen=True)
class Wrong:
    """A leaf that fails: with a kind, or by its skill's death for some ticks (None: for good)."""

    leaf: str
    kind: FailureKind | None
    dead_for: int | None = None

    def words(self) -> str:
        """Return it for people."""
        if self.kind is not None:
            return f"{self.leaf}: {self.kind}"
        return f"{self.leaf}: skill dies" + ("" if self.dead_for is None else f" for {self.dead_for} ticks")


@dataclass(frozen=True)
class Plan:
    """A world and what goes wrong in it."""

    world: str
    wrongs: tuple[Wrong, ...] = ()

    def words(self) -> str:
        """Return it for people."""
        return "; ".join((self.world, *(wrong.words() for wrong in self.wrongs)))


WRONGS: Final = (
    *(
        (kind, None)
        for kind in (
            FailureKind.NO_IK,
            FailureKind.BASE_BLOCKED,
            FailureKind.ITEM_GONE,
            FailureKind.ITEM_HIDDEN,
            FailureKind.GRASP_LOST,
            FailureKind.NOT_LOCALISED,
            FailureKind.CAMERA_SILENT,
            FailureKind.HARDWARE_STOPPED,
        )
    ),
    (None, LOST_FOR),
    (None, None),
)
"""One kind for each condition over kinds, a skill's death, and its death for good."""


@dataclass
class Coverage:
    """Which statuses were seen of each node, by its name, and what broke an invariant."""

    seen: dict[str, set[NodeStatus]] = field(default_factory=dict)
    wanted: dict[str, Seen] = field(default_factory=dict)
    runs: int = 0
    ticks: int = 0
    broken: list[str] = field(default_factory=list)

    def missing(self) -> dict[str, tuple[NodeStatus, ...]]:
        """Return what can be and was not seen, by node."""
        gaps = {name: tuple(sorted(can - self.seen.get(name, set()))) for name, can in self.wanted.items()}
        return {name: gap for name, gap in gaps.items() if gap}

    def take(self, bench: TreeBench) -> None:
        """Take in all that was seen in a run that has ended."""
        assert bench.root is not None, "it was started"
        for node in bench.root.iterate():
            if node.name not in self.wanted:  # to ask what is possible looks at all that is below
                self.wanted[node.name] = possible(node)
                self.seen.setdefault(node.name, set())
        running: set[str] = set()
        for name, status in bench.visited:
            if status is not Status.INVALID or name in running:
                self.seen.setdefault(name, set()).add(NodeStatus(status.name))
            if status is Status.RUNNING:
                running.add(name)
            else:
                running.discard(name)


def explore(
    worlds: Mapping[str, Make], corners: Mapping[str, Make], *, depth: int, tell: Callable[[str], None]
) -> Coverage:
    """Explore plans up to ``depth`` wrongs in one.

    Args:
        worlds: by name; each makes a bench anew.
        corners: worlds in which nothing more is made to go wrong.
        depth: of plans; the coverage usually is complete at 3.
        tell: gets each plan in words before it is run.
    """
    coverage, makers = Coverage(), {**worlds, **corners}
    reached: dict[str, Plan] = {}
    tried: set[Wrong] = set()
    waiting = deque(Plan(world) for world in makers)
    while waiting:
        plan = waiting.popleft()
        tell(plan.words())
        for leaf in _run(makers[plan.world](), plan, coverage):
            reached.setdefault(leaf, plan)
            if len(plan.wrongs) < depth and plan.world in worlds:
                waiting.extend(_next_plans(plan, leaf, tried))
    for leaf, plan in reached.items():
        tell(f"{plan.words()}; cancelled at {leaf}")
        _interrupt(makers[plan.world](), plan, leaf, coverage)
    return coverage


def _next_plans(plan: Plan, leaf: str, tried: set[Wrong]) -> Iterator[Plan]:
    """Yield the plan with the leaf failing in each way that has not been tried under an earlier plan."""
    if any(wrong.leaf == leaf for wrong in plan.wrongs):
        return
    for kind, dead_for in WRONGS:
        wrong = Wrong(leaf, kind, dead_for)
        if wrong not in tried:
            tried.add(wrong)
            yield Plan(plan.world, (*plan.wrongs, wrong))


def _run(bench: TreeBench, plan: Plan, coverage: Coverage) -> list[str]:
    """Run a plan to its end; return the leaves that were RUNNING, in order."""
    ran: dict[str, None] = {}
    status, steps = Status.RUNNING, 0
    accident = _Accident(bench, plan)
    while status is Status.RUNNING and steps < STEPS_WITHIN:
        accident.step()
        status = bench.step()
        steps += 1
        if moves_stretched(bench):
            coverage.broken.append(f"{plan.words()}: base and stretched arm move together")
        for node in bench.running_leaves():
            ran[node.name] = None
    coverage.runs += 1
    coverage.ticks += steps
    coverage.take(bench)
    coverage.broken.extend(f"{plan.words()}: {what}" for what in broken(bench, status))
    return list(ran)


def _interrupt(bench: TreeBench, plan: Plan, leaf: str, coverage: Coverage) -> None:
    """Run a plan until a leaf is RUNNING, and cancel the task there."""
    accident = _Accident(bench, plan)
    status = Status.RUNNING
    for _ in range(STEPS_WITHIN):
        accident.step()
        status = bench.step()
        coverage.ticks += 1
        if status is not Status.RUNNING or any(node.name == leaf for node in bench.running_leaves()):
            break
    coverage.runs += 1
    at_rest = bench.interrupt()
    coverage.take(bench)
    if not at_rest:
        coverage.broken.append(f"{plan.words()}; cancelled at {leaf}: its skills did not come to rest")


class _Accident:
    """Makes a plan's wrongs happen."""

    def __init__(self, bench: TreeBench, plan: Plan) -> None:
        self._bench = bench
        self._deaths = {wrong.leaf: wrong for wrong in plan.wrongs if wrong.kind is None}
        self._back: dict[str, int] = {}
        self._steps = 0
        for wrong in plan.wrongs:
            if wrong.kind is not None:
                failure = Failure(kind=wrong.kind, message="as planned")
                bench.robot.leaf_faults[wrong.leaf] = Fault(failure=failure)
            else:
                bench.robot.leaf_faults[wrong.leaf, 1] = Fault(hangs=True)

    def step(self) -> None:
        """Let die whose turn it is, and bring back who was gone long enough."""
        self._steps += 1
        for action, at in list(self._back.items()):
            if self._steps >= at:
                del self._back[action]
                self._bench.robot.bring_back(action)
        for node in self._bench.running_leaves():
            wrong = self._deaths.get(node.name)
            action = node.skill if isinstance(node, Act) else ""
            if wrong is None or action not in self._bench.robot.busy:
                continue
            del self._deaths[node.name]
            self._bench.robot.lose(action)
            if wrong.dead_for is not None:
                self._back[action] = self._steps + wrong.dead_for


def moves_stretched(bench: TreeBench) -> bool:
    """Say whether the base is under way while an arm is out or moves."""
    busy = bench.robot.busy
    arms = any(name.startswith("arm_") and name.endswith("/move") for name in busy)
    return any(name in {"base/drive", "base/rotate"} for name in busy) and (arms or bench.robot.arms_out)


def broken(bench: TreeBench, status: Status) -> list[str]:
    """Return in words which invariants a task that has ended has broken."""
    wrong = []
    if status is Status.RUNNING:
        wrong.append(f"did not end within {STEPS_WITHIN} ticks")
    if not bench.context.quiet:
        wrong.append("a skill is still at work after the end")
    for name in ("base", "head", "arm_left", "arm_right", "gripper_left", "gripper_right"):
        holder = bench.context.resources.holder(name)
        if holder is not None:
            wrong.append(f"{name} is still held by {holder}")
    failure = bench.failure()
    if status is Status.FAILURE and failure is None:
        wrong.append("failed without a reason")
    if status is Status.FAILURE and failure is not None and bench.robot.localised:
        told = {"robot_is", "item_is"} if bench.about_items else {"robot_is"}
        missing = told - set(failure.evidence)
        wrong.extend(f"the failure does not say {each}" for each in sorted(missing))
    if status is Status.SUCCESS and not bench.ends_anywhere and bench.robot.base != bench.context.site.home:
        wrong.append("succeeded, and is not at home")
    return wrong
