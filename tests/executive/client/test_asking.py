"""A question whose answer is lost is put again before its patience ends."""

from __future__ import annotations

import pytest

from tandem.executive.client.asking import Asking
from tandem.skills.ports.tasks import TASK_HISTORY, TASK_STEP
from tandem.skills.wire.memory import MemoryBus, MemoryHub, MemoryPending


class Lossy(MemoryBus):
    """Nobody hears the first ``lost`` questions, and nobody says so."""

    def __init__(self, lost: int, now: list[float]) -> None:
        super().__init__(MemoryHub())
        self.asked, self._lost, self._now = list[float](), lost, now

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> MemoryPending:  # noqa: ARG002
        self.asked.append(self._now[0])
        return Open() if len(self.asked) <= self._lost else MemoryPending(replies={key: b"answer"})


class Open(MemoryPending):
    def done(self) -> bool:
        return False


def ask(key: str, *, lost: int) -> tuple[bytes | None, list[float]]:
    """Ask with a patience of 20 s; return the answer, and when the question was put."""
    now = [0.0]
    bus = Lossy(lost, now)
    asking = Asking(bus, key, b"", lambda: now[0], 20.0)
    while (left := asking.left()) > 0.0:
        now[0] += left
    assert asking.answer is not None or now[0] == pytest.approx(20.0)
    return asking.answer, bus.asked


@pytest.mark.parametrize(
    ("lost", "answer", "asked"),
    [
        (0, b"answer", [0.0]),
        (1, b"answer", [0.0, 1.0]),
        (3, b"answer", [0.0, 1.0, 3.0, 7.0]),
        (9, None, [0.0, 1.0, 3.0, 7.0, 15.0]),
    ],
)
def test_an_open_question_is_put_again_ever_less_often(
    lost: int, answer: bytes | None, asked: list[float]
) -> None:
    assert ask(TASK_HISTORY.key, lost=lost) == (answer, asked)


def test_a_step_whose_answer_is_lost_is_not_made_twice() -> None:
    assert ask(TASK_STEP.key, lost=1) == (None, [0.0])
