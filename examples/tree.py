"""Print the running tree with nothing but zenoh and json: ``python tree.py [ROUTER] [KEYS]``."""
# ruff: noqa: INP001, T201 - an example: a file of its own that prints

import json
import sys

import zenoh

router, keys = (*sys.argv[1:], *("tcp/127.0.0.1:7447", "lab/tiago")[len(sys.argv) - 1 :])


def show(node: dict[str, object], depth: int) -> None:
    """Print a node and all below it, one in a line."""
    print(f"{'  ' * depth}{node['name']}: {node['status']} {node['message']}")
    for child in node["children"]:  # type: ignore[attr-defined]
        show(child, depth + 1)


config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([router]))
with zenoh.open(config) as session:
    for reply in session.get(f"{keys}/tree/now", payload="{}"):
        if reply.ok is not None:
            show(json.loads(reply.ok.payload.to_bytes())["root"], 0)
