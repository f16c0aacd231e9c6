"""The client for asyncio.

async with AsyncClient() as client:
    await client.run({"task": "fetch", "item": 29})
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator, Callable, Iterable
from dataclasses import dataclass
from types import TracebackType
from typing import Protocol, Self

from tandem.executive.client.errors import ClientError, NotConnectedError, TaskFailedError, UnknownTaskError
from tandem.executive.client.following import Following, FollowingTree
from tandem.executive.client.questions import By, Forced, Questions, Request, When, new_id
from tandem.executive.client.talks import LOST_AFTER, PATIENCE, T, Talk, Talks
from tandem.executive.config.run_options import DEFAULT_ENDPOINT, DEFAULT_ROBOT, DEFAULT_SITE
from tandem.executive.security.holders import KeysError
from tandem.executive.security.identity import Identity
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.records import Records
from tandem.skills.ports.reflex import ReflexState
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import (
    AskHistory,
    Breakpoint,
    ExecutiveInfo,
    ForceNode,
    History,
    TaskKinds,
    TaskState,
    TaskStatus,
    Timeline,
    TreeSnapshot,
)
from tandem.skills.wire.waking import LoopWaker
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus


class AsyncLink(Protocol):
    """An end of a bus that can be awaited."""

    @property
    def bus(self) -> Bus:
        """The end."""
        ...

    async def wait(self, seconds: float) -> None:
        """Return when something has arrived, or after so many seconds."""
        ...

    async def close(self) -> None:
        """Leave. Closing twice is allowed."""
        ...


@dataclass(eq=False)
class AsyncZenohLink:
    """A session of its own with a router."""

    bus: ZenohBus
    waker: LoopWaker

    async def wait(self, seconds: float) -> None:
        """Return when something has arrived, or after so many seconds."""
        await self.waker.rung(seconds)

    async def close(self) -> None:
        """Leave; zenoh's own closing blocks, and so goes to asyncio's threads."""
        await asyncio.to_thread(self.bus.close)


class AsyncClient:
    """A client of one robot's executive in an asyncio loop; any number of tasks may use it at once.

    What ``executive.client.sync.Client`` has, awaited. It is connected by ``async with``, or by ``connect``
    and left by ``close``. Times are seconds of the host.

    Args:
        endpoint: the router's, such as ``tcp/127.0.0.1:7447``.
        site: first part of every key.
        robot: second part of every key.
        patience: seconds in which router and executive must answer.
        lost_after: seconds of silence after which waiting for a task's end is given up.
        identity: whose key is shown to a router that speaks TLS: ``Identity(Path(folder), name)`` of what
            ``tandem keys`` made.
        link: an end of a bus to use instead of a session of its own, as tests do.
        ids: makes the ids of requests that have none.
        monotonic: the host's clock.
    """

    def __init__(
        self,
        endpoint: str = DEFAULT_ENDPOINT,
        *,
        site: str = DEFAULT_SITE,
        robot: str = DEFAULT_ROBOT,
        patience: float = PATIENCE,
        lost_after: float = LOST_AFTER,
        identity: Identity | None = None,
        link: AsyncLink | None = None,
        ids: Callable[[], str] = new_id,
        monotonic: Callable[[], float] = time.monotonic,
    ) -> None:
        self._endpoint, self._prefix = endpoint, f"{site}/{robot}"
        self._patience, self._lost_after = patience, lost_after
        self._link, self._ids, self._monotonic = link, ids, monotonic
        self._identity = identity

    async def connect(self) -> Self:
        """Open the session, in asyncio's threads, as zenoh's opening blocks.

        Raises:
            NotConnectedError: when no router answers at the endpoint.
        """
        if self._link is None:
            waker = LoopWaker(asyncio.get_running_loop())
            try:
                shown = None if self._identity is None else self._identity.client()
                bus = await asyncio.to_thread(
                    ZenohBus,
                    self._endpoint,
                    self._prefix,
                    patience=self._patience,
                    waker=waker,
                    credentials=shown,
                )
            except (BusError, KeysError) as error:
                raise NotConnectedError(str(error)) from error
            self._link = AsyncZenohLink(bus, waker)
        return self

    async def close(self) -> None:
        """End the session; tasks of the executive go on. Closing twice is allowed."""
        if self._link is not None:
            link, self._link = self._link, None
            await link.close()

    async def __aenter__(self) -> Self:
        """Connect."""
        return await self.connect()

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close."""
        await self.close()

    # Requests.

    async def submit(self, request: Request, *, client_id: str = "") -> str:
        """Send a request and return its task's id; RejectedError with each problem in the document."""
        return await self._drive(self._ask.submit(request, client_id))

    async def run(
        self,
        request: Request,
        *,
        client_id: str = "",
        timeout: float | None = None,  # noqa: ASYNC109 - as in sync
    ) -> TaskStatus:
        """Send a request, wait for its task's end, and return its last status.

        Raises:
            RejectedError: when it is not taken.
            TaskFailedError: when it ends otherwise than well.
            TimedOutError: when it has not ended within ``timeout``.
        """
        status = await self.wait(await self.submit(request, client_id=client_id), timeout=timeout)
        if status.state is not TaskState.SUCCEEDED:
            raise TaskFailedError(status)
        return status

    # Following.

    async def wait(self, task: str, *, timeout: float | None = None) -> TaskStatus:  # noqa: ASYNC109
        """Wait until a task has ended, well or not, and return its last status; errors as in sync."""
        async for status in self.watch(task, timeout=timeout):
            if status.state.terminal:
                return status
        raise UnknownTaskError(task)

    async def watch(
        self,
        task: str,
        *,
        timeout: float | None = None,  # noqa: ASYNC109
    ) -> AsyncIterator[TaskStatus]:
        """Yield how a task stands, then each change, and at last how it ended; errors as ``wait``."""
        following = Following(self._ask, task, timeout)
        try:
            while (status := await self._drive(following.next())) is not None:
                yield status
        finally:
            following.close()

    async def trees(
        self,
        task: str,
        *,
        timeout: float | None = None,  # noqa: ASYNC109
    ) -> AsyncIterator[TreeSnapshot]:
        """Yield a task's tree as it changes, until the task has ended; errors as ``wait``."""
        following = FollowingTree(self._ask, task, timeout)
        try:
            while (tree := await self._drive(following.next())) is not None:
                yield tree
        finally:
            following.close()

    # Questions.

    async def info(self) -> ExecutiveInfo:
        """Return who serves, which kinds of task it takes, and what runs."""
        return await self._drive(self._ask.info())

    async def kinds(self) -> TaskKinds:
        """Return the kinds of task, with the JSON Schema of each one's request, and the site's items."""
        return await self._drive(self._ask.kinds())

    async def site(self) -> Site:
        """Return the place that the robot works in, as its executive knows it."""
        return await self._drive(self._ask.site())

    async def description(self) -> RobotDescription:
        """Return who the robot is, as its hardware says."""
        return await self._drive(self._ask.description())

    async def tasks(self) -> tuple[TaskStatus, ...]:
        """Return the tasks that have not ended and the last that have, oldest first."""
        return await self._drive(self._ask.tasks())

    async def history(
        self, *, states: Iterable[TaskState] = (), since: float = 0.0, before: int = 0, limit: int = 100
    ) -> History:
        """Return tasks out of the ledger, also those that ended long ago, newest first.

        Args:
            states: those in one of these; all unless given.
            since: those accepted at or after this moment (UTC seconds).
            before: as ``History.more`` of the answer before: the next page.
            limit: how many at the most, up to 100.
        """
        asked = AskHistory(states=tuple(states), since=since, before=before, limit=limit)
        return await self._drive(self._ask.history(asked))

    async def timeline(self, task: str) -> Timeline:
        """Return when which phase, recovery and action of a task ran; empty when there is none of this id."""
        return await self._drive(self._ask.timeline(task))

    async def records(self, task: str = "") -> Records:
        """Return which records the recorder keeps; of black boxes only those of a task, if one is named."""
        return await self._drive(self._ask.records(task))

    async def status(self, task: str) -> TaskStatus:
        """Return a task as it stands; UnknownTaskError when there is none of this id."""
        return await self._drive(self._ask.status(task))

    async def tree(self) -> TreeSnapshot:
        """Return the running task's tree, or the last one's."""
        return await self._drive(self._ask.tree())

    async def why(self, task: str = "") -> str:
        """Tell in words why a task failed and what to do; the last that failed unless named."""
        return await self._drive(self._ask.why(task))

    async def picture(self, task: str, number: str) -> bytes:
        """Return the camera's picture of an attempt as JPEG; empty when it is not kept (any more)."""
        return await self._drive(self._ask.picture(task, number))

    async def camera(self, name: str = "") -> bytes:
        """Return what a camera (the first, unless named) sees now as JPEG; empty when no picture comes."""
        return await self._drive(self._ask.camera(name))

    # Verbs: as in sync.

    async def cancel(self, task: str) -> str:
        """Cancel a queued or a running task; ``wait`` tells when the robot is at rest."""
        return await self._drive(self._ask.cancel(task))

    async def pause(self, task: str = "") -> str:
        """Have the running task's skills come to rest and its tree stay where it is."""
        return await self._drive(self._ask.pause(task))

    async def resume(self, task: str = "") -> str:
        """Go on with a paused task."""
        return await self._drive(self._ask.resume(task))

    async def step(self, task: str = "", *, by: By = "leaf") -> str:
        """Go on with a paused task until one more leaf of its tree has ended, or by one tick."""
        return await self._drive(self._ask.step(task, by))

    async def abandon(self, task: str) -> str:
        """Give up waiting until a cancelled task comes to rest, when the hardware does not answer."""
        return await self._drive(self._ask.abandon(task))

    async def reprioritise(self, task: str, priority: int) -> str:
        """Change the priority of a queued task: the higher goes first, -100 to 100."""
        return await self._drive(self._ask.reprioritise(task, priority))

    async def answer(self, task: str, answer: str) -> str:
        """Answer the question that a task's tree has put to an operator (``status.question``)."""
        return await self._drive(self._ask.answer(task, answer))

    async def set_breakpoint(self, task: str, node: str, *, when: When = "before", on: bool = True) -> str:
        """Have a task pause before or after a node, by the node's name; ``on=False`` takes it back."""
        return await self._drive(self._ask.breakpoint(Breakpoint(task=task, node=node, when=when, on=on)))

    async def force(self, task: str, node: str, status: Forced) -> str:
        """Have a node end so without its work, for a test run; None takes it back."""
        return await self._drive(self._ask.force(ForceNode(task=task, node=node, status=status)))

    async def switch_reflex(self, reflex: str, *, on: bool, by: str) -> ReflexState:
        """Switch a reflex on or off, until its process starts anew: then it is as declared."""
        return await self._drive(self._ask.switch_reflex(reflex, by, on=on))

    # The hardware's stop, which needs no executive.

    async def stop(self, *, by: str, reason: str) -> StopState:
        """Stop the robot at once until ``release``; name and reason are shown to who finds it stopped."""
        return await self._drive(self._ask.stop(by, reason))

    async def release(self, *, by: str, reason: str = "") -> StopState:
        """Release the stop: the robot may move again, and a waiting task goes on."""
        return await self._drive(self._ask.release(by, reason))

    @property
    def _ask(self) -> Questions:
        where = f"{self._prefix} at {self._endpoint}"
        return Questions(
            Talks(self._open.bus, self._monotonic, where, self._patience, self._lost_after),
            self._ids,
            self._identity,
        )

    @property
    def _open(self) -> AsyncLink:
        if self._link is None:
            raise ClientError("this client is not connected; use `async with`, or await `connect()`")
        return self._link

    async def _drive(self, talk: Talk[T]) -> T:
        while True:
            link = self._open
            try:
                seconds = next(talk)
            except StopIteration as end:
                result: T = end.value
                return result
            await link.wait(seconds)
