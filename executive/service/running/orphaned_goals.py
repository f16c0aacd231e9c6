"""What an ended task or a dead executive has left behind: goals that must be at rest before the next task."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from pydantic import ConfigDict

from tandem.executive.ledger.port import SentGoal
from tandem.executive.service.running.emergency_stop import EmergencyStop
from tandem.executive.service.running.time_limits import REST_WITHIN, SILENCE_ALLOWED, SILENT_AFTER
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType
from tandem.trees.clients import AnyGoal, Clients
from tandem.trees.knowledge import Knowledge

OWNER: Final = "executive"


class Whatever(Message):
    """A document of a skill, which is not read: goals of before a restart only come to rest."""

    model_config = ConfigDict(frozen=True, extra="ignore")


class OrphanedGoals:
    """Moves such goals on; stops the hardware for those that don't end, and then gives them up.

    Args:
        bus: where the hardware is.
        clocks: host time, for the stop.
        clients: whose goals they are.
        knowledge: tells whether the hardware is there.
    """

    def __init__(self, bus: Bus, clocks: Clocks, clients: Clients, knowledge: Knowledge) -> None:
        self._bus, self._clocks, self._clients, self._knowledge = bus, clocks, clients, knowledge
        self._before = Clients(bus, clocks, OWNER, clients.journal)
        self._halt: EmergencyStop | None = None

    @property
    def none(self) -> bool:
        """Whether the next task may begin: all is at rest, and the hardware is there."""
        return self._clients.quiet and self._before.quiet and self._hardware_there

    @property
    def settled(self) -> bool:
        """Whether all goals of before a restart have come to rest."""
        return self._before.quiet

    def adopt(self, goals: Iterable[SentGoal]) -> None:
        """Bring goals to rest that were sent before a restart, as far as they run."""
        for sent in goals:
            action = ActionType(sent.action, Whatever, Whatever, Whatever, timeout=float("inf"))
            self._before.of(action).adopt(sent.goal_id, Whatever())

    def step(self) -> None:
        """Take in what has arrived."""
        self._clients.poll()
        self._before.poll()
        self._knowledge.refresh()
        stuck = self._stuck()
        if not stuck or not self._hardware_there:
            self._halt = None
        elif self._halt is None:
            self._halt = EmergencyStop(self._bus, self._clocks)
            self._halt.set("goals of an ended task did not come to rest")
        elif self._halt.step():
            if self._halt.confirmed:
                why = "it did not come to rest; the hardware was stopped"
                self._clients.drop(self._clients.stuck(REST_WITHIN, SILENCE_ALLOWED), why)
                self._before.drop(self._before.stuck(REST_WITHIN, SILENCE_ALLOWED), why)
            self._halt = None

    def _stuck(self) -> tuple[AnyGoal, ...]:
        return tuple(
            handle
            for clients in (self._clients, self._before)
            for handle in clients.stuck(REST_WITHIN, SILENCE_ALLOWED)
        )

    @property
    def _hardware_there(self) -> bool:
        return self._knowledge.hardware_silent_for <= SILENT_AFTER
