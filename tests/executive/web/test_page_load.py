"""The benchmark of the page's load looks on as often as told, and times a click from end to end."""

from __future__ import annotations

import pytest
from web_fake import FakeRobot, served
from web_rig import of_role

from tandem.skills.ports.keys import STOP

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from web_chromium import MARKS, launched, opened

from benchmarks.page_load import click, viewers

pytestmark = MARKS


def test_viewers_are_opened_and_end_with_the_benchmark() -> None:
    robot = FakeRobot(seconds=100.0)
    with served(robot) as address, viewers(address, 3):
        pass
    with pytest.raises(RuntimeError, match="2 viewers could not be opened"), viewers("http://127.0.0.1:9", 2):
        pass


def test_a_click_is_timed_until_the_hardware_has_answered() -> None:
    robot = FakeRobot(seconds=100.0)
    robot.who = of_role("operator")
    with launched() as browser, served(robot) as address, opened(browser, address) as page:
        page.goto("/")
        assert click(page) > 0.0
        assert [key for key, _ in robot.asked] == [STOP.key]
        page.route("**/api/verb/stop", lambda route: route.fulfill(status=504, json={"error": "no answer"}))
        with pytest.raises(RuntimeError, match="answered with 504"):
            click(page)
