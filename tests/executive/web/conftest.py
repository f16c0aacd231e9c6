from __future__ import annotations

from collections.abc import Iterator

import pytest
from starlette.testclient import TestClient
from web_rig import Rig


@pytest.fixture
def rig() -> Rig:
    return Rig()


@pytest.fixture
def page(rig: Rig) -> Iterator[TestClient]:
    with rig.page() as client:
        yield client
