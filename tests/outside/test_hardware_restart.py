"""The robot's unit is switched off and on while the rest goes on.

A user saw: arms that never told their state again, a base that refused to drive, pictures that were all too
old, and ``tandem up`` that ended with its simulated hardware.
"""

from __future__ import annotations

import json
import math
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import pytest
import zenoh

from tandem.sim.scenario import load_scenario
from tandem.skills.ports.pose import FloorPose
from tests.fakes.ports import free_endpoint

SITE: Final = "restarted"
PREFIX: Final = f"{SITE}/tiago"
BEFORE_THE_TABLE: Final = FloorPose(x=-0.55, y=0.50, yaw=0.0)
"""Item 29 is in view from there."""
WITHIN: Final = 400.0
"""Host seconds for a fetch, also beside other programs; alone it takes 60 to 90."""


@contextmanager
def tandem_up(endpoint: str, folder: Path, *more: str) -> Iterator[subprocess.Popen[bytes]]:
    """Run the whole system; entered when it is ready."""
    command = [sys.executable, "-m", "tandem", "up"]
    command += ["--connect", endpoint, "--site-key", SITE, "--data", str(folder), "--speed", "max", *more]
    with (folder / "log").open("w+") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True)
        try:
            until(lambda: "ready" in (folder / "log").read_text(), 90.0, lambda: process.poll() is None)
            yield process
        finally:
            os.killpg(process.pid, signal.SIGINT)
            process.wait(30)


def hardware_of(parent: int) -> int | None:
    """Return the process id of the hardware that a ``tandem up`` has started, or None."""
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            words = (entry / "cmdline").read_bytes()
            above = int((entry / "stat").read_text().rpartition(") ")[2].split()[1])
        except OSError:
            continue
        if above == parent and b'"role":"hardware"' in words:
            return int(entry.name)
    return None


class Client:
    """A program with zenoh and JSON."""

    def __init__(self, endpoint: str) -> None:
        config = zenoh.Config()
        config.insert_json5("mode", '"client"')
        config.insert_json5("connect/endpoints", json.dumps([endpoint]))
        self.session = zenoh.open(config)
        self.boots: list[str] = []
        self.held: list[int] = []
        self.items: dict[int, list[float]] = {}
        self.states: dict[str, str] = {}
        self._ends = [
            self.session.declare_subscriber(f"{PREFIX}/hw/clock", self._clock),
            self.session.declare_subscriber(f"{PREFIX}/world/state", self._world),
            self.session.declare_subscriber(f"{PREFIX}/task/status", self._status),
        ]

    def _clock(self, sample: zenoh.Sample) -> None:
        boot = json.loads(sample.payload.to_bytes())["stamp"]["boot"]
        if boot not in self.boots:
            self.boots.append(boot)

    def _world(self, sample: zenoh.Sample) -> None:
        world = json.loads(sample.payload.to_bytes())
        self.held = [each["item"] for each in world["held"]]
        self.items = {each["item"]: each["tag_in_map"]["position"] for each in world["items"]}

    def _status(self, sample: zenoh.Sample) -> None:
        status = json.loads(sample.payload.to_bytes())
        self.states[status["task"]] = status["state"]

    def ask(self, key: str, document: object) -> dict[str, object]:
        for reply in self.session.get(f"{PREFIX}/{key}", payload=json.dumps(document), timeout=10.0):
            answer: dict[str, object] = json.loads(reply.ok.payload.to_bytes())
            return answer
        raise AssertionError(f"nobody answered {key}")

    def fetch(self, item: int) -> str:
        answer = self.ask("task/request", {"task": "fetch", "item": item, "to": "depot"})
        assert answer["accepted"], answer
        return str(answer["task"])

    def ended(self, task: str) -> bool:
        return self.states.get(task) in {"SUCCEEDED", "FAILED"}

    def true_place(self, item: int) -> list[float]:
        bodies = self.ask("sim/truth", {})["bodies"]
        assert isinstance(bodies, list)
        return next(each["pose"]["position"] for each in bodies if each["name"] == f"item_{item}")


def until(holds: Callable[[], bool], within: float, meanwhile: Callable[[], bool] = lambda: True) -> None:
    deadline = time.monotonic() + within
    while not holds():
        assert meanwhile()
        assert time.monotonic() < deadline
        time.sleep(0.05)


def fetches(item: int, client: Client, start: list[float], folder: Path) -> None:
    """Have it fetched, and look where it truly is."""
    after = client.fetch(item)
    until(lambda: client.ended(after), WITHIN)
    assert client.states[after] == "SUCCEEDED", (folder / "log").read_text()
    there = client.true_place(item)
    assert math.dist(there, start) > 0.5, "it was brought somewhere else"
    assert math.dist(there, client.items[item]) < 0.1, "and lies where it is believed to lie"


@pytest.mark.processes
def test_the_fetch_after_a_restart_of_the_hardware_at_rest_succeeds(tmp_path: Path) -> None:
    endpoint, near = free_endpoint(), tmp_path / "near.yaml"
    document = load_scenario("Demo").starting_at(BEFORE_THE_TABLE).model_dump(mode="json")
    near.write_text(json.dumps(document))  # JSON is YAML
    with tandem_up(endpoint, tmp_path, "--scenario", str(near)) as up:
        client = Client(endpoint)
        start = client.true_place(29)
        dead = hardware_of(up.pid)
        assert dead is not None
        until(lambda: len(client.boots) == 1, 30.0, lambda: up.poll() is None)
        os.kill(dead, signal.SIGKILL)
        until(lambda: len(client.boots) == 2, 90.0, lambda: up.poll() is None)
        fetches(29, client, start, tmp_path)
        client.session.close()


@pytest.mark.thorough
@pytest.mark.processes
def test_the_fetch_after_a_restart_in_the_middle_of_one_succeeds(tmp_path: Path) -> None:
    endpoint = free_endpoint()
    with tandem_up(endpoint, tmp_path) as up:
        client = Client(endpoint)
        start = client.true_place(42)
        interrupted = client.fetch(29)
        until(lambda: client.held == [29], WITHIN, lambda: not client.ended(interrupted))
        dead = hardware_of(up.pid)
        assert dead is not None
        os.kill(dead, signal.SIGKILL)
        until(lambda: len(client.boots) == 2, 90.0, lambda: up.poll() is None)
        # It goes on from what is true now, or fails: but it ends.
        until(lambda: client.ended(interrupted), WITHIN)
        fetches(42, client, start, tmp_path)
        client.session.close()
    assert "the hardware process ended (signal 9); restarted" in (tmp_path / "log").read_text()
