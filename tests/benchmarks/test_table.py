"""The table of figures, and the command that makes it."""

from __future__ import annotations

import math
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.machine import Others, descendants
from benchmarks.rows import Row, quantile, spread
from benchmarks.run import names, page, table
from tandem.executive.cli.commands import bench_command
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.main import main
from tandem.executive.system.process_usage import shared_memory


@pytest.mark.parametrize(
    ("row", "ratio"),
    [
        (Row("time", 3.0, "ms", aim=2.0), 1.5),
        (Row("speed", 4.0, "x", aim=2.0, more=True), 0.5),
        (Row("memory", 100.0, "MB"), None),
    ],
)
def test_a_ratio_above_one_misses_the_aim_either_way(row: Row, ratio: float | None) -> None:
    assert row.ratio == ratio


def test_quantiles_are_values_that_were_measured() -> None:
    assert [quantile([3.0, 1.0, 2.0, 4.0], share) for share in (0.0, 0.5, 0.99)] == [1.0, 3.0, 4.0]
    assert math.isnan(quantile([], 0.5))


def test_a_spread_tells_milliseconds_and_counts() -> None:
    median, worst = spread("reaction", [0.001, 0.002, 0.003], aim=2.0, note="idle")
    assert (median.value, median.note, median.aim) == (2.0, "of 3, idle", None)
    assert (worst.value, worst.aim) == (3.0, 2.0)


def test_the_table_has_aim_ratio_and_the_others_load() -> None:
    lines = table([Row("speed", 4.0, "x", aim=2.0, more=True, note="n", others=0.25)]).splitlines()
    assert lines[2] == "| speed | 4 | x | ≥ 2 | 0.50 | 0.2 | n |"
    assert table([]) in page("a machine", [])
    assert "a machine" in page("a machine", [])


def test_each_quick_benchmark_is_a_benchmark() -> None:
    assert set(names(quick=True)) <= set(names())
    assert "reaction" in names(quick=True)


def test_what_this_process_burns_is_not_others(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("benchmarks.machine._busy_seconds", iter([10.0, 15.0]).__next__)
    monkeypatch.setattr("benchmarks.machine._own_seconds", iter([1.0, 4.0]).__next__)
    monkeypatch.setattr("benchmarks.machine.time.monotonic", iter([0.0, 4.0]).__next__)
    assert Others().cores() == pytest.approx((5.0 - 3.0) / 4.0)


def test_a_process_has_memory_and_is_its_own_descendant() -> None:
    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as child:
        assert descendants(child.pid) == [child.pid]
        assert 0.0 < shared_memory(child.pid) < 1000.0
        child.kill()


def test_the_command_lists_the_benchmarks(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--list"]) == 0
    assert capfd.readouterr().out.split() == names()


def test_without_a_checkout_the_command_says_that_it_needs_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    elsewhere = tmp_path / "site-packages" / "executive" / "cli" / "commands" / "bench_command.py"
    elsewhere.parent.mkdir(parents=True)
    shutil.copy(bench_command.__file__, elsewhere)
    monkeypatch.setattr(bench_command, "__file__", str(elsewhere))
    with pytest.raises(CommandError, match="clone the repository") as refused:
        bench_command.checkout()
    assert refused.value.code == 2
