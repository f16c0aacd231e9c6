"""Whether the joints' states have stopped coming: then nobody sees what the arm does, and it must not move.

The reflex ``arm_guard`` watches them while a goal has the arm; the field does not wait for rest that is not
told.
"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.hardware import JointStates

SILENT_AFTER: Final = 0.5
"""Robot seconds: 50 of the hardware's periods. A busy machine holds up a process for 0.2 s."""


def joints_silent(newest: JointStates | None, clocks: Clocks) -> bool:
    """Say whether no joint states have come for too long, or none of the hardware's present boot."""
    now = clocks.robot()
    return newest is None or now is None or not newest.stamp.is_fresh(now, SILENT_AFTER)
