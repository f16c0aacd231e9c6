"""The tree's own size and place in a real browser: zoom and follow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import pytest
from web_fake import FakeRobot, served

from tandem.skills.ports.tasks import TREE, NodeStatus, TreeNode, TreeSnapshot

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Locator, Page, expect
from web_chromium import MARKS, opened, picture

pytestmark = MARKS
STEPS: Final = 80
"""Leaves: more than a window shows."""


def tree(running: int) -> TreeSnapshot:
    """Return a long sequence of which one leaf runs."""
    leaves = tuple(
        TreeNode(
            path=f"go/step {number}", name=f"step {number}", kind="action", type="Act",
            status=NodeStatus.RUNNING if number == running else NodeStatus.INVALID,
        )
        for number in range(STEPS)
    )  # fmt: skip
    root = TreeNode(
        path="go", name="go", kind="sequence", type="Seq", status=NodeStatus.RUNNING, children=leaves
    )
    return TreeSnapshot(task="go-1", kind="go", tick=running + 1, root=root)


@pytest.fixture
def robot() -> FakeRobot:
    return FakeRobot(seconds=100.0, tree=tree(0))


@pytest.fixture
def page(browser: Browser, robot: FakeRobot) -> Iterator[Page]:
    with served(robot) as address, opened(browser, address) as made:
        made.goto("/")
        expect(made.get_by_role("treeitem")).to_have_count(STEPS + 1)
        yield made


def percent(page: Page) -> Locator:
    return page.locator(".zoom .percent")


def height(page: Page) -> float:
    """Return the pixels of the tree's first row."""
    box = page.get_by_role("treeitem").first.bounding_box()
    assert box is not None
    return box["height"]


def test_the_tree_is_zoomed_by_buttons_and_stays_so(page: Page) -> None:
    plain = height(page)
    page.get_by_role("button", name="Larger").click()
    page.get_by_role("button", name="Larger").click()
    expect(percent(page)).to_have_text("125 %")
    assert height(page) > 1.15 * plain
    picture(page, "page-zoom")
    page.reload()
    expect(percent(page)).to_have_text("125 %")
    page.get_by_role("button", name="125 %: back to 100 %").click()
    expect(percent(page)).to_have_text("100 %")
    assert height(page) == pytest.approx(plain, abs=1.0)


def test_the_tree_is_zoomed_by_keys_to_its_ends(page: Page) -> None:
    page.get_by_role("treeitem").first.focus()
    page.keyboard.press("-")
    expect(percent(page)).to_have_text("90 %")
    for _ in range(8):
        page.keyboard.press("-")
    expect(percent(page)).to_have_text("50 %")
    expect(page.get_by_role("button", name="Smaller")).to_be_disabled()
    page.keyboard.press("0")
    expect(percent(page)).to_have_text("100 %")


def test_ctrl_and_the_wheel_zoom_the_tree_and_keep_the_row_in_place(page: Page) -> None:
    row = page.get_by_role("treeitem").nth(40)
    row.scroll_into_view_if_needed()
    row.hover()
    before = row.bounding_box()
    page.keyboard.down("Control")
    page.mouse.wheel(0, -100)
    page.keyboard.up("Control")
    expect(percent(page)).to_have_text("110 %")
    after = row.bounding_box()
    assert before is not None
    assert after is not None
    assert after["y"] == pytest.approx(before["y"], abs=2.0)
    assert page.evaluate("devicePixelRatio") == 1, "the browser's own zoom stays"


def test_follow_scrolls_to_the_node_that_runs(page: Page, robot: FakeRobot) -> None:
    rows = page.get_by_role("treeitem")
    robot.tell((TREE, tree(STEPS - 10)))
    expect(rows.nth(STEPS - 9)).to_have_class("node action RUNNING ")
    expect(rows.nth(STEPS - 9)).not_to_be_in_viewport()
    page.get_by_role("button", name="Follow").click()
    expect(rows.nth(STEPS - 9)).to_be_in_viewport()
    robot.tell((TREE, tree(2)))
    expect(rows.nth(3)).to_be_in_viewport()


def test_follow_ends_when_a_node_is_opened_or_closed(page: Page) -> None:
    follow = page.get_by_role("button", name="Follow")
    follow.click()
    expect(follow).to_have_attribute("aria-pressed", "true")
    page.get_by_role("treeitem").first.click()
    expect(page.get_by_role("treeitem")).to_have_count(1)
    expect(follow).to_have_attribute("aria-pressed", "false")
    follow.click()
    expect(page.get_by_role("treeitem")).to_have_count(STEPS + 1)
