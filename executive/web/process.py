"""What the role ``web`` is made of: the page as a process that ``tandem up`` starts and watches."""

from __future__ import annotations

import logging
from collections.abc import Callable

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.config.run_options import BusOptions
from tandem.executive.web.options import AddressError, WebOptions, addresses_of
from tandem.executive.web.robot import RobotOnZenoh, Who
from tandem.executive.web.serve import Shown, listen, serve_until
from tandem.skills.wire.zenoh_bus import ZenohBus

_LOG = logging.getLogger(__name__)


def show_page(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    """Serve the page of the robot, and of those beside it, until ``stopped`` says so.

    Args:
        settings: of the process; ``web`` is where the first page is served, and in whose name it asks.
        bus: of the process, which beats there; the page is a client with a session of its own.
        stopped: says when to end.

    Raises:
        RefusalError: when nothing can listen there.
    """
    site, _, robot = settings.prefix.partition("/")
    person, shown = Who(settings.person), list[Shown]()
    try:
        for name, (host, port) in addresses_of(settings.web, settings.web_of or (robot,)).items():
            options = BusOptions(settings.endpoint, site, name)
            shown.append(Shown(RobotOnZenoh(options, person, None), listen(WebOptions(options, host, port))))
    except AddressError as error:
        raise RefusalError(str(error)) from error
    for each in shown:
        _LOG.info("the page of %s is at %s", each.robot.options.prefix, each.listening.address)
    bus.announce("process/web")
    serve_until(shown, stopped, bus.beat, alone=True)
