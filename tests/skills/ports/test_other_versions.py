"""Messages of another release: a reader takes what it knows; what is asked of a robot is read strictly."""

from __future__ import annotations

import json

import pytest
from pydantic import ValidationError

from tandem.skills.ports.failure import KINDS, Failure, FailureKind
from tandem.skills.ports.keys import LEASE, STOP_STATE
from tandem.skills.ports.tasks import (
    TASK_CANCEL,
    TASK_HISTORY,
    TASK_STATUS,
    CancelTask,
    History,
    TaskState,
    TaskStatus,
)
from tandem.skills.ports.world import WORLD

STATUS = TaskStatus(
    task="fetch-1",
    kind="fetch",
    request={},
    state=TaskState.FAILED,
    accepted_at=0.0,
    failure=Failure(kind=FailureKind.NO_IK, message="no way"),
)


FREE = ("request", "evidence")
"""Fields that hold any names."""


def newer(document: str) -> bytes:
    """Return a document with a field that this release does not know, in each object of it."""

    def grown(value: object) -> object:
        if isinstance(value, dict):
            known = {name: each if name in FREE else grown(each) for name, each in value.items()}
            return {**known, "of_tomorrow": [1]}
        return [grown(each) for each in value] if isinstance(value, list) else value

    return json.dumps(grown(json.loads(document))).encode()


def test_a_status_of_a_newer_executive_is_read() -> None:
    assert TASK_STATUS.decode(newer(STATUS.model_dump_json())) == STATUS


def test_an_answer_of_a_newer_executive_is_read() -> None:
    document = json.dumps({"tasks": [json.loads(newer(STATUS.model_dump_json()))], "of_tomorrow": 1}).encode()
    assert TASK_HISTORY.decode_answer(document) == History(tasks=(STATUS,))


def test_what_is_told_of_the_world_is_read() -> None:
    document = b'{"stamp": {"boot": "a", "seconds": 1.0}, "version": 3, "of_tomorrow": 1}'
    assert WORLD.decode(document).version == 3


def test_a_failure_of_an_unknown_kind_keeps_its_words() -> None:
    document = STATUS.model_dump_json().replace("NO_IK", "WHEELS_MELTED")
    failure = TASK_STATUS.decode(document.encode()).failure
    assert failure == Failure(kind=FailureKind.OTHER, message="no way")


@pytest.mark.parametrize("kind", list(FailureKind))
def test_every_kind_is_itself(kind: FailureKind) -> None:
    assert FailureKind(kind.value) is kind
    assert kind in KINDS


def test_what_is_asked_is_read_strictly() -> None:
    with pytest.raises(ValidationError, match="of_tomorrow"):
        TASK_CANCEL.asked.model_validate_json(newer(CancelTask(task="a").model_dump_json()))


def test_the_hardwares_answers_are_read_strictly() -> None:
    with pytest.raises(ValidationError, match="of_tomorrow"):
        LEASE.decode_answer(b'{"granted": null, "of_tomorrow": 1}')


def test_the_hardware_is_heard_strictly() -> None:
    with pytest.raises(ValidationError, match="of_tomorrow"):
        STOP_STATE.decode(b'{"stopped": true, "of_tomorrow": 1}')
