"""A robot in memory that tells what a test wants, with its page served to a real browser from a thread."""

from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from tandem.executive.client.aio import AsyncClient
from tandem.executive.config.run_options import BusOptions
from tandem.executive.web.options import Secure, WebOptions
from tandem.executive.web.replay import Replay
from tandem.executive.web.robot import Ears, Who
from tandem.executive.web.serve import Shown, listen, serve_until
from tandem.sim.robots.registry import robot_model
from tandem.skills.ports.actions.perception import PICTURE, AskView
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.endpoint import AnyDocument, Call, Endpoint, answering, endpoint
from tandem.skills.ports.hardware import Clock, Stop, StopRelease, StopState
from tandem.skills.ports.keys import (
    CLOCK,
    DESCRIPTION,
    STOP,
    STOP_RELEASE,
    STOP_STATE,
    Nothing,
    Service,
    Topic,
)
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.records import TASK_RECORDS, Records
from tandem.skills.ports.reflex import ReflexState, ReflexSwitch, reflex_state, reflex_switch
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_HISTORY,
    TASK_INFO,
    TASK_KINDS,
    TASK_LIST,
    TASK_PAUSE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_SITE,
    TASK_STATUS,
    TASK_STEP,
    TASK_TIMELINE,
    TREE_NOW,
    AnswerQuestion,
    AskHistory,
    ControlAnswer,
    ExecutiveInfo,
    History,
    TaskAnswer,
    TaskKinds,
    TaskList,
    TaskStatus,
    Timeline,
    TreeNode,
    TreeSnapshot,
)
from tandem.skills.ports.whereabouts import RobotWhereabouts, whereabouts
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryHub

M = TypeVar("M", bound=Message)
CAMERA = Service(PICTURE, AskView, Nothing, reads=True, exact=True)
ASK = Service(REQUEST, AnyDocument, TaskAnswer)
VERBS: tuple[Service[Any, ControlAnswer], ...] = (
    TASK_CANCEL, TASK_PAUSE, TASK_RESUME, TASK_STEP, TASK_ABANDON, TASK_REPRIORITISE, TASK_BREAKPOINT,
    TASK_FORCE,
)  # fmt: skip
"""They change nothing."""
EMPTY = TreeSnapshot(
    task="", kind="none", tick=0, root=TreeNode(path="none", name="none", kind="action", type="None")
)


@dataclass
class FakeRobot:
    """What is told and answered; implements ``Robot``. Of one loop, but for ``tell``."""

    who: Who = field(default_factory=lambda: Who("anna"))
    options: BusOptions = field(default_factory=BusOptions)
    site: Site = field(default_factory=lambda: load("lab"))
    description: RobotDescription = field(default_factory=lambda: robot_model("tiago_dual").description)
    kinds: TaskKinds = field(default_factory=lambda: TaskKinds(kinds=()))
    unable: dict[str, str] = field(default_factory=dict)
    tasks: tuple[TaskStatus, ...] = ()
    records: Records = field(default_factory=lambda: Records(boxes=()))
    timeline: Timeline = field(default_factory=lambda: Timeline(task=""))
    tree: TreeSnapshot = EMPTY
    picture: bytes = b""
    viewed: list[str] = field(default_factory=list)
    """Which cameras were asked for."""
    reflexes: dict[str, ReflexState] = field(default_factory=dict)
    asked: list[tuple[str, dict[str, Any]]] = field(default_factory=list)
    """What was asked that changes something: the key, and the document."""
    refuses: str = ""
    """Why no verb is taken; empty: each is."""
    seconds: float = 1.0

    def __post_init__(self) -> None:
        self.hub, self.commons = MemoryHub(), MemoryHub()
        self.bus, self.asking = self.hub.endpoint(), self.hub.endpoint()
        self.presence = self.hub.endpoint()
        self.presence.announce("executive")
        self.loop: asyncio.AbstractEventLoop | None = None
        self.endpoints = Endpoints(self.bus, time.monotonic, tuple(self.answers()))

    def answers(self) -> Iterator[Endpoint]:
        yield answering(DESCRIPTION, lambda _: self.description)
        yield answering(TASK_SITE, lambda _: self.site)
        yield answering(TASK_KINDS, lambda _: self.kinds)
        yield answering(
            TASK_INFO, lambda _: ExecutiveInfo(name="tiago", version="test", tasks=(), unable=self.unable)
        )
        yield answering(TASK_LIST, lambda _: TaskList(tasks=self.tasks))
        yield answering(TASK_HISTORY, self.history)
        yield answering(TASK_RECORDS, lambda _: self.records)
        yield answering(TASK_TIMELINE, lambda _: self.timeline)
        yield answering(TREE_NOW, lambda _: self.tree)
        yield answering(CAMERA, self.view)
        yield answering(STOP, lambda asked: self.stop(asked, stopped=True))
        yield answering(STOP_RELEASE, lambda asked: self.stop(asked, stopped=False))
        yield answering(reflex_switch("avoid_collision"), self.switch)
        yield answering(TASK_ANSWER, self.answer)
        yield endpoint(ASK, self.request)
        for verb in VERBS:
            yield answering(verb, partial(self.verb, verb.key))

    def verb(self, key: str, asked: Message) -> ControlAnswer:
        self.asked.append((key, asked.model_dump(mode="json")))
        return ControlAnswer(accepted=not self.refuses, reason=self.refuses)

    def request(self, call: Call[AnyDocument]) -> TaskAnswer:
        self.asked.append((REQUEST, dict(call.fields)))
        return TaskAnswer(accepted=True, task="new-1", client_id=str(call.fields["id"]))

    def answer(self, asked: AnswerQuestion) -> ControlAnswer:
        """Take one of the choices; the task asks no more."""
        for task in self.tasks:
            if task.task == asked.task and task.question and asked.answer in task.question.choices:
                TASK_STATUS.publish(self.bus, task.model_copy(update={"question": None}))
                return self.verb(TASK_ANSWER.key, asked)
        return ControlAnswer(accepted=False, reason=f"{asked.task} asks nothing of that kind")

    def view(self, asked: AskView) -> bytes:
        self.viewed.append(asked.camera)
        return self.picture

    def history(self, asked: AskHistory) -> History:
        named = [each for each in self.tasks if not asked.task or each.task == asked.task]
        return History(tasks=tuple(named[: asked.limit]))

    def stop(self, asked: Stop | StopRelease, *, stopped: bool) -> StopState:
        self.asked.append((STOP.key if stopped else STOP_RELEASE.key, asked.model_dump(mode="json")))
        state = StopState(stopped=stopped, by=asked.by, reason=asked.reason)
        STOP_STATE.publish(self.bus, state)
        return state

    def switch(self, asked: ReflexSwitch) -> ReflexState:
        name = "avoid_collision"
        self.asked.append((reflex_switch(name).key, asked.model_dump(mode="json")))
        state = self.reflexes[name].model_copy(update={"on": asked.on, "by": asked.by})
        self.reflexes[name] = state
        reflex_state(name).publish(self.bus, state)
        return state

    def executive(self, *, there: bool) -> None:
        """Have the executive's name go, as when it is killed, or come back."""
        assert self.loop is not None
        if there:
            self.presence = self.hub.endpoint()
        act = (lambda: self.presence.announce("executive")) if there else self.presence.close
        self.loop.call_soon_threadsafe(act)

    def tell(self, *told: tuple[Topic[M], M]) -> None:
        """Publish from any thread, with the clock as it is."""

        def publish() -> None:
            CLOCK.publish(self.bus, Clock(stamp=self.now, tick=0))
            for topic, message in told:
                topic.publish(self.bus, message)

        if self.loop is None:
            publish()
        else:
            self.loop.call_soon_threadsafe(publish)

    def tell_site(self, name: str, told: RobotWhereabouts) -> None:
        """Publish where another robot is."""
        assert self.loop is not None
        end = self.commons.endpoint()
        self.loop.call_soon_threadsafe(lambda: whereabouts(name).publish(end, told))

    @property
    def now(self) -> RobotTime:
        return RobotTime(boot="fake", seconds=self.seconds)

    async def client(self) -> AsyncClient:
        return AsyncClient(link=FakeLink(self), monotonic=time.monotonic)

    async def listen(self) -> Ears:
        bus = self.hub.endpoint()
        return Ears(bus, bus.close, self.commons.endpoint())

    async def close(self) -> None:
        pass


@dataclass
class FakeLink:
    """The end at which the page's client asks; waiting lets the robot answer."""

    robot: FakeRobot

    @property
    def bus(self) -> Bus:
        return self.robot.asking

    async def wait(self, seconds: float) -> None:
        del seconds
        self.robot.endpoints.step()
        await asyncio.sleep(0)

    async def close(self) -> None:
        pass


@contextmanager
def served(robot: FakeRobot | Replay, keys: Path | None = None) -> Iterator[str]:
    """Serve a robot's page from a thread; yields its address. With a folder of keys: TLS, and a login."""
    shown, secure = at_any_port(robot), None
    address = shown.listening.address.rstrip("/")
    if keys is not None:
        address = address.replace("http://127.0.0.1", "https://localhost")
        secure = Secure(address, keys / "r1.router.pem", keys / "r1.router.key", keys)
    with served_by_a_thread([shown], secure):
        yield address


@contextmanager
def served_together(*robots: FakeRobot) -> Iterator[list[str]]:
    """Serve the pages of several robots from one thread; yields their addresses."""
    shown = [at_any_port(robot) for robot in robots]
    with served_by_a_thread(shown):
        yield [each.listening.address.rstrip("/") for each in shown]


def at_any_port(robot: FakeRobot | Replay) -> Shown:
    return Shown(robot, listen(WebOptions(robot.options, "127.0.0.1", 0)))


@contextmanager
def served_by_a_thread(shown: Sequence[Shown], secure: Secure | None = None) -> Iterator[None]:
    stopped, there = threading.Event(), threading.Event()

    def turn() -> None:
        if not there.is_set():
            for each in shown:
                if isinstance(each.robot, FakeRobot):
                    each.robot.loop = asyncio.get_running_loop()
            there.set()

    thread = threading.Thread(target=serve_until, args=(shown, stopped.is_set, turn, secure))
    thread.start()
    there.wait(20.0)
    try:
        yield
    finally:
        stopped.set()
        thread.join(20.0)
