"""What a record of a robot is, whatever file it stands in, and how one is opened.

Robot time starts anew with each boot of the hardware. So a record counts on over boots: ``at`` is the robot
seconds since its recorder began, and never falls. ``stamp`` is the robot's own time of the same moment.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal, Protocol

from tandem.skills.ports.message import Count, Message, RobotTime
from tandem.skills.ports.records import Cause
from tandem.skills.ports.sources import DocumentError

LAYOUT: Final = 1
"""Of what stands in a file, whichever kind it is of. A file with a larger number is refused."""
GZIP: Final = b"\x1f\x8b"
MCAP: Final = b"\x89MCAP0\r\n"
"""The first bytes of a gzip file and of an MCAP file of version 0: they tell which kind a record is of."""
JSON: Final = "application/json"

Encoding = Literal["json", "jpeg", "bytes"]
"""``json``: as it was on the bus. ``jpeg``: a picture, made smaller. ``bytes``: as it was, and no JSON."""


class RecordError(DocumentError):
    """A record that can't be used: the text names the file, what was expected and found, and what to do."""

    def __init__(self, path: Path, expected: str, found: str, advice: str) -> None:
        super().__init__(f"{path}: expected {expected}; found {found}; {advice}")


@dataclass(frozen=True)
class Recorded:
    """One message, as it was heard."""

    key: str
    """Without ``<site>/<robot>``."""
    at: float
    """Robot seconds since the recorder began, counted on over boots of the hardware; never falls."""
    stamp: RobotTime | None
    """The robot's time when it was heard; None before the hardware's clock was."""
    host: int
    """Nanoseconds since 1970 on the recorder's host, when it was heard."""
    payload: bytes
    encoding: Encoding = "json"


@dataclass(frozen=True)
class Attachment:
    """A document beside the messages: who the robot is, its site, the tree at a task's start."""

    name: str
    """The key whose answer it is, such as ``hw/description``; of a tree ``tree/<task>``."""
    at: float
    """Robot seconds since the recorder began."""
    data: bytes
    media: str = JSON


class Facts(Message):
    """What a record is of."""

    site: str
    """First part of the robot's keys."""
    robot: str
    """Second part."""
    scenario: str = ""
    seed: Count = 0
    lockstep: bool = False
    """Whether the run can be repeated from scenario and seed."""
    request: str = ""
    """Of `tandem run` in lockstep: what was asked for, as a JSON document; empty: the scenario's demo."""
    campaign: str = ""
    """The campaign that the run is of: ``fetch``, ``recovery`` or ``hopeless``; empty: of none."""
    run: Count = 0
    """Its number in that campaign."""
    faults: str = ""
    """What was to go wrong, as the JSON of a file of faults; empty: nothing besides the scenario's own."""
    pictures: bool = False
    """Whether the recorder of a run in lockstep listened to the cameras, which keeps them at work."""
    release: str
    """Version of the Tandem that wrote it."""
    commit: str = ""
    """Of its checkout; empty: not known."""
    began: float
    """UTC seconds, when the recorder began."""
    causes: tuple[Cause, ...] = ()
    """Of a black box: why it was kept, in order."""

    @property
    def cause(self) -> Cause | None:
        """The first of them; None of a recording."""
        return next(iter(self.causes), None)


@dataclass(frozen=True)
class Span:
    """From when to when a record is whole, in robot seconds since its recorder began.

    Earlier messages are the last ones of their keys from before ``begin``: what was known then.
    """

    begin: float
    end: float

    def clipped(self, at: float) -> float:
        """Return the moment, or the nearest one that lies within."""
        return min(max(at, self.begin), self.end)


@dataclass(frozen=True)
class BootSpan:
    """What a record has of one boot of the robot."""

    boot: str
    begin: float
    """The robot's own time of the first message, in seconds."""
    end: float
    """That of the last one."""
    offset: float
    """What to add to a robot time of this boot to get ``at``."""


class Recording(Protocol):
    """A record that can be read again and again. Its owner closes it."""

    @property
    def path(self) -> Path:
        """The file."""
        ...

    @property
    def facts(self) -> Facts:
        """What it is of."""
        ...

    @property
    def span(self) -> Span:
        """From when to when it is whole."""
        ...

    @property
    def attachments(self) -> tuple[Attachment, ...]:
        """The documents beside the messages, in the order in which they came."""
        ...

    def messages(self, since: float = -math.inf, until: float = math.inf) -> Iterator[Recorded]:
        """Yield the messages with ``since <= at <= until``, in the order in which they were heard."""
        ...

    def pictures(self, since: float = -math.inf, until: float = math.inf) -> Iterator[Recorded]:
        """Yield the pictures between two moments, as JPEG under the key of their camera."""
        ...

    def known(self, at: float) -> Mapping[str, Recorded]:
        """Return the last message of each key up to and with a moment, the newest last."""
        ...

    def boots(self) -> tuple[BootSpan, ...]:
        """Return the boots of the robot whose time it has, in order."""
        ...

    def grow(self) -> None:
        """Take in what has been written since, of a file that is still written."""
        ...

    def close(self) -> None:
        """Close the file. Closing twice is allowed."""
        ...


NAMED: Final = 4
"""Records of a folder that a message names."""


def open_recording(path: Path) -> Recording:
    """Return the record in a file.

    Raises:
        RecordError: for a file that can't be read, is no record, was cut, or was written by a newer release.
    """
    if path.is_dir():
        raise RecordError(path, "a record", f"a folder {_with(path)}", "name one of its files")
    try:
        with path.open("rb") as file:
            first = file.read(len(MCAP))
    except OSError as error:
        raise RecordError(
            path,
            "a record",
            error.strerror or str(error),
            "`tandem why ID` names those of a task; all lie in `records` beside the ledger",
        ) from error
    if first == MCAP:
        from tandem.executive.records.mcap_file import McapRecording  # noqa: PLC0415 - of the extra `record`

        return McapRecording(path)
    if first.startswith(GZIP):
        from tandem.executive.records.lines_file import LinesRecording  # noqa: PLC0415 - as both know this

        return LinesRecording(path)
    raise RecordError(
        path,
        "a record of Tandem (.mcap, or .jsonl.gz of the black box)",
        "another kind of file" if first else "an empty file",
        "`tandem up --record` writes records, and the black box writes into `records` of the data folder",
    )


def finite(said: object) -> float:
    """Return a number that a file says, perhaps as text; ValueError for none, or one that is not finite."""
    if isinstance(said, int | float | str) and math.isfinite(number := float(said)):
        return number
    raise ValueError(f"expected a number, found {said!r}")


def check_layout(path: Path, layout: object, release: str) -> None:
    """Refuse a file of a newer layout, or of none.

    Raises:
        RecordError: saying so.
    """
    if isinstance(layout, int) and 1 <= layout <= LAYOUT:
        return
    expected = f"layout {LAYOUT} or older"
    if isinstance(layout, int) and layout > LAYOUT:
        raise RecordError(
            path, expected, f"layout {layout}, of release {release}", "read it with that release"
        )
    raise RecordError(path, expected, "no record of Tandem", "open it with the program that wrote it")


def _with(folder: Path) -> str:
    """Tell the newest records in a folder; each of several robots has its own folder in it."""
    found = [
        each
        for pattern in ("*", "*/*")
        for each in folder.glob(pattern)
        if each.name.endswith((".mcap", ".jsonl.gz"))
    ]
    newest = sorted(found, key=lambda each: each.name)[-NAMED:]
    more = "" if len(found) <= NAMED else f" and {len(found) - NAMED} older ones"
    names = ", ".join(str(each.relative_to(folder)) for each in reversed(newest))
    return f"with {names}{more}" if found else "without any"
