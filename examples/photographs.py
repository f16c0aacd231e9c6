"""Photograph the simulated robot at work: ``python photographs.py [FOLDER] [ROUTER] [KEYS]``.

Run it beside ``tandem up`` and then ask for something. It takes a picture whenever one of the steps below has
ended, and ends with the task. ``sim/photograph`` is the stand-in's: a real robot has no such key.
"""
# ruff: noqa: INP001, T201 - an example: a file of its own that prints

import json
import queue
import sys
from collections.abc import Iterator
from pathlib import Path

import zenoh

VIEWS = {
    "retract": {"eye": [1.0, 2.3, 1.6], "target": [0.1, 0.55, 0.75]},
    "put down": {"eye": [-0.5, -2.6, 1.7], "target": [-2.2, -1.1, 0.7]},
}
"""Where to photograph from and towards, in map (metres), by the step that has just ended."""


def steps(node: dict[str, object]) -> Iterator[tuple[str, str]]:
    """Yield name and status of a tree's leaves."""
    children = node["children"]
    if not isinstance(children, list) or not children:
        yield str(node["name"]), str(node["status"])
        return
    for child in children:
        yield from steps(child)


folder, router, keys = (*sys.argv[1:], *(".", "tcp/127.0.0.1:7447", "lab/tiago")[len(sys.argv) - 1 :])
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([router]))
arrived: queue.Queue[tuple[str, bytes]] = queue.Queue()
with zenoh.open(config) as session:
    subscribers = [
        session.declare_subscriber(
            f"{keys}/{key}", lambda sample: arrived.put((str(sample.key_expr), sample.payload.to_bytes()))
        )
        for key in ("tree/snapshot", "task/status")
    ]
    waiting = dict(VIEWS)
    while waiting:
        key, payload = arrived.get()
        document = json.loads(payload)
        if key.endswith("task/status"):
            if document["state"] in {"SUCCEEDED", "FAILED", "CANCELED"}:
                print(f"the task {document['state'].lower()}; not photographed: {', '.join(waiting)}")
                break
            continue
        ended = {name for name, status in steps(document["root"]) if status == "SUCCESS"}
        for step in [step for step in waiting if step in ended]:
            asked = json.dumps({**waiting.pop(step), "width": 960, "height": 600})
            for reply in session.get(f"{keys}/sim/photograph", payload=asked, timeout=10.0):
                if reply.ok is not None:
                    path = Path(folder) / f"{step.replace(' ', '-')}.png"
                    path.write_bytes(reply.ok.payload.to_bytes())
                    print(path)
