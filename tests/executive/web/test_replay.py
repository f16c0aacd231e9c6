"""The page over a record: what live showed, at any moment; and no orders."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient
from web_record import MOMENTS, STEP, Run, record, whole

from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.recording import Facts, Recorded, Span, open_recording
from tandem.executive.web.app import application
from tandem.executive.web.feed import Feed
from tandem.executive.web.replay import Move, Replay
from tandem.executive.web.verbs import VERBS
from tandem.executive.web.viewers import Update, merge
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.whereabouts import RobotWhereabouts, whereabouts
from tandem.skills.wire.clocks import SteppedClocks

AT = "http://127.0.0.1:8447"


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> tuple[Run, Path]:
    path = tmp_path_factory.mktemp("record") / "box.jsonl.gz"
    return record(path), path


def shown_at(replay: Replay, at: float) -> Update:
    """Return what a page that is opened at a moment is told."""
    replay.move(Move(at=at, speed=0.0))
    feed = Feed(replay.player.bus, lambda: 0.0)
    replay.player.say_known()
    feed.poll()
    return whole(feed)


@pytest.mark.parametrize("order", [sorted, lambda each: sorted(each, reverse=True)])
def test_at_ten_moments_it_shows_what_live_showed(run: tuple[Run, Path], order: Callable[[Any], Any]) -> None:
    live, path = run
    replay = Replay(open_recording(path), lambda: 0.0)
    assert len(MOMENTS) == 10
    for tick in order(MOMENTS):
        told = shown_at(replay, (tick + 1) * STEP)
        assert set(told) == set(live.shown[tick])
        for part, value in told.items():
            assert value == live.shown[tick][part], (tick, part)
    assert any("tree" in each for each in live.shown.values())


def test_the_past_takes_no_orders(run: tuple[Run, Path]) -> None:
    with TestClient(application(Replay(open_recording(run[1]))), base_url=AT, headers={"origin": AT}) as page:
        told = page.get("/api/session").json()
        assert (told["role"], told["may"], told["robot"]) == ("replay", [], "tiago")
        for verb in VERBS:
            answer = page.post(f"/api/verb/{verb}", json={})
            assert (answer.status_code, "takes no orders" in answer.json()["error"]) == (403, True)


def test_a_viewer_moves_through_it_and_the_tasks_are_as_they_were(run: tuple[Run, Path]) -> None:
    with TestClient(application(Replay(open_recording(run[1]))), base_url=AT, headers={"origin": AT}) as page:
        for at, count in ((15.0, 1), (0.5, 0), (15.0, 1)):
            moved = page.post("/api/replay", json={"at": at, "speed": 0}).json()["replay"]
            assert (moved["at"], moved["speed"], moved["cause"]["at"]) == (at, 0.0, 3.0)
            assert page.get("/api/history").json()["count"] == count
            with page.websocket_connect(AT.replace("http", "ws") + "/live", headers={"origin": AT}) as socket:
                known: Update = {}
                while "replay" not in known or "executive" not in known or "tasks" not in known:
                    merge(known, socket.receive_json())
                assert len(known["tasks"]) == count  # type: ignore[arg-type]
        for wrong in ({"at": "soon"}, {"speed": -1}, {"speed": 1e9}, {"colour": 1}):
            assert page.post("/api/replay", json=wrong).status_code == 422


def test_other_robots_are_where_they_were_and_grow_old_by_the_record_s_time(tmp_path: Path) -> None:
    told = RobotWhereabouts(
        name="r3", start="a", sequence=1, base_in_map=FloorPose(x=1.0, y=0.5, yaw=0.0), kind="follow"
    )
    payload = told.model_dump_json().encode()
    heard = Recorded(whereabouts("r3").key, 5.0, RobotTime(boot="b", seconds=5.0), 0, payload)
    path, host = tmp_path / "box.jsonl.gz", SteppedClocks()
    write_lines(path, Facts(site="lab", robot="r2", release="", began=0.0), Span(0.0, 20.0), (), (heard,))
    replay = Replay(open_recording(path), host.monotonic)
    replay.move(Move(at=5.5, speed=0.0))
    ears = asyncio.run(replay.listen())
    feed = Feed(ears.bus, host.monotonic, ears.commons, "r2", age=ears.age)

    def robots() -> object:
        ears.turn()
        feed.poll()
        return feed.whole()["robots"]

    there = {
        "at": [1.0, 0.5, 0.0],
        "task": "",
        "kind": "follow",
        "phase": "",
        "size": [None, None],
        "silent": False,
    }
    assert robots() == {"r3": there}
    host.advance(60.0)  # as it stands
    assert robots() == {"r3": there}
    replay.player.seek(15.0)
    assert robots() == {"r3": there | {"silent": True}}


def test_a_robot_is_no_record(page: TestClient) -> None:
    answer = page.post("/api/replay", json={"at": 1.0})
    assert (answer.status_code, answer.json()["error"]) == (409, "this page shows a robot, not a record")
