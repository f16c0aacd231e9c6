"""What every message is, whatever it says."""

from __future__ import annotations

import json
import re

import pytest

from tandem.executive.service.running.orphaned_goals import Whatever
from tandem.skills.ports.action import GoalStatus
from tandem.skills.ports.hardware import Stop, StopState
from tandem.skills.ports.message import PLAIN_TEXT, Message, plain, read_leniently
from tandem.skills.ports.problems import Problem

RUNNING = (
    b'{"goal_id": "fetch-1/reach/1", "state": "RUNNING", "sequence": 1, "feedback": {"a word": "of it"}}'
)


def test_strings_that_were_read_are_kept_by_nobody_else() -> None:
    """Pydantic's cache would hand out the same object twice, and hold it for as long as the process lives."""
    first, second = GoalStatus.model_validate_json(RUNNING), read_leniently(GoalStatus, RUNNING)
    assert first.goal_id is not second.goal_id
    assert first.feedback is not None
    assert second.feedback is not None
    assert first.feedback["a word"] is not second.feedback["a word"]
    assert next(iter(first.feedback)) is not next(iter(second.feedback))


@pytest.mark.parametrize("kind", [Message, GoalStatus, Whatever])
def test_kinds_of_messages_with_settings_of_their_own_keep_no_strings_either(kind: type[Message]) -> None:
    assert kind.model_config.get("cache_strings") == "none"


@pytest.mark.parametrize("text", ["\x1b[2Jgone", "a\nb", "\u202egnp.exe", "\x9b31m", "\u2028", "\ufeff29"])
def test_what_others_wrote_reaches_the_screen_without_what_would_change_it(text: str) -> None:
    """A stop with such a reason still stops: it is written otherwise, where a request would be refused."""
    stop = Stop.model_validate_json(json.dumps({"by": text, "reason": text}))
    told = StopState(stopped=True, by=text, reason=text)
    found = Problem(path="item", expected="an item", found=text).found
    for shown in (stop.by, stop.reason, told.by, told.reason, found):
        assert re.fullmatch(PLAIN_TEXT, shown)
    assert plain(stop.reason) == stop.reason, "nothing is written otherwise twice"
    assert plain("plain, in Ελληνικά and 日本語") == "plain, in Ελληνικά and 日本語"
