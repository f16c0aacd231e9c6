"""The table of states: complete, walked at random, and what the documentation shows."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tandem.executive.ledger.memory import MemoryLedger
from tandem.executive.service.intake.request_parser import Asked
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.executive.service.tasks.task_states import FIRST, LEADS_TO, WrongTransitionError, check, table
from tandem.executive.service.tasks.wall_clock import WallClock
from tandem.skills.ports.tasks import TaskState
from tandem.skills.wire.clocks import SteppedClocks
from tests.executive.surroundings import WAIT, WaitRequest

ROOT = Path(__file__).parents[4]


def book() -> TaskBook:
    return TaskBook(MemoryLedger(), WallClock(SteppedClocks(), None))


def queued(tasks: TaskBook) -> str:
    return tasks.accept(Asked(WAIT, WaitRequest(item=29), {"task": "wait", "item": 29})).task


def test_every_state_stands_in_it_and_ends_lead_nowhere() -> None:
    assert set(LEADS_TO) == set(TaskState)
    assert {state for state, ways in LEADS_TO.items() if not ways} == {s for s in TaskState if s.terminal}


def test_every_state_can_be_reached_and_every_one_can_end() -> None:
    reached, new = {FIRST}, {FIRST}
    while new:
        new = {then for state in new for then in LEADS_TO[state]} - reached
        reached |= new
    assert reached == set(TaskState)
    ending = {state for state in TaskState if state.terminal}
    for _ in TaskState:
        ending |= {state for state, ways in LEADS_TO.items() if ending & set(ways)}
    assert ending == set(TaskState)


@settings(max_examples=200, deadline=None)
@given(st.lists(st.sampled_from(TaskState), max_size=12))
def test_the_book_walks_the_table_and_never_beside_it(walk: list[TaskState]) -> None:
    """Each wish leads on when the table has it; else it is refused, and nothing has changed."""
    tasks = book()
    task, now = queued(tasks), FIRST
    for then in walk:
        if now.terminal:
            break
        if then is now or then in LEADS_TO[now]:
            told = tasks.end(task, then, None) if then.terminal else tasks.change(task, then)
            assert told.state is then
            now = then
        else:
            with pytest.raises(WrongTransitionError, match=f"{now} does not lead to {then}"):
                tasks.change(task, then)
            assert tasks.find(task).state is now


@pytest.mark.parametrize("state", [s for s in TaskState if s.terminal])
def test_what_has_ended_never_changes(state: TaskState) -> None:
    for then in TaskState:
        if then is not state:
            with pytest.raises(WrongTransitionError, match="it is final"):
                check("wait-1", state, then)


def test_the_documentation_has_the_table() -> None:
    page = (ROOT / "docs" / "service.md").read_text("utf-8")
    assert table() in page, (
        "put what tandem.executive.service.tasks.task_states.table() returns into docs/service.md"
    )
