"""A run as a small moving picture: ``tandem demo --film FILE`` and ``tandem run ... --film FILE``."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from tandem.executive.render.frame import Picture, frame, save
from tandem.sim.controls import PHOTOGRAPH, PhotographRequest
from tandem.sim.demonstration import View
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import TREE, TreeSnapshot

EVERY: Final = 0.6
"""Robot seconds between two pictures: 93 in the demo. Only steps without a motion fall between two."""
SHOWN: Final = 0.12
"""Seconds for which each is shown: five times as fast as the robot."""
SIZE: Final = (512, 384)
"""Pixels of the room, width and height."""
ANSWER_WITHIN: Final = 10.0
"""Seconds for one photograph."""


class Film:
    """Takes a picture of room and tree every so often, while a task goes on; a node beside the caller.

    Args:
        bus: where the robot is.
        clocks: robot time.
        view: from where the room is seen.
    """

    name = "film"

    def __init__(self, bus: Bus, clocks: Clocks, view: View) -> None:
        self._bus, self._clocks = bus, clocks
        self._ask = PhotographRequest(eye=view.eye, target=view.target, width=SIZE[0], height=SIZE[1])
        self._trees = Latest(bus, TREE, depth=1024)
        self._tree: TreeSnapshot | None = None
        self._taken: Pending | None = None
        self._began, self._last = robot_seconds(clocks), -EVERY
        self.frames: list[Picture] = []
        """What has been taken."""

    def step(self) -> bool:
        """Take in the tree, and take a picture when it is time."""
        for tree in self._trees.take():
            self._tree = tree
        if self._tree is None:
            return False
        now = robot_seconds(self._clocks) - self._began
        if self._taken is not None:
            self._develop(self._taken, self._tree, now)
        elif now - self._last >= EVERY:
            self._last = now
            self._taken = self._bus.query(
                PHOTOGRAPH.key, self._ask.model_dump_json().encode(), timeout=ANSWER_WITHIN
            )
        return False

    def _develop(self, taken: Pending, tree: TreeSnapshot, now: float) -> None:
        photograph = taken.poll()
        if photograph is not None:
            self.frames.append(frame(photograph, tree.root, f"robot time {now:.1f} s"))
        if photograph is not None or taken.done():
            self._taken = None

    def write(self, path: Path) -> None:
        """Write what was taken.

        Raises:
            OSError: when nothing was taken, or the file can't be written.
        """
        if not self.frames:
            raise OSError(f"{path}: no moving picture: the simulation took no photograph")
        save(path, self.frames, SHOWN)

    def close(self) -> None:
        """Stop listening."""
        self._trees.close()
