"""How each key is delivered, and that zenoh is told so: nothing that we publish may wait for a reader."""

from __future__ import annotations

import pytest
import zenoh

from tandem.executive.interface.entries import entries
from tandem.skills.ports.delivery import DELIVERY, Delivery, delivery_of
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.match import matches
from tandem.skills.wire.zenoh_bus import MEANS


@pytest.mark.parametrize(
    ("key", "how"),
    [
        ("hw/camera/head/rgbd", Delivery.BULK),
        ("hw/clock", Delivery.CONTROL),
        ("hw/group/arm_left/setpoint", Delivery.CONTROL),
        ("hw/group/arm_left/status", Delivery.STATE),
        ("skill/base/drive/status", Delivery.STATE),
        ("world/robot", Delivery.CONTROL),
        ("world/state", Delivery.STATE),
        ("a/key/of/a/plug-in", Delivery.STATE),
    ],
)
def test_the_table(key: str, how: Delivery) -> None:
    assert delivery_of(key) is how


def test_every_topic_stands_in_the_table() -> None:
    topics = [entry.key for group in entries().values() for entry in group if isinstance(entry, Topic)]
    assert topics
    assert [key for key in topics if not any(matches(row, key) for row, _ in DELIVERY)] == []


def test_no_way_of_delivery_blocks() -> None:
    assert set(MEANS) == set(Delivery)
    assert all(means.congestion is not zenoh.CongestionControl.BLOCK for means in MEANS.values())


def test_keys_of_tasks_that_have_ended_are_forgotten() -> None:
    for number in range(1000):
        delivery_of(f"task/fetch-{number}/status")
    assert delivery_of.cache_info().currsize < 1000
