"""Router, mocked robot and executive as processes that may be killed at any moment, and start again."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Final, Literal, Self, TypeVar

from pydantic import JsonValue

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system.processes import Supervisor
from tandem.executive.trials.campaigns.crash_world import RESET, AskReset
from tandem.executive.trials.campaigns.mock_roles import CRASH_AT, CRASH_LOG, CRASHING, MOCKED
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import REQUEST, TASK_HISTORY, AskHistory, TaskAnswer, TaskStatus
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus

A = TypeVar("A", bound=Message)
B = TypeVar("B", bound=Message)
PREFIX: Final = "crash/mock"
ASK_AGAIN: Final = 0.3
"""Host seconds after which an unanswered question is asked again."""
START_WITHIN: Final = 30.0
"""Host seconds."""
Victim = Literal["executive", "mock", "all"]
PROCESSES: Final = ("router", "mock", "executive")


class StuckError(RuntimeError):
    """Nobody answered, or nothing went on, for too long."""


class CrashRig:
    """Use as a context.

    Args:
        folder: of ledger, truth, deeds and logs.
        endpoint: where the router listens.
    """

    def __init__(self, folder: Path, endpoint: str) -> None:
        self.folder, self._endpoint = folder, endpoint
        self.crash_at = ""
        """The point at which the executive that was told one last kills itself."""
        self._supervisor = Supervisor(folder / "logs")
        self._bus: ZenohBus | None = None
        self._plain = WorkerSettings(
            role="router", endpoint=endpoint, prefix=PREFIX, site="lab", data=str(folder)
        )

    def __enter__(self) -> Self:
        """Start all."""
        self.folder.mkdir(parents=True, exist_ok=True)
        self._supervisor.__enter__()
        self.start("router", "mock", "executive")
        self._supervisor.keep_spare("executive")  # as `tandem up` does
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End all."""
        self._leave()
        self._supervisor.end()

    @property
    def bus(self) -> ZenohBus:
        """The client's end."""
        if self._bus is None:
            self._bus = self._join()
        return self._bus

    def now(self) -> float:
        """Return host seconds."""
        return ProcessClocks(self.bus).monotonic()

    def start(self, *roles: str, crash_at: str | None = None, crash_log: Path | None = None) -> None:
        """Start processes; the executive perhaps such that it is killed at a point."""
        for role in roles:
            update: dict[str, object] = {"role": role, "played_by": MOCKED if role == "mock" else ""}
            if role == "executive":
                self.crash_at = self.crash_at if crash_at is None else crash_at
                if crash_at is not None or crash_log is not None:
                    told = {CRASH_AT: crash_at, CRASH_LOG: None if crash_log is None else str(crash_log)}
                    arguments = {name: value for name, value in told.items() if value is not None}
                    update |= {"played_by": CRASHING, "arguments": arguments}
            self._supervisor.start(self._plain.model_copy(update=update))
            if role == "router":
                self._leave()
                assert self.bus

    def kill(self, victim: Victim) -> None:
        """Kill by SIGKILL: one process, or all."""
        roles = PROCESSES if victim == "all" else (victim,)
        for role in roles:
            self._supervisor.child(role).process.kill()
        for role in roles:
            self.bury(role)

    def bury(self, role: str) -> None:
        """Wait for a killed process's end, and forget it."""
        child = self._supervisor.child(role)
        child.process.wait(START_WITHIN)
        child.stream.close()
        self._supervisor.children.remove(child)

    def tidy(self) -> None:
        """Have a spare made when it is time for it."""
        self._supervisor.tidy()

    def exit_code(self, role: str) -> int | None:
        """Return the code with which a process has ended, negative for a signal; None while it lives."""
        return self._supervisor.child(role).process.poll()

    def last_words(self, role: str) -> str:
        """Return the end of a process's log."""
        return self._supervisor.child(role).last_words()

    def request(self, document: dict[str, JsonValue], *, meanwhile: Callable[[], None]) -> TaskAnswer:
        """Send a request until it is answered, as a client does: the same document with the same id."""
        payload = json.dumps(document).encode()
        answer = self._ask(REQUEST, payload, meanwhile)
        return TaskAnswer.model_validate_json(answer)

    def tasks(self, asked: AskHistory, *, meanwhile: Callable[[], None]) -> tuple[TaskStatus, ...]:
        """Return tasks of the ledger."""
        answer = self._ask(TASK_HISTORY.key, asked.model_dump_json().encode(), meanwhile)
        return TASK_HISTORY.decode_answer(answer).tasks

    def ask(self, service: Service[A, B], message: A, *, meanwhile: Callable[[], None]) -> B:
        """Ask a service until it is answered."""
        return service.decode_answer(self._ask(service.key, message.model_dump_json().encode(), meanwhile))

    def pass_seconds(self, seconds: float, meanwhile: Callable[[], None]) -> None:
        """Let host seconds pass."""
        end = self.now() + seconds
        while self.now() < end:
            self.bus.waker.wait(0.02)
            meanwhile()

    def reset(self) -> None:
        """Have everything where it was at first."""
        self._ask(RESET.key, AskReset(by="campaign").model_dump_json().encode(), lambda: None)

    def _ask(self, key: str, payload: bytes, meanwhile: Callable[[], None]) -> bytes:
        end = self.now() + START_WITHIN
        self.tidy()
        while self.now() < end:
            asked_at, pending = self.now(), self.bus.query(key, payload, timeout=1.0)
            bus = self.bus
            while not pending.done() and pending.poll() is None and bus is self.bus:
                bus.waker.wait(0.01)
                meanwhile()
            answer = pending.poll()
            if answer is not None:
                return answer
            while self.now() - asked_at < ASK_AGAIN:
                self.bus.waker.wait(0.02)
                meanwhile()
            # A session that was there when the other end was killed may get no answers any more (zenoh 1.10,
            # issues 2454 and 2767), whoever is there now. A new one does.
            self._leave()
        raise StuckError(f"nobody answered on {key} within {START_WITHIN:.0f} s")

    def _join(self) -> ZenohBus:
        for _ in range(round(START_WITHIN / 0.5)):
            try:
                return ZenohBus(self._endpoint, PREFIX, patience=0.5)
            except BusError:
                continue
        raise StuckError(f"no router at {self._endpoint}")

    def _leave(self) -> None:
        if self._bus is not None:
            self._bus.close()
            self._bus = None
