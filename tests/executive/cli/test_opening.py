"""What ``tandem up`` opens: which roles need nothing before, and whose keys are shown."""

from __future__ import annotations

import datetime as dt
from dataclasses import replace
from pathlib import Path

import pytest

from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.opening import owner_of, refuse_without_extras
from tandem.executive.config import extras
from tandem.executive.config.run_options import BusOptions
from tandem.executive.security.authority import Wanted, begin, issue


def test_without_the_extra_of_a_role_that_nobody_asked_for_all_else_starts(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(extras, "_is_there", lambda module: module != "rosbags")
    refuse_without_extras(())
    with pytest.raises(CommandError, match=r"the role ros: rosbags missing; .*tandem-executive\[ros\]"):
        refuse_without_extras(("ros",))


def test_several_robots_show_the_keys_of_their_own_names(tmp_path: Path) -> None:
    now = dt.datetime.now(dt.UTC)
    begin(tmp_path, now)
    issue(tmp_path, Wanted("robot", "r2"), now)
    bus = BusOptions(keys=tmp_path)
    missing = rf"no keys of the robot 'r3'; found r2; `tandem keys new --role robot --folder {tmp_path} r3`"
    with pytest.raises(CommandError, match=missing):
        owner_of(bus, ("r2", "r3"))
    issue(tmp_path, Wanted("robot", "r3"), now)
    assert owner_of(bus, ("r2", "r3")).holder == "r2"
    assert owner_of(replace(bus, holder="kim"), ("r2", "r3"), by_environment=True).holder == "r2"
    with pytest.raises(CommandError, match=r"^--as r3: the robots r2, r3 show the keys of their own names"):
        owner_of(replace(bus, holder="r3"), ("r2", "r3"))
