"""A whole system in lockstep, a client before it, and the truth behind it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field

import pybullet

from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import Scenario
from tandem.sim.truth import Truth, lies_on
from tandem.skills.ports.action import GoalStatus
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import (
    TASK_CANCEL,
    TASK_LIST,
    TASK_STATUS,
    TREE,
    AskTasks,
    CancelTask,
    ControlAnswer,
    NodeStatus,
    TaskList,
    TaskStatus,
    TreeSnapshot,
)
from tandem.skills.ports.world import WORLD, WorldState
from tandem.skills.site import load

REST_FOR = 0.5
"""Robot seconds over which a robot at rest must not have moved."""
STILL = 0.003
"""Metres and radians by which it may have, for its joints sag and its wheels settle."""


@dataclass(eq=False)
class Course:
    """What a test does to the system and reads from it; ``story`` holds what was told."""

    system: LockstepSystem
    site: Site
    story: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.caller = Caller(self.system, self.story.append)
        self._world = Latest(self.system.bus, WORLD)
        self._trees = Latest(self.system.bus, TREE)
        self._statuses = Latest(self.system.bus, TASK_STATUS, depth=4096)
        self._goals = self.system.bus.subscribe("skill/**", depth=1 << 16)
        self._states: dict[str, GoalStatus] = {}

    @property
    def seconds(self) -> float:
        """Robot seconds since the start."""
        return self.system.lockstep.seconds

    def ask(self, item: int) -> str:
        """Request a fetch; return the task's id."""
        answer = self.caller.request({"task": "fetch", "item": item})
        assert answer.accepted, answer.problems
        return answer.task

    def fetch(self, item: int, *, within: float = 300.0) -> TaskStatus:
        """Request a fetch and go on until it has ended."""
        return self.caller.follow(self.ask(item), within=within)

    def until(self, condition: Callable[[], bool], *, within: float) -> None:
        """Go on until the condition holds; fail, with the story, when it does not in time."""
        assert self.system.lockstep.run_until(condition, within=within), self.account()

    def account(self) -> str:
        """Return how all tasks stand, for when a test fails."""
        lines = [f"{self.seconds:.2f} s, running: {self.running()}"]
        for status in (sample for sample in self._statuses.take() if sample.state.terminal):
            chain = () if status.failure is None else status.failure.chain()
            lines += [f"{status.task} {status.state}", *(f"  {each.kind}: {each.message}" for each in chain)]
        return "\n".join([*self.story, *lines])

    def truth(self) -> Truth:
        """Return how things truly are."""
        return self.system.lockstep.station.truth()

    def delivered(self, item: int) -> bool:
        """Say whether, in truth, the item lies in the depot."""
        return lies_on(self.truth(), self.site, item, "depot")

    def world(self) -> WorldState | None:
        """Return what is believed."""
        return self._world.refresh()

    def running(self) -> tuple[str, ...]:
        """Return the paths of the tree's nodes that run."""
        tree: TreeSnapshot | None = self._trees.refresh()
        nodes = () if tree is None else tree.root.walk()
        return tuple(node.path for node in nodes if node.status is NodeStatus.RUNNING)

    def open_goals(self) -> tuple[str, ...]:
        """Return the goals of skills that have not ended."""
        for sample in self._goals.drain():
            if sample.key.endswith("/status"):
                status = GoalStatus.model_validate_json(sample.payload)
                self._states[status.goal_id] = status
        return tuple(goal for goal, status in self._states.items() if not status.state.terminal)

    def tasks(self) -> tuple[TaskStatus, ...]:
        """Return the executive's list."""
        pending = TASK_LIST.query(self.system.bus, AskTasks())
        self.until(pending.done, within=1.0)
        answer = pending.poll()
        assert answer is not None
        return TaskList.model_validate_json(answer).tasks

    def cancel(self, task: str) -> ControlAnswer:
        """Cancel a task."""
        pending = TASK_CANCEL.query(self.system.bus, CancelTask(task=task))
        self.until(pending.done, within=1.0)
        answer = pending.poll()
        assert answer is not None
        return ControlAnswer.model_validate_json(answer)

    def posture(self) -> tuple[float, ...]:
        """Return the base's true x, y, z and quaternion, and all joints' true positions but the wheels'."""
        station = self.system.lockstep.station
        base = station.truth().base_in_map
        body, client = station.body.body, station.physics.client
        joints = [
            pybullet.getJointState(body, index, physicsClientId=client)[0]
            for name, index in sorted(station.body.joint_index.items())
            if "wheel" not in name and "caster" not in name
        ]
        return (*base.position, *base.orientation, *joints)

    def moves(self) -> float:
        """Let half a second pass; return by how much the robot truly moved (m or rad, the largest)."""
        before = self.posture()
        end = self.seconds + REST_FOR
        self.until(lambda: self.seconds >= end, within=REST_FOR + 0.1)
        return max(abs(a - b) for a, b in zip(self.posture(), before, strict=True))


@contextmanager
def course(
    scenario: Scenario,
    *,
    seed: int = 1,
    site: Site | None = None,
    left_out: Mapping[str, str] | None = None,
) -> Iterator[Course]:
    """Start a system and end it; ``site`` stands in for the scenario's, ``left_out`` has plug-ins load."""
    system = LockstepSystem(scenario, seed, site=site, left_out=left_out)
    try:
        yield Course(system, site or load(scenario.site))
    finally:
        system.close()
