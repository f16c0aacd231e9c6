"""Whether a router can listen somewhere: kinds of endpoint that a command would start a whole system for."""

from __future__ import annotations

import socket

import pytest

from tandem.executive.system.free_endpoint import EndpointError, TakenError, require_vacant
from tests.fakes.ports import free_endpoint


def test_a_free_port_may_be_taken_again_and_again() -> None:
    endpoint = free_endpoint()
    assert require_vacant(endpoint)
    assert require_vacant(endpoint)


def test_another_programs_port_is_taken() -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        for endpoint in (f"tcp/127.0.0.1:{port}", f"tls/localhost:{port}", f"tcp/0.0.0.0:{port}"):
            with pytest.raises(TakenError, match=f"another program already listens on {endpoint}"):
                require_vacant(endpoint)


@pytest.mark.parametrize(
    "endpoint", ["tcp/192.0.2.1:7447", "tcp/no-such-host.invalid:7447", "tcp/[::1]:99999"]
)
def test_no_address_of_this_host(endpoint: str) -> None:
    with pytest.raises(EndpointError, match=r"cannot listen|not an address|expected a port"):
        require_vacant(endpoint)


def test_other_kinds_are_left_to_zenoh() -> None:
    assert not require_vacant("unixsock-stream//tmp/somewhere")
