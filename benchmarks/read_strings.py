"""What pydantic keeps of strings that were read: ``python -m benchmarks.read_strings``.

Once as messages are read, and once with the cache that pydantic uses unless it is told otherwise. Each read
names another goal, as the goals of one task after the other do.
"""

from __future__ import annotations

import os
import sys
from typing import Final

from pydantic import ConfigDict

from tandem.executive.system.process_usage import anonymous_memory
from tandem.skills.ports.action import AskResult

READS: Final = (4_000, 8_000, 16_000, 32_000, 64_000)


class Cached(AskResult):
    """The same message, with pydantic's default."""

    model_config = ConfigDict(cache_strings="all")


def main() -> int:
    """Print the anonymous memory that was gained, for each way and number of strings."""
    for how, model in (("as messages are read", AskResult), ("with the cache", Cached)):
        before, read = anonymous_memory(os.getpid()), 0
        for reads in READS:
            for number in range(read, reads):
                model.model_validate_json(
                    b'{"goal_id":"fetch-5d1f0a7c-0001/look again at spot/%06d"}' % number
                )
            read = reads
            gained = anonymous_memory(os.getpid()) - before
            print(f"{how:20s} {reads:6d} strings: {gained / 1e6:.2f} MB", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
