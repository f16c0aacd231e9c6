"""A driver with a bug: beside the true joint states it tells some that can't be right.

A user saw: joint states that name some joints only, or come without velocities, ended the process
``bimanual``, which holds the reflex between the arms; and again each time that it was started anew.
"""

from __future__ import annotations

import itertools
import json
from pathlib import Path
from typing import Any, Final

import pytest
import zenoh

from tests.fakes.ports import free_endpoint
from tests.outside._up import client, until, up

SITE: Final = "wrong"
PREFIX: Final = f"{SITE}/tiago"


def wrong(states: dict[str, Any]) -> list[bytes]:
    """Return what a true message of the joints becomes in bad hands."""
    few = {name: states[name][:3] for name in ("names", "positions", "velocities", "efforts")}
    documents = [
        states | few,
        states | {"velocities": []},
        states | {"names": [f"{name}_" for name in states["names"]]},
        states | {"positions": [1e300 for _ in states["positions"]]},
        states | {"stamp": states["stamp"] | {"seconds": 0.0}},
    ]
    return [json.dumps(document).encode() for document in documents] + [b"", b"\xff", b"[" * 5000]


@pytest.mark.processes
def test_wrong_joint_states_are_refused_counted_and_harmless(tmp_path: Path) -> None:
    endpoint = free_endpoint()
    true: list[dict[str, Any]] = []
    crossings: list[bytes] = []
    gone: list[str] = []
    refused: dict[str, int] = {}

    def left(sample: zenoh.Sample) -> None:
        if sample.kind == zenoh.SampleKind.DELETE:
            gone.append(str(sample.key_expr))

    def count(sample: zenoh.Sample) -> None:
        document = json.loads(sample.payload.to_bytes())
        if document["process"] == "bimanual":
            refused.update({f"{each['key']} {each['reason']}": each["count"] for each in document["refused"]})

    def crossing(sample: zenoh.Sample) -> None:
        crossings.append(sample.payload.to_bytes())

    def joints(sample: zenoh.Sample) -> None:
        if not true:
            true.append(json.loads(sample.payload.to_bytes()))

    with up(endpoint, SITE, tmp_path, only="router,hardware,bimanual"), client(endpoint) as session:
        listening = [
            session.declare_subscriber(f"{PREFIX}/refused", count),
            session.declare_subscriber(f"{PREFIX}/skill/reflex/crossing", crossing),
            session.liveliness().declare_subscriber(f"{PREFIX}/alive/process/bimanual", left),
        ]
        first = session.declare_subscriber(f"{PREFIX}/hw/joints/state", joints)
        until(lambda: bool(true and crossings), 60.0)
        first.undeclare()  # type: ignore[no-untyped-call]
        bad = itertools.cycle(wrong(true[0]))

        def told_and_counted() -> bool:
            session.put(f"{PREFIX}/hw/joints/state", next(bad))
            key = "hw/joints/state"
            return all(refused.get(f"{key} {reason}", 0) > 2 for reason in ("malformed", "misfit", "older"))

        until(told_and_counted, 60.0)
        before = len(crossings)
        until(lambda: len(crossings) > before + 1, 60.0)
        assert gone == [], "the process that watches over both arms must not end"
        assert len(listening) == 3
