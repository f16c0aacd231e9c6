"""Times of day: read from seconds and from ISO 8601, written as seconds or for people."""

from __future__ import annotations

import json

import pytest
from pydantic import ValidationError

from tandem.skills.ports.message import Message
from tandem.skills.ports.utc import ISO, Utc, iso, seconds_of


class Asked(Message):
    at: Utc


@pytest.mark.parametrize(
    ("said", "seconds"),
    [
        (1.5, 1.5),
        ("1970-01-01T00:00:01.5Z", 1.5),
        ("1970-01-01T01:00:01+01:00", 1.0),
        ("1970-01-01T00:00Z", 0.0),
    ],
)
def test_seconds_and_iso_are_read(said: object, seconds: float) -> None:
    assert Asked.model_validate_json(json.dumps({"at": said}), strict=True).at == seconds


@pytest.mark.parametrize(
    "said", ["1970-01-01T00:00:01", "1970-01-01", "tomorrow", "1.5", "", -1.0, 1e12, True]
)
def test_what_is_no_time_of_day_is_refused(said: object) -> None:
    with pytest.raises(ValidationError):
        Asked.model_validate_json(json.dumps({"at": said}), strict=True)


def test_a_refused_time_says_what_was_expected() -> None:
    with pytest.raises(ValueError, match="ISO 8601 with a zone such as"):
        seconds_of("2026-11-24T08:30")


@pytest.mark.parametrize("said", ["9999-12-31T23:59:59Z", "1969-12-31T23:59:59Z"])
def test_a_date_out_of_bounds_is_refused_with_dates(said: str) -> None:
    with pytest.raises(ValidationError, match="a time from 1970-01-01T00:00:00Z to 5138-11-16T09:46:40Z"):
        Asked.model_validate_json(json.dumps({"at": said}), strict=True)


def test_times_are_seconds_on_the_wire_and_iso_for_people() -> None:
    message = Asked(at=1.25)
    assert message.model_dump_json() == '{"at":1.25}'
    assert message.model_dump_json(context=ISO) == '{"at":"1970-01-01T00:00:01.250Z"}'


@pytest.mark.parametrize(
    ("utc", "text"),
    [(0.0, "1970-01-01T00:00:00Z"), (0.9996, "1970-01-01T00:00:01Z"), (1e15, "1000000000000000 s")],
)
def test_iso_has_a_fraction_only_where_there_is_one(utc: float, text: str) -> None:
    assert iso(utc) == text
