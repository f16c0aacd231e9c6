"""The client's conversations, over the bus in memory: whoever waits lets the executive go on."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Iterator
from dataclasses import dataclass, field

import pytest
from surroundings import Surroundings, WaitRequest

from tandem.executive.client.aio import AsyncClient
from tandem.executive.client.errors import (
    ClientError,
    DeclinedError,
    NotConnectedError,
    OtherVersionError,
    RefusedError,
    RejectedError,
    TaskFailedError,
    TimedOutError,
    UnknownTaskError,
)
from tandem.executive.client.sync import Client
from tandem.skills.ports.tasks import ExecutiveInfo, NodeStatus, TaskState
from tandem.skills.wire.memory import MemoryBus, MemoryPending

WAIT = {"task": "wait", "item": 3}


@dataclass
class Stepping:
    """Waiting lets the executive make a step; ``events`` says what else happens at which step."""

    here: Surroundings
    served: bool = True
    events: dict[int, object] = field(default_factory=dict)
    steps: int = 0

    def __post_init__(self) -> None:
        self.bus: MemoryBus = self.here.hub.endpoint()

    def wait(self, seconds: float) -> None:
        self.steps += 1
        event = self.events.get(self.steps)
        if isinstance(event, int):
            self.here.world(event)
        if self.served:
            self.here.step()
        else:
            self.here.clocks.advance(max(seconds, 1e-6))  # less is lost in a large number of seconds

    def close(self) -> None:
        self.bus.close()


@dataclass
class Awaiting(Stepping):
    async def wait(self, seconds: float) -> None:  # type: ignore[override]
        super().wait(seconds)
        await asyncio.sleep(0)

    async def close(self) -> None:  # type: ignore[override]
        super().close()


def numbered() -> Iterator[str]:
    for number in range(1000):
        yield f"mine-{number}"


@pytest.fixture
def link() -> Stepping:
    return Stepping(Surroundings())


@pytest.fixture
def client(link: Stepping) -> Client:
    ids = numbered()
    return Client(link=link, ids=lambda: next(ids), monotonic=link.here.clocks.monotonic)


def test_a_request_becomes_a_task(client: Client) -> None:
    assert client.submit(WAIT) == "wait-0001"
    assert client.submit(WaitRequest(item=4)) == "wait-0002"
    assert [status.request["item"] for status in client.tasks()] == [3, 4]


@pytest.mark.parametrize(("first", "again"), [("mine", "mine"), ("", "")])
def test_the_same_id_is_the_same_task(client: Client, first: str, again: str) -> None:
    one, other = client.submit(WAIT, client_id=first), client.submit(WAIT, client_id=again)
    assert (one == other) is bool(first)


def test_an_id_in_the_document_is_kept(client: Client) -> None:
    task = client.submit({**WAIT, "id": "theirs"})
    assert client.status(task).request["id"] == "theirs"


def test_what_is_wrong_with_a_request_is_told(client: Client) -> None:
    with pytest.raises(RejectedError, match="item: expected a whole number, found") as caught:
        client.submit({"task": "wait", "item": "three"})
    assert [problem.path for problem in caught.value.problems] == ["item"]


def test_watching_tells_each_change_until_the_end(client: Client, link: Stepping) -> None:
    task = client.submit(WAIT)
    link.events = {link.steps + 5: 1}
    seen = [(status.state, status.progress.fraction) for status in client.watch(task)]
    assert seen == [(TaskState.RUNNING, 0.5), (TaskState.SUCCEEDED, 1.0)]


def test_a_status_that_got_lost_is_asked_for(client: Client, link: Stepping) -> None:
    task = client.submit(WAIT)
    watching = client.watch(task)
    assert next(watching).state is TaskState.RUNNING
    deaf = [inbox for inbox in link.here.hub.inboxes if inbox.expression == f"task/{task}/status"]
    for inbox in deaf:
        link.here.hub.forget(inbox)
    link.here.world(1)
    assert next(watching).state is TaskState.SUCCEEDED


@pytest.mark.parametrize(("version", "state"), [(1, TaskState.SUCCEEDED), (2, TaskState.FAILED)])
def test_waiting_ends_with_the_task(client: Client, link: Stepping, version: int, state: TaskState) -> None:
    task = client.submit(WAIT)
    link.events = {link.steps + 3: version}
    assert client.wait(task).state is state
    assert client.wait(task).state is state, "who comes late is told as well"


def test_running_a_request_that_fails_raises_with_its_status(client: Client, link: Stepping) -> None:
    link.events = {4: 2}
    with pytest.raises(TaskFailedError, match="FAILED: GRASP_EMPTY") as caught:
        client.run(WAIT)
    assert "GRASP_EMPTY" in client.why()
    assert caught.value.status.state is TaskState.FAILED


def test_time_is_bounded(client: Client) -> None:
    task = client.submit(WAIT)
    with pytest.raises(TimedOutError, match=r"wait-0001 has not ended within 0\.5 s"):
        client.wait(task, timeout=0.5)
    assert client.status(task).state is TaskState.RUNNING


def test_trees_come_as_they_change_and_end_with_the_task(client: Client, link: Stepping) -> None:
    task = client.submit(WAIT)
    link.events = {link.steps + 5: 1}
    roots = [tree.root.status for tree in client.trees(task)]
    assert (roots[0], roots[-1]) == (NodeStatus.RUNNING, NodeStatus.SUCCESS)
    assert client.tree().task == task


def test_verbs_say_whether_they_were_taken(client: Client) -> None:
    with pytest.raises(RefusedError, match="pause of the running task was refused: no task is running"):
        client.pause()
    task = client.submit(WAIT)
    client.info()
    assert client.pause() == task
    assert client.status(task).state is TaskState.PAUSED
    assert client.resume() == task
    with pytest.raises(RefusedError, match="the task is not paused"):
        client.step(task)
    assert client.cancel(task) == task
    assert client.wait(task).state is TaskState.CANCELED
    with pytest.raises(RefusedError, match="the task has ended"):
        client.cancel(task)


def test_verbs_of_a_queued_task(client: Client) -> None:
    client.submit(WAIT)
    second, third = client.submit(WAIT), client.submit(WAIT)
    assert client.reprioritise(third, 5) == third
    assert client.status(third).priority == 5
    for refused in (
        lambda: client.abandon(second),
        lambda: client.answer(second, "yes"),
        lambda: client.reprioritise("wait-0099", 1),
        lambda: client.force("wait-0001", "no such node", "SUCCESS"),
    ):
        with pytest.raises(RefusedError):
            refused()


def test_a_breakpoint_holds_the_task_and_a_step_goes_on(client: Client, link: Stepping) -> None:
    task = client.submit(WAIT)
    client.info()
    assert client.set_breakpoint(task, "wait for the world", when="after") == task
    link.here.world(1)
    link.here.step(10)
    assert client.status(task).state is TaskState.PAUSED
    assert client.set_breakpoint(task, "wait for the world", when="after", on=False) == task
    assert client.step(by="tick") == task


def test_the_history_is_asked_page_by_page(client: Client) -> None:
    tasks = [client.submit(WAIT) for _ in range(3)]
    first = client.history(limit=2)
    assert [status.task for status in first.tasks] == [tasks[2], tasks[1]]
    assert [status.task for status in client.history(before=first.more).tasks] == [tasks[0]]
    assert client.history(states=[TaskState.FAILED]).tasks == ()


def test_an_empty_name_cancels_nothing(client: Client) -> None:
    task = client.submit(WAIT)
    with pytest.raises(RefusedError, match="unknown task ''"):
        client.cancel("")
    assert client.status(task).state is TaskState.RUNNING


@pytest.mark.parametrize("ask", [Client.status, Client.wait, Client.why])
def test_unknown_tasks_are_said_to_be_unknown(client: Client, ask: object) -> None:
    assert callable(ask)
    with pytest.raises(UnknownTaskError, match="unknown task 'wait-0099'"):
        ask(client, "wait-0099")


def test_an_executive_that_is_silent_is_waited_for_no_longer_than_said(
    client: Client, link: Stepping
) -> None:
    link.served = False
    before = link.here.clocks.seconds
    with pytest.raises(NotConnectedError, match="no executive answers on lab/tiago"):
        client.info()
    assert link.here.clocks.seconds - before == pytest.approx(2.5)


def test_waiting_outlives_an_executive_that_is_silent_for_a_while(client: Client, link: Stepping) -> None:
    task = client.submit(WAIT)

    def back_after(seconds: float) -> None:
        """Serve again after so many seconds, and have the task succeed soon afterwards."""
        link.served = False
        end, wait = link.here.clocks.seconds + seconds, link.wait

        def waiting(left: float) -> None:
            if link.here.clocks.seconds >= end and not link.served:
                link.served, link.events = True, {link.steps + 5: 1}
            wait(left)

        link.wait = waiting  # type: ignore[method-assign]

    back_after(40.0)
    assert client.wait(task).state is TaskState.SUCCEEDED
    assert link.here.clocks.seconds > 40.0


def test_waiting_ends_after_a_silence_that_no_restart_explains(client: Client, link: Stepping) -> None:
    task = client.submit(WAIT)
    link.served = False
    before = link.here.clocks.seconds
    with pytest.raises(NotConnectedError, match="no executive answers on lab/tiago"):
        client.wait(task)
    assert 60.0 <= link.here.clocks.seconds - before < 70.0


class Declining(Stepping):
    """The executive refuses each question for a while, as for its rate."""

    def __post_init__(self) -> None:
        super().__post_init__()
        self.until, ask = 1.0, self.bus.query

        def query(key: str, payload: bytes, *, timeout: float = 2.0) -> object:
            pending = ask(key, payload, timeout=timeout)
            if self.here.clocks.seconds >= self.until:
                return pending
            pending.replies.clear()
            return MemoryPending(error=b'{"reason": "too often; ask again in 1 s"}')

        self.bus.query = query  # type: ignore[method-assign,assignment]


def test_a_question_that_is_refused_for_its_rate_is_asked_again() -> None:
    link = Declining(Surroundings())
    client = Client(link=link, monotonic=link.here.clocks.monotonic)
    assert client.tasks() == ()
    assert link.here.clocks.seconds >= 1.0


def test_a_question_that_is_always_refused_says_why() -> None:
    link = Declining(Surroundings())
    link.until = 100.0
    client = Client(link=link, monotonic=link.here.clocks.monotonic)
    with pytest.raises(DeclinedError, match="task/list was declined: too often; ask again in 1 s"):
        client.tasks()


class Losing(Stepping):
    """The answer to the first request is lost on its way, as with a link that goes."""

    def wait(self, seconds: float) -> None:
        super().wait(seconds)
        if self.steps == 1:
            for pending in self.asked:
                pending.replies.clear()
                assert pending.done()

    def __post_init__(self) -> None:
        super().__post_init__()
        self.asked, ask = [], self.bus.query

        def query(key: str, payload: bytes, *, timeout: float = 2.0) -> object:
            self.asked.append(ask(key, payload, timeout=timeout))
            return self.asked[-1]

        self.bus.query = query  # type: ignore[method-assign,assignment]


def test_a_lost_answer_is_asked_for_again_and_starts_nothing_twice() -> None:
    link = Losing(Surroundings())
    client = Client(link=link, monotonic=link.here.clocks.monotonic)
    assert client.submit(WAIT) == "wait-0001"
    assert len(link.asked) == 2
    assert len(client.tasks()) == 1


def test_an_answer_of_another_version_is_said_to_be_one(client: Client, link: Stepping) -> None:
    link.served = False
    desk = next(desk for desk in link.here.hub.desks if desk.expression == "task/info")
    talk = client._ask.info()
    next(talk)
    desk.drain()[0].reply(json.dumps({"name": "executive", "new": 1}).encode())
    with pytest.raises(OtherVersionError, match="task/info: the answer is from another version of tandem"):
        next(talk)


def test_a_closed_client_says_so(client: Client) -> None:
    client.close()
    client.close()
    with pytest.raises(ClientError, match="closed"):
        client.info()


def test_the_client_of_asyncio_serves_many_at_once() -> None:
    link = Awaiting(Surroundings())

    async def one(client: AsyncClient, item: int) -> TaskState:
        task = await client.submit({**WAIT, "item": item})
        return (await client.wait(task)).state

    async def main() -> list[TaskState]:
        async with AsyncClient(link=link, monotonic=link.here.clocks.monotonic) as client:
            link.events = {30: 1, 35: 1, 40: 1}
            ends = await asyncio.gather(*(one(client, item) for item in range(3)))
            assert isinstance(await client.info(), ExecutiveInfo)
            assert [tree.task async for tree in client.trees("wait-0003")] == ["wait-0003"]
            with pytest.raises(RefusedError):
                await client.pause("wait-0001")
        with pytest.raises(ClientError, match="not connected"):
            await client.info()
        return ends

    assert asyncio.run(main()) == [TaskState.SUCCEEDED] * 3


def test_both_clients_have_the_same_methods() -> None:
    def public(of: type) -> set[str]:
        return {name for name in vars(of) if not name.startswith("_")}

    assert public(AsyncClient) - public(Client) == {"connect"}
    assert public(Client) - public(AsyncClient) == set()
