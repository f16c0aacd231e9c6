"""Strangers on the robot's network look around, ask for nonsense, ask too much and too often.

A user saw: a viewer that listed ``<site>/<robot>/hw/**`` released the stop that an operator had set, and one
that listed ``**`` ended the executive. ``task/history {"before": 99999999999999999999}`` ended it, too.
While somebody asked for the list of 1,000 tasks again and again, or sent 200 MB as ``task/cancel``, the
executive did not beat for seconds, and skills came to rest since its client seemed to hang. The id "1" of one
client was refused since another had used it, and a client that was allowed 50 open requests got 100.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import pytest
import zenoh

from tests.fakes.ports import free_endpoint
from tests.outside._up import client, until, up

SITE: Final = "strangers"
PREFIX: Final = f"{SITE}/tiago"
MAY_GAP: Final = 1.0
"""Seconds between two beats, beyond what a program that only sleeps is late: on a busy machine all are.
`tandem bench limits` measures gaps. They were 1.6 and 7.9 s."""
FETCH: Final = {"task": "fetch", "item": 29}
COMMANDS: Final = (
    *("goal", "command", "cancel", "release", "stop", "reset", "request"),
    *("pause", "resume", "step", "abandon", "answer", "force", "move", "remove", "fault"),
)

pytestmark = pytest.mark.processes


_SLEEPER: Final = """
import sys, threading, time
ends, late = threading.Event(), 0.0
threading.Thread(target=lambda: (sys.stdin.read(), ends.set()), daemon=True).start()
while not ends.is_set():
    began = time.monotonic()
    time.sleep(0.05)
    late = max(late, time.monotonic() - began - 0.05)
print(late)
"""
"""Sleeps until its input is closed, and tells by how much it was late at the most. It is on no bus."""
_HUGE: Final = """
import json, sys, zenoh
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([sys.argv[1]]))
with zenoh.open(config) as session:
    print(len(list(session.get(sys.argv[2], payload=b"x" * 200_000_000, timeout=5.0))))
"""


@dataclass
class Robot:
    """A running system, and a stranger's session."""

    endpoint: str
    session: zenoh.Session
    beats: list[float] = field(default_factory=list)
    """When the executive was heard to go on."""

    def get(self, selector: str, payload: bytes | None = None, within: float = 5.0) -> list[zenoh.Reply]:
        return list(self.session.get(selector, payload=payload, timeout=within))

    def ask(self, key: str, document: object = None) -> Any:
        """Return the answer's document, or that of the error."""
        body = None if document is None else json.dumps(document).encode()
        for _ in range(5):
            for reply in self.get(f"{PREFIX}/{key}", body):
                told = (reply.ok or reply.err).payload.to_bytes()  # type: ignore[union-attr]
                if told != b"Timeout":  # zenoh's own: on a busy machine a query may get lost
                    return json.loads(told)
        raise AssertionError(f"nobody answers at {key}")


def gap(beats: list[float]) -> float:
    """The longest time between two beats."""
    return max(later - one for one, later in pairwise(beats))


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Robot]:
    endpoint, folder = free_endpoint(), Path(tmp_path_factory.mktemp("strangers"))
    with up(endpoint, SITE, folder), client(endpoint) as session:
        made = Robot(endpoint, session)

        def beat(sample: zenoh.Sample) -> None:
            if "executive" in sample.payload.to_string().split("\n"):
                made.beats.append(time.monotonic())

        session.declare_subscriber(f"{PREFIX}/beat", beat)
        # With the stop set no task starts: what is asked for here waits, and nothing moves.
        assert made.ask("hw/stop", {"by": "operator", "reason": "strangers"})["stopped"]
        yield made


@pytest.mark.parametrize(
    "selector", [f"{PREFIX}/hw/**", f"{PREFIX}/**", f"{PREFIX}/sim/**", f"{PREFIX}/skill/**", "**"]
)
@pytest.mark.parametrize("document", [None, b"{}", b'{"by": "me"}', b'{"seed": 1}', b"\xff"])
def test_whoever_looks_around_commands_nothing(robot: Robot, selector: str, document: bytes | None) -> None:
    truth = robot.ask("sim/truth")
    answered = [str(reply.ok.key_expr) for reply in robot.get(selector, document) if reply.ok is not None]
    assert not [key for key in answered if "*" in key]
    assert not [key for key in answered if key.rsplit("/", 1)[-1] in COMMANDS]
    stop = robot.ask("hw/stop", {"by": "operator", "reason": "strangers"})
    assert (stop["stopped"], stop["by"]) == (True, "operator")
    assert robot.ask("sim/truth")["stamp"]["boot"] == truth["stamp"]["boot"], "the sim was reset"
    assert robot.ask("task/info")["name"] == "executive"


def test_a_look_around_finds_what_may_be_read(robot: Robot) -> None:
    found = {str(reply.ok.key_expr) for reply in robot.get(f"{PREFIX}/**") if reply.ok is not None}
    assert {f"{PREFIX}/{key}" for key in ("hw/description", "sim/truth", "task/list", "task/info")} <= found


@pytest.mark.parametrize("key", ["**", f"{SITE}/**", f"{PREFIX}/**", f"{PREFIX}/hw/**", f"{PREFIX}/*/*"])
def test_what_is_put_on_a_wildcard_is_nobodys_message(robot: Robot, key: str) -> None:
    """One set-point on ``strangers/**`` ended the hardware, one request there was accepted as a task."""
    truth, before = robot.ask("sim/truth"), robot.ask("task/info")
    setpoint = {"stamp": truth["stamp"], "positions": [0.0], "velocities": [0.0]}
    stop = {"stopped": False, "by": "me", "reason": ""}
    for document in (FETCH, setpoint, stop, {"by": "me"}, {"linear": 0.5, "angular": 0.0}):
        robot.session.put(key, json.dumps(document))
    robot.session.delete(key)
    robot.beats.clear()
    until(lambda: len(robot.beats) > 3, 10.0)  # several turns of the executive's loop
    after = robot.ask("task/info")
    assert (after["queued"], after["running"]) == (before["queued"], before["running"])
    assert robot.ask("sim/truth")["stamp"]["boot"] == truth["stamp"]["boot"]


def test_a_release_names_who_releases(robot: Robot) -> None:
    for nobody in (None, b"", b"{}", b'{"who": "me"}', b'{"by": ""}'):
        for reply in robot.get(f"{PREFIX}/hw/stop/release", nobody):
            assert reply.ok is None
    assert robot.ask("hw/stop/release", {"by": "operator"})["stopped"] is False
    robot.get(f"{PREFIX}/hw/stop", b"\xff no document")
    stop = robot.ask("hw/stop", {"by": "operator", "reason": "strangers"})
    assert stop["stopped"] is True


@pytest.mark.parametrize(
    "document",
    [
        b'{"before": 99999999999999999999}',
        b'{"before": -1}',
        b'{"limit": 1000000}',
        b'{"since": 1e999}',
        b"[" * 60_000,
        b'{"task": "' + b"x" * 70_000 + b'"}',
        b'{"task": "a", "task": "b"}',
        b"\xff\xfe",
    ],
)
def test_a_bad_question_costs_its_sender_an_answer(robot: Robot, document: bytes) -> None:
    for _ in range(4):
        (reply,) = robot.get(f"{PREFIX}/task/history", document)
        assert reply.err is not None
        refusal = json.loads(reply.err.payload.to_bytes())
        assert refusal["problems"][0]["expected"]
    assert robot.ask("task/history", {"limit": 1})["tasks"] is not None


def test_ids_are_a_clients_own(robot: Robot) -> None:
    hers = robot.ask("task/by/ann/request", {**FETCH, "id": "1"})
    his = robot.ask("task/by/bob/request", {"task": "fetch", "item": 3, "id": "1"})
    assert hers["accepted"]
    assert his["accepted"]
    assert hers["task"] != his["task"]
    assert robot.ask("task/by/ann/request", {**FETCH, "id": "1"})["task"] == hers["task"]
    reason = robot.ask("task/by/bob/cancel", {"task": hers["task"]})["reason"]
    assert "belongs to another client than bob" in reason
    assert not robot.ask("task/request", {**FETCH, "id": "a\nb"})["accepted"]


def test_requests_that_nobody_has_read_yet_count_as_open(robot: Robot) -> None:
    key, body = f"{PREFIX}/task/by/greedy/request", json.dumps(FETCH).encode()
    answers = [robot.session.get(key, payload=body, timeout=10.0) for _ in range(75)]
    for _ in range(75):
        robot.session.put(key, body)
    accepted = [
        json.loads(reply.ok.payload.to_bytes())["accepted"]
        for answer in answers
        for reply in answer
        if reply.ok is not None
    ]
    until(lambda: robot.ask("task/info")["queued"] >= 50, 10.0)
    listed, before = list[dict[str, Any]](), 0
    while True:
        page = robot.ask("task/list", {"before": before})
        listed += page["tasks"]
        before = page["more"]
        if not before:
            break
    assert accepted.count(True) <= 50
    assert sum(each["request"].get("by") == "greedy" for each in listed) == 50


def test_lists_of_many_tasks_and_a_huge_document_stop_nobody(robot: Robot) -> None:
    body = json.dumps(FETCH).encode()

    def many() -> bool:
        for _ in range(100):
            robot.session.put(f"{PREFIX}/task/request", body)
        # `until` asks 50 times a second at the most: who asks without a pause is refused for the rate.
        return bool(robot.ask("task/info")["queued"] >= 900)

    until(many, 120.0)
    until(lambda: time.monotonic() - robot.beats[-1] < 0.2, 10.0)
    robot.beats.clear()
    sleeper = subprocess.Popen(
        [sys.executable, "-c", _SLEEPER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    asked = [robot.session.get(f"{PREFIX}/task/list", timeout=10.0) for _ in range(120)]
    answers = [reply.ok for each in asked for reply in each if reply.ok is not None]
    pages = [json.loads(answer.payload.to_bytes()) for answer in answers]
    assert pages
    assert all(len(page["tasks"]) == 100 and page["more"] for page in pages)
    # By a process of its own: one that sends so much hears nobody's beats meanwhile.
    subprocess.run(
        [sys.executable, "-c", _HUGE, robot.endpoint, f"{PREFIX}/task/cancel"], check=True, timeout=60
    )
    assert robot.ask("task/info")["name"] == "executive"
    late = float(sleeper.communicate(timeout=60.0)[0])
    assert gap(robot.beats) < MAY_GAP + late
