"""Makes faults happen: begins them in their time or at their event, and ends them.

What is wrong with the hardware is worked out anew from all faults that are under way, so that faults of one
kind may overlap. What happens to the room happens once.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.sim.controls import FAULTS
from tandem.sim.defects import Standing, break_hardware, misfit
from tandem.sim.events import Events, Occurrence
from tandem.sim.faults import (
    BumperPressed,
    CameraFrozen,
    DepotTaken,
    Fault,
    FaultEvent,
    GripperStuck,
    GripperWeak,
    HandOpens,
    ItemGone,
    ItemMoves,
    JointStall,
    ObstacleAppears,
    OdometryJump,
    RangeSilent,
    RangeStuck,
    StopSet,
)
from tandem.sim.lens import Freeze
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Answer, StopState

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Literal

    from tandem.sim.faulty_link import FaultyLink
    from tandem.sim.hardware import Hardware
    from tandem.sim.room import Room
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.message import HandName


ROOM_AGAIN: Final = 0.1
"""Robot seconds after which a thing that found no room is tried again; the base drives 10 cm at the most."""


@dataclass(eq=False)
class _Case:
    """One fault on its way: waiting, under way, or over."""

    number: int
    fault: Fault
    hands: tuple[HandName, ...]
    """All hands of the robot."""
    due: float
    """Robot seconds at which it begins; infinity while its event has not happened."""
    happened: int = 0
    cause: Occurrence | None = None
    ends: float = math.inf
    made: str = ""
    """The body that it made, to be taken away in the end."""
    freeze: Freeze | None = None

    @property
    def sides(self) -> tuple[str, ...]:
        """The sides that are meant: the one named, else the event's, else all."""
        if not isinstance(self.fault, GripperStuck | GripperWeak | HandOpens | JointStall):
            return ()
        side = getattr(self.fault, "side", None) or (None if self.cause is None else self.cause.side)
        return self.hands if side is None else (side,)

    def standing(self) -> Standing:
        """Return what is wrong while it lasts."""
        return Standing(self.fault, self.sides, self.freeze)


class Trouble:
    """Call ``step`` once a period, before the hardware's.

    Args:
        bus: where it is told what began and ended.
        link: the hardware's end of the bus, which faults cut.
        hardware: what is broken.
        room: what is changed.
        faults: of the scenario, checked.
    """

    def __init__(
        self, bus: Bus, link: FaultyLink, hardware: Hardware, room: Room, faults: Sequence[Fault]
    ) -> None:
        self._bus, self._link, self._hardware = bus, link, hardware
        self.restart(room, faults)

    def restart(self, room: Room, faults: Sequence[Fault]) -> None:
        """Begin anew after the hardware has been restarted; nothing is broken."""
        self._room = room
        self._events = Events(self._link, self._hardware, room.world, room.robot)
        self._count = 0
        self._waiting: list[_Case] = []
        self._under_way: list[_Case] = []
        self._link.cut, self._link.spoils = frozenset(), {}
        for fault in faults:
            self._add(fault)

    @property
    def silent(self) -> bool:
        """Whether nobody hears the hardware's clock."""
        return self._link.is_cut(keys.CLOCK.key)

    def ask(self, fault: Fault) -> Answer:
        """Have a fault happen in its time, or at once when it has none; refuse what can't be."""
        problem = misfit(fault, self._hardware.description)
        if problem:
            return Answer(accepted=False, reason=problem)
        self._add(fault)
        return Answer(accepted=True)

    def step(self) -> None:
        """End what is over, and begin what is due."""
        now = self._hardware.now.seconds
        self._await_events(now)
        over = [case for case in self._under_way if now >= case.ends - 1e-9]
        due = [case for case in self._waiting if now >= case.due - 1e-9]
        if not over and not due:
            return
        for case in over:
            self._under_way.remove(case)
            self._end(case)
        for case in due:
            self._waiting.remove(case)
            self._begin(case, now)
        standing = [case.standing() for case in self._under_way]
        break_hardware(standing, self._link, self._hardware)

    def _add(self, fault: Fault) -> None:
        due = (fault.at or 0.0) if fault.when is None else math.inf
        self._waiting.append(_Case(self._count, fault, self._hardware.description.hands, due))
        self._count += 1

    def _await_events(self, now: float) -> None:
        awaiting = [case for case in self._waiting if case.fault.when is not None and case.due == math.inf]
        if not awaiting:
            self._events.look_away()
            return
        wanted = {case.fault.when.event for case in awaiting if case.fault.when is not None}
        for occurrence in self._events.step(self._hardware.now, wanted):
            for case in awaiting:
                when = case.fault.when
                if when is None or case.cause is not None or not occurrence.is_one_of(when):
                    continue
                case.happened += 1
                if case.happened == when.nth:
                    case.cause, case.due = occurrence, now + when.after

    def _begin(self, case: _Case, now: float) -> None:
        try:
            words = self._strike(case)
        except (KeyError, ValueError) as error:
            if isinstance(error, ValueError) and isinstance(case.fault, ObstacleAppears) and case.fault.waits:
                case.due = now + ROOM_AGAIN
                self._waiting.append(case)
                return
            self._tell(case, "refused", str(error.args[0]))
            return
        lasts = getattr(case.fault, "lasts", None)
        case.ends = math.inf if lasts is None else now + lasts
        if not isinstance(case.fault, OdometryJump | ItemMoves | ItemGone):
            self._under_way.append(case)
        self._tell(case, "began", words)

    def _strike(self, case: _Case) -> str:
        """Do what happens once, and return what happens in words."""
        fault = case.fault
        if isinstance(fault, OdometryJump):
            self._hardware.base.odometer.jump(fault.dx, fault.dy, fault.dyaw)
            return f"odometry jumps by ({fault.dx:g}, {fault.dy:g}) m and {fault.dyaw:g} rad"
        if isinstance(fault, StopSet):
            self._hardware.set_stop(StopState(stopped=True, by=fault.by, reason=fault.reason))
            return f"{fault.by} sets the stop"
        if isinstance(fault, ItemMoves | ItemGone | ObstacleAppears | DepotTaken):
            done = self._room.change(fault, case.number, None if case.cause is None else case.cause.item)
            case.made = done.made
            return done.words
        if isinstance(fault, CameraFrozen):
            case.freeze = Freeze()
        return _standing(case)

    def _end(self, case: _Case) -> None:
        if case.made:
            self._room.remove(case.made)
        stop = self._hardware.stop_state
        if isinstance(case.fault, StopSet) and (stop.by, stop.reason) == (case.fault.by, case.fault.reason):
            self._hardware.set_stop(StopState(stopped=False))
        self._tell(case, "ended", f"{case.fault.kind.replace('_', ' ')} is over")

    def _tell(self, case: _Case, phase: Literal["began", "ended", "refused"], words: str) -> None:
        event = FaultEvent(
            stamp=self._hardware.now, number=case.number, kind=case.fault.kind, phase=phase, words=words
        )
        FAULTS.publish(self._bus, event)


def _standing(case: _Case) -> str:
    """Return in words what is so while a fault lasts."""
    fault = case.fault
    lasts = getattr(fault, "lasts", None)
    span = "for good" if lasts is None else f"for {lasts:g} s"
    what = fault.kind.replace("_", " ")
    match fault:
        case JointStall():
            group = fault.group or f"{' and '.join(case.sides)} arm"
            what = f"{group}: {'all joints' if fault.joint is None else fault.joint} stalled"
        case GripperStuck() | GripperWeak() | HandOpens():
            what += f" ({' and '.join(case.sides)})"
        case BumperPressed():
            what = f"{'a bumper' if fault.bumper is None else f'bumper {fault.bumper}'} reads pressed"
        case RangeSilent() | RangeStuck():
            sensors = "all range sensors" if fault.sensor is None else f"range sensor {fault.sensor}"
            what = f"{sensors} {fault.kind.removeprefix('range_')}"
    return f"{what} {span}"
