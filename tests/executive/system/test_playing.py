"""How a process of a role comes to the bus."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system.playing import connect
from tandem.executive.system.roles.registry import role_of
from tandem.skills.wire.configs import router_config
from tandem.skills.wire.zenoh_bus import RouterSession
from tests.fakes.ports import free_endpoint


def _settings(endpoint: str, folder: Path) -> WorkerSettings:
    return WorkerSettings(
        role="executive", endpoint=endpoint, prefix="early/tiago", site="lab", data=str(folder)
    )


def test_a_process_that_starts_before_its_router_waits_for_it(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    settings, routers = _settings(endpoint := free_endpoint(), tmp_path), list[RouterSession]()

    def router_comes() -> bool:
        if caplog.records and not routers:
            routers.append(RouterSession(router_config(endpoint), [endpoint]))
        return False

    bus = connect(settings, role_of(settings), router_comes)
    assert bus is not None
    assert [record.getMessage() for record in caplog.records] == ["waits for its router"]
    bus.close()
    routers[0].close()


def test_one_that_is_stopped_meanwhile_ends(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    settings = _settings(free_endpoint(), tmp_path)
    assert connect(settings, role_of(settings), lambda: bool(caplog.records)) is None
