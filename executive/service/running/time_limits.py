"""How long is waited for goals that come to rest, for silent hardware, and for what follows a cancel."""

from __future__ import annotations

from typing import Final

REST_WITHIN: Final = 5.0
"""Robot seconds in which a goal must have come to rest once told to; then the hardware is stopped."""
SILENCE_ALLOWED: Final = 10.0
"""Host seconds that this is waited for while the robot's clock stands still."""
SILENT_AFTER: Final = 0.4
"""Host seconds without the hardware's clock after which the tree waits."""
LOST_AFTER: Final = 15.0
"""Host seconds without it after which the task ends."""
WIND_DOWN_WITHIN: Final = 120.0
"""Robot seconds for what is done after a cancel."""
