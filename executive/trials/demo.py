"""One request from start to end, told as it goes; what it ends with is read from the truth."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

from pydantic import JsonValue

from tandem.executive.system.systems import System, SystemFailure, wait_for
from tandem.sim.controls import PHOTOGRAPH, PhotographRequest
from tandem.sim.demonstration import View
from tandem.sim.truth import TRUTH, Truth
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.keys import Latest, Nothing
from tandem.skills.ports.node import Node
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_STATUS,
    TREE,
    NodeStatus,
    TaskAnswer,
    TaskState,
    TaskStatus,
    TreeSnapshot,
)

ANSWER_WITHIN: Final = 10.0
"""Seconds for one query."""
Say = Callable[[str], None]


@dataclass(eq=False)
class Story:
    """Tells a task as it goes: phases, and each leaf that ends.

    Args:
        say: takes one line.
    """

    say: Say
    phase: str = ""
    _leaves: dict[str, NodeStatus] = field(default_factory=dict)

    def on_status(self, status: TaskStatus, seconds: float) -> None:
        """Tell a new phase."""
        if status.progress.phase != self.phase:
            self.phase = status.progress.phase
            self.say(f"{seconds:7.2f} s  {self.phase}")

    def on_tree(self, tree: TreeSnapshot, seconds: float) -> None:
        """Tell the leaves that have ended since the last tree."""
        for leaf in tree.root.walk():
            before = self._leaves.get(leaf.path)
            self._leaves[leaf.path] = leaf.status
            if leaf.children or leaf.kind != "action" or leaf.status is before:
                continue
            if leaf.status in {NodeStatus.SUCCESS, NodeStatus.FAILURE}:
                mark = "ok  " if leaf.status is NodeStatus.SUCCESS else "FAIL"
                words = "" if leaf.message in {"done", "yes"} else f": {leaf.message}"
                self.say(f"{seconds:7.2f} s    {mark} {leaf.name}{words}")


@dataclass(frozen=True)
class Together:
    """Several nodes that are stepped and closed as one."""

    nodes: tuple[Node, ...]
    name: str = "together"

    def step(self) -> bool:
        """Step each."""
        more = [node.step() for node in self.nodes]
        return any(more)

    def close(self) -> None:
        """Close each."""
        for node in self.nodes:
            node.close()


class Caller:
    """A client of the executive that lets the system go on while it waits.

    Args:
        system: what goes on.
        say: takes one line of the story.
        also: a node that is stepped along, such as a report's recorder.
    """

    def __init__(self, system: System, say: Say, *, also: Node | None = None) -> None:
        self._system, self._also = system, also
        self._statuses = Latest(system.bus, TASK_STATUS)
        self._trees = Latest(system.bus, TREE, depth=1024)
        self._story = Story(say)

    def request(self, document: dict[str, JsonValue] | str) -> TaskAnswer:
        """Send a request, as a document or as its text, and return the answer.

        Raises:
            SystemFailure: when nobody answers.
        """
        text = document if isinstance(document, str) else json.dumps(document)
        pending = self._system.bus.query(REQUEST, text.encode(), timeout=ANSWER_WITHIN)
        answer = wait_for(self._system, pending, ANSWER_WITHIN)
        if answer is None:
            raise SystemFailure("the executive did not answer the request")
        return TaskAnswer.model_validate_json(answer)

    def follow(self, task: str, *, within: float) -> TaskStatus:
        """Go on until the task has ended; return its last status.

        Raises:
            SystemFailure: when it has not ended ``within`` robot seconds.
        """
        end = robot_seconds(self._system.clocks) + within
        while True:
            self._system.advance()
            if self._also is not None:
                self._also.step()
            now = robot_seconds(self._system.clocks)
            for tree in self._trees.take():
                if tree.task == task:
                    self._story.on_tree(tree, now)
            for status in self._statuses.take():
                if status.task == task:
                    self._story.on_status(status, now)
                    if status.state.terminal:
                        return status
            if now > end:
                raise SystemFailure(f"task {task} has not ended within {within:.0f} s")

    def truth(self) -> Truth:
        """Return how things truly are.

        Raises:
            SystemFailure: when the sim does not answer.
        """
        return truth_of(self._system)

    def photograph(self, view: View) -> bytes | None:
        """Return a picture of the room as PNG, or None when none came."""
        ask = PhotographRequest(eye=view.eye, target=view.target).model_dump_json().encode()
        pending = self._system.bus.query(PHOTOGRAPH.key, ask, timeout=ANSWER_WITHIN)
        return wait_for(self._system, pending, ANSWER_WITHIN)


def truth_of(system: System) -> Truth:
    """Return how things truly are.

    Raises:
        SystemFailure: when the sim does not answer.
    """
    answer = wait_for(system, TRUTH.query(system.bus, Nothing()), ANSWER_WITHIN)
    if answer is None:
        raise SystemFailure("the sim did not tell the truth")
    return Truth.model_validate_json(answer)


def succeeded(status: TaskStatus) -> bool:
    """Say whether a task ended well, by its own account."""
    return status.state is TaskState.SUCCEEDED
