"""What a recorder listens to, and how a message becomes a record of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Final, Protocol

from tandem.executive.records.known import ALIVE, Alive
from tandem.executive.records.recording import Encoding, Recorded
from tandem.skills.ports.hearing import Ear, Entrance
from tandem.skills.ports.keys import CLOCK
from tandem.skills.ports.match import matches
from tandem.skills.ports.message import Message, RobotTime, RobotTimer, read_leniently
from tandem.skills.ports.whereabouts import whereabouts
from tandem.skills.wire.memory import Kind, MemoryHub

HEARD: Final = (
    "hw/clock",
    "hw/joints/state",
    "hw/base/*",
    "hw/*/laser",
    "hw/ranges",
    "hw/cliffs",
    "hw/pose",
    "hw/robots",
    "hw/stop/state",
    "hw/leases",
    "hw/group/**",
    "hw/gripper/**",
    "hw/wrench/*",
    "world/**",
    "skill/**",
    "task/**",
    "tree/**",
    "refused",
)
"""All but beats and pictures. A camera that somebody listens to is exposed and sent: 4.6 MB a picture."""
OF_SITE: Final = (whereabouts("*").key,)
"""Relative to ``<site>``: where its robots are. In a record it stands among the robot's own keys, of which
none is like it."""
JSON: Final[Encoding] = "json"
BYTES: Final[Encoding] = "bytes"
PICTURES: Final = "hw/camera/*/rgbd"
DEPTH: Final = 4096
"""Messages of a key that wait: at a hundred times real time, a clock of 100 Hz says 1,000 in a turn."""


class Arrived(Protocol):
    """One message that arrived."""

    @property
    def key(self) -> str:
        """Relative to ``<site>/<robot>``."""
        ...

    @property
    def payload(self) -> bytes:
        """What was put."""
        ...

    @property
    def monotonic(self) -> int:
        """Nanoseconds of the host's monotonic clock."""
        ...


@dataclass(frozen=True)
class Said:
    """One message that was put on a bus in memory, and when."""

    key: str
    payload: bytes
    monotonic: int


class MemoryEars:
    """What is put on a bus in memory, in order; implements ``Ears``.

    Args:
        hub: of the bus.
        monotonic: the host's monotonic clock in seconds (in lockstep: simulated).
        keys: expressions; what none stands for is not heard.
    """

    def __init__(self, hub: MemoryHub, monotonic: Callable[[], float], keys: Sequence[str] = HEARD) -> None:
        self._monotonic, self._keys = monotonic, tuple(keys)
        self._wanted: dict[str, bool] = {}
        self._said: list[Said] = []
        self._open = True
        hub.watch(self._hear)

    def drain(self) -> Sequence[Said]:
        """Take all that was put."""
        taken, self._said = self._said, []
        return taken

    def close(self) -> None:
        """Stop hearing."""
        self._open = False

    def _hear(self, kind: Kind, key: str, payload: bytes) -> None:
        if kind != "put" or not self._open:
            return
        if key not in self._wanted:
            self._wanted[key] = any(matches(each, key) for each in self._keys)
        if self._wanted[key]:
            self._said.append(Said(key, payload, round(self._monotonic() * 1e9)))


class Ears(Protocol):
    """Where a recorder takes its messages from."""

    def drain(self) -> Sequence[Arrived]:
        """Take all that has arrived, in the order in which it came."""
        ...

    def close(self) -> None:
        """Stop hearing."""
        ...


class _Stamped(Message):
    """What is read of a clock."""

    stamp: RobotTime


class Stamper:
    """Gives messages their times. Only the hardware's clock is decoded.

    Args:
        ear: of the process; counts what is no clock.
    """

    def __init__(self, ear: Ear) -> None:
        self._clock = Entrance(ear, _read_clock)
        self._timer = RobotTimer()
        self._alive: frozenset[str] | None = None
        self.stamp: RobotTime | None = None
        """The robot's time, as heard last."""

    @property
    def at(self) -> float:
        """Robot seconds since the recorder began; during the first boot the robot's own."""
        return round(self._timer.reading, 9)

    def stamped(self, arrived: Iterable[Arrived], offset: int) -> list[Recorded]:
        """Return the messages with their times.

        Args:
            arrived: in the order in which they came.
            offset: nanoseconds from the host's monotonic clock to 1970.
        """
        return [self._stamped(each, offset) for each in arrived]

    def alive(self, names: frozenset[str], host: int) -> Recorded | None:
        """Return a record of who is announced, if that has changed."""
        if names == self._alive:
            return None
        self._alive = names
        told = Alive(names=tuple(sorted(names))).model_dump_json().encode()
        return Recorded(ALIVE, self.at, self.stamp, host, told)

    def _stamped(self, arrived: Arrived, offset: int) -> Recorded:
        if arrived.key == CLOCK.key:
            self._hear(arrived.payload)
        is_json = arrived.payload[:1] in {b"{", b"["}
        host, encoding = arrived.monotonic + offset, JSON if is_json else BYTES
        return Recorded(arrived.key, self.at, self.stamp, host, arrived.payload, encoding)

    def _hear(self, payload: bytes) -> None:
        said = self._clock.read(CLOCK.key, payload)
        if said is None:
            return
        if self._clock.is_newer(CLOCK.key, said):
            self.stamp = said.stamp
            self._timer.read(said.stamp)
        else:
            self._clock.keeps_old(CLOCK.key, said)  # which counts it


def _read_clock(payload: bytes) -> _Stamped:
    return read_leniently(_Stamped, payload)
