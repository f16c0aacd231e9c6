"""What every ledger does: the one in memory and the one on disk, which is opened anew before it is asked."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tandem.executive.ledger.memory import PAST, MemoryLedger
from tandem.executive.ledger.port import Entry, Ledger, Reading, SentGoal, Transition
from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.ledger.stubs import same_request
from tandem.skills.ports.tasks import AskHistory, TaskState, TaskStatus

S = TaskState


@pytest.fixture(params=["memory", "disk"])
def ledger(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Ledger]:
    made = MemoryLedger() if request.param == "memory" else SqliteLedger(tmp_path)
    yield made
    made.close()


def again(ledger: Ledger) -> Ledger:
    """Commit, and read with other eyes."""
    ledger.commit()
    if isinstance(ledger, SqliteLedger):
        ledger.close()
        ledger.__init__(ledger.path.parent)  # type: ignore[misc]  # the fixture closes this one
    return ledger


def entry(number: int, state: TaskState = S.QUEUED, client_id: str = "") -> Entry:
    status = TaskStatus(
        task=f"wait-{number:04d}",
        kind="wait",
        request={"task": "wait", "weight": 0.1, "spots": ["ä", None, True]},
        state=state,
        accepted_at=100.0 + number,
        client_id=client_id,
    )
    return Entry(status, number, "ask", test_run=True)


def end(ledger: Ledger, number: int, state: TaskState = S.SUCCEEDED, at: float = 200.0) -> None:
    status = entry(number).status.model_copy(update={"state": state, "ended_at": at})
    ledger.change(status, at)


def test_what_was_entered_is_there_as_it_was(ledger: Ledger) -> None:
    ledger.enter(entry(1, client_id="mine"))
    ledger.enter(entry(2))
    ledger = again(ledger)
    assert ledger.open_entries() == (entry(1, client_id="mine"), entry(2))
    assert ledger.entry("wait-0002") == entry(2)
    assert ledger.of_client("mine", "") == entry(1, client_id="mine")
    assert ledger.last_number() == 2


def test_what_is_not_there_is_none(ledger: Ledger) -> None:
    assert ledger.entry("wait-0009") is None
    assert ledger.of_client("nobody", "") is None
    assert (ledger.last_number(), ledger.open_entries(), ledger.open_goals()) == (0, (), ())
    assert (ledger.transitions("wait-0009"), ledger.attempts("wait-0009"), ledger.past("wait")) == (
        (),
        {},
        {},
    )
    assert ledger.history(AskHistory()).tasks == ()


def test_a_change_of_state_is_a_transition_and_another_fact_is_none(ledger: Ledger) -> None:
    ledger.enter(entry(1))
    running = entry(1, S.RUNNING).status
    ledger.change(running, 5.0)
    ledger.change(running.model_copy(update={"begun": 2}), 6.0)
    end(ledger, 1, at=7.0)
    ledger = again(ledger)
    assert ledger.transitions("wait-0001") == (
        Transition(S.QUEUED, 101.0),
        Transition(S.RUNNING, 5.0),
        Transition(S.SUCCEEDED, 7.0),
    )
    assert ledger.open_entries() == ()
    kept = ledger.entry("wait-0001")
    assert kept is not None
    assert kept.status.ended_at == 7.0


def test_attempts_are_counted_by_node_and_open_goals_are_known(ledger: Ledger) -> None:
    ledger.enter(entry(1))
    for goal_id in ("wait-0001/grasp/1", "wait-0001/look/at it/1", "wait-0001/grasp/2"):
        ledger.goal(SentGoal(goal_id, "test/nudge"))
    ledger.goal_ended("wait-0001/grasp/1", "FAILED")
    ledger = again(ledger)
    assert ledger.attempts("wait-0001") == {"grasp": 2, "look/at it": 1}
    assert ledger.open_goals() == (
        SentGoal("wait-0001/look/at it/1", "test/nudge"),
        SentGoal("wait-0001/grasp/2", "test/nudge"),
    )
    end(ledger, 1)
    assert again(ledger).open_goals() == ()


def test_the_newest_of_what_was_learnt_counts(ledger: Ledger) -> None:
    for second in range(PAST + 5):
        ledger.learn("wait", {"search": float(second), "home": 1.0})
    found = again(ledger).past("wait")
    assert found["search"] == tuple(float(second) for second in range(5, PAST + 5))
    assert len(found["home"]) == PAST


def test_history_is_newest_first_and_paged(ledger: Ledger) -> None:
    for number in range(1, 6):
        ledger.enter(entry(number))
    end(ledger, 2, S.FAILED)
    ledger = again(ledger)

    def names(**asked: object) -> list[str]:
        return [status.task[-1] for status in ledger.history(AskHistory.model_validate(asked)).tasks]

    assert names() == ["5", "4", "3", "2", "1"]
    assert names(states=["FAILED"]) == ["2"]
    assert names(since=104.0) == ["5", "4"]
    assert names(task="wait-0003") == ["3"]
    first = ledger.history(AskHistory(limit=2))
    assert ([each.task[-1] for each in first.tasks], first.more) == (["5", "4"], 4)
    assert names(limit=3, before=first.more) == ["3", "2", "1"]
    assert ledger.history(AskHistory(limit=3, before=first.more)).more == 0


@pytest.mark.parametrize(
    ("older_than", "keep", "left"),
    [(0.0, 10, "12345"), (203.0, 10, "345"), (0.0, 2, "345"), (1e9, 0, "5"), (1e9, 10, "5")],
)
def test_old_ones_are_forgotten_by_age_and_number(
    ledger: Ledger, older_than: float, keep: int, left: str
) -> None:
    """1 to 4 have ended at 201 to 204 s; 5 waits."""
    for number in range(1, 6):
        ledger.enter(entry(number, client_id=f"c{number}"))
    for number in range(1, 5):
        end(ledger, number, at=200.0 + number)
    assert ledger.prune(older_than=older_than, keep=keep) == 5 - len(left)
    ledger = again(ledger)
    assert "".join(each.task[-1] for each in reversed(ledger.history(AskHistory()).tasks)) == left
    gone = set("12345") - set(left)
    assert [ledger.transitions(f"wait-000{number}") for number in gone] == [()] * len(gone)


def test_a_clients_id_is_its_own(ledger: Ledger) -> None:
    hers, his = (
        replace(each, status=each.status.model_copy(update={"request": {"by": name}}))
        for each, name in ((entry(1, client_id="1"), "ann"), (entry(2, client_id="1"), "bob"))
    )
    for each in (hers, his):
        ledger.enter(each)
    ledger.commit()
    assert ledger.of_client("1", "ann") == hers
    assert ledger.of_client("1", "bob") == his
    assert ledger.of_client("1", "") is None


def test_a_clients_id_is_known_after_its_task_is_forgotten(ledger: Ledger) -> None:
    """So that the same request does not run a second time, whatever has been forgotten."""
    for number in range(1, 4):
        asked = entry(number, client_id=f"c{number}" if number > 1 else "")
        ledger.enter(asked)
        ledger.change(asked.status.model_copy(update={"state": S.SUCCEEDED, "ended_at": 200.0}), 200.0)
    ledger.enter(entry(4))
    assert ledger.prune(older_than=1e9, keep=0) == 3
    ledger = again(ledger)
    assert [each.task for each in ledger.history(AskHistory()).tasks] == ["wait-0004"]
    known = ledger.of_client("c2", "")
    assert known is not None
    assert (known.status.task, known.status.state) == ("wait-0002", S.SUCCEEDED)
    assert same_request(known.status.request, entry(2, client_id="c2").status.request)
    assert not same_request(known.status.request, {"task": "other"})
    assert ledger.prune(older_than=1e9, keep=0) == 0


def test_the_clocks_are_noted(ledger: Ledger) -> None:
    assert ledger.reading() is None
    ledger.note(Reading(utc=5.0, host="a", monotonic=1.0, doubt=2.0))
    ledger.note(Reading(utc=6.0, host="a", monotonic=2.0, doubt=1.0))
    assert again(ledger).reading() == Reading(utc=6.0, host="a", monotonic=2.0, doubt=1.0)


def test_a_number_never_comes_again(ledger: Ledger) -> None:
    ledger.enter(entry(1))
    end(ledger, 1)
    ledger.prune(older_than=1e9, keep=0)
    assert again(ledger).last_number() == 1
