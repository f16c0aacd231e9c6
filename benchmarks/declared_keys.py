"""What zenoh keeps of a key that was declared: ``python -m benchmarks.declared_keys``.

A router and a client, each a process. For each way to use a key, a thousand keys that are used once, and the
anonymous memory that both have gained.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from collections.abc import Callable
from typing import Final

import zenoh

from tandem.executive.system.process_usage import anonymous_memory
from tandem.skills.wire.configs import client_config, router_config

KEYS: Final = 1000
WAYS: Final[dict[str, Callable[[zenoh.Session, str], object]]] = {
    "put, not declared": lambda session, key: session.put(key, b"1"),
    "get": lambda session, key: list(session.get(key, timeout=1.0)),
    "publisher": lambda session, key: session.declare_publisher(key).undeclare(),  # type: ignore[no-untyped-call]
    "subscriber": lambda session, key: session.declare_subscriber(key, print).undeclare(),  # type: ignore[no-untyped-call]
    "queryable": lambda session, key: session.declare_queryable(key, print).undeclare(),  # type: ignore[no-untyped-call]
    "token": lambda session, key: session.liveliness().declare_token(key).undeclare(),  # type: ignore[no-untyped-call]
}


def main() -> int:
    """Print a line for each way, or be the router when told an endpoint."""
    if len(sys.argv) > 1:
        session = zenoh.open(router_config(sys.argv[1]))
        print("listens", flush=True)
        sys.stdin.read()
        session.close()  # type: ignore[no-untyped-call]
        return 0
    with socket.create_server(("127.0.0.1", 0)) as probe:
        endpoint = f"tcp/127.0.0.1:{probe.getsockname()[1]}"
    with subprocess.Popen(  # noqa: S603 - this module itself
        [sys.executable, "-m", "benchmarks.declared_keys", endpoint],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    ) as router:
        assert router.stdout is not None
        router.stdout.readline()
        session = zenoh.open(client_config(endpoint, 5.0, None, pictures=False))
        for name, use in WAYS.items():
            use(session, f"warm/{name.replace(' ', '')}")
            before = anonymous_memory(router.pid), anonymous_memory(os.getpid())
            for number in range(KEYS):
                use(session, f"{name.replace(' ', '')}/{number}")
            list(session.get("all/through", timeout=1.0))
            after = anonymous_memory(router.pid), anonymous_memory(os.getpid())
            kept = [(then - first) / KEYS for first, then in zip(before, after, strict=True)]
            print(f"{name:18s} router {kept[0]:6.0f}, client {kept[1]:6.0f} bytes a key", flush=True)
        session.close()  # type: ignore[no-untyped-call]
        router.kill()
    return 0


if __name__ == "__main__":
    sys.exit(main())
