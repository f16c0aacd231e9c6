"""Both clients over a real router, beside an executive whose skills are mocked."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

import pytest

from tandem.executive.client.aio import AsyncClient
from tandem.executive.client.errors import NotConnectedError, TaskFailedError
from tandem.executive.client.sync import Client
from tandem.skills.ports.tasks import TaskState
from tandem.trees.tasks.fetch import FetchRequest
from tests.fakes.mocked import mocked_system
from tests.fakes.ports import free_endpoint

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("client_over_zenoh")]


@pytest.fixture
def router() -> Iterator[str]:
    endpoint = free_endpoint()
    with mocked_system(endpoint, skill_seconds=0.05):
        yield endpoint


def test_a_fetch_is_followed_from_request_to_end(router: str) -> None:
    with Client(router) as client:
        statuses = list(client.watch(client.submit(FetchRequest(item=29)), timeout=60.0))
        fractions = [status.progress.fraction for status in statuses]
        assert fractions == sorted(fractions)
        assert statuses[-1].state is TaskState.SUCCEEDED
        assert client.run(FetchRequest(item=29), timeout=60.0).state is TaskState.SUCCEEDED


def test_two_clients_of_one_loop_and_a_cancel(router: str) -> None:
    async def main() -> str:
        async with AsyncClient(router) as one, AsyncClient(router) as other:
            first, second = await asyncio.gather(
                one.submit(FetchRequest(item=29)), other.submit(FetchRequest(item=29))
            )
            last = asyncio.create_task(one.run(FetchRequest(item=29), client_id="to be cancelled"))
            await other.cancel(await other.submit(FetchRequest(item=29), client_id="to be cancelled"))
            with pytest.raises(TaskFailedError, match="CANCELED"):
                await last
            assert await one.cancel(second) == second
            assert (await other.wait(second, timeout=60.0)).state is TaskState.CANCELED
            ticks = [tree.tick async for tree in one.trees(first, timeout=60.0)]
            assert ticks == sorted(ticks)
            assert (await other.wait(first, timeout=60.0)).state is TaskState.SUCCEEDED
            return await other.why()

    assert asyncio.run(main()) == "no task has failed, and none is running"


def test_no_router_is_said_at_once() -> None:
    endpoint = free_endpoint()
    with pytest.raises(NotConnectedError, match=f"no zenoh router answers at {endpoint}"):
        Client(endpoint, patience=0.2)

    async def main() -> None:
        async with AsyncClient(endpoint, patience=0.2):
            pass

    with pytest.raises(NotConnectedError):
        asyncio.run(main())
