"""What the page's server answers: questions, requests, verbs, and what is wrong with them."""

from __future__ import annotations

from typing import Any

import pytest
from starlette.testclient import TestClient
from web_rig import AT, Rig, of_role

from tandem.executive.security.role import Role
from tandem.executive.web.app import application
from tandem.executive.web.verbs import VERBS
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.tasks import TaskState

WAIT = {"task": "wait", "item": 3}
CLIENTS_VERBS = {
    "viewer": set(),
    "requester": {"request", "retry", "cancel"},
    "operator": {"request", *VERBS},
}


def test_any_address_of_a_view_is_the_page(page: TestClient) -> None:
    for address in ("/", "/history?state=FAILED", "/task/fetch-1"):
        answer = page.get(address)
        assert (answer.status_code, "/static/app.js" in answer.text) == (200, True)
    assert page.get("/static/app.js").headers["content-type"].startswith("text/javascript")


@pytest.mark.parametrize(
    "address", ["/api/nothing", "/static/%2e%2e%2fapp.py", "/static/app.ts", "/mesh/etc/passwd"]
)
def test_what_is_not_there_is_not_there(page: TestClient, address: str) -> None:
    assert page.get(address).status_code == 404


def test_who_asks_and_what_is_allowed_is_told(page: TestClient) -> None:
    told = page.get("/api/session").json()
    assert (told["site"], told["robot"], told["role"], told["keys"]) == ("lab", "tiago", "operator", False)


@pytest.mark.parametrize("role", ["viewer", "requester", "operator"])
def test_each_role_has_its_verbs_and_no_others(role: Role) -> None:
    rig = Rig(of_role(role))
    with rig.page() as page:
        assert set(page.get("/api/session").json()["may"]) == CLIENTS_VERBS[role]
        for verb in VERBS:
            answer = page.post(f"/api/verb/{verb}", json={"task": "wait-1"})
            assert (answer.status_code == 403) is (verb not in CLIENTS_VERBS[role]), verb
        answer = page.post("/api/request", json=WAIT)
        assert (answer.status_code == 403) is (role == "viewer")
    if role == "viewer":
        assert not rig.here.executive.book.waiting
        assert not rig.hardware.state.stopped


def test_robot_place_and_kinds_are_told(page: TestClient) -> None:
    assert "<robot" in page.get("/api/robot").json()["urdf"]
    assert page.get("/api/site").json()["depots"][0]["name"] == "depot"
    assert [each["name"] for each in page.get("/api/kinds").json()["kinds"]] == ["wait"]


def test_pages_of_other_robots_are_told(rig: Rig) -> None:
    with TestClient(application(rig, pages={"r2": "https://r2.example"}), base_url=AT) as page:
        assert page.get("/api/session").json()["pages"] == {"r2": "https://r2.example"}


def test_a_mesh_is_sent_if_the_urdf_names_it(page: TestClient) -> None:
    path = "example-robot-data/robots/tiago_description/meshes/torso/torso_lift_collision_neck.dae"
    answer = page.get(f"/mesh/{path}")
    assert answer.content == resolve(f"package://{path}").read_bytes()
    unnamed = "example-robot-data/robots/talos_data/robots/talos_reduced.urdf"
    assert page.get(f"/mesh/{unnamed}").status_code == 404


def test_a_request_becomes_a_task_with_a_page_of_its_own(page: TestClient) -> None:
    task = page.post("/api/request", json=WAIT).json()["task"]
    told = page.get(f"/api/task/{task}").json()
    assert (told["status"]["request"]["item"], told["status"]["state"]) == (3, "RUNNING")
    assert page.get("/api/task/wait-9999").status_code == 404


def test_what_is_wrong_with_a_request_is_told_by_its_place(page: TestClient) -> None:
    answer = page.post("/api/request", json={**WAIT, "item": "three"})
    assert (answer.status_code, answer.json()["problems"][0]["path"]) == (422, "item")


@pytest.mark.parametrize(
    ("body", "status"),
    [(b"{", 400), (b"[]", 400), (b"\xff", 400), (b"[" * 50_000, 400), (b'"' + b"x" * 70_000 + b'"', 413)],
)
def test_what_is_no_document_is_refused(page: TestClient, body: bytes, status: int) -> None:
    answer = page.post("/api/request", content=body, headers={"content-type": "application/json"})
    assert (answer.status_code, bool(answer.json()["error"])) == (status, True)


def test_a_verb_is_taken_or_refused_in_the_executives_words(page: TestClient) -> None:
    task = page.post("/api/request", json=WAIT).json()["task"]
    assert page.post("/api/verb/pause", json={"task": task}).json() == {"answer": task}
    assert page.post("/api/verb/cancel", json={"task": task}).status_code == 200
    again = page.post("/api/verb/resume", json={"task": task})
    assert (again.status_code, "resume of" in again.json()["error"]) == (409, True)
    assert page.post("/api/verb/dance", json={}).status_code == 404
    assert page.post("/api/verb/pause", json={"task": 3}).status_code == 422


def test_an_ended_task_is_tried_again_as_a_task_of_its_own(page: TestClient, rig: Rig) -> None:
    task = page.post("/api/request", json={**WAIT, "id": "mine"}).json()["task"]
    assert page.post("/api/verb/retry", json={"task": task}).status_code == 409
    rig.here.world(2)
    rig.here.step(5)
    new = page.post("/api/verb/retry", json={"task": task}).json()["answer"]
    request = page.get(f"/api/task/{new}").json()["status"]["request"]
    assert (new != task, request["retry_of"], request["id"] != "mine") == (True, task, True)


def test_why_a_task_failed_and_what_to_do_are_told(page: TestClient, rig: Rig) -> None:
    task = page.post("/api/request", json=WAIT).json()["task"]
    rig.here.world(2)
    rig.here.step(5)
    told = page.get(f"/api/task/{task}").json()
    assert told["status"]["state"] == TaskState.FAILED
    assert (told["helper"], "is visible" in told["next"]) == ("look", True)


def test_the_stop_says_who_set_it(page: TestClient) -> None:
    assert page.post("/api/verb/stop", json={}).json()["answer"] == {
        "stopped": True,
        "by": "anna",
        "reason": "the stop on the page",
    }
    assert page.post("/api/verb/release", json={"reason": "seen"}).json()["answer"]["stopped"] is False


def test_the_camera_is_asked_once_for_all_who_look(page: TestClient, rig: Rig) -> None:
    answers = [page.get("/api/camera") for _ in range(3)]
    assert {(each.status_code, each.content) for each in answers} == {(200, b"a jpeg")}
    assert (float(answers[0].headers["x-age"]) < 1.0, rig.hardware.asked_pictures) == (True, 1)


def test_each_camera_has_a_picture_of_its_own(page: TestClient, rig: Rig) -> None:
    names = ("wrist", "wrist", "", "wrist", "")
    answers = [page.get("/api/camera", params={"name": name} if name else {}).content for name in names]
    assert answers == [b"wrist", b"wrist", b"a jpeg", b"wrist", b"a jpeg"]
    assert rig.hardware.asked_pictures == 2


def test_a_camera_without_a_picture_is_said_so(page: TestClient, rig: Rig) -> None:
    rig.hardware.pictures.append(b"")
    answer = page.get("/api/camera")
    assert (answer.status_code, answer.json()["error"]) == (404, "the camera sends no picture")


def test_a_reflex_is_switched_in_the_viewers_name(page: TestClient, rig: Rig) -> None:
    told = page.post("/api/verb/reflex", json={"reflex": "back_off", "on": True}).json()["answer"]
    assert (told["on"], told["by"]) == (True, "anna")
    rig.hardware.obeys = False
    answer = page.post("/api/verb/reflex", json={"reflex": "back_off", "on": True})
    assert (answer.status_code, "still off" in answer.json()["error"]) == (409, True)
    assert page.post("/api/verb/reflex", json={"reflex": "a/b", "on": True}).status_code == 422


@pytest.mark.parametrize("test_run", [True, False])
def test_a_node_is_forced_in_a_test_run_only(page: TestClient, *, test_run: bool) -> None:
    task = page.post("/api/request", json={**WAIT, "test_run": test_run}).json()["task"]
    document = {"task": task, "node": "wait/wait for the world", "status": "SUCCESS"}
    answer = page.post("/api/verb/force", json=document)
    assert (answer.status_code == 200) is test_run


def test_an_executive_that_is_gone_is_said_so(page: TestClient, rig: Rig) -> None:
    rig.link.served = False
    answer = page.get("/api/kinds")
    assert (answer.status_code, "no executive answers" in answer.json()["error"]) == (503, True)


def test_the_history_is_filtered_and_counted(page: TestClient, rig: Rig) -> None:
    for item, version in ((3, 2), (4, 1), (4, 1)):
        rig.here.world(0)
        page.post("/api/request", json={"task": "wait", "item": item, "labels": {"zone": f"z{item}"}})
        rig.here.world(version)
        rig.here.step(5)

    def found(query: str) -> dict[str, Any]:
        answer: dict[str, Any] = page.get(f"/api/history?{query}").json()
        return answer

    counts = {
        "": 3, "state=FAILED": 1, "item=4": 2, "item=salt": 1, "text=wait-0002": 1, "label=zone": 3,
        "label=zone=z4": 2, "label=z4": 0, "week=1970-W01": 3, "week=2026-W01": 0,
        "failure=GRASP_EMPTY": 1, "where=nowhere": 0, "days=1": 0, "days=90000": 3,
    }  # fmt: skip
    assert {query: found(query)["count"] for query in counts} == counts
    assert found("failure=GRASP_EMPTY")["failures"] == {"GRASP_EMPTY": 1}
    every = found("")
    (week,) = every["weeks"]
    assert (week["week"], week["kind"], week["succeeded"], week["decided"]) == ("1970-W01", "wait", 2, 3)
    assert [(each["failure"], each["count"]) for each in every["nodes"]] == [("GRASP_EMPTY", 1)]
    assert every["labels"] == ["zone=z4", "zone=z3"]
    assert (every["kinds"][0]["succeeded"], found("page=7")["tasks"]) == (2, [])
    assert page.get("/api/history?since=soon").status_code == 422
    assert page.get("/api/history?colour=red").status_code == 422


def test_a_task_that_had_not_ended_is_asked_for_again(page: TestClient, rig: Rig) -> None:
    for number in range(30):
        page.post("/api/request", json={**WAIT, "id": f"n{number}"})

    def states() -> list[str]:
        return [each["state"] for each in page.get("/api/history").json()["tasks"]]

    assert states() == ["QUEUED"] * 29 + ["RUNNING"]
    rig.here.world(1)
    rig.here.step(5)
    assert "SUCCEEDED" in states()[20:], "the oldest, which is not on the first page of what is new"
