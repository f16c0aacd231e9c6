"""The router: passes on what the others say, as far as the rules allow. It says nothing itself."""

from __future__ import annotations

from collections.abc import Callable

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system.roles.role import Role


def _route(settings: WorkerSettings, stopped: Callable[[], bool]) -> None:
    from tandem.executive.system.playing import credentials_of  # noqa: PLC0415
    from tandem.executive.system.router import Router  # noqa: PLC0415
    from tandem.skills.wire.zenoh_ends import Waker  # noqa: PLC0415

    router, waker = Router(settings, credentials_of(settings, ROLES[0])), Waker()
    try:
        while not stopped():
            waker.wait(0.1)
            router.step()
    finally:
        router.close()


ROLES = (Role(name="router", starts=0, kind="router", route=_route),)
