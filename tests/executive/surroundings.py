"""A small task over the bus in memory: a leaf that waits for a word, and one that moves a fake skill."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, TypeVar

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence
from pydantic import Field

from tandem.executive.ledger.memory import MemoryLedger
from tandem.executive.ledger.port import Ledger
from tandem.executive.service.executive import Executive
from tandem.executive.service.policy import Policy
from tandem.skills.ports.action import (
    GoalCommand,
    GoalState,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    status_topic,
)
from tandem.skills.ports.bus import Inbox
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK, Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import ActionType, Command
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_CANCEL,
    TASK_STATUS,
    TREE,
    CancelTask,
    ControlAnswer,
    NameTask,
    TaskAnswer,
    TaskStatus,
    TreeSnapshot,
)
from tandem.skills.ports.world import WORLD, WorldState
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.trees.client import GoalHandle
from tandem.trees.context import TreeContext
from tandem.trees.task import TaskType

M = TypeVar("M", bound=Message)


class WaitRequest(Message):
    task: Literal["wait"] = "wait"
    item: int = Field(ge=0, le=586)
    to: str = "depot"
    arm: Literal["left", "right"] | None = None
    weight: float = Field(default=1.0, gt=0.0, le=5.0)
    spots: tuple[str, ...] = ()


class Empty(Message):
    pass


NUDGE = ActionType("test/nudge", Empty, Empty, Empty, timeout=60.0)


class WaitForWorld(Behaviour):
    """Ends with what the world's version says: 1 success, 2 failure, 3 raises; waits while it is 0."""

    def __init__(self, context: TreeContext) -> None:
        super().__init__("wait for the world")
        self.context = context

    def update(self) -> Status:
        world = self.context.knowledge.world
        version = 0 if world is None else world.version
        self.context.enter("waiting", 0.5)
        self.feedback_message = f"version {version}"
        if version == 3:
            raise RuntimeError("a mistake")
        if version == 2:
            self.context.failures.add(Failure(kind=FailureKind.GRASP_EMPTY, message="closed on nothing"))
        return {0: Status.RUNNING, 1: Status.SUCCESS}.get(version, Status.FAILURE)


class Nudge(Behaviour):
    """Starts a goal of a fake skill; cancels it when stopped."""

    def __init__(self, context: TreeContext, name: str = "nudge") -> None:
        super().__init__(name)
        self.context = context
        self.handle: GoalHandle[Empty, Empty, Empty] | None = None

    def initialise(self) -> None:
        client = self.context.clients.of(NUDGE)
        self.handle = client.start(
            Empty(), f"{self.context.task}/{self.name}/{self.context.notes.next_attempt(self.name)}"
        )

    def update(self) -> Status:
        assert self.handle is not None
        return Status.SUCCESS if self.handle.ended else Status.RUNNING

    def terminate(self, new_status: Status) -> None:
        if new_status is Status.INVALID and self.handle is not None:
            self.handle.cancel()


def problems(request: WaitRequest, site: Site) -> tuple[Problem, ...]:
    names = tuple(depot.name for depot in site.depots)
    if request.to not in names:
        return (Problem(path="to", expected=" or ".join(names), found=request.to),)
    return ()


def build(request: WaitRequest, context: TreeContext) -> Behaviour:
    root = Sequence("wait", memory=True)
    if request.weight == 2.0:
        root.add_child(Nudge(context))
    if request.weight == 4.0:
        context.wind_down = Nudge(context, "put down")
    if request.weight == 5.0:
        context.wind_down = WaitForWorld(context)
    if request.weight == 3.0:
        raise RuntimeError("can't build")
    root.add_child(WaitForWorld(context))
    return root


WAIT = TaskType("wait", "Wait for the world.", WaitRequest, problems, build)


@dataclass
class Surroundings:
    """An executive over the bus in memory, and a client's eyes and hands."""

    hub: MemoryHub = field(default_factory=MemoryHub)
    clocks: SteppedClocks = field(default_factory=SteppedClocks)
    ledger: Callable[[], Ledger] = MemoryLedger
    policy: Policy = field(default_factory=Policy)
    kinds: dict[str, TaskType[Message]] = field(default_factory=lambda: {"wait": WAIT})
    died: str = ""

    def __post_init__(self) -> None:
        self.bus = self.hub.endpoint()
        self.statuses: Inbox = self.bus.subscribe(TASK_STATUS.key)
        self.trees: Inbox = self.bus.subscribe(TREE.key)
        self.commons = MemoryBus()
        self.begin()

    def begin(self) -> None:
        """Start the executive (once more)."""
        self.kept = self.ledger()
        self.end = self.hub.endpoint()
        self.executive = Executive(
            self.end,
            self.clocks,
            load("lab"),
            self.kinds,
            ledger=self.kept,
            policy=self.policy,
            died=self.died,
            commons=self.commons,
            robot="robot",
        )

    def crash(self) -> None:
        """Have the executive die as by kill -9: what it has not committed is gone, and so is its name."""
        self.end.close()
        self.kept.close()
        for desk in (*self.hub.desks,):
            if desk.expression.startswith("task/") or desk.expression.startswith("tree/"):
                desk.close()

    def step(self, times: int = 1, seconds: float = 0.01) -> None:
        for _ in range(times):
            self.clocks.advance(seconds)
            self.executive.step()

    def ask(self, document: object) -> TaskAnswer:
        payload = document if isinstance(document, bytes) else json.dumps(document).encode()
        pending = self.bus.query(REQUEST, payload)
        self.step()
        answer = pending.poll()
        assert answer is not None
        return TaskAnswer.model_validate_json(answer)

    def cancel(self, task: str) -> ControlAnswer:
        pending = TASK_CANCEL.query(self.bus, CancelTask(task=task))
        self.step()
        answer = pending.poll()
        assert answer is not None
        return ControlAnswer.model_validate_json(answer)

    def verb(self, service: Service[NameTask, ControlAnswer], task: str) -> ControlAnswer:
        return self.say(service, NameTask(task=task))

    def say(self, service: Service[M, ControlAnswer], message: M) -> ControlAnswer:
        pending = service.query(self.bus, message)
        self.step()
        answer = pending.poll()
        assert answer is not None
        return ControlAnswer.model_validate_json(answer)

    def hardware(self, tick: int = 1) -> None:
        """Say a word of the hardware's clock."""
        stamp = self.clocks.robot()
        assert stamp is not None
        CLOCK.publish(self.bus, Clock(stamp=stamp, tick=tick))

    def world(self, version: int) -> None:
        stamp = self.clocks.robot()
        assert stamp is not None
        WORLD.publish(self.bus, WorldState(stamp=stamp, version=version))

    def told(self) -> list[TaskStatus]:
        return [TASK_STATUS.decode(sample.payload) for sample in self.statuses.drain()]

    def shown(self) -> list[TreeSnapshot]:
        return [TREE.decode(sample.payload) for sample in self.trees.drain()]


AFTER = {
    Command.CANCEL: GoalState.CANCELING,
    Command.PAUSE: GoalState.PAUSED,
    Command.RESUME: GoalState.RUNNING,
}


class Skill:
    """A fake server of ``test/nudge`` that takes goals and ends them when it is told to."""

    def __init__(self, here: Surroundings) -> None:
        self.goal, self.sequence = "", 0
        bus = here.hub.endpoint()
        self.bus = bus
        bus.announce(f"skill/{NUDGE.name}")
        self.goals = bus.serve(goal_service(NUDGE.name).key)
        self.commands = bus.serve(command_service(NUDGE.name).key)
        self.canceled = False
        self.commands_seen: list[Command] = []

    def step(self) -> None:
        for request in self.goals.drain():
            self.goal = SendGoal.model_validate_json(request.payload).goal_id
            request.reply(self.status(GoalState.RUNNING))
        for request in self.commands.drain():
            command = GoalCommand.model_validate_json(request.payload).command
            self.commands_seen.append(command)
            self.canceled = self.canceled or command is Command.CANCEL
            request.reply(self.status(AFTER[command]))

    def status(self, state: GoalState) -> bytes:
        self.sequence += 1
        status = GoalStatus(goal_id=self.goal, state=state, sequence=self.sequence)
        return status.model_dump_json().encode()

    def end(self, state: GoalState) -> None:
        self.bus.publish(status_topic(NUDGE.name).key, self.status(state))
