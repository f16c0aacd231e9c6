"""What the role ``observer`` is made of: the records that were asked for, and the page with the metrics."""

from __future__ import annotations

import logging
from collections.abc import Callable
from contextlib import ExitStack

from tandem.executive.config.addresses import METRICS_EXAMPLE, host_and_port
from tandem.executive.config.extras import words_on_module
from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.telemetry.observer import Observer, Record
from tandem.skills.ports.clocks import Clocks
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.loop import run
from tandem.skills.wire.zenoh_bus import ZenohBus

_LOG = logging.getLogger(__name__)


def observe(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    """Keep the records until ``stopped`` says so.

    Raises:
        RefusalError: when nothing can listen where metrics are to be served, or the extra for traces is
            missing.
    """
    clocks = ProcessClocks(bus)
    with ExitStack() as open_until_the_end:
        records: list[Record] = []
        if settings.metrics:
            records.append(_metrics(settings.metrics, open_until_the_end))
        if settings.traces:
            records.append(_traces(settings.traces, settings.prefix, clocks))
        run("observer", bus, clocks, [Observer(bus, clocks, records)], stopped, calm=lambda: True)


def _metrics(address: str, until: ExitStack) -> Record:
    from prometheus_client import CollectorRegistry  # noqa: PLC0415 - only where it is asked for

    from tandem.executive.telemetry.metrics import Metrics, Page  # noqa: PLC0415

    registry = CollectorRegistry()
    try:
        # Of several robots, the last may be beyond the last port.
        host, port = host_and_port(address, example=METRICS_EXAMPLE)
        page = Page(host, port, registry)
    except (OSError, ValueError) as error:
        why = (error.strerror if isinstance(error, OSError) else "") or error
        raise RefusalError(f"metrics can't be served at {address}: {why}") from error
    until.callback(page.close)
    _LOG.info("metrics at http://%s:%d/metrics", host, page.port)
    return Metrics(registry)


def _traces(endpoint: str, robot: str, clocks: Clocks) -> Record:
    try:
        from tandem.executive.telemetry.traces import Traces, batching_provider, otlp_exporter  # noqa: PLC0415
    except ModuleNotFoundError as error:
        raise RefusalError(words_on_module(error, "what sends traces") or str(error)) from error
    _LOG.info("traces go to %s", endpoint)
    return Traces(batching_provider(otlp_exporter(endpoint), robot), clocks)
