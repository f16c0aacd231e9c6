"""What the role ``recorder`` is made of."""

from __future__ import annotations

import logging
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import TYPE_CHECKING, Final

from tandem.executive.config.extras import words_on_module
from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.records.boxes import FOLDER, Boxes
from tandem.executive.records.ears import DEPTH, HEARD, OF_SITE
from tandem.executive.records.recorder import Recorder
from tandem.executive.records.recording import Facts
from tandem.executive.records.recordings import recordings_in
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.records import TASK_RECORDING
from tandem.skills.wire.clocks import HostClocks
from tandem.skills.wire.zenoh_bus import ZenohBus

if TYPE_CHECKING:
    from tandem.executive.records.pictures import Pictures
    from tandem.executive.records.recording_sink import RecordingSink

_LOG = logging.getLogger(__name__)
TURN: Final = 0.1
"""Host seconds between two looks. Messages carry their own times; a process must beat within 0.3 s."""


def record(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    """Record until ``stopped`` says so.

    Args:
        settings: of the process.
        bus: of the process; nothing that is heard on it wakes the loop.
        stopped: says when to end.
    """
    clocks = HostClocks()
    boxes = None if settings.data is None else Boxes(Path(settings.data) / FOLDER)
    ears = bus.gather(HEARD, depth=DEPTH, of_site=OF_SITE)
    facts = facts_of(settings, clocks.utc())
    sink, pictures = _recording(settings, bus, clocks, facts) if settings.record else (None, None)
    sinks = () if sink is None else (sink,)
    folders = {each for each in (boxes and boxes.folder, settings.record and Path(settings.record)) if each}
    node = Recorder(
        bus, ears, clocks, facts=facts, boxes=boxes, sinks=sinks, recordings=partial(recordings_in, folders)
    )
    bus.announce("process/recorder")
    try:
        while not stopped():
            bus.waker.wait(TURN)
            bus.beat()
            node.step()
            if pictures is not None:
                pictures.step(node.newest)
    finally:
        if pictures is not None:
            pictures.close()
        node.close()


def _recording(
    settings: WorkerSettings, bus: ZenohBus, clocks: Clocks, facts: Facts
) -> tuple[RecordingSink, Pictures | None]:
    """Return what writes a recording, and what gives it pictures.

    Raises:
        RefusalError: when the extra is missing.
    """
    try:
        from tandem.executive.records.foxglove_view import FoxgloveView  # noqa: PLC0415 - of the extra `record`
        from tandem.executive.records.json_schemas import JsonSchemas  # noqa: PLC0415
        from tandem.executive.records.recording_sink import RecordingSink  # noqa: PLC0415
    except ModuleNotFoundError as error:
        raise RefusalError(words_on_module(error, "what records as MCAP") or str(error)) from error

    sink = RecordingSink(
        Path(settings.record),
        facts,
        clocks,
        schema_of=JsonSchemas().of,
        tell=partial(TASK_RECORDING.publish, bus),
        shows=FoxgloveView(bus.ear),
    )
    if not settings.record_pictures:
        return sink, None
    try:
        from tandem.executive.records.pictures import Pictures  # noqa: PLC0415 - numpy and cv2
    except ModuleNotFoundError as error:
        _LOG.warning("the recording has no pictures: %s", words_on_module(error, "what reads pictures"))
        return sink, None
    return sink, Pictures(bus, clocks.monotonic, sink.also)


def facts_of(settings: WorkerSettings, began: float) -> Facts:
    """Return what the records of a process are of; ``began``: UTC seconds."""
    site, _, robot = settings.prefix.partition("/")
    return Facts(
        site=site,
        robot=robot,
        scenario=settings.scenario,
        seed=settings.seed,
        release=release(),
        commit=settings.commit,
        began=began,
    )


def release() -> str:
    """Return the version of this Tandem; empty where it was not installed."""
    with suppress(PackageNotFoundError):
        return version("tandem-executive")
    return ""
