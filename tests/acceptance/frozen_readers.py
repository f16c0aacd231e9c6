"""A fetch while other programs on the bus stand still: does anybody notice?

``python -m tests.acceptance.frozen_readers [READERS] [--thawing]`` starts the Demo scenario with real
processes, subscribes to ``**`` in so many programs (3), stops them with SIGSTOP, requests a fetch of item 29,
and prints the longest time without a beat of each process, what had to be recovered, and the machine's load.
It ends with 0 when the task succeeded without any recovery and no gap was above 0.3 s.

zenoh gives up a program that stands still for 10 s. With ``--thawing`` each goes on for a second after eight,
so that none is given up and all are in the way for the whole task.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import zenoh

from tests.fakes.ports import free_endpoint
from tests.outside._readers import Reader, readers
from tests.outside._up import client, until, up

SITE: Final = "still"
PREFIX: Final = f"{SITE}/tiago"
ALLOWED: Final = 0.3
"""Seconds: others say that a process hangs after that (``skills/wire/pulse.py``)."""
FETCH_WITHIN: Final = 1200.0
FROZEN, THAWED = 8.0, 1.0


@dataclass
class Beats:
    """The longest time without a beat, by process."""

    last: dict[str, float] = field(default_factory=dict)
    longest: dict[str, float] = field(default_factory=dict)
    counts: bool = False

    def __call__(self, sample: zenoh.Sample) -> None:
        now = time.monotonic()
        for name in sample.payload.to_string().split("\n"):
            if name.startswith("process/"):
                if self.counts and name in self.last:
                    self.longest[name] = max(self.longest.get(name, 0.0), now - self.last[name])
                self.last[name] = now

    def finish(self) -> None:
        """Count the time since the last beat of each, too."""
        self.counts, now = False, time.monotonic()
        for name, last in self.last.items():
            self.longest[name] = max(self.longest.get(name, 0.0), now - last)


def say(text: str) -> None:
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()


def fetch(session: zenoh.Session, still: Sequence[Reader], *, thawing: bool) -> dict[str, Any]:
    """Request it and wait for its end; return its last status."""
    request = json.dumps({"task": "fetch", "item": 29, "to": "depot"})
    (reply,) = session.get(f"{PREFIX}/task/request", payload=request)
    assert reply.ok is not None
    answer = json.loads(reply.ok.payload.to_bytes())
    assert answer["accepted"], answer
    status: dict[str, Any] = {}
    turn, asked = time.monotonic() + FROZEN, 0.0
    frozen, began, told = True, time.monotonic(), ""

    def ended() -> bool:
        nonlocal turn, frozen, asked, told
        now = time.monotonic()
        if thawing and now >= turn:
            frozen = not frozen
            turn = now + (FROZEN if frozen else THAWED)
            for reader in still:
                reader.freeze() if frozen else reader.thaw()
        if now - asked < 1.0:
            return False
        asked = now
        for each in session.get(f"{PREFIX}/task/list"):
            if each.ok is not None:
                (found,) = json.loads(each.ok.payload.to_bytes())["tasks"]
                status.update(found)
        phase = status.get("progress", {}).get("phase", "")
        if phase != told:
            told = phase
            say(f"{now - began:6.1f} s  {phase}")
        return status.get("ended") is not None

    until(ended, FETCH_WITHIN)
    return status


def main(words: Sequence[str]) -> int:
    """Run it, print what came of it."""
    numbers = [int(word) for word in words if word.isdigit()]
    count, thawing = numbers[0] if numbers else 3, "--thawing" in words
    endpoint, beats = free_endpoint(), Beats()
    with (
        tempfile.TemporaryDirectory() as folder,
        up(endpoint, SITE, Path(folder)) as said,
        client(endpoint) as session,
        readers(endpoint, "**", count) as still,
    ):
        listening = session.declare_subscriber(f"{PREFIX}/beat/*", beats)
        until(lambda: len(beats.last) > 1, 10.0)
        for reader in still:
            reader.freeze()
        beats.counts = True
        status = fetch(session, still, thawing=thawing)
        beats.finish()
        listening.undeclare()  # type: ignore[no-untyped-call]
        log = said.read_text()
    for name, longest in sorted(beats.longest.items()):
        say(f"{name:24} {longest:6.3f} s without a beat at the most")
    tried = [f"{each['failure']['kind']} {each['recovery']}" for each in status["tried"]]
    restarted = [line for line in log.splitlines() if "again" in line]
    say(
        f"{count} frozen readers of **{', thawing' if thawing else ''}: {status['state']}; recovered: {tried}"
    )
    say(f"restarts: {restarted}; load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    good = status["state"] == "SUCCEEDED" and not tried and not restarted
    return 0 if good and max(beats.longest.values()) <= ALLOWED else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
