"""``tandem web`` and ``tandem up --web``: where the page is served, and what is refused."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import pytest

from tandem.executive.cli.main import main
from tests.fakes.ports import free_endpoint, free_pair

PROGRAM = "import sys; from tandem.executive.cli.start import run; sys.exit(run())"


@contextmanager
def told(words: list[str]) -> Iterator[Iterator[str]]:
    """Give the lines that a command prints, and end it afterwards."""
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM, *words], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        try:
            yield iter(process.stdout)
        finally:
            process.terminate()


def session_at(address: str) -> dict[str, Any]:
    session: dict[str, Any] = json.loads(urlopen(f"{address}api/session").read())  # noqa: S310 - our own address
    return session


def assert_two_pages(lines: Iterator[str], line: str) -> None:
    """Each of r2 and r3 has a page at the address that is printed, which links to the other's."""
    found = dict(next(match.groups() for each in lines if (match := re.search(line, each))) for _ in range(2))
    sessions = {robot: session_at(address) for robot, address in found.items()}
    assert {robot: each["robot"] for robot, each in sessions.items()} == {"r2": "r2", "r3": "r3"}
    assert {robot: each["pages"] for robot, each in sessions.items()} == {
        "r2": {"r3": found["r3"]},
        "r3": {"r2": found["r2"]},
    }


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["web", "--at", "0.0.0.0:8447"], 2, "anyone who can reach the page could move the robot"),
        (["web", "--at", "0.0.0.0:8447", "--keys", "nowhere"], 2, "say with --name"),
        (["web", "--at", "192.168.1.5:0", "--keys", "nowhere"], 2, "a port that is known before"),
        (["web", "--at", "192.168.1.5:8447", "--keys", "nowhere"], 2, "nowhere"),
        (["web", "--at", "192.168.1.5:8447", "--keys", "nowhere", "--also", "r3"], 2, "once for each robot"),
        (["keys", "link", "anna", "--page", "http://robot:8447"], 2, "an address such as https://"),
        (["keys", "link", "anna", "--page", "https://robot:8447", "--folder", "nowhere"], 2, "no such file"),
        (["web", "--record", "pyproject.toml"], 2, "expected a record of Tandem"),
        (["replay", "pyproject.toml", "--web"], 2, "expected a record of Tandem"),
        (["web", "--at", "8447"], 2, "expected a host and a port"),
        (["web", "--connect", "tcp/127.0.0.1:1"], 3, "tandem up"),
        (["up", "--web-at", "192.168.1.5:80"], 2, "--web-at: 192.168.1.5:80: anyone who can reach"),
        (["up", "--web", "--web-at", "127.0.0.1:0"], 2, "a port other than 0"),
        (["up", "--scenario", "Rocs3", "--web-at", "127.0.0.1:65535"], 2, "2 robots have a port each"),
    ],
)
def test_what_can_not_be_is_said(
    words: list[str], code: int, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == code
    captured = capsys.readouterr()
    assert said in captured.err + captured.out


@pytest.mark.processes
@pytest.mark.xdist_group("processes")
def test_up_starts_the_page_and_says_where_it_is(tmp_path: Path) -> None:
    endpoint, at = free_endpoint(), free_endpoint().removeprefix("tcp/")
    options = ["--only", "router", "--connect", endpoint, "--data", str(tmp_path), "--web", "--web-at", at]
    with told(["up", *options]) as lines:
        session = session_at(
            next(re.findall(r"http://\S+", line)[0] for line in lines if "the page:" in line)
        )
    assert (session["robot"], session["role"]) == ("tiago", "operator")


@pytest.mark.processes
@pytest.mark.xdist_group("processes")
def test_each_of_several_robots_has_a_page_that_links_to_the_others(tmp_path: Path) -> None:
    endpoint, at = free_endpoint(), f"127.0.0.1:{free_pair()}"
    up = ["--only", "router", "--connect", endpoint, "--data", str(tmp_path)]
    with told(["up", "--scenario", "Rocs3", *up, "--web-at", at]) as lines:
        assert_two_pages(lines, r"the page of (\w+): (http://\S+)")
        robots = ["--site-key", "rocs", "--robot", "r2", "--also", "r3"]
        with told(["web", "--connect", endpoint, *robots, "--at", "127.0.0.1:0"]) as others:
            assert_two_pages(others, r"the page of rocs/(\w+) is at (http://\S+)")
