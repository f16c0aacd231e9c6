"""What ``tandem up`` opens: a role that is started only when asked for needs nothing before."""

from __future__ import annotations

import pytest

from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.opening import refuse_without_extras
from tandem.executive.config import extras


def test_without_the_extra_of_a_role_that_nobody_asked_for_all_else_starts(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(extras, "_is_there", lambda module: module != "rosbags")
    refuse_without_extras(())
    with pytest.raises(CommandError, match=r"the role ros: rosbags missing; .*tandem-executive\[ros\]"):
        refuse_without_extras(("ros",))
