"""What is declared to zenoh, which keeps some memory of each key for ever."""

from __future__ import annotations

from unittest.mock import MagicMock

import pytest

from tandem.skills.wire import zenoh_bus
from tandem.skills.wire.zenoh_bus import ZenohBus


@pytest.fixture
def session(monkeypatch: pytest.MonkeyPatch) -> MagicMock:
    made = MagicMock()
    monkeypatch.setattr(zenoh_bus, "open_session", lambda *_: made)
    return made


def test_a_key_of_one_task_is_put_and_never_declared(session: MagicMock) -> None:
    bus = ZenohBus("tcp/127.0.0.1:1", "lab/tiago")
    for number in range(3):
        bus.publish(f"task/fetch-{number}/status", b"{}")
    bus.publish("task/status", b"{}")
    assert [call.args[0] for call in session.put.call_args_list] == [
        f"lab/tiago/task/fetch-{number}/status" for number in range(3)
    ]
    assert [call.args[0] for call in session.declare_publisher.call_args_list] == ["lab/tiago/task/status"]
