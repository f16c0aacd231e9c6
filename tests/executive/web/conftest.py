from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from starlette.testclient import TestClient
from web_rig import Rig

if TYPE_CHECKING:
    from playwright.sync_api import Browser


@pytest.fixture
def rig() -> Rig:
    return Rig()


@pytest.fixture
def page(rig: Rig) -> Iterator[TestClient]:
    with rig.page() as client:
        yield client


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    from web_chromium import launched  # noqa: PLC0415 - most tests need no browser, nor what drives one

    with launched() as made:
        yield made
