"""What the observer answers to an address that can't be served."""

from __future__ import annotations

from unittest.mock import Mock

import pytest

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.telemetry.process import observe


@pytest.mark.parametrize(
    "address", ["127.0.0.1:65536", "192.0.2.1:9464"], ids=["no port", "not of this host"]
)
def test_metrics_that_cannot_be_served_are_refused_with_their_address(address: str) -> None:
    settings = WorkerSettings(
        role="observer", endpoint="tcp/127.0.0.1:7447", prefix="lab/tiago", site="lab", metrics=address
    )
    with pytest.raises(RefusalError, match=f"metrics can't be served at {address}: "):
        observe(settings, Mock(), lambda: True)
