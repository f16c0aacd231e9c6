"""Two executives for one robot: ``python -m tests.acceptance.two_executives --pairs 50 [--busy] [--zombie]``.

Each pair starts at the same moment, with ledgers of their own, on a mocked robot. Right: one serves, and the
other has ended with exit code 4 and a sentence that names the first. Then a third one comes, too late, and
ends alike. With ``--zombie`` one is stopped (SIGSTOP) in the middle of a task until another has taken over,
and goes on (SIGCONT): right is that the robot begins no goal for it from then on, and that it ends with exit
code 4.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tandem.executive.config.process_settings import REFUSED, WorkerSettings
from tandem.executive.system.processes import Supervisor
from tandem.executive.trials.campaigns.crash_world import DEEDS, ITEM, Deed
from tandem.executive.trials.campaigns.mock_roles import MOCKED
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.keys import Nothing
from tandem.skills.ports.lease import present_claims
from tandem.skills.ports.tasks import REQUEST, TASK_INFO, TaskAnswer
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus, wait_until
from tests.fakes.ports import free_endpoint

PREFIX: Final = "pairs/mock"
ROLE: Final = "executive"
WITHIN: Final = 60.0
"""Host seconds for a start, on a machine whose cores are all busy."""
GONE_WITHIN: Final = 30.0
"""Host seconds in which zenoh drops a process that is stopped; ten by its own account."""
NAMED: Final = re.compile(rf"{ROLE}: process \d+ on \S+ plays this role already")


@dataclass(frozen=True)
class Rig:
    """Router and mocked robot, and a client of theirs."""

    folder: Path
    endpoint: str
    bus: ZenohBus

    def settings(self, role: str, name: str) -> WorkerSettings:
        """Return what a process is told; ``name`` is its folder's."""
        return WorkerSettings.model_validate(
            {
                "role": role,
                "endpoint": self.endpoint,
                "prefix": PREFIX,
                "site": "lab",
                "data": str(self.folder / name),
            }
        )

    def parents(self, *names: str) -> list[Supervisor]:
        """Return the parents of executives that are to start, with their modules loaded."""
        parents = [Supervisor(self.folder / name) for name in names]
        for parent in parents:
            parent.__enter__()
            parent.keep_spare(ROLE)
        for parent in parents:
            until("a spare", lambda parent=parent: _has_spare(parent))  # type: ignore[misc]
        return parents

    def serves(self) -> bool:
        """Say whether an executive answers."""
        return self._ask(TASK_INFO.query(self.bus, Nothing(), timeout=1.0)) is not None

    def request(self, client_id: str) -> TaskAnswer:
        """Ask for a fetch, until somebody answers."""
        document = json.dumps({"task": "fetch", "item": ITEM, "id": client_id}).encode()
        answers: list[bytes] = []

        def answered() -> bool:
            answer = self._ask(self.bus.query(REQUEST, document, timeout=1.0))
            answers.extend([] if answer is None else [answer])
            return bool(answers)

        until("an answer to a request", answered)
        return TaskAnswer.model_validate_json(answers[0])

    def claims(self) -> frozenset[str]:
        """Return who is announced as executive."""
        return present_claims(self.bus.alive(), ROLE)

    def deeds(self) -> list[Deed]:
        """Return what the robot has done."""
        lines = (self.folder / "mock" / DEEDS).read_text("utf-8").splitlines()
        return [Deed.model_validate_json(line) for line in lines]

    def _ask(self, pending: Pending) -> bytes | None:
        return wait_until(self.bus, pending, 1.0)


def until(what: str, holds: Callable[[], bool], within: float = WITHIN) -> None:
    """Wait until it holds."""
    deadline, pause = time.monotonic() + within, threading.Event()
    while not holds():
        if time.monotonic() > deadline:
            raise TimeoutError(f"{what}: not within {within:.0f} s")
        pause.wait(0.01)


def _has_spare(supervisor: Supervisor) -> bool:
    """Say whether the spare has loaded everything: it waits for its settings, and computes no more."""
    supervisor.tidy()
    spare = supervisor.spare(ROLE)
    if spare is None:
        return False
    path, pause = Path(f"/proc/{spare}/stat"), threading.Event()
    before = path.read_text().split()[13:15]
    pause.wait(0.1)
    after = path.read_text().split()
    return after[2] == "S" and after[13:15] == before and int(after[13]) > 0


@contextmanager
def rig() -> Iterator[Rig]:
    """Start router and robot; end them."""
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="tandem-pairs-")))
        endpoint = free_endpoint()
        supervisor = stack.enter_context(Supervisor(folder / "logs"))
        (folder / "mock").mkdir()
        plain = {"endpoint": endpoint, "prefix": PREFIX, "site": "lab", "data": str(folder / "mock")}
        supervisor.start(WorkerSettings.model_validate({"role": "router", **plain}))
        bus = _join(endpoint)
        stack.callback(bus.close)
        supervisor.start(WorkerSettings.model_validate({"role": "mock", "played_by": MOCKED, **plain}))
        until("the mocked robot", lambda: "process/mock" in bus.alive())
        yield Rig(folder, endpoint, bus)


def _join(endpoint: str) -> ZenohBus:
    deadline = time.monotonic() + WITHIN
    while True:
        try:
            return ZenohBus(endpoint, PREFIX, patience=0.5)
        except BusError:
            if time.monotonic() > deadline:
                raise


def pair(robot: Rig, number: int) -> str:
    """Start two at the same moment, and one late; return what was wrong."""
    parents = robot.parents(f"{number}a", f"{number}b")
    try:
        for letter, parent in zip("ab", parents, strict=True):
            parent.start(robot.settings(ROLE, f"{number}{letter}"))
        until("one of the two ends", lambda: any(parent.deaths() for parent in parents))
        until("the other serves", robot.serves)
        wrong = _wrong_end(parents)
        if not wrong:
            until("one is announced", lambda: len(robot.claims()) == 1)
            wrong = _late(robot, number)
    except TimeoutError as error:
        return f"{error}: {[_last_words(parent) for parent in parents]}"
    finally:
        for parent in parents:
            parent.end()
        until("all names are gone", lambda: not robot.claims())
    return wrong


def _wrong_end(parents: list[Supervisor]) -> str:
    ended = [death for parent in parents for death in parent.deaths()]
    if len(ended) != 1:
        return f"{len(ended)} of two have ended: {[death.describe() for death in ended]}"
    if ended[0].code != REFUSED or not NAMED.search(ended[0].last_words):
        return f"the loser: {ended[0].describe()}"
    return ""


def _late(robot: Rig, number: int) -> str:
    """Start a third one; return what was wrong."""
    late = Supervisor(robot.folder / f"{number}late")
    with late:
        child = late.start(robot.settings(ROLE, f"{number}late"))
        try:
            code = child.process.wait(WITHIN)
        except subprocess.TimeoutExpired:
            return "a third one, that came late, has not ended"
        words = child.last_words()
        return "" if code == REFUSED and NAMED.search(words) else f"the late one: exit code {code}, {words}"


def _last_words(parent: Supervisor) -> str:
    return parent.children[-1].last_words() if parent.children else ""


def zombie(robot: Rig) -> str:
    """Stop one in the middle of a task until another has taken over; return what was wrong."""
    first, second = robot.parents("zombie", "heir")
    try:
        child = first.start(robot.settings(ROLE, "zombie"))
        until("the first serves", robot.serves)
        answer = robot.request("before")
        until("its task goes on", lambda: any(deed.what == "began" for deed in robot.deeds()))
        os.kill(child.process.pid, signal.SIGSTOP)
        try:
            until("zenoh drops it", lambda: not robot.claims(), GONE_WITHIN)
            second.start(robot.settings(ROLE, "heir"))
            until("the second serves", robot.serves)
            done = len(robot.deeds())
        finally:
            os.kill(child.process.pid, signal.SIGCONT)
        code = child.process.wait(WITHIN)
        after = [deed for deed in robot.deeds()[done:] if deed.what == "began"]
        if any(deed.goal_id.startswith(answer.task) for deed in after):
            return f"goals of the one that was stopped have begun: {after}"
        if code != REFUSED:
            return f"the one that was stopped ended with {code}: {child.last_words()}"
        taken = robot.request("after")
        until("the second's task goes on", lambda: _begun(robot, taken.task))
    except (TimeoutError, subprocess.TimeoutExpired) as error:
        return f"{error}: {_last_words(first)} / {_last_words(second)}"
    finally:
        first.end()
        second.end()
    return ""


def _begun(robot: Rig, task: str) -> bool:
    return any(deed.what == "began" and deed.goal_id.startswith(task) for deed in robot.deeds())


def _burn() -> None:
    while True:
        pass


@contextmanager
def busy(*, wanted: bool) -> Iterator[None]:
    """Keep all cores busy."""
    burners = [multiprocessing.Process(target=_burn, daemon=True) for _ in range(os.cpu_count() or 1)]
    for burner in burners if wanted else ():
        burner.start()
    try:
        yield
    finally:
        for burner in burners if wanted else ():
            burner.kill()
            burner.join()


def main(argv: list[str]) -> int:
    """Run what was asked for; return 0 when all was right."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pairs", type=int, default=50)
    parser.add_argument("--busy", action="store_true", help="with a process that computes on each core")
    parser.add_argument(
        "--zombie", action="store_true", help="and one that is stopped until another took over"
    )
    asked = parser.parse_args(argv)
    faults: list[str] = []
    with rig() as robot, busy(wanted=asked.busy):
        for number in range(asked.pairs):
            wrong = pair(robot, number)
            faults += [f"pair {number}: {wrong}"] if wrong else []
            sys.stdout.write(f"{number + 1}: {wrong or 'one serves'}\n")
            sys.stdout.flush()
        if asked.zombie:
            wrong = zombie(robot)
            faults += [f"zombie: {wrong}"] if wrong else []
            sys.stdout.write(f"zombie: {wrong or 'none of its goals was accepted'}\n")
    how = "busy" if asked.busy else "idle"
    sys.stdout.write(f"{asked.pairs} pairs ({how}), {len(faults)} wrong\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
