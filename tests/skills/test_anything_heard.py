"""Whatever is told on ``hw/...`` and ``world/...``, no node's step raises.

The whole system runs in lockstep, with physics and with goals of all kinds under way. Between its true
messages a stranger on the bus tells them with something changed (left out, doubled, of another kind, huge),
and on other keys than their own.
"""

from __future__ import annotations

import copy
import json
import random
import traceback
from collections.abc import Callable, Sequence
from typing import Final

import pytest
from pydantic import JsonValue

from tandem.executive.system.lockstep import Lockstep
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.action import SendGoal, goal_service
from tandem.skills.wire.memory import Kind, MemoryBus

SECONDS: Final = 6.0
"""Robot seconds of each run: each goal below is started and ends in them, or the next is."""
FORGED: Final = 8
"""Messages of the stranger in each period of 10 ms, in which the hardware tells about 8."""
ODD: Final[tuple[JsonValue, ...]] = (
    None,
    True,
    -1,
    0,
    1 << 70,
    1e6,
    -1e6,
    1e-300,
    1e308,
    float("nan"),
    float("inf"),
    "",
    "left",
    "arm_left",
    "\x00",
    [],
    [0.0] * 3,
    [0.0, 0.0, 0.0, 1.0],
    {},
)
GOALS: Final[tuple[tuple[str, dict[str, JsonValue]], ...]] = (
    ("base/localise", {}),
    ("perception/look", {"tilts": [-0.45], "clutter": True}),
    ("arm_left/move", {"posture": "home"}),
    ("arm_right/move", {"joints": [0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3]}),
    ("torso/move", {"joints": [0.2]}),
    ("gripper_left/grip", {"grip": "CLOSE"}),
    ("bimanual/coordinate", {}),
    ("base/drive", {"goal": {"x": 0.3, "y": 0.0, "yaw": 0.0}}),
    ("base/rotate", {"angle": 0.5}),
    ("perception/track", {}),
    ("arm_left/approach", {"item": 29, "grasps": [{}]}),
)


class Stranger:
    """Remembers the last true message of each key, and tells others."""

    def __init__(self, bus: MemoryBus, seed: int) -> None:
        self._bus, self._rng = bus, random.Random(seed)  # noqa: S311 - no secret hangs on it
        self._true: dict[str, bytes] = {}
        self._busy = False
        bus.hub.watch(self._hear)

    def _hear(self, kind: Kind, key: str, payload: bytes) -> None:
        if kind == "put" and not self._busy and key.startswith(("hw/", "world/")):
            self._true[key] = payload

    def tell(self, count: int) -> None:
        self._busy = True
        for _ in range(count if self._true else 0):
            key = self._rng.choice(sorted(self._true))
            self._bus.publish(key, self._changed(key))
        self._busy = False

    def _changed(self, key: str) -> bytes:
        payload = self._true[key]
        if key.endswith("/rgbd"):
            return self._cut(payload)
        if self._rng.random() < 0.1:
            return self._true[self._rng.choice(sorted(self._true))]
        document = json.loads(payload)
        for _ in range(self._rng.choice((1, 1, 1, 2, 5))):
            self._change(document)
        return json.dumps(document).encode()

    def _cut(self, payload: bytes) -> bytes:
        at = self._rng.choice((0, 3, 4, 40, len(payload) - 1, len(payload)))
        return payload[:at] + self._rng.choice((b"", b"\xff", payload[at:]))

    def _change(self, document: JsonValue) -> None:
        """Change one place: a number, mostly, so that most of what is told can't be told from the truth."""
        places = list(_places(document))
        if not places:
            return
        container, at = self._rng.choice(places)
        old = container[at] if isinstance(container, list) else container[str(at)]
        new: JsonValue = copy.deepcopy(self._rng.choice(ODD))
        if isinstance(old, float) and self._rng.random() < 0.7:
            new = old + self._rng.choice((-1e6, -10.0, -0.1, 1e-9, 0.1, 10.0, 1e5))
        elif isinstance(old, list) and old and self._rng.random() < 0.5:
            new = self._rng.choice((old[:-1], [*old, old[0]], old[::-1]))
        if isinstance(container, list):
            container[int(at)] = new
        elif self._rng.random() < 0.1:
            del container[str(at)]
        else:
            container[str(at)] = new


def _places(value: JsonValue) -> Sequence[tuple[list[JsonValue] | dict[str, JsonValue], int | str]]:
    found: list[tuple[list[JsonValue] | dict[str, JsonValue], int | str]] = []
    if isinstance(value, list):
        for index, each in enumerate(value[:8]):
            found += [(value, index), *_places(each)]
    elif isinstance(value, dict):
        for name, each in value.items():
            found += [(value, name), *_places(each)]
    return found


def _start(bus: MemoryBus, number: int) -> None:
    action, goal = GOALS[number % len(GOALS)]
    sent = SendGoal(goal_id=f"test/{action.replace('/', '-')}/{number}", client="tester", goal=goal)
    goal_service(action).query(bus, sent)


@pytest.mark.lockstep
@pytest.mark.parametrize("seed", [1, 2])
def test_no_message_ends_a_process(seed: int) -> None:
    system = Lockstep(load_scenario("Demo"), seed)
    stranger = Stranger(MemoryBus(system.hub), seed)
    system.bus.announce("tester")
    raised: list[str] = []
    try:
        for period in range(round(SECONDS / system.period)):
            if period % 25 == 0:
                _start(system.bus, period // 25)
            stranger.tell(FORGED)
            system.clocks.advance(system.period)
            for node in system.nodes:
                raised += _error(node.name, node.step)
            assert not raised, raised[0]
    finally:
        system.close()


def _error(name: str, step: Callable[[], bool]) -> list[str]:
    try:
        step()
    except Exception as error:  # noqa: BLE001 - what the test is about
        return [f"{name}: {''.join(traceback.format_exception(error))}"]
    return []
