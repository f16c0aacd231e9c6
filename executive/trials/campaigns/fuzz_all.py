"""Every served key of every process, fuzzed: what may be asked is answered, and nobody falls over.

Hardware, simulator, skills, keeper and executive run in lockstep, in one thread. Whatever is sent to a served
key, at its own key or with a wildcard, each query ends; a command is answered; a wildcard is answered by keys
that may be read, each under its own name; and no handler raises, which its log would say.
"""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from tandem.executive.system.lockstep import Lockstep
from tandem.executive.trials.campaigns.fuzz_inputs import Input, feed_drawn
from tandem.executive.trials.campaigns.fuzz_keys import IDS, inputs_of, service_of, services
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.action import command_service
from tandem.skills.ports.hardware import Stop
from tandem.skills.ports.keys import STOP
from tandem.skills.ports.message import Message
from tandem.skills.wire.memory import MemoryPending

AT_ONCE: Final = 4
"""Inputs between two periods of the system."""
WITHIN: Final = 400
"""Periods in which a query must have ended: the camera's picture has two seconds."""
STOP_EVERY: Final = 50
"""Inputs after which the stop is set again: what is accepted moves nothing for long."""
CHUNK: Final = 5000
"""Inputs for one system, after which there is a new one."""


class AllCounts(Message):
    """What became of the inputs."""

    inputs: int
    keys: dict[str, int]
    """Inputs by the key that was served."""
    answered: int
    refused: int
    """With an error reply; commands refuse in their own answers."""
    silent: int
    """Ended without an answer, as a wildcard at a command's key does."""
    seed: int = 1
    broken: str = ""
    """The inputs after which something was wrong, and what; empty when nothing was."""


@dataclass(eq=False)
class _Sent:
    each: Input
    pending: MemoryPending
    unserved: bool
    """Nobody served the key when it was sent: a skill begins anew after each boot of the hardware."""
    age: int = 0


class _Raised(logging.Handler):
    """Keeps what was logged with a trace."""

    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.lines: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        """Keep it."""
        if record.exc_info is not None:
            self.lines.append(f"{record.name}: {record.getMessage()}: {record.exc_info[1]!r}")


class Everything:
    """A whole system that is fed one input after the other."""

    def __init__(self) -> None:
        self.system = Lockstep(load_scenario("Demo"), 1)
        self.counts, self.keys = Counter[str](), Counter[str]()
        self._known, self._sent, self._fed = services(), list[_Sent](), 0
        self._raised = _Raised()
        logging.getLogger().addHandler(self._raised)
        for _ in range(20):
            self.system.step()
        self._at_first = frozenset(self.served)

    @property
    def served(self) -> tuple[str, ...]:
        """The keys that are served, as they are declared."""
        return tuple(dict.fromkeys(desk.expression for desk in self.system.hub.desks))

    def feed(self, each: Input) -> None:
        """Send it, and look at what has ended meanwhile; AssertionError when something is wrong."""
        pending = self.system.bus.query(each.key, each.payload)
        assert isinstance(pending, MemoryPending)
        self._sent.append(_Sent(each, pending, self._unserved(each)))
        self._fed += 1
        if self._fed % STOP_EVERY == 0:
            STOP.query(self.system.bus, Stop(by="fuzz", reason="as often as that"))
        if self._fed % AT_ONCE == 0:
            self._go_on()

    def flush(self) -> None:
        """Wait for all that is under way, and until whatever was served at first is served again."""
        for _ in range(WITHIN + 1):
            gone = self._at_first.difference(self.served)
            if not self._sent and not gone:
                return
            self._go_on()
        assert not gone, f"nobody serves {sorted(gone)} any more"

    def close(self) -> None:
        """End the system."""
        logging.getLogger().removeHandler(self._raised)
        self.system.close()

    def _go_on(self) -> None:
        self.system.step()
        assert not self._raised.lines, self._raised.lines
        for sent in self._sent:
            sent.age += 1
            if sent.pending.done():
                self._judge(sent)
            else:
                assert sent.age < WITHIN, f"{sent.each.key} has not ended"
        self._sent = [sent for sent in self._sent if not sent.pending.done()]

    def _judge(self, sent: _Sent) -> None:
        each, pending = sent.each, sent.pending
        self.keys[each.key if "*" not in each.key else "(a wildcard)"] += 1
        if pending.refusal() is not None:
            self.counts["refused"] += 1
        elif pending.replies:
            self.counts["answered"] += 1
        else:
            self.counts["silent"] += 1
        for key in pending.replies:
            assert "*" not in key, f"{each.key} was answered under {key}"
            service = service_of(key, self._known)
            if "*" in each.key:
                assert service is None or service.reads, f"{each.key} was answered by {key}, a command"
        service = None if "*" in each.key else service_of(each.key, self._known)
        if service is not None and not service.reads and pending.refusal() is None:
            if not pending.replies and each.key.startswith("hw/") and self.system.station.silent:
                return  # a fault that was asked for cuts the hardware's line
            if not pending.replies and (sent.unserved or self._unserved(each)):
                return  # ended by a boot that was asked for; ``flush`` looks whether it is served again
            assert pending.replies, f"{each.key} was not answered"
            service.decode_answer(pending.replies[each.key])
            self._cancel(each)

    def _unserved(self, each: Input) -> bool:
        """Say whether nobody serves the key now."""
        return each.key in self._at_first and each.key not in self.served

    def _cancel(self, each: Input) -> None:
        """Have a goal that was perhaps accepted come to rest, so that others may be accepted."""
        if not each.key.startswith("skill/") or not each.key.endswith("/goal"):
            return
        action = each.key.removeprefix("skill/").removesuffix("/goal")
        for goal_id in IDS:
            document = b'{"goal_id": "%s", "command": "CANCEL"}' % goal_id.encode()
            self.system.bus.query(command_service(action).key, document)


def fuzz_all(count: int, start: int, say: Callable[[int], None] = lambda _: None) -> AllCounts:
    """Feed so many inputs; stop where something is wrong.

    Args:
        count: how many.
        start: the seed.
        say: told how many there have been, now and then.
    """
    fed, counts, keys, broken = 0, Counter[str](), Counter[str](), ""
    while fed < count and not broken:
        target = Everything()
        here, broken = _chunk(target, min(CHUNK, count - fed), start + fed)
        fed += here
        counts += target.counts
        keys += target.keys
        target.close()
        say(fed)
    told = {name: counts[name] for name in ("answered", "refused", "silent")}
    return AllCounts(inputs=fed, seed=start, keys=dict(sorted(keys.items())), broken=broken, **told)


def _chunk(target: Everything, count: int, start: int) -> tuple[int, str]:
    """Feed one system; return how many inputs it had, and what went wrong."""
    fed, last = 0, list[Input]()

    def feed(each: Input) -> None:
        nonlocal fed
        fed += 1
        last.append(each)
        del last[:-AT_ONCE]
        target.feed(each)

    try:
        feed_drawn(inputs_of(target.served), count, start, feed)
        target.flush()
    except Exception as error:  # noqa: BLE001 - whatever it is, it is what was looked for
        shown = "; ".join(f"{each.key} {each.payload[:300]!r}" for each in last)
        # hypothesis feeds it once more, where it may go well: the first error is the one that was looked for.
        first = error.exceptions[0] if isinstance(error, ExceptionGroup) else error
        return fed, f"{type(first).__name__}: {first} after {shown}"
    return fed, ""
