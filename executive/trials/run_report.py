"""The report of a run as JSON: what was asked, each change of state and of a tree's node, each failure.

All but ``this_run`` is the same for two lockstep runs of one seed.
"""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Final, Literal

from pydantic import Field, JsonValue

from tandem.executive.trials.provenance import installed_packages
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.tasks import (
    TASK_ANSWERS,
    TASK_STATUS,
    TREE,
    NodeStatus,
    Progress,
    TaskState,
)

DEPTH: Final = 4096
"""Messages that the recorder's inboxes hold between two steps."""


class AskedTask(Message):
    """A request that was taken."""

    task: str
    request: dict[str, JsonValue]


class Rejection(Message):
    """A request that was not, and why. ``at``: robot seconds."""

    at: float
    problems: tuple[Problem, ...]


class StateChange(Message):
    """A task came into a state. ``at``: robot seconds."""

    at: float
    task: str
    state: TaskState
    progress: Progress


class Transition(Message):
    """A node of a tree came into a status; ``at``: robot seconds of the tick."""

    at: float
    task: str
    tick: int
    node: str
    """Its path of names from the root."""
    before: NodeStatus
    after: NodeStatus
    message: str


class FailedTask(Message):
    """A task that failed: its failure with all below it, nearest first."""

    task: str
    chain: tuple[Failure, ...]


class TrueItem(Message):
    """Where an item truly was, in the map, at the start and at the end; None: it was not there."""

    item: int
    start: Pose | None
    end: Pose | None


class ThisRun(Message):
    """What differs from run to run. Times in seconds; ``accepted_at`` (UTC) by task."""

    started_at: float
    wall_seconds: float
    accepted_at: dict[str, float]
    processes: dict[str, int]
    """Process ids by role."""
    machine: str
    python: str
    packages: dict[str, str]


class Report(Message):
    """A run, whole."""

    format: Literal["tandem-report/1"] = "tandem-report/1"
    scenario: str
    seed: int
    lockstep: bool
    robot_seconds: float
    """From the recorder's first step to its last, on the robot's clock."""
    requests: tuple[AskedTask, ...]
    rejections: tuple[Rejection, ...]
    states: tuple[StateChange, ...]
    transitions: tuple[Transition, ...]
    failures: tuple[FailedTask, ...]
    items: tuple[TrueItem, ...]
    notes: dict[str, JsonValue] = Field(default_factory=dict)
    """What the command has to add, such as whether the item lies in the depot."""
    this_run: ThisRun


class Recorder:
    """A node that listens to tasks and trees, and keeps what the report needs.

    Args:
        bus: where the executive is.
        clocks: the robot's time, for states; UTC and host time, for ``this_run``.
    """

    def __init__(self, bus: Bus, clocks: Clocks) -> None:
        self._clocks = clocks
        self._statuses = Latest(bus, TASK_STATUS, depth=DEPTH)
        self._answers = Latest(bus, TASK_ANSWERS, depth=DEPTH)
        self._trees = Latest(bus, TREE, depth=DEPTH)
        self._nodes: dict[str, dict[str, NodeStatus]] = {}
        self._states: list[StateChange] = []
        self._asked: dict[str, AskedTask] = {}
        self._accepted_at: dict[str, float] = {}
        self._rejections: list[Rejection] = []
        self._failures: dict[str, FailedTask] = {}
        self._transitions: list[Transition] = []
        self._began: float | None = None
        self._started_at, self._started_on_host = clocks.utc(), clocks.monotonic()

    @property
    def name(self) -> str:
        """For logs."""
        return "recorder"

    def step(self) -> bool:
        """Take in what was published."""
        if self._began is None and self._clocks.robot() is not None:
            self._began = robot_seconds(self._clocks)
        now = robot_seconds(self._clocks)
        for answer in self._answers.take():
            if not answer.accepted:
                self._rejections.append(Rejection(at=now, problems=answer.problems))
        self._take_statuses(now)
        self._take_trees(now)
        return False

    def close(self) -> None:
        """End the subscriptions."""
        for latest in (self._statuses, self._answers, self._trees):
            latest.close()

    def report(
        self,
        *,
        scenario: str,
        seed: int,
        lockstep: bool,
        start: Mapping[int, Pose] | None = None,
        end: Mapping[int, Pose] | None = None,
        processes: Mapping[str, int] | None = None,
        notes: Mapping[str, JsonValue] | None = None,
    ) -> Report:
        """Return the report of what has been heard until now.

        Args:
            scenario: its name or path.
            seed: of all that is random.
            lockstep: whether all ran in one thread.
            start: the true poses of items in the map when the run began.
            end: and when it ended.
            processes: process ids by role.
            notes: what the command has to add.
        """
        start, end = start or {}, end or {}
        return Report(
            scenario=scenario,
            seed=seed,
            lockstep=lockstep,
            robot_seconds=round(robot_seconds(self._clocks) - (self._began or 0.0), 6),
            requests=tuple(self._asked.values()),
            rejections=tuple(self._rejections),
            states=tuple(self._states),
            transitions=tuple(self._transitions),
            failures=tuple(self._failures.values()),
            items=tuple(
                TrueItem(item=item, start=start.get(item), end=end.get(item))
                for item in sorted({*start, *end})
            ),
            notes=dict(notes or {}),
            this_run=self._this_run(processes or {}),
        )

    def _take_statuses(self, now: float) -> None:
        for status in self._statuses.take():
            task = status.task
            self._asked.setdefault(task, AskedTask(task=task, request=status.request))
            self._accepted_at[task] = status.accepted_at
            self._states.append(StateChange(at=now, task=task, state=status.state, progress=status.progress))
            if status.failure is not None:
                self._failures[task] = FailedTask(task=task, chain=status.failure.chain())

    def _take_trees(self, now: float) -> None:
        for tree in self._trees.take():
            known = self._nodes.setdefault(tree.task, {})
            at = round(now - self._ago(tree.stamp), 6)
            for node in tree.root.walk():
                before = known.get(node.path, NodeStatus.INVALID)
                if node.status is before:
                    continue
                known[node.path] = node.status
                self._transitions.append(
                    Transition(
                        at=at,
                        task=tree.task,
                        tick=tree.tick,
                        node=node.path,
                        before=before,
                        after=node.status,
                        message=node.message,
                    )
                )

    def _ago(self, stamp: RobotTime | None) -> float:
        """Return how many robot seconds ago that was; of another boot, or not known when: just now."""
        now = self._clocks.robot()
        return 0.0 if now is None or stamp is None else now.since(stamp) or 0.0

    def _this_run(self, processes: Mapping[str, int]) -> ThisRun:
        return ThisRun(
            started_at=self._started_at,
            wall_seconds=self._clocks.monotonic() - self._started_on_host,
            accepted_at=dict(self._accepted_at),
            processes=dict(processes) or {"all": os.getpid()},
            machine=f"{platform.system()} {platform.release()} {platform.machine()}, {os.cpu_count()} cores",
            python=sys.version.split()[0],
            packages=installed_packages(),
        )


def write_report(path: Path, report: Report) -> None:
    """Write the report, whole or not at all.

    Raises:
        OSError: when the file can't be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.part")
    beside.write_text(f"{report.model_dump_json(indent=2)}\n", encoding="utf-8")
    beside.replace(path)
