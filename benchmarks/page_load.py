"""What the page costs, and how soon its stop gets through: ``python -m benchmarks.page_load``.

It starts ``tandem up`` with its page in real time and prints two tables:

- the web process's share of a core with no, one and twenty viewers, while the robot stands and while it
  fetches. A viewer is a websocket that takes in all that it is told.
- the time from a click on STOP in Chromium to the hardware's acknowledgement, at drawn moments of a fetch.
  The answer's way back to the page is in it. The hardware answers once all its parts have begun to brake.

Run it alone: shares and times are those of real time. It needs Chromium and the extra ``dev``.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from http import HTTPStatus
from pathlib import Path
from typing import Final

import numpy as np
from playwright.sync_api import Page, sync_playwright
from websockets.asyncio.client import ClientConnection, connect
from websockets.typing import Origin

from benchmarks.fetch_time import REQUESTED
from benchmarks.machine import describe
from benchmarks.page_pictures import BROWSERS, ROBOT, SITE, system
from benchmarks.processes import by_role
from benchmarks.rows import Row, quantile
from benchmarks.run import table
from tandem.client import Client
from tandem.executive.system.process_usage import processor_seconds
from tandem.executive.system.roles.web import NAME as WEB
from tandem.executive.trials.provenance import provenance
from tandem.skills.ports.tasks import TaskState

AIMS: Final = {0: None, 1: 3.0, 20: 10.0}
"""Most per cent of a core, by viewers; without any, next to nothing: the process beats."""
SECONDS: Final = 60.0
"""Of each share, unless the fetch ends before. The kernel counts in 10 ms: 0.02 % of it."""
SETTLES: Final = 5.0
"""Seconds in which viewers have read the first picture, and a start is over."""
CLICKS: Final = 50
CLICK_AIMS: Final = (100.0, 250.0)
"""Milliseconds: median and p99."""
LATEST: Final = 2.5
"""Seconds of a fetch after which it is stopped at the latest; the next goes on from where the robot is."""
ENDS_WITHIN: Final = 120.0
"""Seconds for a task to run, or to end after a stop: it takes a few."""
CHECKED_EVERY: Final = 0.05
"""Seconds between two questions how a task stands, while nothing is measured by the answer."""
OPEN: Final = "all look on"
CLICKED: Final = """() => {
  performance.clearResourceTimings();
  addEventListener("click", event => { window.clicked = event.timeStamp }, {capture: true, once: true});
}"""
ANSWERED: Final = """() => performance.getEntriesByType("resource")
  .filter(each => each.name.endsWith("/api/verb/stop") && each.responseEnd > 0)
  .map(each => [each.responseStatus, each.responseEnd - window.clicked])[0]"""
"""Status of the stop's answer, and the ms from the click: both are of the browser's own clock."""


async def look_on(address: str, count: int) -> None:
    """Open so many viewers, say so, and take in all that they are told until this process is ended."""
    where, origin = f"{address.replace('http', 'ws')}/live", Origin(address)
    tabs = [await connect(where, origin=origin, max_size=None) for _ in range(count)]
    print(OPEN, flush=True)
    await asyncio.gather(*(_take_in(tab) for tab in tabs))


async def _take_in(tab: ClientConnection) -> None:
    async for _ in tab:
        pass


@contextmanager
def viewers(address: str, count: int) -> Iterator[None]:
    """Have so many viewers, in a process of their own: their reading is not the server's."""
    if not count:
        yield
        return
    argv = [sys.executable, "-m", "benchmarks.page_load", "--look-on", address, str(count)]
    with subprocess.Popen(argv, stdout=subprocess.PIPE, text=True) as looking:  # noqa: S603 - our own code
        try:
            if looking.stdout is None or looking.stdout.readline().strip() != OPEN:
                raise RuntimeError(f"{count} viewers could not be opened")
            yield
            if looking.poll() is not None:
                raise RuntimeError("the viewers ended while they were counted")
        finally:
            looking.terminate()


def share(most: float, client: Client | None = None, task: str = "") -> tuple[float, float]:
    """Return the web process's per cent of a core, and the seconds that were counted: until the task ends."""
    before, began = _web_seconds(), time.monotonic()
    while (passed := time.monotonic() - began) < most:
        if client is not None and client.status(task).state.terminal:
            break
        time.sleep(min(1.0, most - passed))
    passed = time.monotonic() - began
    return 100.0 * (_web_seconds() - before) / passed, passed


def _web_seconds() -> float:
    return by_role(os.getpid(), processor_seconds, above="benchmark")[WEB]


def shares(seconds: float) -> Iterator[Row]:
    """Measure what viewers cost, each number of them beside a system of its own."""
    for count, aim in AIMS.items():
        with (
            tempfile.TemporaryDirectory(prefix="tandem-bench-") as data,
            system(Path(data)) as (endpoint, address),
            viewers(address, count),
            Client(endpoint, site=SITE, robot=ROBOT) as client,
        ):
            time.sleep(SETTLES)
            value, passed = share(seconds)
            yield Row(f"page, viewers: {count}, robot stands", value, "%", aim, note=f"{passed:.0f} s")
            value, passed = share(seconds, client, begin(client))
            yield Row(f"page, viewers: {count}, during a fetch", value, "%", aim, note=f"{passed:.0f} s")


def begin(client: Client) -> str:
    """Ask for a fetch; returns its task once it runs."""
    task = client.submit(REQUESTED)
    await_state(client, task, running=True)
    return task


def await_state(client: Client, task: str, *, running: bool) -> TaskState:
    """Wait until a task runs, or with ``running=False`` until it has ended; a task that ended ran before."""
    deadline = time.monotonic() + ENDS_WITHIN
    while time.monotonic() < deadline:
        state = client.status(task).state
        if state.terminal or (running and state is TaskState.RUNNING):
            return state
        time.sleep(CHECKED_EVERY)
    raise TimeoutError(f"{task} did not {'run' if running else 'end'} within {ENDS_WITHIN:.0f} s")


def clicks(count: int, chromium: str) -> Iterator[Row]:
    """Measure the stop; a system ends when its item has been fetched, and the next one goes on."""
    took: list[float] = []
    rng = np.random.default_rng(1)
    while len(took) < count:
        with (
            tempfile.TemporaryDirectory(prefix="tandem-bench-") as data,
            system(Path(data)) as (endpoint, address),
            sync_playwright() as driver,
            Client(endpoint, site=SITE, robot=ROBOT) as client,
        ):
            browser = driver.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
            page = browser.new_page(base_url=address)
            page.goto("/")
            page.wait_for_selector(".canvas[data-robot=loaded]", timeout=1e3 * ENDS_WITHIN)
            while len(took) < count:
                task = begin(client)
                time.sleep(float(rng.uniform(0.0, LATEST)))
                if client.status(task).state.terminal:
                    break
                took.append(click(page))
                await_state(client, task, running=False)
                client.release(by="benchmark")
            browser.close()
    what, note = "from the click to the hardware's acknowledgement", f"of {len(took)}"
    for name, where, aim in zip(("median", "p99"), (0.5, 0.99), CLICK_AIMS, strict=True):
        yield Row(f"{what}, {name}", quantile(took, where), "ms", aim, note=note)
    yield Row(f"{what}, max", max(took), "ms", note=note)


def click(page: Page) -> float:
    """Click on STOP; returns the milliseconds until its answer had come.

    Raises:
        RuntimeError: when the server answered with an error: then nothing was acknowledged.
    """
    page.evaluate(CLICKED)
    page.locator("button.stop").click()
    status, took = page.wait_for_function(ANSWERED).json_value()
    if status != HTTPStatus.OK:
        raise RuntimeError(f"the stop was answered with {status}")
    return float(took)


def main(argv: Sequence[str]) -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--seconds", type=float, default=SECONDS, help="of each share")
    parser.add_argument("--clicks", type=int, default=CLICKS)
    parser.add_argument("--look-on", nargs=2, metavar=("ADDRESS", "COUNT"), help=argparse.SUPPRESS)
    asked = parser.parse_args(argv)
    if asked.look_on:
        asyncio.run(look_on(asked.look_on[0], int(asked.look_on[1])))
        return 0
    chromium = next((found for name in BROWSERS if (found := shutil.which(name))), None)
    if chromium is None:
        sys.stderr.write("no Chromium: apt-get install --no-install-recommends chromium\n")
        return 2
    made = provenance(("python -m benchmarks.page_load", *argv), time.time())
    where = describe()
    print(f"{made.line()}\n\n{where}\n\n{table(list(shares(asked.seconds)))}", flush=True)
    print(f"\n{table(list(clicks(asked.clicks, chromium)))}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
