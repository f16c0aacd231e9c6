"""Keep what later versions must open and serve: ``python -m tests.releases.freeze v0_1_0``.

Starts a router, a robot of mocked skills and an executive; has tasks end, run and wait; asks all that the
client can ask; kills the executive; and writes the data folder, the client's documents and the schemas beside
this file. Run it once, on the commit that is released. Never change what it has written.
"""

from __future__ import annotations

import json
import shutil
import signal
import sqlite3
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Final

from tandem.client import Client, ClientError
from tandem.executive.interface.schemas import interface_schema, separate_schemas
from tandem.skills.ports.bus import Pending
from tandem.skills.wire.zenoh_bus import ZenohBus
from tandem.trees.registry import discover
from tests.outside._mocked import Mocked, until
from tests.releases.frozen import DATA, HERE, SITE, Exchange, Facts, write

FETCH: Final = {"task": "fetch", "item": 29, "to": "depot"}
NOT_THERE: Final = 3
"""An item of the site that the mocked robot does not find."""
DAY: Final = 86400.0
LEDGER: Final = "ledger.sqlite"
KEPT: Final = (LEDGER, f"{LEDGER}-wal", "truth.json")

Asked = list[tuple[str, bytes, Pending]]


@contextmanager
def recorded() -> Iterator[Asked]:
    """Note all that this process asks."""
    asked: Asked = []
    asking = ZenohBus.query

    def query(bus: ZenohBus, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        pending = asking(bus, key, payload, timeout=timeout)
        asked.append((key, payload, pending))
        return pending

    ZenohBus.query = query  # type: ignore[method-assign]
    try:
        yield asked
    finally:
        ZenohBus.query = asking  # type: ignore[method-assign]


def fill(system: Mocked) -> Facts:
    """Have tasks end, run and wait."""
    client, now = system.client, time.time()
    done = client.submit({"task": "inspect", "labels": {"order": "4711"}}, client_id="first")
    failed = client.submit(FETCH | {"item": NOT_THERE})
    ended = {task: system.until_state(task) for task in (done, failed)}
    running = client.submit(FETCH | {"priority": 1, "on_restart": "resume"}, client_id="runs")
    until("it runs", lambda: system.state(running) == "RUNNING")
    system.signal("mock", signal.SIGSTOP)
    unwanted = client.submit({"task": "pick", "item": 29})
    client.cancel(unwanted)
    ended[unwanted] = system.until_state(unwanted)
    waiting = (
        client.submit(FETCH | {"on_cancel": "put_down"}, client_id="waits"),
        client.submit({"task": "place", "to": "depot"}),
    )
    start = datetime.fromtimestamp(now + DAY, UTC).isoformat()
    later = client.submit(FETCH | {"not_before": start}, client_id="later")
    return Facts(
        version=version("tandem-executive"),
        frozen_at=now,
        ended=ended,
        running=running,
        waiting=waiting,
        later=later,
        by_client={"first": done, "runs": running, "waits": waiting[0], "later": later},
    )


def ask_all(client: Client, facts: Facts) -> None:
    """Ask what the client can ask; a refusal is an answer, too."""
    done = next(iter(facts.ended))
    questions: list[Callable[[], object]] = [
        client.info,
        client.tasks,
        client.history,
        client.tree,
        lambda: client.status(done),
        lambda: client.why(done),
        lambda: client.submit({"task": "dance"}),
        lambda: client.submit({"task": "fetch", "item": "no such item"}),
        lambda: client.cancel(done),
        lambda: client.pause(done),
        lambda: client.resume(done),
        lambda: client.step(done),
        lambda: client.abandon(done),
        lambda: client.reprioritise(done, 3),
        lambda: client.answer(done, "yes"),
        lambda: client.set_breakpoint(done, "fetch"),
        lambda: client.force(done, "fetch", "SUCCESS"),
    ]
    for question in questions:
        with suppress(ClientError):
            question()


def exchanges(asked: Asked) -> list[Exchange]:
    """Return each different question once, with its last answer and that answer's schema."""
    keys = interface_schema(discover())["keys"]
    assert isinstance(keys, dict)
    found: dict[tuple[str, bytes], Exchange] = {}
    for key, payload, pending in asked:
        answer, entry = pending.poll(), keys.get(key)
        if answer is None or not isinstance(entry, dict):
            continue
        reference = entry["answer"]
        assert isinstance(reference, dict)
        name = str(reference["$ref"]).rsplit("/", 1)[-1]
        found[key, payload] = Exchange(
            key=key, asked=payload.decode(), answer=answer.decode(), schema_name=name
        )
    return list(found.values())


def shrink(ledger: Path) -> None:
    """Take what was committed from the write-ahead log, of some megabytes, into the file."""
    database = sqlite3.connect(ledger)
    database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    database.close()
    ledger.with_name(f"{LEDGER}-wal").unlink(missing_ok=True)


def freeze(folder: Path) -> None:
    """Write a release into the folder, which must not be there yet."""
    with tempfile.TemporaryDirectory() as place, recorded() as asked, Mocked(Path(place), SITE) as system:
        facts = fill(system)
        ask_all(system.client, facts)
        system.signal("executive", signal.SIGKILL)
        until("it is dead", lambda: system.code("executive") is not None)
        (folder / DATA).mkdir(parents=True)
        for name in KEPT:
            shutil.copy(Path(place) / name, folder / DATA / name)
        shrink(folder / DATA / LEDGER)
        write(folder, facts, exchanges(asked), separate_schemas(discover()))


def main(argv: list[str]) -> int:
    """Keep the release that is named, such as v0_1_0."""
    if len(argv) != 1:
        sys.stderr.write("usage: python -m tests.releases.freeze vMAJOR_MINOR_PATCH\n")
        return 2
    expected = "v" + version("tandem-executive").replace(".", "_")
    if argv[0] != expected:
        sys.stderr.write(f"expected {expected}, the version of this checkout; found {json.dumps(argv[0])}\n")
        return 2
    folder = HERE / argv[0]
    if folder.exists():
        sys.stderr.write(f"{folder} is there already; what is kept of a release never changes\n")
        return 2
    freeze(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
