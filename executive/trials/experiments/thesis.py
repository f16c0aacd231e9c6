"""The two-arm thesis's own figures, as they stand in its tables 5.1 to 5.7 (5.4)."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

ROWS: Final = (
    "SR APF left",
    "SR APF right",
    "SR RRTConnect left",
    "SR RRTConnect right",
    "SR pick left",
    "SR pick right",
)
"""The rows of the tables of success rates."""

SUCCESS: Final = MappingProxyType(
    {
        ("uncoordinated", 1, "apf_rrtconnect"): ("20/20", "20/20", "20/20", "20/20", "20/20", "15/20"),
        ("uncoordinated", 1, "rrtconnect"): ("-", "-", "15/20", "20/20", "0/20", "0/20"),
        ("uncoordinated", 2, "apf_rrtconnect"): ("20/20", "20/20", "20/20", "20/20", "20/20", "20/20"),
        ("uncoordinated", 2, "rrtconnect"): ("-", "-", "18/20", "20/20", "0/20", "0/20"),
        ("uncoordinated", 3, "apf_rrtconnect"): ("20/20", "20/20", "20/20", "20/20", "19/20", "17/20"),
        ("uncoordinated", 3, "rrtconnect"): ("-", "-", "19/20", "20/20", "0/20", "0/20"),
        ("crossing", 1, "dual"): ("60/60", "60/60", "60/60", "60/60", "59/60", "58/60"),
        ("crossing", 1, "sequential"): ("59/60", "60/60", "59/60", "60/60", "58/60", "60/60"),
        ("coordinated", 1, "apf_rrtconnect"): ("60/60", "60/60", "60/60", "60/60", "53/60", "53/60"),
        ("coordinated", 1, "rrtconnect"): ("-", "-", "57/60", "57/60", "0/60", "0/60"),
    }
)
"""Tables 5.1 to 5.4 and 5.6, by experiment, position and column. Its right hand was a five-fingered one: two
grippers are not like for like."""

TIMES: Final = MappingProxyType(
    {
        "dual": (175.01, 31.35, 32.38, 64.15, 18.20, 26.57, 238.74),
        "sequential": (86.92, 31.27, 33.08, 50.74, 18.22, 31.40, 251.63),
    }
)
"""Table 5.5: seconds; APF, pick and home of the left arm, of the right arm, and in all."""
TIME_ROWS: Final = (
    "APF time left",
    "pick time left",
    "home time left",
    "APF time right",
    "pick time right",
    "home time right",
    "total time",
)

OFFSETS: Final = MappingProxyType(
    {
        "apf_rrtconnect": ((0.00088, 0.06419), (0.00090, 0.08251)),
        "rrtconnect": ((0.10950, 0.12623), (0.10956, 0.12624)),
    }
)
"""Table 5.7: mean (signed, or it could not be so small) and deviation of the offset (m), left and right."""
