"""What the role ``web`` is made of: the page as a process that ``tandem up`` starts and watches."""

from __future__ import annotations

import logging
from collections.abc import Callable

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.config.run_options import BusOptions
from tandem.executive.web.options import AddressError, WebOptions, checked_address
from tandem.executive.web.robot import RobotOnZenoh, Who
from tandem.executive.web.serve import listen, serve_until
from tandem.skills.wire.zenoh_bus import ZenohBus

_LOG = logging.getLogger(__name__)


def show_page(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    """Serve the page until ``stopped`` says so.

    Args:
        settings: of the process; ``web`` is where the page is served, and in whose name it asks.
        bus: of the process, which beats there; the page is a client with a session of its own.
        stopped: says when to end.

    Raises:
        RefusalError: when nothing can listen there.
    """
    site, _, robot = settings.prefix.partition("/")
    options = BusOptions(settings.endpoint, site, robot)
    try:
        listening = listen(WebOptions(options, *checked_address(settings.web)))
    except AddressError as error:
        raise RefusalError(str(error)) from error
    _LOG.info("the page is at %s", listening.address)
    bus.announce("process/web")
    serve_until(RobotOnZenoh(options, Who(settings.person), None), listening, stopped, bus.beat, alone=True)
