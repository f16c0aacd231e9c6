"""Robot seconds of a fetch in lockstep, phase by phase: Demo's own, and one with the item in the first view.

Each motion of an arm is held against the bang-bang bound of its joints: the time without any limit of jerk,
without obstacles and in no straight line, from where it starts to where it ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from pydantic import JsonValue

from benchmarks.rows import Row, quantile
from tandem.executive.system.systems import LockstepSystem, SystemFailure
from tandem.executive.trials.demo import Caller
from tandem.executive.trials.phase_times import Phases
from tandem.sim.scenario import Scenario, load_scenario
from tandem.sim.truth import lies_on
from tandem.skills.arm.timing import bang_bang
from tandem.skills.arm.trajectory import MotionLimits
from tandem.skills.ports.hardware import TrajectoryGoal
from tandem.skills.ports.keys import group_goal
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.tasks import TREE, NodeStatus, TaskState, TreeNode
from tandem.skills.site import load
from tandem.skills.wire.memory import Kind

ITEM: Final = 29
REQUESTED: Final[dict[str, JsonValue]] = {"task": "fetch", "item": ITEM, "to": "depot"}
NEAR_THE_TABLE: Final = FloorPose(x=-0.90, y=0.60, yaw=0.0)
"""From here the camera sees the item at the first look."""
WITHIN: Final = 240.0


@dataclass
class Motions:
    """Listens to the bus for the arms' goals; each with its seconds over the bound's."""

    description: RobotDescription
    ratios: list[float] = field(default_factory=list)
    seconds: float = 0.0

    def __call__(self, kind: Kind, key: str, payload: bytes) -> None:
        """Take one message in."""
        hands = {group_goal(hand.group).key: hand.group for hand in self.description.end_effectors}
        if kind != "query" or key not in hands:
            return
        points = TrajectoryGoal.model_validate_json(payload).points
        limits = self.description.group(hands[key]).limits
        motion = MotionLimits(
            np.array([each.velocity for each in limits]),
            np.array([each.acceleration for each in limits]),
            np.array([each.jerk for each in limits]),
        )
        bound = bang_bang(np.array(points[0].positions), np.array(points[-1].positions), motion)
        taken = points[-1].time - points[0].time
        self.seconds += taken
        if bound > 0.0:
            self.ratios.append(taken / bound)


@dataclass
class Trees:
    """Listens to the bus for the tree: how often it is told, and how often for what its nodes say alone."""

    told: int = 0
    words: int = 0
    largest: int = 0
    _last: list[tuple[NodeStatus, NodeStatus]] = field(default_factory=list)

    def __call__(self, kind: Kind, key: str, payload: bytes) -> None:
        """Take one message in."""
        if kind != "put" or key != TREE.key:
            return
        statuses = list(_statuses(TREE.decode(payload).root))
        self.told += 1
        self.words += statuses == self._last
        self.largest, self._last = max(self.largest, len(payload)), statuses


def _statuses(node: TreeNode) -> Iterator[tuple[NodeStatus, NodeStatus]]:
    yield node.status, node.last
    for child in node.children:
        yield from _statuses(child)


def rows() -> Iterator[Row]:
    """Measure."""
    demo = load_scenario("Demo")
    yield from fetch("Demo", demo, aim=None)
    yield from fetch("item in the first view", demo.starting_at(NEAR_THE_TABLE), aim=60.0)


def fetch(name: str, scenario: Scenario, *, aim: float | None) -> Iterator[Row]:
    """Fetch once, and say how long what took."""
    system = LockstepSystem(scenario, 1)
    try:
        motions, phases = Motions(system.lockstep.station.model.description), Phases(system)
        trees = Trees()
        system.lockstep.hub.watch(motions)
        system.lockstep.hub.watch(trees)
        caller = Caller(system, lambda _: None, also=phases)
        began = system.lockstep.seconds
        task = caller.request(REQUESTED).task
        try:
            status = caller.follow(task, within=WITHIN)
            ended = status.state.value.lower() if status.failure is None else status.failure.message
            right = status.state is TaskState.SUCCEEDED and lies_on(
                caller.truth(), load(scenario.site), ITEM, "depot"
            )
        except SystemFailure as failure:
            ended, right = str(failure), False
        seconds = system.lockstep.seconds - began
        phases.step()
        note = f"{ended}; {'the item lies in the depot' if right else 'NOT RIGHT, so no figure to go by'}"
        yield Row(f"fetch, {name}", seconds, "robot s", aim, note=note)
        for phase, spent in phases.seconds().items():
            yield Row(f"fetch, {name}: {phase}", spent, "robot s")
        yield Row(f"fetch, {name}: arms in motion", motions.seconds, "robot s", note=_count(motions))
        over = f"fetch, {name}: arm motions over bang-bang"
        yield Row(f"{over}, median", quantile(motions.ratios, 0.5), "", 1.5)
        yield Row(f"{over}, p95", quantile(motions.ratios, 0.95), "")
        words = f"{trees.words} for words alone; {trees.largest / 1000:.0f} kB at most"
        yield Row(f"fetch, {name}: trees told", float(trees.told), "", note=words)
    finally:
        system.close()


def _count(motions: Motions) -> str:
    return f"{len(motions.ratios)} motions, both arms"
