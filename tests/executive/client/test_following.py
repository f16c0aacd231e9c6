"""What a client subscribes to while it follows a task."""

from __future__ import annotations

import time
from types import SimpleNamespace
from typing import Any, cast

import pytest

from tandem.executive.client.following import Following, FollowingTree
from tandem.skills.ports.delivery import passing
from tandem.skills.wire.memory import MemoryBus, MemoryHub


@pytest.mark.parametrize("follow", [Following, FollowingTree])
def test_no_key_is_subscribed_to_for_one_task_alone(follow: type[Any]) -> None:
    """A router keeps some memory of each key that anybody ever subscribed to."""
    hub = MemoryHub()
    talks = SimpleNamespace(bus=MemoryBus(hub), monotonic=time.monotonic)
    follow(cast("Any", SimpleNamespace(talks=talks)), "fetch-0001", None)
    assert [inbox.expression for inbox in hub.inboxes if passing(inbox.expression)] == []
