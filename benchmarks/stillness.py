"""When the robot moves, and for whose sake it stands still: read off the bus alone.

While a task runs and the robot stands, the reason is read off the goals that are under way, at each message
of its joints (a hundred times a second):

- a look, a localisation or a grip: the skill's own work (light, a sharp picture, the fingers' force);
- no goal at all: between one goal's end and the next one's start, which is the executive's time;
- any other goal: planning, checks, messages, waiting for a motion's end; also for the executive's sake.
"""

from __future__ import annotations

from typing import Final

from benchmarks.listening import Listening
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.tasks import TaskState, TaskStatus

OWN_WORK: Final = ("perception/look", "base/localise")
"""Skills that work while the robot stands; grippers' too."""


class Stillness(Listening):
    """See ``Listening`` for the argument."""

    def __init__(self, bus: Bus) -> None:
        super().__init__(bus)
        self._running = False
        self.seconds: dict[str, float] = {}
        """Robot seconds of the task by what the robot did: ``moving``, or why it stood."""
        self.moved_at: float | None = None
        """Robot time of the first motion of a task."""

    @property
    def total(self) -> float:
        """Robot seconds of the task until now."""
        return sum(self.seconds.values())

    @property
    def idle_share(self) -> float:
        """Share of the task in which the robot stood for the executive's sake."""
        own = {"moving", *(name for name in self.seconds if _own_work(name))}
        idle = sum(spent for name, spent in self.seconds.items() if name not in own)
        return idle / self.total if self.total else float("nan")

    def on_task(self, status: TaskStatus) -> None:
        """Take in whether a task runs."""
        self._running = status.state is TaskState.RUNNING

    def on_passed(self, seconds: float, now: float, *, moving: bool) -> None:
        """Count the seconds."""
        if not self._running:
            return
        what = "moving" if moving else self._why()
        self.seconds[what] = self.seconds.get(what, 0.0) + seconds
        if what == "moving" and self.moved_at is None:
            self.moved_at = now

    def _why(self) -> str:
        skills = {skill for skill, _ in self.open.values()}
        return min(skills, key=lambda name: (not _own_work(name), name), default="no goal")


def _own_work(name: str) -> bool:
    return name in OWN_WORK or name.startswith("gripper_")
