"""Runs a short lockstep in a process of its own and prints its hashes: ``digest_child.py SECONDS``."""

from __future__ import annotations

import json
import sys

from tandem.executive.system.lockstep import Digest, Lockstep
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import REQUEST

BEFORE_THE_TABLE = FloorPose(x=-0.55, y=0.50, yaw=0.0)


def main(seconds: str) -> None:
    """Fetch item 29 from where it is in view, for so many robot seconds; one line a robot second."""
    lockstep = Lockstep(load_scenario("Demo").starting_at(BEFORE_THE_TABLE), seed=3)
    digest = Digest()
    lockstep.hub.watch(digest)
    lockstep.bus.query(REQUEST, json.dumps({"task": "fetch", "item": 29}).encode())
    for second in range(1, int(seconds) + 1):
        lockstep.run_until(lambda: False, within=1.0)
        sys.stdout.write(f"second {second} {digest.messages} {digest.hexdigest()}\n")
        sys.stdout.flush()
    lockstep.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
