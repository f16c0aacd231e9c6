"""Ask for item 29 and follow it with the typed client: ``python client_sync.py [ITEM] [ROUTER]``."""
# ruff: noqa: INP001, T201 - an example: a file of its own that prints

import sys

from tandem.client import Client, RejectedError

item, router = (*sys.argv[1:], *("29", "tcp/127.0.0.1:7447")[len(sys.argv) - 1 :])

with Client(router) as client:
    try:
        task = client.submit({"task": "fetch", "item": int(item), "to": "depot"})
    except RejectedError as rejected:
        sys.exit(str(rejected))
    for status in client.watch(task, timeout=600.0):
        print(f"{status.state} {status.progress.phase} {status.progress.fraction:.0%}")
    if status.failure is not None:
        print(client.why(task))
