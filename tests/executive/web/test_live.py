"""What viewers are told while things happen: each at its own pace, and nothing is done without them."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Callable
from typing import Any

import pytest
from starlette.testclient import TestClient, WebSocketTestSession
from starlette.websockets import WebSocketDisconnect
from web_rig import AT, Rig

from tandem.executive.web import viewers
from tandem.executive.web.feed import LASER_EVERY, Feed
from tandem.executive.web.viewers import Told, Update, Viewer, merge
from tandem.skills.ports.action import GoalState, GoalStatus, status_topic
from tandem.skills.ports.actions.base import DRIVE, DriveFeedback
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import Occupancy, pack
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.tasks import TREE, NodeStatus, TaskState, TaskStatus, TreeNode, TreeSnapshot
from tandem.skills.ports.whereabouts import RobotWhereabouts, whereabouts
from tandem.skills.ports.world import (
    PEOPLE,
    SCENE,
    SIGHTINGS,
    People,
    PlanningScene,
    Sighting,
    Sightings,
    TrackedPerson,
)
from tandem.skills.wire.memory import MemoryHub

LIVE = AT.replace("http", "ws") + "/live"
WAIT = {"task": "wait", "item": 3}


def hear(socket: WebSocketTestSession, until: Callable[[Update], bool]) -> Update:
    """Take in updates until what is known is so."""
    known: Update = {}
    for _ in range(200):
        merge(known, socket.receive_json())
        if until(known):
            return known
    raise AssertionError(known)


def state(known: Any, task: str) -> str:  # JSON
    return str(known.get("tasks", {}).get(task, {}).get("state"))


@pytest.mark.parametrize(
    ("older", "newer", "merged"),
    [
        ({}, {"pose": 1}, {"pose": 1}),
        ({"pose": 1}, {"pose": 2}, {"pose": 2}),
        ({"joints": {"a": 1, "b": 1}}, {"joints": {"b": 2}}, {"joints": {"a": 1, "b": 2}}),
        ({"nodes": {"a": 1}}, {"tree": {"task": "b"}}, {"tree": {"task": "b"}}),
        ({"tree": {"task": "b"}}, {"nodes": {"a": 2}}, {"tree": {"task": "b"}, "nodes": {"a": 2}}),
    ],
)
def test_what_a_slow_viewer_has_not_read_becomes_one_update(
    older: Update, newer: Update, merged: Update
) -> None:
    merge(older, newer)
    assert older == merged


def test_a_viewer_sees_a_task_from_its_request_to_its_end(page: TestClient, rig: Rig) -> None:
    with page.websocket_connect(LIVE, headers={"origin": AT}) as socket:
        hear(socket, lambda known: known.get("executive") is True)
        task = page.post("/api/request", json=WAIT).json()["task"]
        rig.here.step(3)
        known = hear(socket, lambda known: state(known, task) == "RUNNING" and "tree" in known)
        assert known["tree"]["root"]["path"] == "wait"  # type: ignore[index, call-overload]
        rig.here.world(1)
        rig.here.step(5)
        hear(socket, lambda known: state(known, task) == "SUCCEEDED")


def test_who_comes_late_is_told_what_is_known(page: TestClient, rig: Rig) -> None:
    task = page.post("/api/request", json=WAIT).json()["task"]
    rig.here.step(3)
    for _ in range(2):
        with page.websocket_connect(LIVE, headers={"origin": AT}) as socket:
            hear(socket, lambda known: state(known, task) == "RUNNING" and "tree" in known)


def test_the_stop_is_told(page: TestClient, rig: Rig) -> None:
    with page.websocket_connect(LIVE, headers={"origin": AT}) as socket:
        hear(socket, lambda known: "link" in known and bool(rig.ears))
        page.post("/api/verb/stop", json={"reason": "a test"})
        known = hear(socket, lambda known: "stop" in known)
        assert known["stop"] == {"stopped": True, "by": "anna", "reason": "a test"}


def test_without_viewers_nothing_is_heard(page: TestClient, rig: Rig) -> None:
    page.get("/api/session")
    assert rig.ears == []
    with page.websocket_connect(LIVE, headers={"origin": AT}) as socket:
        hear(socket, lambda known: known.get("executive") is True)
    deadline = time.monotonic() + 20.0
    while len(rig.closed) < len(rig.ears) and time.monotonic() < deadline:
        page.get("/api/session")
    assert rig.closed == rig.ears != []


def test_a_page_from_elsewhere_hears_nothing(page: TestClient, rig: Rig) -> None:
    elsewhere = {"origin": "http://elsewhere.example"}
    with pytest.raises(WebSocketDisconnect), page.websocket_connect(LIVE, headers=elsewhere) as socket:
        socket.receive_json()
    assert rig.ears == []


def test_of_a_tree_only_what_changes_is_told(rig: Rig) -> None:
    feed = Feed(rig.here.hub.endpoint(), time.monotonic)
    rig.here.ask(WAIT)
    rig.here.step(2)
    assert "tree" in feed.poll()
    rig.here.world(1)
    rig.here.step(3)
    update = feed.poll()
    assert ("tree" in update, set(update["nodes"])) == (False, {"wait", "wait/wait for the world"})  # type: ignore[arg-type]


def test_an_answer_that_was_overtaken_hides_nothing() -> None:
    """As after a restart of the executive: what it answers at first is older than what is heard meanwhile."""
    hub = MemoryHub()
    bus, feed = hub.endpoint(), Feed(hub.endpoint(), time.monotonic)

    def tree(seconds: float, *states: NodeStatus) -> TreeSnapshot:
        leaves = tuple(
            TreeNode(path=f"t/{number}", name="leaf", kind="action", type="Leaf", status=state)
            for number, state in enumerate(states)
        )
        root = TreeNode(path="t", name="t", kind="sequence", type="Sequence", children=leaves)
        return TreeSnapshot(task="t", kind="t", tick=1, stamp=RobotTime(boot="b", seconds=seconds), root=root)

    known: Update = {}
    TREE.publish(bus, tree(2.0, NodeStatus.RUNNING, NodeStatus.INVALID))
    merge(known, feed.poll())
    merge(known, feed.know([], tree(1.0, NodeStatus.INVALID, NodeStatus.INVALID)))
    TREE.publish(bus, tree(3.0, NodeStatus.RUNNING, NodeStatus.RUNNING))
    merge(known, feed.poll())
    now = {"t/0": "RUNNING", "t/1": "RUNNING"}
    told: Any = known["tree"]
    shown = {each["path"]: each["status"] for each in told["root"]["children"]}
    changed: Any = known.get("nodes", {})
    assert shown | {path: status for path, (status, _, _) in changed.items()} == now


def test_a_task_that_waits_is_not_forgotten_over_those_that_end() -> None:
    feed = Feed(MemoryHub().endpoint(), time.monotonic)

    def task(name: str, state: TaskState) -> TaskStatus:
        return TaskStatus(task=name, kind="go", request={}, state=state, accepted_at=0.0)

    ended = [task(str(number), TaskState.SUCCEEDED) for number in range(500)]
    feed.know([task("waits", TaskState.QUEUED), *ended], None)
    told: Any = feed.whole()["tasks"]
    assert (len(told), "waits" in told, "499" in told) == (201, True, True)


def test_of_joints_only_those_that_move_are_told() -> None:
    hub = MemoryHub()
    bus, feed = hub.endpoint(), Feed(hub.endpoint(), time.monotonic)

    def say(seconds: float, *positions: float) -> None:
        stamp = RobotTime(boot="b", seconds=seconds)
        zeros = tuple(0.0 for _ in positions)
        names = ("first", "second")
        told = JointStates(stamp=stamp, names=names, positions=positions, velocities=zeros, efforts=zeros)
        JOINT_STATES.publish(bus, told)

    say(1.0, 0.1, 0.2)
    assert feed.poll()["joints"] == {"first": 0.1, "second": 0.2}
    say(2.0, 0.1001, 0.3)
    assert feed.poll()["joints"] == {"second": 0.3}
    assert feed.whole()["joints"] == {"first": 0.1, "second": 0.3}


def test_a_planned_way_is_told_while_the_base_drives() -> None:
    hub = MemoryHub()
    bus, feed = hub.endpoint(), Feed(hub.endpoint(), time.monotonic)
    here = FloorPose(x=0.0, y=0.0, yaw=0.0)
    fed = DriveFeedback(base_in_map=here, remaining=2.0, progress=0.0, way=((0.0, 0.0), (2.0, 0.0)))
    for number, state in enumerate((GoalState.RUNNING, GoalState.SUCCEEDED), 1):
        told = GoalStatus(goal_id="a/b/1", state=state, sequence=number, feedback=fed.model_dump(mode="json"))
        status_topic(DRIVE.name).publish(bus, told)
        assert feed.poll()["plan"] == ([[0.0, 0.0], [2.0, 0.0]] if state is GoalState.RUNNING else [])


def test_the_last_tags_seen_are_told() -> None:
    hub = MemoryHub()
    bus, feed = hub.endpoint(), Feed(hub.endpoint(), time.monotonic)
    there = Pose(position=(0.0, 0.1, 1.0), orientation=(0.0, 0.0, 0.0, 1.0))
    tag = Sighting(
        item=29, stamp=RobotTime(boot="b", seconds=1.0), tag_in_map=there, tag_in_base=there,
        tag_in_camera=there, distance=1.004, quality=0.9, position_sigma=0.01,
    )  # fmt: skip
    for seconds, tags in ((1.0, (tag,)), (2.0, ())):
        SIGHTINGS.publish(bus, Sightings(stamp=RobotTime(boot="b", seconds=seconds), sightings=tags))
    told: Any = feed.poll()["tags"]
    assert (told["stamp"]["seconds"], [each["item"] for each in told["seen"]]) == (1.0, [29])


def test_other_robots_are_told_by_their_own_names_and_when_they_fall_silent() -> None:
    hub, now = MemoryHub(), [0.0]
    commons = hub.endpoint()
    feed = Feed(MemoryHub().endpoint(), lambda: now[0], hub.endpoint(), "r1")
    for key, name in (("r1", "r1"), ("r2", "r2"), ("r3", "r2")):
        told = RobotWhereabouts(name=name, start="s", sequence=1, kind="patrol")
        whereabouts(key).publish(commons, told)
    robots: Any = feed.poll()["robots"]
    assert {name: each["silent"] for name, each in robots.items()} == {"r2": False}
    assert "robots" not in feed.poll()
    now[0] = 10.0
    robots = feed.poll()["robots"]
    assert robots["r2"]["silent"]


def test_people_are_told_where_they_are_and_go() -> None:
    hub, stamp = MemoryHub(), RobotTime(boot="b", seconds=1.0)
    bus, feed = hub.endpoint(), Feed(hub.endpoint(), time.monotonic)
    one = TrackedPerson(
        id=7, x=1.004, y=2.0, vx=0.5, vy=0.0, position_sigma=0.1, radius=0.3, unseen=0.0
    )  # fmt: skip
    told = []
    for people in ((one,), (one,), ()):
        PEOPLE.publish(bus, People(stamp=stamp, people=people))
        told += [update["people"] for _ in range(LASER_EVERY) if "people" in (update := feed.poll())]
    assert told == [{"7": [1.0, 2.0, 0.5, 0.0, 0.3]}, {}]


def test_occupied_space_is_told_when_it_changes_and_once_a_second_at_the_most() -> None:
    hub, seconds = MemoryHub(), 10.0
    bus, now = hub.endpoint(), RobotTime(boot="b", seconds=1.0)
    feed = Feed(hub.endpoint(), lambda: seconds)

    def told(*cells: int) -> object:
        occupied = Occupancy(
            stamp=now, version=1, origin=(0, 0, 0), shape=(9, 9, 9), resolution=0.1, cells=pack(cells)
        )
        SCENE.publish(bus, PlanningScene(stamp=now, version=1, objects=(), occupied=occupied))
        return feed.poll().get("occupied")

    assert told(1, 2) == {"origin": [0, 0, 0], "shape": [9, 9, 9], "resolution": 0.1, "cells": pack((1, 2))}
    assert told(1, 2, 3) is None, "not before a second has passed"
    seconds = 11.0
    assert told(4) == {"origin": [0, 0, 0], "shape": [9, 9, 9], "resolution": 0.1, "cells": pack((4,))}
    seconds = 12.0
    assert told(4) is None, "it has not changed"
    assert feed.whole()["scene"] == {"objects": [], "occupied": None}, "cells are not told twice"


def test_what_all_are_told_becomes_text_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of twenty viewers only one that has not read what was before gets a text of its own."""
    quick, slow = [Viewer({}) for _ in range(20)], Viewer({"pose": 1, "stop": 1})
    told = Told({"pose": 2})
    made: list[Update] = []

    def as_text(update: Update) -> str:
        made.append(update)
        return json.dumps(update)

    monkeypatch.setattr(viewers, "as_text", as_text)
    for each in (*quick, slow):
        each.tell(told)
    assert {asyncio.run(each.next()) for each in quick} == {'{"pose": 2}'}
    assert json.loads(asyncio.run(slow.next())) == {"pose": 2, "stop": 1}
    assert made == [{"pose": 2}, {"pose": 2, "stop": 1}]
