"""A run in lockstep that is recorded, and one that is held to a record of it, message by message."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Final

from tandem.executive.records.ears import MemoryEars
from tandem.executive.records.recorder import Recorder, Sink
from tandem.executive.records.recording import Attachment, Facts, Recorded, Recording
from tandem.executive.system.systems import LockstepSystem
from tandem.sim.scenario import Scenario
from tandem.skills.testing.faulty_bus import BusFaults

if TYPE_CHECKING:
    from tandem.executive.records.mcap_writing import McapFile
    from tandem.executive.records.pictures import Pictures

EVERY: Final = 10
"""Periods between two looks of the recorder: 0.1 s, as beside a robot."""


class ReachedError(RuntimeError):
    """A run that is held to a record came to its end, or to the first message that differs.

    Args:
        at: robot seconds of the moment.
        words: what was found there.
        same: whether all was as recorded.
    """

    def __init__(self, at: float, words: str, *, same: bool) -> None:
        super().__init__(words)
        self.at, self.words, self.same = at, words, same


class RecordedLockstep(LockstepSystem):
    """A run in lockstep with a recorder beside it: the same run each time, as long as it has one.

    Args:
        scenario: where all starts.
        seed: of all that is random.
        facts: what the record is of.
        sinks: who takes what is heard.
        bus_faults: what happens to messages that skills and executive receive.
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
        digest: take every message into a hash.
        write_pictures: has pictures written into a file; None: nobody listens to the cameras.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int,
        *,
        facts: Facts,
        sinks: Iterable[Sink],
        bus_faults: BusFaults | None = None,
        left_out: Mapping[str, str] | None = None,
        digest: bool = False,
        write_pictures: Callable[[Callable[[McapFile], None]], None] | None = None,
    ) -> None:
        super().__init__(scenario, seed, digest=digest, bus_faults=bus_faults, left_out=left_out)
        ears = MemoryEars(self.lockstep.hub, self.clocks.monotonic)
        end = self.lockstep.hub.endpoint()
        self._recorder = Recorder(end, ears, self.clocks, facts=facts, boxes=None, sinks=sinks)
        self._pictures: Pictures | None = None
        if write_pictures is not None:
            from tandem.executive.records.pictures import Pictures  # noqa: PLC0415 - cv2, and of the extra `record`

            self._pictures = Pictures(end, self.clocks.monotonic, write_pictures)
        self._periods = 0

    def advance(self) -> None:
        """Let one period pass.

        Raises:
            ReachedError: from a sink that holds the run to a record.
        """
        super().advance()
        self._periods += 1
        if self._periods % EVERY == 0:
            self._recorder.step()
            if self._pictures is not None:
                self._pictures.step(self._recorder.newest)

    def close(self) -> None:
        """End the record, and all nodes."""
        try:
            if self._pictures is not None:
                self._pictures.close()
            self._recorder.close()
        finally:
            super().close()


class HeldTo:
    """Holds what is heard to a record; implements ``recorder.Sink``.

    Args:
        record: of a run in lockstep.
        until: robot seconds at which it is enough.
    """

    def __init__(self, record: Recording, until: float) -> None:
        self._recorded: Iterator[Recorded] = record.messages()
        self._until, self._ended = until, False

    def take(self, messages: Iterable[Recorded]) -> None:
        """Compare messages.

        Raises:
            ReachedError: at the moment, or at the first message that differs.
        """
        for message in messages:
            if self._ended:
                return
            expected = next(self._recorded, None)
            if expected is None or message.at > self._until:
                self._end(message.at, f"the run is as recorded up to {message.at:.2f} s", same=True)
            elif (message.key, message.payload, message.at) != (expected.key, expected.payload, expected.at):
                words = f"the run differs from the record at {message.at:.2f} s: "
                self._end(message.at, words + _difference(expected, message), same=False)

    def attach(self, attachment: Attachment) -> None:
        """Take in no document: messages say more."""

    def close(self) -> None:
        """Hold it to nothing more."""
        self._ended = True

    def _end(self, at: float, words: str, *, same: bool) -> None:
        self._ended = True
        raise ReachedError(at, words, same=same)


def _difference(expected: Recorded, found: Recorded) -> str:
    if expected.key != found.key:
        return f"expected {expected.key}, found {found.key}"
    place = next(
        (
            number
            for number, (one, other) in enumerate(zip(expected.payload, found.payload, strict=False))
            if one != other
        ),
        min(len(expected.payload), len(found.payload)),
    )
    around = slice(max(0, place - 20), place + 40)
    told = [each[around].decode("utf-8", "replace") for each in (expected.payload, found.payload)]
    return f"{found.key}: expected ...{told[0]}..., found ...{told[1]}..."
