"""A record in a real browser: a slider through time, and a click on the timeline leads to its moment."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from web_fake import FakeRobot, served
from web_record import record

from tandem.executive.records.recording import open_recording
from tandem.executive.records.tape import Tape
from tandem.executive.web.replay import Replay
from tandem.skills.ports.records import BlackBox, Cause, Records
from tandem.skills.ports.tasks import TASK_TIMELINE, Timeline

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, expect
from web_chromium import MARKS, opened, picture

pytestmark = MARKS


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("record") / "box.jsonl.gz"
    record(made)
    return made


def robot_of(path: Path) -> FakeRobot:
    """Return a robot that has done what stands in a record, and whose recorder keeps it as a black box."""
    tape = Tape(open_recording(path))
    tape.go(tape.record.span.end)
    known = tape.known()
    (status,) = known.statuses()
    attached = {each.name: each.data for each in tape.record.attachments}
    timeline = Timeline.model_validate_json(attached[f"{TASK_TIMELINE.key}/{status.task}"])
    cause = Cause(kind="task", words="it failed", task=status.task, stamp=timeline.spans[-1].begin)
    box = BlackBox(file=str(path), size=path.stat().st_size, began=0.0, causes=(cause,))
    return FakeRobot(tasks=(status,), timeline=timeline, records=Records(boxes=(box,)))


def test_a_task_tells_its_black_box_and_what_was_known_at_a_moment(browser: Browser, path: Path) -> None:
    robot = robot_of(path)
    with served(robot) as address, opened(browser, address) as page:
        page.goto(f"/task/{robot.tasks[0].task}")
        expect(page.locator(".record code")).to_have_text(f"tandem replay {path} --web")
        page.locator(".lane").first.click(position={"x": 150, "y": 5})
        expect(page.locator(".moment")).to_contain_text("item 29")
        expect(page.locator(".moment dl").first).to_contain_text("destinationdepot")
        expect(page.locator(".moment .node.RUNNING").first).to_be_visible()
        expect(page.locator(".moment .canvas")).to_have_attribute("data-robot", "loaded")
        picture(page, "page-moment")
        page.get_by_label("Moment of the timeline").press("End")
        expect(page.locator(".moment dl").first).to_contain_text("graspspitch")
        robot.records = Records(boxes=())
        page.reload()
        expect(page.locator(".moment")).to_contain_text("was not recorded")


def test_a_record_is_looked_at_where_one_wants(browser: Browser, path: Path) -> None:
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
        page.goto("/map?item=29")
        expect(page.locator("main")).to_contain_text("A record takes no requests")
        assert page.get_by_role("link", name="Request").count() == 0
        page.goto("/request")
        expect(page.locator("main")).to_contain_text("A record takes no requests")
