"""Somebody who moves things while the arms are on their way: each once, at a drawn moment of its phase."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final

from tandem.executive.trials.experiments.draws import Spot, Step
from tandem.executive.trials.experiments.settings import CARTON, LEFT, Series
from tandem.executive.trials.experiments.timeline import Timeline
from tandem.sim.controls import FAULT, FAULTS
from tandem.sim.faults import FaultRequest, ItemMoves, Place
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Message

FIELD_LEAVES: Final = ("approach", "plan before item")
GRASP_LEAVES: Final = ("grasp",)


class Moved(Message):
    """That an item was moved: to where, and when (robot seconds)."""

    item: int
    to: Spot
    at: float


@dataclass(eq=False)
class _Waiting:
    step: Step
    tries: int = 0
    asked: bool = False


@dataclass(eq=False)
class Mover:
    """A node.

    Args:
        bus: where the sim's controls are.
        clocks: robot time.
        timeline: says in which phase the arms are.
        steps: what is to be moved.
        series: in which phase.
    """

    bus: Bus
    clocks: Clocks
    timeline: Timeline
    steps: tuple[Step, ...]
    series: Series
    moved: list[Moved] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Nothing has been moved yet."""
        self._waiting = [_Waiting(step) for step in self.steps]
        self._events = Latest(self.bus, FAULTS, depth=16)

    def step(self) -> bool:
        """Move what is due; where an arm is in the way, try the next place."""
        now = robot_seconds(self.clocks)
        told = [event.phase for event in self._events.take()]
        for waiting in self._waiting[:1] if any(each.asked for each in self._waiting) else self._waiting:
            if waiting.asked:
                self._heed(waiting, told, now)
                break
            if self._due(waiting.step, now):
                self._ask(waiting)
                self._waiting.remove(waiting)
                self._waiting.insert(0, waiting)
                break
        return False

    def close(self) -> None:
        """Stop listening."""
        self._events.close()

    def _heed(self, waiting: _Waiting, told: Sequence[str], now: float) -> None:
        if "began" in told:
            to = waiting.step.to[waiting.tries]
            self.moved.append(Moved(item=waiting.step.item, to=to, at=round(now, 3)))
            self._waiting.remove(waiting)
        elif "refused" in told:
            waiting.tries, waiting.asked = waiting.tries + 1, False
            if waiting.tries >= len(waiting.step.to):
                self._waiting.remove(waiting)  # nobody moves a thing through an arm

    def _ask(self, waiting: _Waiting) -> None:
        to = waiting.step.to[waiting.tries]
        place = Place(support="table", x=to.x, y=to.y, yaw=to.yaw)
        FAULT.query(self.bus, FaultRequest(fault=ItemMoves(item=waiting.step.item, to=place)))
        waiting.asked = True

    def _due(self, step: Step, now: float) -> bool:
        sides = ("left", "right") if step.item == CARTON else ("left",) if step.item == LEFT else ("right",)
        leaves = FIELD_LEAVES if self.series == "field" else GRASP_LEAVES
        spans = [self.timeline.running(f"{side} arm: {leaf}") for side in sides for leaf in leaves]
        return any(span is not None and now - span.begin >= step.delay for span in spans)
