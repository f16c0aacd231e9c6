"""All words on the page can be read, light and dark: contrast of 4.5, large ones of 3 (WCAG 2.2, AA)."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from web_fake import FakeRobot, served

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import (
    TaskState,
    TaskStatus,
    TreeNode,
    TreeSnapshot,
)

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Page, expect
from web_chromium import MARKS, opened

pytestmark = MARKS
FAINT = """() => {
  const pen = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
  const rgba = colour => {
    pen.clearRect(0, 0, 1, 1);
    pen.fillStyle = colour;
    pen.fillRect(0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data].map((each, i) => i < 3 ? each : each / 255);
  };
  const over = (top, below) => below.map((each, i) => top[i] * top[3] + each * (1 - top[3]));
  const parents = element => element ? [...parents(element.parentElement), element] : [];
  const light = colour => colour.map(each => each / 255)
    .map(each => each <= 0.03928 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4)
    .reduce((sum, each, i) => sum + each * [0.2126, 0.7152, 0.0722][i], 0);
  const words = element => [...element.childNodes].some(each => each.nodeType === 3 && each.data.trim());
  const all = document.querySelectorAll("body *:not(svg *, .labels *, :disabled)");
  return [...all].filter(words).flatMap(element => {
    const style = getComputedStyle(element), around = parents(element);
    if (style.visibility === "hidden" || !element.getBoundingClientRect().width) return [];
    const paint = (below, each) => over(rgba(getComputedStyle(each).backgroundColor), below);
    const ground = around.reduce(paint, [255, 255, 255]);
    const [r, g, b, alpha] = rgba(style.color);
    const shown = around.reduce((product, each) => product * getComputedStyle(each).opacity, alpha);
    const [low, high] = [light(ground), light(over([r, g, b, shown], ground))].sort((a, b) => a - b);
    const size = parseFloat(style.fontSize), large = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
    const ratio = (high + 0.05) / (low + 0.05);
    const faint = ratio < (large ? 3 : 4.5);
    return faint ? [`${element.className} ${element.textContent} ${ratio.toFixed(2)}`] : [];
  });
}"""
"""Names the words that are too faint, with their contrast."""


@pytest.fixture
def page(browser: Browser, robot: FakeRobot) -> Iterator[Page]:
    with served(robot) as address, opened(browser, address) as made:
        yield made


@pytest.fixture
def robot() -> FakeRobot:
    now = RobotTime(boot="fake", seconds=100.0)
    lost = Failure(kind=FailureKind.ITEM_NOT_FOUND, message="item 29 is not in view")
    status = TaskStatus(
        task="fetch-1", kind="fetch", request={"task": "fetch", "item": 29}, state=TaskState.FAILED,
        accepted_at=0.0, started=now, ended=now, failure=None,
    )  # fmt: skip
    waiting = status.model_copy(
        update={"task": "fetch-2", "state": TaskState.QUEUED, "waits_for": "its turn"}
    )
    ends = {"SUCCESS": "yes", "FAILURE": lost.message, "RUNNING": "remaining 2.4", "INVALID": ""}
    leaves = tuple(
        TreeNode.model_validate(
            {"path": f"root/{now} {last}", "name": f"{now} {last}", "kind": "action", "type": "Leaf"}
            | {"status": now, "last": last, "message": ends[now]}
        )
        for now in ends
        for last in ends
    )
    root = TreeNode(path="root", name="root", kind="sequence", type="Sequence", children=leaves)
    tree = TreeSnapshot(stamp=now, task="fetch-1", kind="fetch", tick=1, root=root)
    return FakeRobot(tasks=(status, waiting), tree=tree)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_all_words_can_be_read(page: Page, scheme: str) -> None:
    page.emulate_media(color_scheme=scheme)  # type: ignore[arg-type]
    for address in ("/", "/map", "/request", "/history", "/task/fetch-1?at=100"):
        page.goto(address)
        expect(page.locator(".link")).to_contain_text("nothing heard")
        expect(page.locator(".card").first).to_be_visible()
        if address == "/":
            page.get_by_label("all 17 nodes").check()
            expect(page.locator(".node.past .sign.SUCCESS").first).to_be_visible()
        assert page.evaluate(FAINT) == [], address
