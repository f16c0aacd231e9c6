"""What the recorder tells of itself: which records there are, and whether it records."""

from __future__ import annotations

from typing import Final, Literal

from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.message import Count, Message, RobotTime


class Cause(Message):
    """Why a black box was kept."""

    kind: Literal["task", "stop", "death", "asked"]
    """A task failed, a stop was set, a process died, or somebody asked for it."""
    words: str
    """What happened, in a line."""
    task: str = ""
    """The task that failed or ran; empty if none did."""
    at: float = 0.0
    """Robot seconds since the recorder began."""
    stamp: RobotTime | None = None
    """The robot's time."""


class BlackBox(Message):
    """A black box: a file of the last minute before something went wrong."""

    file: str
    """Its path, on the recorder's host."""
    size: Count
    """Its size in bytes."""
    began: float
    """UTC seconds at which its recorder began."""
    causes: tuple[Cause, ...] = ()
    """What went wrong, in order."""


class AskRecords(Message):
    """Query the records that are kept."""

    task: str = ""
    """Only black boxes that name this task; empty: all."""


class RecordingFile(Message):
    """A recording that is kept (.mcap)."""

    file: str
    """Its path, on the recorder's host."""
    size: Count
    """Its size in bytes."""
    began: float
    """UTC seconds at which it began."""
    written: float
    """UTC seconds at which it was last written."""


class Records(Message):
    """The records that are kept, oldest first."""

    boxes: tuple[BlackBox, ...]
    recordings: tuple[RecordingFile, ...] = ()
    """The newest 100 recordings, whatever task was asked for: when they were written says what is in them."""


class RecordingState(Message):
    """Whether the robot is recorded; told when it changes, and every 10 s while recording has stopped."""

    recording: bool
    file: str = ""
    """The file that is written, on the recorder's host."""
    reason: str = ""
    """Why recording stopped, such as a full disk; empty while it records."""


TASK_RECORDS: Final = Service("task/records", AskRecords, Records, reads=True)
TASK_RECORDING: Final = Topic("task/recording", RecordingState)
