"""Two fetches, and a question while they run, in asyncio: ``python client_async.py [ROUTER]``."""
# ruff: noqa: INP001, T201 - an example: a file of its own that prints

import asyncio
import sys

from tandem.client import AsyncClient, TaskFailedError

router = (*sys.argv[1:], "tcp/127.0.0.1:7447")[0]


async def fetch(client: AsyncClient, item: int) -> str:
    """Return how it ended."""
    try:
        status = await client.run({"task": "fetch", "item": item}, timeout=600.0)
    except TaskFailedError as failed:
        return str(failed)
    return f"{status.task} {status.state}"


async def main() -> None:
    """Both wait for their ends at once; the robot does one after the other."""
    async with AsyncClient(router) as client:
        both = asyncio.gather(fetch(client, 29), fetch(client, 29))
        print((await client.info()).tasks)
        for end in await both:
            print(end)


asyncio.run(main())
