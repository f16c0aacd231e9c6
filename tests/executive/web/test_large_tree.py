"""A tree of a thousand nodes that changes sixty times a second: the page shows the newest of it."""

from __future__ import annotations

import statistics
import sys
import time

import pytest
from web_fake import FakeRobot, served

from tandem.skills.ports.tasks import TREE, NodeStatus, TreeNode, TreeSnapshot

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, expect
from web_chromium import MARKS, opened

pytestmark = MARKS
WIDE = 10
"""Children of each node: 1 + 10 + 100 + 889."""
NODES = 1000
RATE = 60
BEHIND = 0.5
"""Seconds."""
SAMPLE = """() => {
  window.seen = [];
  let last = "";
  const look = () => {
    const said = [...document.querySelectorAll('.node .said')].at(-1)?.textContent ?? "";
    if (said !== last) window.seen.push([Date.now() / 1000, Number(last = said)]);
    requestAnimationFrame(look);
  };
  look();
}"""
"""Notes when the page shows the number in its last row."""


def large_tree(number: int) -> TreeSnapshot:
    """Return a tree whose last leaf says a number, and of which a tenth of the leaves changes with it."""
    left = NODES - 1 - WIDE - WIDE * WIDE
    branches = []
    for i in range(WIDE):
        twigs = []
        for j in range(WIDE):
            count = min(WIDE, left)
            left -= count
            twigs.append(_node(f"r/{i}/{j}", tuple(_leaf(f"r/{i}/{j}/{k}", number, k) for k in range(count))))
        branches.append(_node(f"r/{i}", tuple(twigs)))
    return TreeSnapshot(task="large", kind="large", tick=number, root=_node("r", tuple(branches)))


def _node(path: str, children: tuple[TreeNode, ...]) -> TreeNode:
    return TreeNode(
        path=path, name=path, kind="sequence", type="Sequence", status=NodeStatus.RUNNING, children=children
    )


def _leaf(path: str, number: int, place: int) -> TreeNode:
    status = NodeStatus.RUNNING if place == number % WIDE else NodeStatus.SUCCESS
    return TreeNode(path=path, name=path, kind="action", type="Leaf", status=status, message=str(number))


def behind(browser: Browser, seconds: float, *, every: bool) -> list[float]:
    """Return by how many seconds the page was behind each time that it showed another number.

    Args:
        browser: a real one.
        seconds: how long the tree changes.
        every: whether all nodes are drawn.
    """
    robot = FakeRobot(seconds=100.0, tree=large_tree(0))
    trees = [large_tree(number) for number in range(int(RATE * seconds))]
    with served(robot) as address, opened(browser, address) as page:
        page.goto("/")
        expect(page.get_by_role("checkbox")).to_be_visible()
        if every:
            page.get_by_role("checkbox").check()
        page.evaluate(SAMPLE)
        told, began = [], time.monotonic()
        for number, tree in enumerate(trees):
            while time.monotonic() < began + number / RATE:
                page.wait_for_timeout(1)
            told.append(time.time())
            robot.tell((TREE, tree))
        expect(page.locator(".node .said").last).to_have_text(str(len(trees) - 1))
        seen = page.evaluate("window.seen")
    return [at - told[int(number)] for at, number in seen if number]


def test_the_page_shows_the_newest_of_many(browser: Browser) -> None:
    assert behind(browser, 1.0, every=False)


@pytest.mark.thorough
@pytest.mark.parametrize("every", [False, True])
def test_the_page_is_not_behind(browser: Browser, capsys: pytest.CaptureFixture[str], *, every: bool) -> None:
    late = behind(browser, 5.0, every=every)
    drawn = "all nodes" if every else "folded"
    figures = f"{statistics.median(late):.3f} s median, {max(late):.3f} s at most, {len(late)} times drawn"
    with capsys.disabled():
        sys.stdout.write(f"{NODES} nodes, {RATE}/s, {drawn}: behind by {figures}\n")
    assert statistics.median(late) < BEHIND
    assert statistics.median(late[-len(late) // 4 :]) < BEHIND, "the end is as near as the beginning"
