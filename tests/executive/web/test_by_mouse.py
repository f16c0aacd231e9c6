"""What each role sees and sends in a real browser, beside a robot in memory that notes what it is asked."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import pytest
from web_fake import FakeRobot, served
from web_rig import of_role

from tandem.executive.security.role import Role
from tandem.executive.web.verbs import VERBS
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import STOP
from tandem.skills.ports.reflex import ReflexState, reflex_state, reflex_switch
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_ANSWER,
    TASK_FORCE,
    TREE,
    KindOfTask,
    Question,
    TaskKinds,
    TaskState,
    TaskStatus,
    TreeNode,
    TreeSnapshot,
)

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Page, expect
from web_chromium import MARKS, opened, picture

pytestmark = MARKS
QUESTION: Final = Question(
    node="fetch/ask", text="Is the way free now?", choices=("it is free", "leave the item")
)


def task(state: TaskState, **more: object) -> TaskStatus:
    name = str(state).lower()
    fields = {"request": {"task": "fetch", "item": 29}, "accepted_at": 1.0, **more}
    return TaskStatus.model_validate({"task": name, "kind": "fetch", "state": state, **fields})


WHY: Final = Failure(kind=FailureKind.GRASP_EMPTY, message="nothing is between the fingers")
TASKS: Final = (
    task(TaskState.RUNNING, question=QUESTION),
    *(task(state) for state in (TaskState.QUEUED, TaskState.PAUSED, TaskState.CANCELING)),
    task(TaskState.FAILED, failure=WHY),
)
REFLEX: Final = ReflexState(
    reflex="avoid_collision", on=True, resources=("base",), rank=2, holds=False, fired=0, about="Backs off."
)
KIND: Final = KindOfTask(
    name="fetch",
    summary="Fetch an item.",
    request={
        "type": "object",
        "properties": {
            "task": {"const": "fetch"},
            "item": {"type": "integer"},
            "priority": {"type": "integer", "default": 0},
        },
        "required": ["task", "item"],
    },
)
LEAF: Final = TreeNode(path="fetch/ask", name="ask", kind="action", type="Ask", status="RUNNING")
TREE_: Final = TreeSnapshot(
    task="running", kind="fetch", tick=1,
    root=TreeNode(
        path="fetch", name="fetch", kind="sequence", type="Seq", status="RUNNING", children=(LEAF,)
    ),
)  # fmt: skip
REQUESTS: Final = [("queued", "Cancel"), ("running", "Cancel"), ("paused", "Cancel"), ("failed", "Retry")]
PRESSED: Final[dict[str, list[tuple[str, str]]]] = {
    "viewer": [],
    "requester": REQUESTS,
    "operator": [
        *REQUESTS,
        ("running", "Pause"),
        *(("running", choice) for choice in QUESTION.choices),
        ("paused", "Resume"),
        ("paused", "Step"),
        ("canceling", "Abandon"),
    ],
}
"""Which buttons the page of a task has, by role."""


@pytest.fixture
def robot() -> FakeRobot:
    return FakeRobot(
        seconds=100.0,
        tasks=TASKS,
        tree=TREE_,
        kinds=TaskKinds(kinds=(KIND,)),
        reflexes={REFLEX.reflex: REFLEX},
    )


@pytest.fixture
def page(browser: Browser, robot: FakeRobot) -> Iterator[Page]:
    with served(robot) as address, opened(browser, address) as made:
        yield made


def show(page: Page, view: str) -> None:
    """Open a view, and wait until it hears."""
    page.goto(view)
    expect(page.locator(".link")).to_contain_text("nothing heard")


@pytest.mark.parametrize("role", PRESSED)
def test_each_role_sees_its_verbs_and_what_it_presses_is_asked(
    browser: Browser, robot: FakeRobot, role: Role
) -> None:
    robot.who = of_role(role)
    found = []
    with served(robot) as address, opened(browser, address) as page:
        for each in ("queued", "running", "paused", "canceling", "failed"):
            page.goto(f"/task/{each}")
            expect(page.locator(".task h2")).to_contain_text(each.upper())
            expect(page.get_by_label("priority")).to_have_count(int((role, each) == ("operator", "queued")))
            for name in page.locator(".task button").all_inner_texts():
                found.append((each, name))
                if name == QUESTION.choices[1]:
                    continue  # the question is answered by then
                before = len(robot.asked)
                page.locator(".task").get_by_role("button", name=name).click()
                said = f"Answered: {name}" if name == QUESTION.choices[0] else f"{name}: taken."
                expect(page.locator(".said-bar")).to_contain_text(said)
                assert len(robot.asked) == before + 1
    assert sorted(found) == sorted(PRESSED[role])


def test_a_viewer_sees_no_verbs_and_can_send_none(browser: Browser, robot: FakeRobot) -> None:
    robot.who = of_role("viewer")
    with served(robot) as address, opened(browser, address) as page:
        show(page, "/")
        robot.tell((reflex_state(REFLEX.reflex), REFLEX), (TREE, TREE_))
        page.locator(".resources summary").click()
        expect(page.locator(".reflexes")).to_contain_text("Backs off.")
        expect(page.locator(".question")).to_contain_text(
            "An operator may answer: it is free, leave the item"
        )
        page.get_by_role("treeitem").last.click()
        offered = page.locator("header button, .side button:not(.bar button)").all_inner_texts()
        assert offered == [], "neither stop nor verb nor switch"
        picture(page, "page-viewer")
        page.keyboard.press("Control+.")
        page.goto("/request?task=fetch&item=29")
        expect(page.locator("form")).to_contain_text("This key does not allow requests.")
        expect(page.get_by_role("button", name="Send")).to_have_count(0)
        page.get_by_label("item").press("Enter")  # sends a form that has no button
        send = """verb => fetch(verb, {method: "POST", body: JSON.stringify({task: "running"}),
            headers: {"Content-Type": "application/json"}}).then(answer => answer.status)"""
        asked = ["/api/request", *(f"/api/verb/{verb}" for verb in VERBS)]
        assert {verb: page.evaluate(send, verb) for verb in asked} == dict.fromkeys(asked, 403)
    assert robot.asked == []


@pytest.mark.parametrize("role", PRESSED)
def test_a_node_of_a_test_run_is_forced_by_an_operator_only(
    browser: Browser, robot: FakeRobot, role: Role
) -> None:
    robot.who = of_role(role)
    robot.tasks = (task(TaskState.RUNNING, request={"task": "fetch", "item": 29, "test_run": True}),)
    with served(robot) as address, opened(browser, address) as page:
        show(page, "/")
        leaf = page.get_by_role("treeitem").last
        leaf.click()
        forces = {
            "Force ✓": ("SUCCESS", "It will succeed without its work."),
            "Force ✗": ("FAILURE", "It will fail without its work."),
        }
        expect(leaf.get_by_role("button", name="Force")).to_have_count(
            len(forces) if role == "operator" else 0
        )
        for name, (_, words) in forces.items() if role == "operator" else ():
            leaf.get_by_role("button", name=name).click()
            expect(page.locator(".said-bar")).to_contain_text(words)
    wanted = [status for status, _ in forces.values()] if role == "operator" else []
    assert robot.asked == [
        (TASK_FORCE.key, {"task": "running", "node": LEAF.path, "status": status}) for status in wanted
    ]


def test_a_question_is_answered_in_one_tab_and_gone_in_the_other(
    page: Page, browser: Browser, robot: FakeRobot
) -> None:
    show(page, "/task/running")
    with opened(browser, page.url.removesuffix("/task/running"), width=800) as other:
        show(other, "/task/running")
        for each in (page, other):
            expect(each.get_by_role("alert").filter(has_text=QUESTION.text)).to_be_visible()
        picture(page, "page-question")
        page.get_by_role("button", name="it is free").click()
        for each in (page, other):
            expect(each.locator(".question")).to_have_count(0)
    assert robot.asked == [(TASK_ANSWER.key, {"task": "running", "answer": "it is free"})]


def test_an_answer_that_comes_too_late_is_said_so(page: Page, robot: FakeRobot) -> None:
    show(page, "/task/running")
    expect(page.locator(".question")).to_be_visible()
    robot.tasks = ()  # somebody else has answered
    page.get_by_role("button", name="leave the item").click()
    expect(page.get_by_role("alert").last).to_contain_text("running asks nothing of that kind")
    assert robot.asked == []


def test_a_stop_in_one_tab_is_released_in_another(page: Page, browser: Browser, robot: FakeRobot) -> None:
    show(page, "/request")
    with opened(browser, page.url.removesuffix("/request"), width=800) as other:
        show(other, "/history")
        page.get_by_role("button", name="STOP").click()
        expect(other.locator(".stopped")).to_contain_text("Stopped by anna: the stop on the page")
        other.get_by_role("button", name="Release").click()
        expect(page.locator(".stopped")).to_have_count(0)
    assert [key for key, _ in robot.asked] == [STOP.key, "hw/stop/release"]


def test_a_form_is_as_it_was_when_the_page_is_loaded_anew(page: Page, robot: FakeRobot) -> None:
    show(page, "/request?task=fetch")
    page.get_by_label("item").fill("29")
    page.locator("summary", has_text="how urgent").click()
    page.get_by_label("priority").fill("5")
    page.reload()
    expect(page.get_by_label("item")).to_have_value("29")
    expect(page.get_by_label("priority")).to_be_visible()
    expect(page.get_by_label("priority")).to_have_value("5")
    assert robot.asked == []
    page.get_by_role("button", name="Send").dblclick()
    expect(page.locator(".said-bar")).to_contain_text("new-1 was accepted")
    sent = [document for key, document in robot.asked if key == REQUEST]
    assert len({document.pop("id") for document in sent}) == 1, "two clicks are one request"
    assert sent[0] == {"task": "fetch", "item": 29, "priority": 5}


def test_one_tab_switches_a_reflex_off_while_another_asks_about_it(
    page: Page, browser: Browser, robot: FakeRobot
) -> None:
    robot.reflexes[REFLEX.reflex] = protects = REFLEX.model_copy(update={"protects": "people"})
    show(page, "/")
    with opened(browser, page.url.rstrip("/")) as other:
        show(other, "/")
        robot.tell((reflex_state(REFLEX.reflex), protects))
        for each in (page, other):
            each.locator(".resources summary").click()
            each.get_by_role("button", name="Switch avoid_collision off").click()
            expect(each.get_by_role("alertdialog")).to_be_visible()
        page.get_by_role("button", name="Switch off all the same").click()
        expect(other.locator(".warn")).to_contain_text("avoid_collision is off, by anna")
        expect(other.get_by_role("alertdialog")).to_have_count(0)
    assert [key for key, _ in robot.asked] == [reflex_switch(REFLEX.reflex).key]
