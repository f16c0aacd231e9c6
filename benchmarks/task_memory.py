"""What many tasks leave in memory: ``python -m benchmarks.task_memory TASKS``.

An executive with its ledger on disk and a robot of mocked skills, in one process over the bus in memory, on a
clock that runs as fast as it can. The tasks are those of ``tandem campaign soak``. A picture of the tree is
made at every fortieth question only, which is quicker. Printed are the process's anonymous memory, and how
many blocks of it Python's objects have.
"""

from __future__ import annotations

import gc
import json
import logging
import os
import sys
import tempfile
from pathlib import Path
from typing import Final

from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.executive import Executive
from tandem.executive.service.running.tree_run import Run
from tandem.executive.system.process_usage import anonymous_memory
from tandem.executive.trials.campaigns.crash_world import RESET, AskReset, LastingRobot
from tandem.executive.trials.campaigns.soak import CANCEL_EVERY, request
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, CancelTask, TaskAnswer
from tandem.skills.site import load
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryHub
from tandem.trees.registry import shipped

STEP: Final = 0.05
"""Robot seconds between two steps: a tick of the tree each."""
LOOK_EVERY: Final = 40
PRINT_EVERY: Final = 100


class Rig:
    """The two, and a client.

    Args:
        folder: of ledger and truth.
    """

    def __init__(self, folder: Path) -> None:
        hub, self._clocks, site = MemoryHub(), SteppedClocks(), load("lab")
        self._robot = LastingRobot(hub.endpoint(), self._clocks, site, folder, "mock")
        ledger = SqliteLedger(folder)
        self._executive = Executive(
            hub.endpoint(), self._clocks, site, shipped(), start="0123abcd", ledger=ledger
        )
        self._client = hub.endpoint()

    def carry_out(self, number: int) -> None:
        """Carry out one task of the soak."""
        self._ask(RESET.key, AskReset(by="campaign").model_dump_json().encode())
        answer = TaskAnswer.model_validate_json(self._ask(REQUEST, json.dumps(request(number)).encode()))
        if number % CANCEL_EVERY == 1:
            self._ask(TASK_CANCEL.key, CancelTask(task=answer.task).model_dump_json().encode())
        status = self._executive.book.get(answer.task)
        while status is not None and not status.state.terminal:
            self._step()
            status = self._executive.book.get(answer.task)

    def close(self) -> None:
        """Leave."""
        self._executive.close()
        self._robot.close()

    def _step(self) -> None:
        self._clocks.advance(STEP)
        self._robot.step()
        self._executive.step()

    def _ask(self, key: str, payload: bytes) -> bytes:
        pending = self._client.query(key, payload, timeout=10.0)
        while pending.poll() is None:
            self._step()
        return pending.poll() or b""


def look_seldom() -> None:
    """Have the tree's picture made at every ``LOOK_EVERY``-th question only."""
    look, asked = Run.changed_tree, iter(range(sys.maxsize))

    def seldom(self: Run) -> bytes | None:
        return None if next(asked) % LOOK_EVERY else look(self)

    Run.changed_tree = seldom  # type: ignore[method-assign]  # in this process only


def main(tasks: str) -> int:
    """Carry them out."""
    logging.disable()
    look_seldom()
    with tempfile.TemporaryDirectory() as folder:
        rig = Rig(Path(folder))
        gc.collect()
        gc.freeze()  # as a process's loop does
        for number in range(1, int(tasks) + 1):
            rig.carry_out(number)
            if number % PRINT_EVERY == 0:
                memory, blocks = anonymous_memory(os.getpid()) / 1e6, sys.getallocatedblocks()
                print(f"{number:6d} tasks: {memory:.2f} MB, {blocks} blocks of Python's", flush=True)
        rig.close()
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
