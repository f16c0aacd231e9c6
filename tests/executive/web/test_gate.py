"""Who may speak to the page's server."""

from __future__ import annotations

import pytest
from starlette.datastructures import Headers
from starlette.testclient import TestClient

from tandem.executive.web.gate import refusal

HOST = "127.0.0.1:8447"
OWN = {"host": HOST, "origin": f"http://{HOST}", "content-type": "application/json"}


@pytest.mark.parametrize(
    ("kind", "method", "headers", "why"),
    [
        ("http", "GET", {"host": HOST}, ""),
        ("http", "GET", {"host": "localhost:8447"}, ""),
        ("http", "GET", {"host": "[::1]:8447"}, ""),
        ("http", "GET", {"host": "robot.example.org"}, "this host's own address"),
        ("http", "GET", {}, "this host's own address"),
        ("http", "POST", OWN, ""),
        ("http", "POST", {**OWN, "origin": "http://elsewhere.example"}, "asked by the page"),
        ("http", "POST", {**OWN, "origin": "http://127.0.0.1:9999"}, "asked by the page"),
        ("http", "POST", {**OWN, "origin": "null"}, "asked by the page"),
        ("http", "POST", {"host": HOST, "content-type": "application/json"}, "asked by the page"),
        ("http", "POST", {**OWN, "content-type": "text/plain"}, "application/json"),
        ("http", "DELETE", {"host": HOST}, "asked by the page"),
        ("websocket", "", {"host": HOST, "origin": f"http://{HOST}"}, ""),
        ("websocket", "", {"host": HOST, "origin": "http://elsewhere.example"}, "asked by the page"),
        ("websocket", "", {"host": HOST}, "asked by the page"),
    ],
)
def test_only_the_page_itself_may_ask(kind: str, method: str, headers: dict[str, str], why: str) -> None:
    found = refusal(kind, method, Headers(headers))
    assert why in found if why else found == ""


def test_a_browser_is_told_to_load_nothing_from_elsewhere(page: TestClient) -> None:
    told = page.get("/").headers
    assert "default-src 'none'; script-src 'self'" in told["content-security-policy"]
    assert (told["x-content-type-options"], told["referrer-policy"]) == ("nosniff", "no-referrer")


def test_a_page_from_elsewhere_stops_nothing(page: TestClient) -> None:
    answer = page.post("/api/verb/stop", json={}, headers={"origin": "http://elsewhere.example"})
    assert (answer.status_code, "asked by the page" in answer.json()["error"]) == (403, True)
