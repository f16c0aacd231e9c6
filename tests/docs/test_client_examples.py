"""The examples of clients do what docs/clients.md says, beside an executive whose skills are mocked."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.client.sync import Client
from tests.fakes.mocked import mocked_system
from tests.fakes.ports import free_endpoint

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("client_examples")]
EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def router() -> Iterator[str]:
    endpoint = free_endpoint()
    with mocked_system(endpoint):
        yield endpoint


def example(name: str, *arguments: str) -> str:
    argv = [sys.executable, str(EXAMPLES / f"{name}.py"), *arguments]
    done = subprocess.run(argv, capture_output=True, text=True, check=False, timeout=30)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_watch_and_tree_with_zenoh_and_json(router: str) -> None:
    with Client(router) as client:
        task = client.submit({"task": "fetch", "item": 29})
    assert example("watch", task, router).splitlines()[-1].startswith("SUCCEEDED {'phase': ")
    assert example("tree", router).startswith("fetch: SUCCESS")


def test_cancel_with_zenoh_and_json(router: str) -> None:
    answer = example("cancel", "fetch-0", router)
    assert answer == "{'accepted': False, 'reason': \"unknown task 'fetch-0'\"}\n"


def test_the_typed_client(router: str) -> None:
    assert example("client_sync", "29", router).splitlines()[-1].startswith("SUCCEEDED")


def test_the_typed_client_says_what_is_wrong(router: str) -> None:
    argv = [sys.executable, str(EXAMPLES / "client_sync.py"), "30", router]
    done = subprocess.run(argv, capture_output=True, text=True, check=False, timeout=30)
    assert done.returncode == 1
    assert "item: expected one of" in done.stderr


def test_the_client_of_asyncio(router: str) -> None:
    lines = example("client_async", router).splitlines()
    assert lines[0].startswith("('fetch',")
    assert [line.rsplit(" ", 1)[1] for line in lines[1:]] == ["SUCCEEDED", "SUCCEEDED"]
