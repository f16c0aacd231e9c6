"""No connection of the router waits for its peer when it is closed."""

from __future__ import annotations

import socket
import struct

from tandem.skills.wire.linger import close_at_once


def lingers(connection: socket.socket) -> tuple[int, int]:
    on, seconds = struct.unpack("ii", connection.getsockopt(socket.SOL_SOCKET, socket.SO_LINGER, 8))
    return on, seconds


def test_connections_are_told_not_to_linger() -> None:
    with (
        socket.create_server(("127.0.0.1", 0)) as server,
        socket.create_connection(server.getsockname()) as near,
    ):
        far, _ = server.accept()
        with far:
            far.setblocking(False)
            for each in (near, far):
                each.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 10))
            close_at_once()
            assert [lingers(each)[0] for each in (near, far)] == [0, 0]
            assert far.getblocking() is False, "what else was set stays"
            near.sendall(b"still open")
            assert server.fileno() > 0
