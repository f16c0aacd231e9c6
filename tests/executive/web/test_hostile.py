"""Words that look like markup are shown as words, in each field of each message that the page shows."""

from __future__ import annotations

import contextlib
import json
from typing import Any, TypeVar

import pytest
from web_fake import FakeRobot, served

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP_STATE, Topic
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.reflex import PipelineState, ReflexState, pipeline_state, reflex_state
from tandem.skills.ports.tasks import (
    TASK_STATUS,
    TREE,
    Attempt,
    KindOfTask,
    NodeStatus,
    Progress,
    Question,
    Span,
    TaskKinds,
    TaskState,
    TaskStatus,
    Timeline,
    TreeNode,
    TreeSnapshot,
)
from tandem.skills.ports.world import (
    ROBOT_POSE,
    SCENE,
    WORLD,
    Box,
    ItemFact,
    Placed,
    PlanningScene,
    RobotPose,
    SceneObject,
    WorldState,
)

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Page, expect
from playwright.sync_api import TimeoutError as PlaywrightTimeout
from web_chromium import MARKS, opened

pytestmark = MARKS
M = TypeVar("M", bound=Message)
EVIL = "<img src=x onerror=document.title='broken'>\"'&amp;{{1}}${1}"
TELLS = 30
"""Seconds for a page to listen, on a machine that is busy with other things."""
NOW = RobotTime(boot="fake", seconds=100.0)
THERE = Pose(position=(0.5, 0.5, 0.7), orientation=(0.0, 0.0, 0.0, 1.0))
CAUSE = Failure(kind=FailureKind.OTHER, message=EVIL, where=EVIL)
FAILURE = Failure(
    kind=FailureKind.GRASP_EMPTY, message=EVIL, where=EVIL, evidence={EVIL: EVIL}, causes=(CAUSE,)
)
REQUEST = {"task": EVIL, "by": EVIL, "item": EVIL, "labels": {EVIL: EVIL}, "retry_of": EVIL, EVIL: [EVIL]}
VIEWS = ("/", "/map?item=29", "/request", f"/request?task={EVIL}", "/history", "/task/failed", "/task/asks")


def status(task: str, state: TaskState, **more: Any) -> TaskStatus:
    made = TaskStatus(
        task=task, kind=EVIL, request=REQUEST, state=state, accepted_at=1.0,
        progress=Progress(phase=EVIL, fraction=0.5),
        waits_for=EVIL, client_id=EVIL, running=(EVIL,), started=NOW, begun=2, **more,
    )  # fmt: skip
    return TaskStatus.model_validate_json(made.model_dump_json())


FAILED = status(
    "failed", TaskState.FAILED, failure=FAILURE, result={EVIL: EVIL}, ended=NOW,
    tried=(Attempt(at=NOW, failure=FAILURE, recovery=EVIL, times=1, picture=EVIL),),
)  # fmt: skip
ASKS = status("asks", TaskState.RUNNING, question=Question(node=EVIL, text=EVIL, choices=(EVIL, "no")))
WAITS = status("waits", TaskState.QUEUED)
LEAF = TreeNode(path=f"a/{EVIL}", name=EVIL, kind="action", type=EVIL, message=EVIL)
TREE_ = TreeSnapshot(
    task="asks", kind=EVIL, tick=1, stamp=NOW,
    root=TreeNode(path="a", name=EVIL, kind="sequence", type=EVIL, message=EVIL, children=(LEAF,)),
)  # fmt: skip


def robot() -> FakeRobot:
    fake = FakeRobot(seconds=100.0, tasks=(ASKS, WAITS, FAILED), tree=TREE_, unable={"no": EVIL})
    schema = {
        "type": "object", "description": EVIL, "required": [EVIL],
        "properties": {EVIL: {"type": "string", "description": EVIL, "default": EVIL}, "e": {"enum": [EVIL]}},
    }  # fmt: skip
    fake.kinds = TaskKinds(
        kinds=(
            KindOfTask(name=EVIL, summary=EVIL, request=schema),
            KindOfTask(name="no", summary=EVIL, request=schema),
        ),
        items=(EVIL,),
    )
    fake.timeline = Timeline(
        task="failed",
        spans=(
            Span(
                path=f"a/{EVIL}", kind="action", begin=NOW, end=NOW, status=NodeStatus.FAILURE, message=EVIL
            ),
        ),
    )
    fake.site = evil_site(fake)
    return fake


def evil_site(fake: FakeRobot) -> Any:
    document = json.loads(fake.site.model_dump_json())
    for part in ("depots", "spots", "furniture"):
        for number, each in enumerate(document[part]):
            each["name"] = f"{EVIL}{number}"
    return fake.site.model_copy(
        update={
            part: tuple(
                old.model_copy(update={"name": new["name"]})
                for old, new in zip(getattr(fake.site, part), document[part], strict=True)
            )
            for part in ("depots", "spots", "furniture")
        }
    )


def told(fake: FakeRobot) -> list[tuple[Topic[Any], Message]]:
    here = FloorPose(x=0.0, y=0.0, yaw=0.0)
    fact = ItemFact(
        item=29, size=(0.07, 0.07, 0.07), tag_in_map=THERE, seen=NOW, quality=1.0, position_sigma=0.0
    )
    thing = SceneObject(name=EVIL, kind="item", box=Box(size=fact.size, pose=THERE), item=29)
    reflex = ReflexState(
        reflex="r", on=False, by=EVIL, resources=("base",), rank=1, holds=True, fired=1, about=EVIL
    )
    pose = RobotPose(
        stamp=NOW, localised=False, base_in_map=here, odom_in_map=here, position_sigma=0.1, yaw_sigma=0.1,
        moving=False, reason=EVIL,
    )  # fmt: skip
    del fake
    return [
        (STOP_STATE, StopState(stopped=True, by=EVIL, reason=EVIL)),
        (SCENE, PlanningScene(stamp=NOW, version=1, objects=(thing,))),
        (
            WORLD,
            WorldState(stamp=NOW, version=1, items=(fact,), placed=(Placed(item=29, depot=EVIL, slot=0),)),
        ),
        (ROBOT_POSE, pose),
        (TASK_STATUS, ASKS),
        (TREE, TREE_),
        (reflex_state("r"), reflex),
        (
            pipeline_state("base"),
            PipelineState(stamp=NOW, resource="base", holder=EVIL, reflex=EVIL, why=FAILURE, doing=(EVIL,)),
        ),
    ]


def test_hostile_words_are_words_in_each_view(browser: Browser) -> None:
    fake = robot()
    with served(fake) as address, opened(browser, address) as page:
        for view in VIEWS:
            page.goto(view)
            expect(page.locator(".link")).not_to_contain_text("no link")
            expect(page.locator("main .card").first).to_be_visible()
            tell_until_heard(fake, page)
            expect(page.locator(".stopped")).to_contain_text(EVIL)
            page.evaluate("document.querySelectorAll('main details').forEach(each => { each.open = true })")
            expect(page.locator("main")).to_contain_text(EVIL)
            assert unharmed(page), view
            assert page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0, view


def tell_until_heard(fake: FakeRobot, page: Page) -> None:
    """Tell all again and again, as a robot does: what is told before the page listens is lost."""
    for _ in range(TELLS):
        fake.tell(*told(fake))
        with contextlib.suppress(PlaywrightTimeout):
            page.locator(".stopped").wait_for(timeout=1000.0)
            return


def unharmed(page: Page) -> bool:
    """Say whether no markup came out of words: no picture but those of attempts, nothing run."""
    pictures = page.locator("img:not([src^='/api/task/'])").count()
    return pictures == 0 and "broken" not in page.title()
