"""What an ended task has left behind: goals that must be at rest before the next task begins."""

from __future__ import annotations

from executive.halt import Halt
from executive.run import REST_WITHIN, SILENCE_ALLOWED, SILENT_AFTER
from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from trees.clients import Clients
from trees.knowledge import Knowledge


class Leftovers:
    """Moves such goals on; stops the hardware for those that don't end, and then gives them up.

    Args:
        bus: where the hardware is.
        clocks: host time, for the stop.
        clients: whose goals they are.
        knowledge: tells whether the hardware is there.
    """

    def __init__(self, bus: Bus, clocks: Clocks, clients: Clients, knowledge: Knowledge) -> None:
        self._bus, self._clocks, self._clients, self._knowledge = bus, clocks, clients, knowledge
        self._halt: Halt | None = None

    @property
    def none(self) -> bool:
        """Whether the next task may begin: all is at rest, and the hardware is there."""
        return self._clients.quiet and self._hardware_there

    def step(self) -> None:
        """Take in what has arrived."""
        self._clients.poll()
        self._knowledge.refresh()
        stuck = self._clients.stuck(REST_WITHIN, SILENCE_ALLOWED)
        if not stuck or not self._hardware_there:
            self._halt = None
        elif self._halt is None:
            self._halt = Halt(self._bus, self._clocks)
            self._halt.set("the goals of a task that has ended did not come to rest")
        elif self._halt.step():
            if self._halt.confirmed:
                self._clients.drop(stuck, "it did not come to rest; the hardware was stopped")
            self._halt = None

    @property
    def _hardware_there(self) -> bool:
        return self._knowledge.hardware_silent_for <= SILENT_AFTER
