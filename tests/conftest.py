"""What every test needs of the process it runs in."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.fakes.packages import Installed


@pytest.fixture(scope="session", autouse=True)
def no_ledger_of_the_users(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep away from the ledgers, and from what is known of plug-ins, of whoever runs the tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        yield


@pytest.fixture(scope="session", autouse=True)
def ctrl_c_is_heard() -> Iterator[None]:
    """Hear SIGINT, and so let the programs that tests start hear it.

    A shell starts background jobs with SIGINT ignored, as do many CI runners; a program that inherits that
    never sees a Ctrl-C.
    """
    before = signal.getsignal(signal.SIGINT)
    if before is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Installed]:
    """A folder of installed packages, to which a test adds its own."""
    packages = Installed(tmp_path / "site-packages", monkeypatch)
    yield packages
    packages.forget()
