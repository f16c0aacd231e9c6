"""A router, a robot of mocked skills and an executive as processes that a test may kill and start again.

They are started as ``python -m tandem.executive.system.worker SETTINGS`` and spoken to over the bus.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Final, Self, TypeVar

import zenoh

from tandem.client import Client, ClientError
from tests.fakes.ports import free_endpoint

T = TypeVar("T")
WITHIN: Final = 60.0
"""Host seconds for all that is waited for: a start of a process takes ten of them on a busy machine."""
MOCKED: Final = "tandem.executive.trials.campaigns.mock_roles:MOCK"
_CLOCK: Final = """
import os, time
_time, _shift = time.time, os.environ["WALL_CLOCK_SHIFT"]
def shifted():
    with open(_shift) as file:
        return _time() + float(file.read() or 0.0)
time.time = shifted
"""


def until(what: str, holds: Callable[[], T]) -> T:
    """Return what ``holds`` returns once that is true."""
    deadline = time.monotonic() + WITHIN
    while time.monotonic() < deadline:
        try:
            found = holds()
        except ClientError:
            found = None
        if found:
            return found
        time.sleep(0.02)
    raise AssertionError(f"{what}: not within {WITHIN:.0f} s")


@dataclass(eq=False)
class Mocked:
    """Use as a context.

    Args:
        folder: of ledger, truth and logs.
        site: of this test alone.
        shift: seconds by which the wall clock of all processes is wrong.
    """

    folder: Path
    site: str
    endpoint: str = field(default_factory=free_endpoint)
    shift: float = 0.0
    _processes: dict[str, subprocess.Popen[bytes]] = field(default_factory=dict)
    _started: int = 0
    _client: Client | None = None
    _session: zenoh.Session | None = None

    def __enter__(self) -> Self:
        """Start all."""
        (self.folder / "clock").mkdir()
        (self.folder / "clock" / "sitecustomize.py").write_text(_CLOCK)
        self.shift_clock(self.shift)
        for role in ("router", "mock", "executive"):
            self.start(role)
        until("all is there", self._is_there)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End all."""
        self._leave()
        for process in self._processes.values():
            process.send_signal(signal.SIGCONT)
            process.kill()
            process.wait()

    def start(self, role: str, *, name: str = "", **settings: object) -> None:
        """Start a process, and know it by a ``name`` (its role's unless given)."""
        name = name or role
        told: Mapping[str, object] = {
            "role": role,
            "played_by": MOCKED if role == "mock" else "",
            "endpoint": self.endpoint,
            "prefix": f"{self.site}/mock",
            "site": "lab",
            "data": str(self.folder),
            "lineage": self.site.lower(),  # each process takes the place of the one before
            "generation": self._started,
            **settings,
        }
        self._started += 1
        paths = [str(self.folder / "clock"), os.environ.get("PYTHONPATH", "")]
        shift = str(self.folder / "shift")
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths), "WALL_CLOCK_SHIFT": shift}
        with (self.folder / f"{name}.log").open("ab") as log:
            self._processes[name] = subprocess.Popen(
                [sys.executable, "-m", "tandem.executive.system.worker", json.dumps(told)],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
                env=environment,
            )

    def signal(self, name: str, number: int) -> None:
        """Send a process a signal."""
        self._processes[name].send_signal(number)

    def code(self, name: str) -> int | None:
        """Return a process's exit code, or None while it goes on."""
        return self._processes[name].poll()

    def alive(self, names: str) -> list[str]:
        """Return the announced names that match a key expression, as a new session hears of them."""
        with zenoh.open(self._config()) as session:
            replies = session.liveliness().get(f"{self.site}/mock/alive/{names}", timeout=5.0)
            return [str(reply.ok.key_expr) for reply in replies if reply.ok is not None]

    def crash(self, **settings: object) -> None:
        """Kill the executive as by kill -9, and start it again."""
        self.signal("executive", signal.SIGKILL)
        self._processes["executive"].wait()
        self.start("executive", **settings)
        until("the executive is back", self._is_there)

    def _is_there(self) -> bool:
        """Ask with a new session: one that was there at a kill may get no answers (zenoh issue 2767)."""
        self._leave()
        return bool(self.client.info().name)

    def shift_clock(self, seconds: float) -> None:
        """Have the wall clock of all processes jump: it is wrong by so much from now on."""
        beside = self.folder / "shift.new"
        beside.write_text(str(seconds))
        beside.replace(self.folder / "shift")

    @property
    def log(self) -> str:
        """What the executive has logged."""
        return (self.folder / "executive.log").read_text("utf-8", "replace")

    @property
    def client(self) -> Client:
        """A client; a new one after a crash."""
        if self._client is None:
            self._client = Client(self.endpoint, site=self.site, robot="mock")
        return self._client

    def state(self, task: str) -> str:
        """Return the state of a task."""
        return str(self.client.status(task).state)

    def until_state(self, task: str, *states: str) -> str:
        """Wait until a task is so, or has ended; return what it is."""
        ends = {"SUCCEEDED", "FAILED", "CANCELED", "EXPIRED", "REJECTED", "INTERRUPTED"}
        try:
            return (
                until(f"{task} is {states}", lambda: (s := self.state(task)) in {*states, *ends} and s) or ""
            )
        except AssertionError as late:
            raise AssertionError(f"{late}; it is {self.client.status(task)}") from late

    def put(self, key: str, document: Mapping[str, object]) -> None:
        """Put a document on a key of the robot."""
        if self._session is None:
            self._session = zenoh.open(self._config())
        self._session.put(f"{self.site}/mock/{key}", json.dumps(document))

    def _config(self) -> zenoh.Config:
        config = zenoh.Config()
        config.insert_json5("mode", '"client"')
        config.insert_json5("connect/endpoints", json.dumps([self.endpoint]))
        config.insert_json5("scouting/multicast/enabled", "false")
        return config

    def hands(self) -> set[int | None]:
        """Return what the hands hold in truth."""
        truth = json.loads((self.folder / "truth.json").read_text())
        return {truth["left"], truth["right"]} - {None}

    def _leave(self) -> None:
        if self._client is not None:
            self._client.close()
            self._client = None
        if self._session is not None:
            self._session.close()
            self._session = None
