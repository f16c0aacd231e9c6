"""The page's history over a ledger of 20,000 tasks: what each filter takes, from the question to its answer.

``python -m benchmarks.page`` prints the table. The ledger is made by ``fill``; an executive serves it, and a
page's server beside it is asked over HTTP, as a browser does.
"""

from __future__ import annotations

import http.client
import random
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from benchmarks.processes import PREFIX, running
from benchmarks.rows import Row, spread
from tandem.executive.config.run_options import BusOptions
from tandem.executive.ledger.port import Entry
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.system.process_usage import shared_memory
from tandem.executive.web.options import WebOptions
from tandem.executive.web.robot import RobotOnZenoh, Who
from tandem.executive.web.serve import Shown, listen, serve_until
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import TaskState, TaskStatus

TASKS: Final = 20_000
WEEK: Final = 7 * 86_400.0
WEEKS: Final = 25
"""As far back as an executive keeps tasks."""
TIMES: Final = 20
AIM: Final = 0.2
"""Seconds for a page."""
KINDS: Final = ("fetch", "pick_two", "patrol", "go_to")
FAILURES: Final = (
    (FailureKind.GRASP_EMPTY, "fetch/pick/close"),
    (FailureKind.ITEM_NOT_FOUND, "fetch/find/look round"),
    (FailureKind.BASE_BLOCKED, "base/drive"),
)
FILTERS: Final = (
    "", "state=FAILED", "kind=fetch", "item=29", "failure=GRASP_EMPTY", "label=zone=north", "text=fetch-1",
    "page=399", "state=SUCCEEDED&kind=fetch&label=zone=north&item=29",
)  # fmt: skip


def fill(folder: Path, count: int = TASKS) -> None:
    """Make a ledger of so many ended tasks, spread over half a year until now."""
    chance, now = random.Random(1), time.time()  # noqa: S311 - no secret
    ledger = SqliteLedger(folder)
    for number in range(1, count + 1):
        accepted = now - WEEK * WEEKS * (count - number + 1) / count
        ledger.enter(Entry(_task(number, accepted, chance), number))
    ledger.commit()
    ledger.close()


def _task(number: int, accepted: float, chance: random.Random) -> TaskStatus:
    kind = chance.choice(KINDS)
    failed = chance.random() < 0.1
    reason, where = chance.choice(FAILURES)
    begun, took = 100.0 * number, chance.uniform(20.0, 90.0)
    return TaskStatus(
        task=f"{kind}-{number}",
        kind=kind,
        request={
            "task": kind,
            "item": chance.randint(20, 40),
            "labels": {"zone": chance.choice(["north", "south"])},
        },
        state=TaskState.FAILED if failed else TaskState.SUCCEEDED,
        failure=Failure(kind=reason, message="as in a benchmark", where=where) if failed else None,
        accepted_at=accepted,
        ended_at=accepted + took,
        started=RobotTime(boot="b", seconds=begun),
        ended=RobotTime(boot="b", seconds=begun + took),
        begun=1,
    )


@contextmanager
def page_of(endpoint: str) -> Iterator[int]:
    """Serve a page from a thread; yields its port."""
    site, _, robot = PREFIX.partition("/")
    options = BusOptions(endpoint, site, robot)
    listening = listen(WebOptions(options, "127.0.0.1", 0))
    stopped = threading.Event()
    shown = Shown(RobotOnZenoh(options, Who("bench"), None), listening)
    served = ([shown], stopped.is_set, lambda: None)
    thread = threading.Thread(target=serve_until, args=served)
    thread.start()
    try:
        yield listening.socket.getsockname()[1]
    finally:
        stopped.set()
        thread.join()


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    count, times = (500, 2) if quick else (TASKS, TIMES)
    with tempfile.TemporaryDirectory(prefix="tandem-bench-") as name:
        fill(Path(name), count)
        with running(["executive"], data=Path(name)) as (endpoint, pids), page_of(endpoint) as port:
            asking = http.client.HTTPConnection("127.0.0.1", port, timeout=120.0)
            first, size = _asked(asking, "")
            yield Row(
                f"first page of a history of {count} tasks", first, "s", note="the whole ledger is read"
            )
            yield Row("the same, bytes", size, "B")
            for query in FILTERS:
                took = [_asked(asking, query)[0] for _ in range(times)]
                yield from spread(f"history?{query}", took, aim=1e3 * AIM)
            asking.close()
            yield Row("memory of the executive that serves it", shared_memory(pids["executive"]), "MB")


def _asked(asking: http.client.HTTPConnection, query: str) -> tuple[float, int]:
    began = time.perf_counter()
    asking.request("GET", f"/api/history?{query}")
    answer = asking.getresponse()
    body = answer.read()
    if answer.status != http.client.OK:
        raise RuntimeError(f"history?{query}: {answer.status} {body[:200]!r}")
    return time.perf_counter() - began, len(body)


if __name__ == "__main__":
    for row in rows(quick="--quick" in sys.argv[1:]):
        aim = "" if row.aim is None else f"  (aim {row.aim:g})"
        sys.stdout.write(f"{row.what:60} {row.value:10.4g} {row.unit}{aim}  {row.note}\n")
