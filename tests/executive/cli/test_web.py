"""``tandem web`` and ``tandem up --web``: where the page is served, and what is refused."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from urllib.request import urlopen

import pytest

from tandem.executive.cli.main import main
from tests.fakes.ports import free_endpoint

PROGRAM = "import sys; from tandem.executive.cli.start import run; sys.exit(run())"


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["web", "--at", "0.0.0.0:8447"], 2, "anyone who can reach the page could move the robot"),
        (["web", "--at", "0.0.0.0:8447", "--keys", "nowhere"], 2, "say with --name"),
        (["web", "--at", "192.168.1.5:0", "--keys", "nowhere"], 2, "a port that is known before"),
        (["web", "--at", "192.168.1.5:8447", "--keys", "nowhere"], 2, "nowhere"),
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
    words = [sys.executable, "-c", PROGRAM, "up", *options]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            told = next(line for line in process.stdout if "the page:" in line)
            address = re.findall(r"http://\S+", told)[0]
            session = json.loads(urlopen(f"{address}api/session").read())  # noqa: S310 - our own address
        finally:
            process.terminate()
    assert (session["robot"], session["role"]) == ("tiago", "operator")


@pytest.mark.processes
@pytest.mark.xdist_group("processes")
def test_each_of_several_robots_has_a_page_that_links_to_the_others(tmp_path: Path) -> None:
    endpoint, at = free_endpoint(), free_endpoint().removeprefix("tcp/")
    options = ["--only", "router", "--connect", endpoint, "--data", str(tmp_path), "--web-at", at]
    words = [sys.executable, "-c", PROGRAM, "up", "--scenario", "Rocs3", *options]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            lines = (line for line in process.stdout if "the page of" in line)
            found = [re.findall(r"of (\w+): (http://\S+)", next(lines))[0] for _ in range(2)]
            told = {robot: json.loads(urlopen(f"{address}api/session").read()) for robot, address in found}  # noqa: S310 - our own
        finally:
            process.terminate()
    assert {robot: each["robot"] for robot, each in told.items()} == {"r2": "r2", "r3": "r3"}
    assert told["r2"]["pages"] == {"r3": dict(found)["r3"]}
