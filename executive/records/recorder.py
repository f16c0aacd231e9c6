"""The recorder: hears everything, keeps the last minute, and writes it down when something has gone wrong."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final, Protocol

from tandem.executive.records.attaching import Attaching
from tandem.executive.records.boxes import Boxes
from tandem.executive.records.ears import Ears, Stamper
from tandem.executive.records.incidents import Incidents
from tandem.executive.records.recording import Attachment, Facts, Recorded
from tandem.executive.records.ring import Ring
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.records import TASK_RECORDS, AskRecords, Cause, RecordingFile, Records
from tandem.skills.ports.serving import Endpoints

AFTER: Final = 2.0
"""Host seconds that a black box goes on after what went wrong: the last status and tree come within one."""
MOST_CAUSES: Final = 16
"""Things that one file names; what goes wrong again and again within two seconds is told by the first."""

_LOG = logging.getLogger(__name__)


class Sink(Protocol):
    """Who else takes what is heard: a recording under way."""

    def take(self, messages: Iterable[Recorded]) -> None:
        """Take in what was heard."""
        ...

    def attach(self, attachment: Attachment) -> None:
        """Take in a document beside it."""
        ...

    def close(self) -> None:
        """Write down what has not been yet."""
        ...


@dataclass(frozen=True)
class Host:
    """The host's clocks, in nanoseconds."""

    clocks: Clocks

    def offset(self) -> int:
        """Return what lies between the monotonic clock and 1970."""
        return round((self.clocks.utc() - self.clocks.monotonic()) * 1e9)

    def now(self) -> int:
        """Return nanoseconds since 1970."""
        return round(self.clocks.utc() * 1e9)


class Recorder:
    """A ``Node``.

    Args:
        bus: where it asks and is asked.
        ears: what it hears.
        clocks: the host's.
        facts: what all its records are of.
        boxes: where black boxes go; None: none is written.
        sinks: who else takes what is heard.
        ring: the last minute.
        recordings: tells which recordings are kept.
    """

    name = "recorder"

    def __init__(
        self,
        bus: Bus,
        ears: Ears,
        clocks: Clocks,
        *,
        facts: Facts,
        boxes: Boxes | None,
        sinks: Iterable[Sink] = (),
        ring: Ring | None = None,
        recordings: Callable[[], tuple[RecordingFile, ...]] = tuple,
    ) -> None:
        self._bus, self._ears, self._clocks, self._facts = bus, ears, clocks, facts
        self._boxes, self._sinks, self._host = boxes, tuple(sinks), Host(clocks)
        self._ring = Ring() if ring is None else ring
        self._stamper, self._incidents = Stamper(bus.ear), Incidents(bus.ear)
        self._attaching = Attaching(bus, clocks.monotonic, self._attached)
        self._recordings = recordings
        self._causes: list[Cause] = []
        self._due: float | None = None
        self.newest: Recorded | None = None
        """The last message that was heard."""
        self._writing: threading.Thread | None = None
        served = answering(TASK_RECORDS, self._known)
        self._endpoints = Endpoints(bus, clocks.monotonic, (served,))

    def step(self) -> bool:
        """Take in what was heard; write what is due."""
        alive = self._bus.alive()
        heard = self._stamper.stamped(self._ears.drain(), self._host.offset())
        who = self._stamper.alive(alive, self._host.now())
        if who is not None:
            heard.append(who)
        for message in heard:
            self._ring.add(message)
            self._attaching.hear(message)
            self._note(self._incidents.hear(message))
        self.newest = heard[-1] if heard else self.newest
        self._note(self._incidents.look(alive, self.newest))
        for sink in self._sinks:
            sink.take(heard)
        self._attaching.step(self._stamper.at)
        if self._due is not None and self._clocks.monotonic() >= self._due:
            self._write()
        return self._endpoints.step()

    def close(self) -> None:
        """Write what is due, and have the sinks closed."""
        self.step()
        if self._due is not None:
            self._write()
        if self._writing is not None:
            self._writing.join()
        self._ears.close()
        self._endpoints.close()
        for sink in self._sinks:
            sink.close()

    def _attached(self, attachment: Attachment) -> None:
        for sink in self._sinks:
            sink.attach(attachment)

    def _known(self, asked: AskRecords) -> Records:
        boxes = () if self._boxes is None else self._boxes.known(asked.task)
        return Records(boxes=boxes, recordings=self._recordings())

    def _note(self, cause: Cause | None) -> None:
        if cause is None or self._boxes is None:
            return
        if len(self._causes) < MOST_CAUSES:
            self._causes.append(cause)
        if self._due is None:
            self._due = self._clocks.monotonic() + AFTER

    def _write(self) -> None:
        """Write a black box, beside the loop: compressing a minute takes half a second."""
        self._due = None
        causes, self._causes = tuple(self._causes), []
        if self._writing is not None:
            self._writing.join()
        facts = self._facts.model_copy(update={"causes": causes})
        wanted: Callable[[], None] = _Writing(
            self._boxes, self._clocks.utc(), facts, self._ring, self._attaching.all
        )
        self._writing = threading.Thread(target=wanted, name="black box", daemon=True)
        self._writing.start()


class _Writing:
    """A black box that is to be written: what it holds is settled when this is made."""

    def __init__(
        self,
        boxes: Boxes | None,
        utc: float,
        facts: Facts,
        ring: Ring,
        attachments: tuple[Attachment, ...],
    ) -> None:
        assert boxes is not None, "only where boxes are kept something is due"
        self._boxes, self._utc, self._facts, self._attachments = boxes, utc, facts, attachments
        self._span, self._kept = ring.span, ring.kept()

    def __call__(self) -> None:
        messages = self._kept.messages()
        try:
            path = self._boxes.keep(self._utc, self._facts, self._span, self._attachments, messages)
        except OSError as error:
            where = error.filename or self._boxes.folder
            _LOG.error("no black box was written: %s: %s", where, error.strerror or error)
            return
        words = "; ".join(cause.words for cause in self._facts.causes)
        _LOG.info("black box written", extra={"file": str(path), "why": words, "task": self._task()})

    def _task(self) -> str:
        return next((cause.task for cause in self._facts.causes if cause.task), "")
