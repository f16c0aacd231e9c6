"""Follow a task to its end with nothing but zenoh and json: ``python watch.py TASK [ROUTER] [KEYS]``."""
# ruff: noqa: INP001, T201 - an example: a file of its own that prints

import json
import queue
import sys

import zenoh

task, router, keys = (*sys.argv[1:], *("", "tcp/127.0.0.1:7447", "lab/tiago")[len(sys.argv) - 1 :])
ENDED = {"SUCCEEDED", "FAILED", "CANCELED", "EXPIRED", "INTERRUPTED", "REJECTED"}
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([router]))
statuses: "queue.Queue[dict[str, object]]" = queue.Queue()
with zenoh.open(config) as session:
    # First listen, then ask how it stands: nothing can happen unseen in between. One key has the statuses
    # of all tasks; a subscription for each task would cost the router memory that it never gives back.
    listening = session.declare_subscriber(
        f"{keys}/task/status", lambda sample: statuses.put(json.loads(sample.payload.to_bytes()))
    )
    for reply in session.get(f"{keys}/task/list", payload="{}"):
        if reply.ok is not None:
            for known in json.loads(reply.ok.payload.to_bytes())["tasks"]:
                if known["task"] == task:
                    statuses.put(known)
    while True:
        status = statuses.get(timeout=60.0)
        if status["task"] != task:
            continue
        print(status["state"], status["progress"])
        if status["state"] in ENDED:
            break
