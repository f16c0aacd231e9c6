"""How what is published on a key is delivered. One rule for all: a publisher never waits for a reader.

A reader that is stopped in a debugger, or behind a cable that was pulled, would otherwise hold up the clock
and the dead man's switch of everybody. What differs is what a reader misses that can't keep up:

- ``CONTROL``: a stream whose next message makes up for the last one. Latest wins.
- ``STATE``: said when it changes, and once more a second later unless it has changed again: a reader that was
  busy for a moment and missed it is not wrong for ever. ``kept/<key>`` answers with the latest.
- ``BULK``: pictures. One at a time is on its way to a reader, whole or not at all; those that come meanwhile
  are not for that reader.
"""

from __future__ import annotations

from enum import StrEnum
from functools import lru_cache
from typing import Final

from tandem.skills.ports.match import matches

PACED: Final = (
    "hw/joints/state",
    "hw/base/odometry",
    "hw/gripper/*/state",
    "hw/wrench/*",
    "hw/ranges",
    "hw/cliffs",
    "world/robot",
    "world/robots/*",
    "beat/**",
)
"""What is told steadily: it wakes nobody. The clock does, which comes after it or in the next tick."""
PASSING: Final = ("task/*/status",)
"""Keys of one thing each, such as a task, which nobody needs once it is over. Nothing of ours declares them
to zenoh, to publish or to subscribe: of each key ever declared, a router (1.10) keeps 1.6 kB and a session
about 1 kB, undeclared or not (``python -m benchmarks.declared_keys``)."""
KEPT: Final = "kept/"
"""Before the key of a state: where its publisher answers with what it said last."""
KEPT_KEYS: Final = 256
"""States that a process keeps; then the one that was said longest ago is forgotten. A process has a few
dozen, the executive one for each task."""
AGAIN_AFTER: Final = 1.0
"""Host seconds after which a state is said once more. Who is busy for longer is said to hang."""
LARGE: Final = 512 * 1024
"""Bytes of a payload above which it goes as bulk, whatever it is: half of what may wait on the way to a
reader (``skills/wire/configs.py``)."""


class Delivery(StrEnum):
    """What may be missed, and whether it can be asked for."""

    CONTROL = "control"
    STATE = "state"
    BULK = "bulk"


DELIVERY: Final[tuple[tuple[str, Delivery], ...]] = (
    ("hw/camera/*/rgbd", Delivery.BULK),
    ("beat/**", Delivery.CONTROL),
    ("refused", Delivery.STATE),
    ("hw/clock", Delivery.CONTROL),
    ("hw/joints/state", Delivery.CONTROL),
    ("hw/base/velocity", Delivery.CONTROL),
    ("hw/base/odometry", Delivery.CONTROL),
    ("hw/*/laser", Delivery.CONTROL),
    ("hw/ranges", Delivery.CONTROL),
    ("hw/cliffs", Delivery.CONTROL),
    ("hw/pose", Delivery.CONTROL),
    ("hw/robots", Delivery.CONTROL),
    ("hw/group/*/setpoint", Delivery.CONTROL),
    ("hw/gripper/*/state", Delivery.CONTROL),
    ("hw/wrench/*", Delivery.CONTROL),
    ("hw/base/bumpers", Delivery.STATE),
    ("hw/group/*/status", Delivery.STATE),
    ("hw/stop/state", Delivery.STATE),
    ("hw/leases", Delivery.STATE),
    ("world/robot", Delivery.CONTROL),
    ("world/robots/*", Delivery.CONTROL),
    ("world/**", Delivery.STATE),
    ("skill/*/approach_state", Delivery.CONTROL),
    ("skill/reflex/crossing", Delivery.CONTROL),
    ("skill/**", Delivery.STATE),
    ("task/request", Delivery.CONTROL),
    ("task/by/**", Delivery.CONTROL),
    ("task/pulse", Delivery.CONTROL),
    ("task/**", Delivery.STATE),
    ("tree/**", Delivery.STATE),
    ("sim/follow", Delivery.CONTROL),
    ("sim/**", Delivery.STATE),
)
"""The first expression that a key matches counts. One that none matches, such as a plug-in's, is a state."""

REMEMBERED: Final = 512
"""Keys whose delivery is remembered. A robot has some hundred that come again and again; a key of one task
comes for seconds, and 4,096 of them in each of three tables took 1 MB."""


@lru_cache(maxsize=REMEMBERED)
def paced(key: str) -> bool:
    """Say whether what is published on the key wakes nobody."""
    return any(matches(expression, key) for expression in PACED)


@lru_cache(maxsize=REMEMBERED)
def passing(key: str) -> bool:
    """Say whether the key is one of many that come and go."""
    return any(matches(expression, key) for expression in PASSING)


@lru_cache(maxsize=REMEMBERED)  # each message asks; keys are few, but a client's documents may name any
def delivery_of(key: str) -> Delivery:
    """Return how what is published on the key (relative to ``<site>/<robot>``) is delivered."""
    return next((how for expression, how in DELIVERY if matches(expression, key)), Delivery.STATE)
