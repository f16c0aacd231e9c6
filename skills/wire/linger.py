"""Takes the patience of closing out of a router's connections.

zenoh has each TCP connection linger for 10 s when it is closed with something unsent (``SO_LINGER``), and
closes it in a thread that other connections need. A reader that stands still is given up after 10 s, its
connection full: with a few of those at once the whole router stands still for another 10 s. zenoh has no
setting for it (1.10). The sockets are this process's own, so they are told not to linger; what is unsent goes
out all the same.
"""

from __future__ import annotations

import os
import socket
import stat
import struct
from contextlib import suppress
from pathlib import Path
from typing import Final

_OFF: Final = struct.pack("ii", 0, 0)
_FILES: Final = Path("/dev/fd")


def close_at_once() -> None:
    """Have no TCP connection of this process linger when it is closed; call it again for those that come."""
    for file in _FILES.iterdir():
        with suppress(OSError, ValueError):  # gone meanwhile, or no number
            if stat.S_ISSOCK(os.fstat(int(file.name)).st_mode):
                _dont_linger(int(file.name))


def _dont_linger(file: int) -> None:
    # A copy of the descriptor: zenoh may close its own at any time, and another file may get its number.
    with socket.socket(fileno=os.dup(file)) as connection:
        if connection.family in {socket.AF_INET, socket.AF_INET6} and connection.type == socket.SOCK_STREAM:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _OFF)
