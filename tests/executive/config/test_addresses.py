from __future__ import annotations

import pytest

from tandem.executive.config.addresses import host_and_port, is_endpoint


def test_a_host_and_a_port_are_read() -> None:
    assert host_and_port("[::1]:65535", example="a:1") == ("::1", 65535)


@pytest.mark.parametrize("text", ["", "80", ":80", "a:", "a:-1", "a:65536"])
def test_what_is_no_host_and_port_is_refused_with_an_example(text: str) -> None:
    with pytest.raises(ValueError, match=r"such as robot:80; found"):
        host_and_port(text, example="robot:80")


@pytest.mark.parametrize(
    ("text", "known"),
    [
        ("tcp/127.0.0.1:7447", True),
        ("tls/[::1]:65535", True),
        ("serial//dev/ttyUSB0", True),
        ("tcp/127.0.0.1:65536", False),
        ("tcp/127.0.0.1:123456", False),
        ("tcp/127.0.0.1", False),
        ("http/127.0.0.1:80", False),
    ],
)
def test_an_endpoint_of_zenoh_is_known(text: str, *, known: bool) -> None:
    assert is_endpoint(text) is known
