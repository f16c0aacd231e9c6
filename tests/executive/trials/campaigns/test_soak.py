"""The soak: what counts as growth, and a short run with real processes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tandem.executive.trials.campaigns.soak import (
    FileSize,
    ProcessGrowth,
    Sample,
    growth_of,
    request,
    what_is_wrong,
)
from tests.fakes.ports import free_endpoint


def sample(tasks: int, *, memory: float = 50.0, handles: int = 20) -> Sample:
    return Sample(tasks=tasks, role="executive", memory=memory, handles=handles, threads=8)


def grown(**changes: object) -> ProcessGrowth:
    still = {"role": "executive", "memory": 50.0, "growth": 0.1, "handles": (20, 20), "threads": (8, 8)}
    return ProcessGrowth.model_validate({**still, **changes})


def test_growth_is_counted_from_the_end_of_the_warm_up_and_one_odd_sample_does_not_count() -> None:
    samples = [sample(tasks, memory=50.0 + tasks * 0.01) for tasks in range(0, 2001, 20)]
    samples[-1] = sample(2000, memory=500.0)
    (found,) = growth_of(samples, 200)
    assert found.growth == pytest.approx(0.01 * (1960 - 240))


@pytest.mark.parametrize(
    ("growth", "size", "ended", "wrong"),
    [
        (grown(), 100, {"SUCCEEDED": 1}, ""),
        (grown(growth=2.1), 100, {"SUCCEEDED": 1}, "grew by 2.10 MB"),
        (grown(handles=(20, 21)), 100, {"SUCCEEDED": 1}, "open handles"),
        (grown(threads=(8, 9)), 100, {"SUCCEEDED": 1}, "threads"),
        (grown(), 20_000_000, {"SUCCEEDED": 1}, "20000000 bytes"),
        (grown(), 100, {"FAILED": 1}, "no task succeeded"),
        (None, 100, {"SUCCEEDED": 1}, "no samples after the warm-up"),
    ],
)
def test_what_misses_its_aim_is_told(
    growth: ProcessGrowth | None, size: int, ended: dict[str, int], wrong: str
) -> None:
    files = [FileSize(name="executive.log", bytes=size)]
    told = what_is_wrong([] if growth is None else [growth], files, ended)
    assert (wrong in told[0]) if wrong else told == ()


def test_of_ten_requests_one_asks_for_what_is_not_there() -> None:
    asked = [request(number)["item"] for number in range(10)]
    assert asked.count(42) == 1


@pytest.mark.thorough
@pytest.mark.processes
@pytest.mark.xdist_group("soak")
def test_a_short_soak_measures_every_process_and_leaves_no_handle_open(tmp_path: Path) -> None:
    """Memory is not judged here: over so few tasks, caches are still filling."""
    report = tmp_path / "soak.json"
    words = ["campaign", "soak", "--tasks", "30", "--warm-up", "15", "--report", str(report)]
    ports = ["--connect", free_endpoint(), "--metrics", free_endpoint().removeprefix("tcp/")]
    subprocess.run(
        [sys.executable, "-c", "from tandem.executive.cli.main import run; run()", *words, *ports],
        timeout=300,
        check=False,
        capture_output=True,
    )
    told = json.loads(report.read_text())["result"]
    assert told["ended"] == {"CANCELED": 3, "FAILED": 3, "SUCCEEDED": 24}
    assert [each["role"] for each in told["processes"]] == [
        "supervisor", "router", "mock", "executive", "observer",
    ]  # fmt: skip
    before, after = ({each["role"]: each["handles"][end] for each in told["processes"]} for end in (0, 1))
    assert after == before
