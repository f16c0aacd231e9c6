"""The table of what processes cost, of figures that were made up."""

from __future__ import annotations

import io

import pytest

from benchmarks.light import ROBOTS, _await_ready, _memory, _spent
from benchmarks.rows import Row


def told(rows: list[Row]) -> dict[str, float]:
    return {row.what: row.value for row in rows}


def test_shares_are_of_one_core_the_hardware_apart() -> None:
    spent = {"base": 1.0, "hardware": 8.0, "up": 0.5}
    rows = list(_spent("idle", spent, 10.0, 12.0, "succeeded"))
    assert told(rows) == {
        "idle: all without the hardware": pytest.approx(15.0),
        "idle: hardware": pytest.approx(80.0),
        "idle: base": pytest.approx(10.0),
        "idle: up": pytest.approx(5.0),
    }
    assert (rows[0].aim, rows[0].note) == (12.0, "over 10 s, succeeded")


def test_memory_is_summed_the_hardware_apart() -> None:
    (row,) = _memory("idle", {"hardware": 500.0, "base": 40.0, "up": 50.0}, 450.0)
    assert (row.value, row.unit) == (90.0, "MB")
    assert "base 40, hardware 500, up 50" in row.note


def test_a_system_that_ends_before_it_is_ready_is_no_figure() -> None:
    _await_ready(io.StringIO("a router\nready: Demo on lab/tiago\n"))
    with pytest.raises(RuntimeError, match="before it was ready"):
        _await_ready(io.StringIO("error: no such scenario\n"))


def test_each_robot_is_measured_in_both_ways() -> None:
    ways = {(robot.scenario, robot.processes) for robot in ROBOTS}
    assert ways == {(name, way) for name in ("Demo", "Locobot") for way in ("many", "few")}
