"""Log-ins to the page: whose word opens which page, and which opens none."""

from __future__ import annotations

import datetime as dt
from collections.abc import Callable
from pathlib import Path

import pytest

from tandem.executive.security.authority import Wanted, begin, issue, revoke
from tandem.executive.security.holders import KeysError
from tandem.executive.security.identity import Identity
from tandem.executive.security.links import LinkError, check, make

PAGE = "https://robot.example:8447"
START = dt.datetime(2026, 11, 27, tzinfo=dt.UTC)
NOW = START.timestamp()


def folder_of_keys(folder: Path) -> Path:
    begin(folder, START)
    for role, name in (("operator", "anna"), ("viewer", "vera"), ("robot", "r1")):
        issue(folder, Wanted(role, name, days=30), START)  # type: ignore[arg-type]
    return folder


@pytest.fixture
def keys(tmp_path: Path) -> Path:
    return folder_of_keys(tmp_path / "keys")


@pytest.mark.parametrize(("name", "role"), [("anna", "operator"), ("vera", "viewer")])
def test_a_word_opens_the_page_in_the_holders_name(keys: Path, name: str, role: str) -> None:
    holder, asked = check(make(Identity(keys, name), PAGE, NOW), keys, PAGE, NOW + 30.0)
    assert (holder.name, holder.role, asked.page) == (name, role, PAGE)


def test_each_word_is_another(keys: Path) -> None:
    words = {make(Identity(keys, "anna"), PAGE, NOW) for _ in range(3)}
    assert len({check(each, keys, PAGE, NOW)[1].nonce for each in words}) == 3


@pytest.mark.parametrize(
    ("later", "page", "why"),
    [
        (601.0, PAGE, "good for 10 minutes"),
        (-61.0, PAGE, "good for 10 minutes"),
        (0.0, "https://elsewhere.example:8447", "it is for https://robot.example:8447"),
    ],
)
def test_a_word_is_for_one_page_and_ten_minutes(keys: Path, later: float, page: str, why: str) -> None:
    with pytest.raises(LinkError, match=why):
        check(make(Identity(keys, "anna"), PAGE, NOW), keys, page, NOW + later)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda word: word[:0],
        lambda word: word[:-40],
        lambda word: word[:30] + ("A" if word[30] != "A" else "B") + word[31:],
        lambda word: "\N{SNOWMAN}" + word,
        lambda word: 100 * word,
    ],
)
def test_what_is_no_word_opens_nothing(keys: Path, spoil: Callable[[str], str]) -> None:
    with pytest.raises(LinkError, match="tandem keys link"):
        check(spoil(make(Identity(keys, "anna"), PAGE, NOW)), keys, PAGE, NOW)


def test_the_key_of_another_authority_opens_nothing(keys: Path, tmp_path: Path) -> None:
    other = folder_of_keys(tmp_path / "other")
    with pytest.raises(LinkError, match="another authority"):
        check(make(Identity(other, "anna"), PAGE, NOW), keys, PAGE, NOW)


def test_a_key_that_is_revoked_or_expired_opens_nothing(keys: Path) -> None:
    later = NOW + 31 * 86_400.0
    with pytest.raises(LinkError, match="anna is expired"):
        check(make(Identity(keys, "anna"), PAGE, later), keys, PAGE, later)
    revoke(keys, "anna")
    with pytest.raises(LinkError, match="anna is revoked"):
        check(make(Identity(keys, "anna"), PAGE, NOW), keys, PAGE, NOW)


def test_a_robots_key_opens_nothing(keys: Path) -> None:
    with pytest.raises(LinkError, match="use the key of a person"):
        check(make(Identity(keys, "r1"), PAGE, NOW), keys, PAGE, NOW)


def test_who_has_no_key_makes_no_word(keys: Path) -> None:
    with pytest.raises(KeysError, match="no such file"):
        make(Identity(keys, "nobody"), PAGE, NOW)
