"""CPU time of the recorder beside a robot at work: ``python -m benchmarks.recorder [--seconds S]``.

It starts a whole simulated robot in real time, has it fetch an item, and reads the recorder's CPU time from
/proc while that goes on. Run it alone: the figures are shares of a core in real time.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from dataclasses import replace
from pathlib import Path

from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.process_usage import processor_seconds
from tandem.executive.system.roles.recorder import NAME
from tandem.skills.ports.isolation import isolate_children
from tandem.skills.ports.tasks import REQUEST
from tandem.skills.wire.clocks import HostClocks


def resident(pid: int) -> float:
    """Return a process's resident memory in MB."""
    pages = int(Path(f"/proc/{pid}/statm").read_text("utf-8").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def measure(options: RunOptions, seconds: float) -> tuple[float, float]:
    """Return the recorder's share of a core, and its memory in MB, over so many seconds of a fetch."""
    clocks = HostClocks()
    with ProcessSystem(options) as system:
        pid = system.pids()[NAME]
        system.bus.publish(REQUEST, b'{"task": "fetch", "item": 29}')
        before, began = processor_seconds(pid), clocks.monotonic()
        while clocks.monotonic() - began < seconds:
            system.advance()
        return (processor_seconds(pid) - before) / (clocks.monotonic() - began), resident(pid)


def main() -> None:
    """Measure the black box alone, then with recordings."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--connect", default="tcp/127.0.0.1:7600")
    asked = parser.parse_args()
    isolate_children(os.environ)
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder)
        box = RunOptions(bus=BusOptions(endpoint=asked.connect), data=data / "data", black_box=True)
        kinds = {
            "black box": box,
            "with a recording": replace(box, record=data / "plain", record_pictures=False),
            "with pictures": replace(box, record=data / "pictures"),
        }
        for name, options in kinds.items():
            share, memory = measure(options, asked.seconds)
            written = 0 if options.record is None else sum(f.stat().st_size for f in options.record.iterdir())
            print(f"{name}: {share:.1%} of a core, {memory:.0f} MB, {written / asked.seconds / 1e6:.2f} MB/s")


if __name__ == "__main__":
    main()
