from __future__ import annotations

import pytest

from tandem.executive.web.options import AddressError, checked_address, checked_pages


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("127.0.0.1:8447", ("127.0.0.1", 8447)),
        ("localhost:0", ("localhost", 0)),
        ("[::1]:80", ("::1", 80)),
    ],
)
def test_an_address_of_this_host_is_taken(text: str, found: tuple[str, int]) -> None:
    assert checked_address(text) == found


@pytest.mark.parametrize("text", ["", "8447", "127.0.0.1", "127.0.0.1:x", "127.0.0.1:65536", ":80"])
def test_what_is_no_address_is_refused(text: str) -> None:
    with pytest.raises(AddressError, match="expected a host and a port"):
        checked_address(text)


@pytest.mark.parametrize("text", ["0.0.0.0:8447", "192.168.1.5:8447", "robot.local:8447", "[::]:8447"])
def test_beyond_this_host_it_is_refused_with_what_to_do(text: str) -> None:
    with pytest.raises(AddressError, match=r"anyone who can reach the page.*ssh -L 8447"):
        checked_address(text)


def test_pages_of_other_robots_are_taken() -> None:
    words = ("r2=https://r2.example:8447", "r3=http://127.0.0.1:8448/")
    assert checked_pages(words) == {"r2": "https://r2.example:8447", "r3": "http://127.0.0.1:8448/"}


@pytest.mark.parametrize(
    "word",
    ["r2", "=http://a", "r2=", "r2=r2.example", "r2=javascript:alert(1)", "r2=http://a:port", "r2=http://[::1",
     "r2=https://me:secret@r2.example"],
)  # fmt: skip
def test_what_is_no_page_of_a_robot_is_refused(word: str) -> None:
    with pytest.raises(AddressError, match="expected ROBOT=ADDRESS"):
        checked_pages((word,))
