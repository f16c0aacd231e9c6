"""The page in a real browser, beside an executive whose robot is mocked.

With ``TANDEM_PICTURES=FOLDER`` the tests leave pictures of the views there, to be looked at.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tandem.executive.client.sync import Client
from tests.fakes.mocked import mocked_system
from tests.fakes.ports import free_endpoint

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Page, expect
from web_chromium import MARKS, opened, picture

pytestmark = MARKS
ROOT = Path(__file__).parents[3]
HOSTILE = "<img src=x onerror=document.title='broken'>"
VIEWS = ("/", "/map?item=29", "/request?task=fetch&item=29", "/history", "/task/{task}")


@contextmanager
def served(endpoint: str, at: str = "127.0.0.1:0") -> Iterator[str]:
    """Run ``tandem web``; yields the page's address."""
    program = "import sys; from tandem.executive.cli.start import run; sys.exit(run())"
    words = [sys.executable, "-c", program, "web", "--at", at, "--connect", endpoint]
    with subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            said = process.stdout.readline()
            yield re.findall(r"http://[^/]+", said)[0]
        finally:
            process.kill()


@pytest.fixture(scope="module")
def robot() -> Iterator[str]:
    endpoint = free_endpoint()
    with mocked_system(endpoint, skill_seconds=0.05):
        yield endpoint


@pytest.fixture(scope="module")
def fetched(robot: str) -> str:
    """Return the id of the first fetch: a second one has nothing to do."""
    ended(robot)
    with Client(robot) as client:
        return client.tasks()[0].task


@pytest.fixture(scope="module")
def address(robot: str) -> Iterator[str]:
    with served(robot) as found:
        yield found


@pytest.fixture
def page(browser: Browser, address: str) -> Iterator[Page]:
    with opened(browser, address) as made:
        yield made


def ended(robot: str, **fields: object) -> str:
    """Send a request and wait for its end."""
    with Client(robot) as client:
        return client.wait(client.submit({"task": "fetch", "item": 29, **fields}), timeout=60.0).task


def test_a_request_goes_from_its_form_to_its_end(page: Page) -> None:
    page.goto("/request")
    page.get_by_role("link", name=re.compile("^fetch")).click()
    page.get_by_label("item").fill("tea")  # as the site calls item 29
    page.get_by_role("button", name="Send").click()
    expect(page).to_have_url(re.compile("/$"))
    expect(page.locator(".task")).to_contain_text("SUCCEEDED")
    expect(page.get_by_role("treeitem").first).to_have_text(re.compile("fetch"))
    expect(page.locator(".canvas")).to_have_attribute("data-robot", "loaded")
    picture(page, "page-now-mocked")
    page.get_by_placeholder("Find a node").fill("retract")
    expect(page.get_by_role("treeitem").last).to_contain_text("retract")


def test_what_is_wrong_stands_at_its_field(page: Page) -> None:
    page.goto("/request?task=fetch&item=29&to=nowhere")
    page.get_by_role("button", name="Send").click()
    expect(page.locator(".field.wrong label")).to_have_text("to")
    expect(page.get_by_role("alert")).to_contain_text("The request was not taken")


def test_the_stop_is_in_reach_and_says_who_may_release_it(page: Page) -> None:
    for view in ("/", "/history"):
        page.goto(view)
        page.get_by_role("button", name="STOP").click()
        expect(page.locator(".stopped")).to_contain_text(re.compile("Stopped by .+: the stop on the page"))
        page.get_by_role("button", name="Release").click()
        expect(page.locator(".stopped")).to_have_count(0)
    expect(page.locator(".link")).to_contain_text("live")
    page.keyboard.press("Control+.")
    page.get_by_role("button", name="Release").click()


def test_a_place_of_the_map_becomes_a_request(page: Page) -> None:
    page.goto("/map")
    page.get_by_role("button", name="depot depot").focus()
    page.keyboard.press("Enter")
    page.get_by_role("link", name="fetch").click()
    expect(page.get_by_label("to", exact=True)).to_have_value("depot")
    expect(page.locator("details.same pre").first).to_contain_text('"to": "depot"')


def test_filters_stand_in_the_address_and_lead_to_a_task(page: Page, fetched: str) -> None:
    page.goto("/history")
    page.get_by_label("state").select_option("SUCCEEDED")
    page.get_by_label("item").fill("29")
    page.get_by_label("item").press("Enter")
    expect(page).to_have_url(re.compile(r"state=SUCCEEDED&item=29"))
    page.get_by_role("link", name=fetched).click()
    expect(page.get_by_role("heading", name="Timeline")).to_be_visible()
    expect(page.locator(".timeline .name", has_text="retract")).to_be_visible()
    picture(page, "page-task-mocked")


def test_hostile_words_are_shown_as_words(page: Page, robot: str) -> None:
    task = ended(robot, labels={HOSTILE: HOSTILE}, id=HOSTILE)
    page.goto(f"/task/{task}")
    expect(page.locator("pre", has_text=HOSTILE).first).to_be_visible()
    page.goto(f"/history?text={HOSTILE}")
    expect(page.get_by_role("searchbox")).to_have_value(HOSTILE)
    assert "broken" not in page.title()
    assert page.locator("img").count() == 0


def test_it_connects_again_by_itself(browser: Browser, robot: str) -> None:
    page = browser.new_page()
    with served(robot) as address:
        page.goto(address)
        expect(page.locator(".link")).to_contain_text("live")
    expect(page.locator(".link")).to_contain_text(re.compile("no link.*data is .* s old"))
    with served(robot, address.removeprefix("http://")):
        expect(page.locator(".link")).to_contain_text("live")
    page.close()


@pytest.mark.parametrize(("width", "scheme"), [(1280, "light"), (800, "dark")])
def test_nothing_hangs_over_the_edge(page: Page, robot: str, width: int, scheme: str) -> None:
    task = ended(robot)
    page.set_viewport_size({"width": width, "height": 800})
    page.emulate_media(color_scheme=scheme)  # type: ignore[arg-type]
    for view in VIEWS:
        page.goto(view.format(task=task))
        expect(page.locator(".card").first).to_be_visible()
        assert page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0, view
