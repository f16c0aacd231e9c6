"""Ask for item 29 with nothing but zenoh and json: ``python request.py [ITEM] [ROUTER] [KEYS]``."""
# ruff: noqa: INP001, T201 - an example: a file of its own that prints

import json
import sys

import zenoh

item, router, keys = (*sys.argv[1:], *("29", "tcp/127.0.0.1:7447", "lab/tiago")[len(sys.argv) - 1 :])
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([router]))
with zenoh.open(config) as session:
    request = json.dumps({"task": "fetch", "item": int(item)})
    replies = list(session.get(f"{keys}/task/request", payload=request))
answers = [json.loads(reply.ok.payload.to_bytes()) for reply in replies if reply.ok is not None]
print(answers[0] if answers else "no executive answered; start the system with `tandem up`")
