"""What lives for one start of the hardware, and is made anew for the next.

Skills learn the robot from its description and gather what it tells: odometry, scans, joint states, what was
sent last. After a restart of the hardware none of it need hold: another clock counts, odometry begins at
zero, nothing is under way, and another robot may have been put in the old one's place. So nothing is carried
over: the nodes are closed, the description is asked for again, and new ones take their places.
"""

from __future__ import annotations

import gc
import logging
from collections.abc import Callable, Sequence
from typing import Final

from pydantic import ValidationError

from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.keys import DESCRIPTION, Nothing
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.scoped_bus import ScopedBus

log = logging.getLogger(__name__)

ASK_AGAIN: Final = 0.5
"""Host seconds between two questions for the robot's description."""

Build = Callable[[Bus, RobotDescription], Sequence[Node]]
"""Makes the nodes on a bus, in the order in which they are stepped."""


class OneBoot:
    """A ``Node`` around those of a role; they never see two boots.

    A goal that runs when the hardware starts anew fails with HARDWARE_LOST. Until the new nodes are there
    nobody answers: clients ask again.

    Args:
        name: the role's.
        bus: where the hardware tells its description.
        clocks: they tell the boot; refreshed before each step, and never in between.
        build: makes the nodes.
        description: what the hardware that is there has told.
    """

    def __init__(
        self, name: str, bus: Bus, clocks: Clocks, build: Build, description: RobotDescription
    ) -> None:
        self._name, self._bus, self._clocks, self._build = name, bus, clocks, build
        self._boot: str | None = None
        self._scope = ScopedBus(bus)
        self._nodes = tuple(build(self._scope, description))
        self._asked: Pending | None = None
        self._asked_at = float("-inf")

    @property
    def name(self) -> str:
        """The role's name."""
        return self._name

    @property
    def nodes(self) -> tuple[Node, ...]:
        """Those that there are now; none while the new hardware has not told who it is."""
        return self._nodes

    def step(self) -> bool:
        """Step the nodes; where the hardware has started anew, replace them."""
        now = self._clocks.robot()
        if now is not None and now.boot != self._boot:
            before, self._boot = self._boot, now.boot
            if before is not None:
                log.warning(
                    "new boot %s of the hardware (before: %s): %s begins anew", now.boot, before, self._name
                )
                self.close()
                self._asked, self._asked_at = None, float("-inf")
        if not self._nodes:
            self._begin()
        more = False
        for node in self._nodes:
            more = node.step() or more
        return more

    def close(self) -> None:
        """End the nodes, the last one first. Closing twice is allowed."""
        nodes, self._nodes = self._nodes, ()
        for node in reversed(nodes):
            node.close()
        self._scope.close()

    def _built(self, description: RobotDescription) -> tuple[Node, ...]:
        """Make the nodes; where the loop has set aside what it began with, this takes its place."""
        if not gc.get_freeze_count():
            return tuple(self._build(self._scope, description))
        gc.unfreeze()
        gc.collect()
        nodes = tuple(self._build(self._scope, description))
        gc.freeze()
        return nodes

    def _begin(self) -> None:
        """Make the nodes once the hardware has told who it is."""
        answer = None if self._asked is None else self._asked.poll()
        if answer is not None:
            self._asked = None
            try:
                description = DESCRIPTION.decode_answer(answer)
            except ValidationError:
                log.warning("the hardware told a description that can't be read; asking again")
            else:
                self._nodes = self._built(description)
            return
        now = self._clocks.monotonic()
        if (self._asked is None or self._asked.done()) and now - self._asked_at >= ASK_AGAIN:
            self._asked, self._asked_at = DESCRIPTION.query(self._bus, Nothing()), now
