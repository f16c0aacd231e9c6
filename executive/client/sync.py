"""The client for programs that wait.

with Client() as client:
    client.run({"task": "fetch", "item": 29})
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
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
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus


class Link(Protocol):
    """An end of a bus that can be waited at."""

    @property
    def bus(self) -> Bus:
        """The end."""
        ...

    def wait(self, seconds: float) -> None:
        """Return when something has arrived, or after so many seconds."""
        ...

    def close(self) -> None:
        """Leave. Closing twice is allowed."""
        ...


@dataclass(eq=False)
class ZenohLink:
    """A session of its own with a router."""

    bus: ZenohBus

    def wait(self, seconds: float) -> None:
        """Return when something has arrived, or after so many seconds."""
        self.bus.waker.wait(seconds)

    def close(self) -> None:
        """Leave."""
        self.bus.close()


class Client:
    """One thread's client of one robot's executive. Use as a context, or ``close`` it.

    Times are seconds of the host. Each question is answered within ``patience`` or raises
    ``NotConnectedError``; ``tandem.executive.client.errors`` has the tree of all errors.

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

    Raises:
        NotConnectedError: when no router answers at the endpoint, or the keys are not as they should be.
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
        link: Link | None = None,
        ids: Callable[[], str] = new_id,
        monotonic: Callable[[], float] = time.monotonic,
    ) -> None:
        where = f"{site}/{robot} at {endpoint}"
        if link is None:
            try:
                shown = None if identity is None else identity.client()
                bus = ZenohBus(endpoint, f"{site}/{robot}", patience=patience, credentials=shown)
                link = ZenohLink(bus)
            except (BusError, KeysError) as error:
                raise NotConnectedError(str(error)) from error
        self._link: Link | None = link
        self._ask = Questions(Talks(link.bus, monotonic, where, patience, lost_after), ids, identity)

    def __enter__(self) -> Self:
        """Stay open until the context is left."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close."""
        self.close()

    def close(self) -> None:
        """End the session; tasks go on. Closing twice is allowed."""
        if self._link is not None:
            self._link.close()
            self._link = None

    # Requests.

    def submit(self, request: Request, *, client_id: str = "") -> str:
        """Send a request and return its task's id; the task waits for its turn.

        Args:
            request: a document such as ``{"task": "fetch", "item": 29}``, or its model.
            client_id: a name of your own for the request: sent again, also by another program, it starts
                nothing and returns the same task. One is made unless given here or as the document's ``id``.

        Raises:
            RejectedError: with each problem in the document.
        """
        return self._drive(self._ask.submit(request, client_id))

    def run(self, request: Request, *, client_id: str = "", timeout: float | None = None) -> TaskStatus:
        """Send a request, wait for its task's end, and return its last status.

        Raises:
            RejectedError: when it is not taken.
            TaskFailedError: when it ends otherwise than well.
            TimedOutError: when it has not ended within ``timeout``.
        """
        status = self.wait(self.submit(request, client_id=client_id), timeout=timeout)
        if status.state is not TaskState.SUCCEEDED:
            raise TaskFailedError(status)
        return status

    # Following.

    def wait(self, task: str, *, timeout: float | None = None) -> TaskStatus:
        """Wait until a task has ended, well or not, and return its last status.

        Raises:
            TimedOutError: when it has not ended within ``timeout``.
            UnknownTaskError: when there is no such task.
        """
        for status in self.watch(task, timeout=timeout):
            if status.state.terminal:
                return status
        raise UnknownTaskError(task)

    def watch(self, task: str, *, timeout: float | None = None) -> Iterator[TaskStatus]:
        """Yield how a task stands, then each change, and at last how it ended; errors as ``wait``."""
        following = Following(self._ask, task, timeout)
        try:
            while (status := self._drive(following.next())) is not None:
                yield status
        finally:
            following.close()

    def trees(self, task: str, *, timeout: float | None = None) -> Iterator[TreeSnapshot]:
        """Yield a task's tree as it changes, until the task has ended; errors as ``wait``."""
        following = FollowingTree(self._ask, task, timeout)
        try:
            while (tree := self._drive(following.next())) is not None:
                yield tree
        finally:
            following.close()

    # Questions.

    def info(self) -> ExecutiveInfo:
        """Return who serves, which kinds of task it takes, and what runs."""
        return self._drive(self._ask.info())

    def kinds(self) -> TaskKinds:
        """Return the kinds of task, with the JSON Schema of each one's request, and the site's items."""
        return self._drive(self._ask.kinds())

    def site(self) -> Site:
        """Return the place that the robot works in, as its executive knows it."""
        return self._drive(self._ask.site())

    def description(self) -> RobotDescription:
        """Return who the robot is, as its hardware says."""
        return self._drive(self._ask.description())

    def tasks(self) -> tuple[TaskStatus, ...]:
        """Return the tasks that have not ended and the last that have, oldest first."""
        return self._drive(self._ask.tasks())

    def history(
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
        return self._drive(self._ask.history(asked))

    def timeline(self, task: str) -> Timeline:
        """Return when which phase, recovery and action of a task ran; empty when there is none of this id."""
        return self._drive(self._ask.timeline(task))

    def records(self, task: str = "") -> Records:
        """Return which records the recorder keeps; of black boxes only those of a task, if one is named."""
        return self._drive(self._ask.records(task))

    def status(self, task: str) -> TaskStatus:
        """Return a task as it stands; UnknownTaskError when there is none of this id."""
        return self._drive(self._ask.status(task))

    def tree(self) -> TreeSnapshot:
        """Return the running task's tree, or the last one's."""
        return self._drive(self._ask.tree())

    def why(self, task: str = "") -> str:
        """Tell in words why a task failed and what to do; the last that failed unless named."""
        return self._drive(self._ask.why(task))

    def picture(self, task: str, number: str) -> bytes:
        """Return the camera's picture of an attempt as JPEG; empty when it is not kept (any more)."""
        return self._drive(self._ask.picture(task, number))

    def camera(self, name: str = "") -> bytes:
        """Return what a camera (the first, unless named) sees now as JPEG; empty when no picture comes."""
        return self._drive(self._ask.camera(name))

    # Verbs: each but cancel is of the running task unless one is named, and returns the task's id;
    # RefusedError has the executive's reason when it is not taken.

    def cancel(self, task: str) -> str:
        """Cancel a queued or a running task; ``wait`` tells when the robot is at rest."""
        return self._drive(self._ask.cancel(task))

    def pause(self, task: str = "") -> str:
        """Have the running task's skills come to rest and its tree stay where it is."""
        return self._drive(self._ask.pause(task))

    def resume(self, task: str = "") -> str:
        """Go on with a paused task."""
        return self._drive(self._ask.resume(task))

    def step(self, task: str = "", *, by: By = "leaf") -> str:
        """Go on with a paused task until one more leaf of its tree has ended, or by one tick."""
        return self._drive(self._ask.step(task, by))

    def abandon(self, task: str) -> str:
        """Give up waiting until a cancelled task comes to rest, when the hardware does not answer."""
        return self._drive(self._ask.abandon(task))

    def reprioritise(self, task: str, priority: int) -> str:
        """Change the priority of a queued task: the higher goes first, -100 to 100."""
        return self._drive(self._ask.reprioritise(task, priority))

    def answer(self, task: str, answer: str) -> str:
        """Answer the question that a task's tree has put to an operator (``status.question``)."""
        return self._drive(self._ask.answer(task, answer))

    def set_breakpoint(self, task: str, node: str, *, when: When = "before", on: bool = True) -> str:
        """Have a task pause before or after a node, by the node's name; ``on=False`` takes it back."""
        return self._drive(self._ask.breakpoint(Breakpoint(task=task, node=node, when=when, on=on)))

    def force(self, task: str, node: str, status: Forced) -> str:
        """Have a node end so without its work, for a test run; None takes it back."""
        return self._drive(self._ask.force(ForceNode(task=task, node=node, status=status)))

    def switch_reflex(self, reflex: str, *, on: bool, by: str) -> ReflexState:
        """Switch a reflex on or off, until its process starts anew: then it is as declared."""
        return self._drive(self._ask.switch_reflex(reflex, by, on=on))

    # The hardware's stop, which needs no executive.

    def stop(self, *, by: str, reason: str) -> StopState:
        """Stop the robot at once until ``release``; name and reason are shown to who finds it stopped."""
        return self._drive(self._ask.stop(by, reason))

    def release(self, *, by: str, reason: str = "") -> StopState:
        """Release the stop: the robot may move again, and a waiting task goes on."""
        return self._drive(self._ask.release(by, reason))

    def _drive(self, talk: Talk[T]) -> T:
        while True:
            if self._link is None:
                raise ClientError("this client is closed; create a new one")
            try:
                self._link.wait(next(talk))
            except StopIteration as end:
                result: T = end.value
                return result
