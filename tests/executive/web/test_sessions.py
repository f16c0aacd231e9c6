"""The page beyond its host: who has logged in, what they may do, and when that ends."""

from __future__ import annotations

import datetime as dt
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect
from web_rig import Rig

from tandem.executive.security.authority import Wanted, begin, issue, revoke
from tandem.executive.security.identity import Identity
from tandem.executive.security.links import LinkError, make
from tandem.executive.web.app import application
from tandem.executive.web.sessions import COOKIE, IDLE, LONGEST, LOOK_EVERY, Sessions
from tandem.executive.web.throttle import TRIES

PAGE = "https://robot.example:8447"
START = dt.datetime(2026, 11, 27, tzinfo=dt.UTC)
WAIT = {"task": "wait", "item": 3}
HERE = "192.0.2.1"
PEOPLE = {"anna": "operator", "rob": "requester", "rita": "requester", "vera": "viewer"}


@dataclass
class Time:
    passed: float = 0.0

    def monotonic(self) -> float:
        return self.passed

    def utc(self) -> float:
        return START.timestamp() + self.passed


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("keys") / "keys"
    begin(folder, START)
    for name, role in PEOPLE.items():
        issue(folder, Wanted(role, name), START)  # type: ignore[arg-type]
    return folder


@pytest.fixture
def time() -> Time:
    return Time()


@pytest.fixture
def sessions(made: Path, time: Time) -> Sessions:
    return Sessions(made, PAGE, time.monotonic, time.utc)


def word(made: Path, name: str, time: Time) -> str:
    return make(Identity(made, name), PAGE, time.utc())


@contextmanager
def browsing(rig: Rig, sessions: Sessions, word_: str = "") -> Iterator[TestClient]:
    app = application(rig, sessions=sessions)
    with TestClient(app, base_url=PAGE, headers={"origin": PAGE}) as page:
        if word_:
            assert page.post("/api/login", json={"word": word_}).status_code == 200
        yield page


def test_a_stranger_is_told_nothing_of_the_robot(rig: Rig, sessions: Sessions) -> None:
    with browsing(rig, sessions) as page:
        assert page.get("/").status_code == page.get("/static/app.js").status_code == 200
        for address in ("session", "robot", "site", "kinds", "history", "camera", "task/wait-1"):
            answer = page.get(f"/api/{address}")
            assert (answer.status_code, answer.json()["login"]) == (401, True), address
        assert page.get("/mesh/a/b.stl").status_code == 401
        assert page.post("/api/verb/stop", json={}).status_code == 401
        live = page.websocket_connect("/live", headers={"origin": PAGE})
        with pytest.raises(WebSocketDisconnect), live:
            live.receive_json()
    assert rig.ears == []
    assert not rig.hardware.state.stopped


def test_a_word_opens_the_page_once(rig: Rig, sessions: Sessions, made: Path, time: Time) -> None:
    used = word(made, "anna", time)
    with browsing(rig, sessions) as page:
        answer = page.post("/api/login", json={"word": used})
        cookie = answer.headers["set-cookie"]
        assert cookie.startswith(f"{COOKIE}=")
        assert all(each in cookie for each in ("HttpOnly", "Secure", "SameSite=strict", "Path=/"))
        assert "max-age" in answer.headers["strict-transport-security"]
        told = page.get("/api/session").json()
        assert (told["who"], told["role"], told["login"]) == ("anna", "operator", True)
        again = page.post("/api/login", json={"word": used})
        assert (again.status_code, "was used" in again.json()["error"]) == (401, True)
        page.post("/api/logout", json={})
        assert page.get("/api/session").status_code == 401


@pytest.mark.parametrize("name", PEOPLE)
def test_each_role_may_do_what_it_may_on_the_bus(
    rig: Rig, sessions: Sessions, made: Path, time: Time, name: str
) -> None:
    role = PEOPLE[name]
    with browsing(rig, sessions, word(made, name, time)) as page:
        may = set(page.get("/api/session").json()["may"])
        assert ("stop" in may, "request" in may) == (role == "operator", role != "viewer")
        assert (page.post("/api/verb/stop", json={}).status_code == 403) is (role != "operator")
        assert (page.post("/api/request", json=WAIT).status_code == 403) is (role == "viewer")


def test_the_stop_and_a_request_name_who_has_logged_in(
    rig: Rig, sessions: Sessions, made: Path, time: Time
) -> None:
    with browsing(rig, sessions, word(made, "anna", time)) as page:
        assert page.post("/api/verb/stop", json={}).json()["answer"]["by"] == "anna"
        page.post("/api/verb/release", json={})
        lies = {**WAIT, "labels": {"zone": "n", "asked_by": "vera"}}
        task = page.post("/api/request", json=lies).json()["task"]
        request = page.get(f"/api/task/{task}").json()["status"]["request"]
        assert request["labels"] == {"zone": "n", "asked_by": "anna"}


def test_a_requester_cancels_his_own_task_only(rig: Rig, sessions: Sessions, made: Path, time: Time) -> None:
    with browsing(rig, sessions, word(made, "rob", time)) as page:
        task = page.post("/api/request", json=WAIT).json()["task"]
    with browsing(rig, sessions, word(made, "rita", time)) as page:
        answer = page.post("/api/verb/cancel", json={"task": task})
        assert (answer.status_code, "it is not rita's" in answer.json()["error"]) == (409, True)
    with browsing(rig, sessions, word(made, "rob", time)) as page:
        assert page.post("/api/verb/cancel", json={"task": task}).status_code == 200


@pytest.mark.parametrize(
    "headers",
    [
        {"origin": "https://elsewhere.example"},
        {"origin": "http://robot.example:8447"},
        {"origin": "null"},
        {"host": "127.0.0.1:8447"},
        {"host": "elsewhere.example:8447"},
    ],
)
def test_a_page_from_elsewhere_asks_nothing_with_the_cookie(
    rig: Rig, sessions: Sessions, made: Path, time: Time, headers: dict[str, str]
) -> None:
    with browsing(rig, sessions, word(made, "anna", time)) as page:
        assert page.post("/api/verb/stop", json={}, headers=headers).status_code == 403
    assert not rig.hardware.state.stopped


@pytest.mark.parametrize("later", [IDLE + 1.0, LONGEST + 1.0])
def test_a_session_ends(sessions: Sessions, made: Path, time: Time, later: float) -> None:
    secret, who = sessions.log_in(word(made, "anna", time), HERE)
    assert sessions.who(secret) == who
    steps = 1 if later < LONGEST else 10
    for _ in range(steps):
        time.passed += later / steps
        found = sessions.who(secret)
    assert found is None
    assert sessions.who("made up") is None


def test_looking_on_does_not_keep_a_session(sessions: Sessions, made: Path, time: Time) -> None:
    secret, _ = sessions.log_in(word(made, "anna", time), HERE)
    for _ in range(4):
        time.passed += IDLE / 3
        found = sessions.who(secret, uses=False)
    assert found is None


def test_a_revoked_key_ends_its_session_and_its_socket(rig: Rig, time: Time, tmp_path: Path) -> None:
    begin(tmp_path, START)
    issue(tmp_path, Wanted("viewer", "vera"), START)
    sessions = Sessions(tmp_path, PAGE, time.monotonic, time.utc)
    with browsing(rig, sessions, word(tmp_path, "vera", time)) as page:
        secret = page.cookies[COOKIE]
        headers = {"origin": PAGE, "cookie": f"{COOKIE}={secret}"}
        with page.websocket_connect("wss://robot.example:8447/live", headers=headers) as live:
            live.receive_json()
            revoke(tmp_path, "vera")
            time.passed += LOOK_EVERY
            with pytest.raises(WebSocketDisconnect) as closed:
                all(live.receive_json() is not None for _ in range(100))
        assert closed.value.code == 4401
        assert page.get("/api/session").status_code == 401


def test_a_word_made_before_the_page_was_started_opens_nothing(made: Path, time: Time) -> None:
    old = word(made, "anna", time)
    time.passed += 1.0
    with pytest.raises(LinkError, match="before this page was started"):
        Sessions(made, PAGE, time.monotonic, time.utc).log_in(old, HERE)


def test_guessing_is_slow_for_who_guesses_and_for_nobody_else(
    sessions: Sessions, made: Path, time: Time
) -> None:
    for _ in range(TRIES):
        with pytest.raises(LinkError, match="does not open"):
            sessions.log_in("guess", HERE)
    with pytest.raises(LinkError, match="from your address; wait a minute"):
        sessions.log_in(word(made, "anna", time), HERE)
    assert sessions.log_in(word(made, "anna", time), "192.0.2.2")
    time.passed += 61.0
    assert sessions.log_in(word(made, "anna", time), HERE)


def test_on_this_host_nobody_logs_in(page: TestClient) -> None:
    assert page.post("/api/login", json={"word": "x"}).status_code == 409
