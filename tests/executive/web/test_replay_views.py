"""A record in a real browser: a slider through time, and a click on the timeline leads to its moment."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from web_fake import served
from web_record import record

from tandem.executive.records.recording import open_recording
from tandem.executive.web.replay import Replay

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, expect
from web_chromium import MARKS, launched, opened, picture

pytestmark = MARKS


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with launched() as made:
        yield made


def test_a_record_is_looked_at_where_one_wants(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "box.jsonl.gz"
    record(path)
    with served(Replay(open_recording(path))) as address, opened(browser, address) as page:
        page.goto("/")
        expect(page.locator(".link")).to_contain_text("replay of a record")
        page.get_by_role("button", name="Stand still").click()
        page.get_by_label("Moment").fill("4.5")
        expect(page.locator(".task")).to_contain_text("RUNNING")
        expect(page.locator(".replay .number")).to_contain_text("0:04.5")
        picture(page, "page-replay")
        page.get_by_label("Moment").fill("15")
        expect(page.locator(".task")).to_contain_text("SUCCEEDED")
        page.get_by_label("Moment").fill("0.5")
        expect(page.locator(".side")).to_contain_text("No task yet")
        page.get_by_label("Moment").fill("15")
        page.locator(".task h2 a").click()
        page.locator(".lane").first.click(position={"x": 40, "y": 5})
        expect(page.locator(".replay .number")).to_contain_text(re.compile("0:0[1-9]"))
        expect(page.locator(".task")).to_contain_text("RUNNING")
        assert page.get_by_role("button", name="STOP").count() == 0
