"""Rules that no linter knows: no state set by hand after a reset, no constraint but the finger gear."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ROOMS = ("executive", "skills", "sim", "trees")
BY_HAND = {
    # The call, and the files that may make it: at a reset, or in the camera's world, which has no physics.
    "resetJointState": {"sim/body.py", "sim/render_world.py"},
    "resetBasePositionAndOrientation": {"sim/render_world.py"},
    "resetBaseVelocity": set(),
    "resetJointStateMultiDof": set(),
    "createConstraint": {"sim/body.py"},
    "applyExternalForce": set(),
    "applyExternalTorque": set(),
}
CLOCKS = {"time.sleep", "datetime.now", "time.time"}
MAY_READ_A_CLOCK = {
    "skills/wire/clocks.py",
    "executive/system/roles.py",  # names this start of the executive
    "executive/system/processes.py",  # waits for other processes' ends, which nobody tells
}


def sources() -> list[Path]:
    return sorted(path for room in ROOMS for path in (ROOT / room).rglob("*.py"))


def calls(path: Path) -> list[str]:
    tree = ast.parse(path.read_text("utf-8"))
    return [ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)]


@pytest.mark.parametrize("path", sources(), ids=lambda path: str(path.relative_to(ROOT)))
def test_nothing_is_set_by_hand(path: Path) -> None:
    name = str(path.relative_to(ROOT))
    used = {call.rsplit(".", 1)[-1] for call in calls(path)}
    assert [call for call in BY_HAND if call in used and name not in BY_HAND[call]] == []


SERVES = {
    "skills/ports/serving.py",  # the one mechanism
    "skills/ports/forwarding_bus.py",  # buses around a bus
    "executive/trials/campaigns/crash_points.py",
    "sim/faulty_link.py",
    "skills/scoped_bus.py",
    "skills/testing/faulty_bus.py",
    "skills/wire/zenoh_bus.py",  # the bus itself
}


@pytest.mark.parametrize("path", sources(), ids=lambda path: str(path.relative_to(ROOT)))
def test_queries_are_taken_by_one_mechanism(path: Path) -> None:
    """Who takes a query from the bus must check it: docs/endpoints.md, "Serving"."""
    if str(path.relative_to(ROOT)) not in SERVES:
        assert [call for call in calls(path) if call.endswith(".serve")] == []


@pytest.mark.parametrize("path", sources(), ids=lambda path: str(path.relative_to(ROOT)))
def test_no_sleep_and_no_wall_clock(path: Path) -> None:
    name = str(path.relative_to(ROOT))
    if name.startswith("executive/cli/") or name in MAY_READ_A_CLOCK:
        return
    assert sorted(set(calls(path)) & CLOCKS) == []


@pytest.mark.parametrize(
    "path",
    sorted((ROOT / "skills").rglob("__init__.py")) + sorted((ROOT / "trees").rglob("__init__.py")),
    ids=str,
)
def test_a_rooms_init_imports_nothing(path: Path) -> None:
    tree = ast.parse(path.read_text("utf-8"))
    assert not [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]


def test_no_body_may_fall_asleep() -> None:
    """One asleep in a hand keeps its contacts and can't be let go: docs/decisions/001."""
    assert [path for path in sources() if "ENABLE_SLEEPING" in path.read_text("utf-8")] == []


def test_truth_is_read_by_tests_and_reports_only() -> None:
    readers = {
        str(path.relative_to(ROOT))
        for path in sources()
        if "tandem.sim.truth" in path.read_text("utf-8")
        and not str(path.relative_to(ROOT)).startswith("sim/")
    }
    assert readers <= {
        "executive/trials/demo.py",
        "executive/trials/run_report.py",
        "executive/trials/truly.py",
        "executive/cli/carrying_out.py",
        "executive/trials/campaigns/crash_physics.py",
        "executive/trials/campaigns/hardware_restart.py",
        "executive/trials/campaigns/oracle.py",
    }


def test_python_programs_of_ours_are_isolated_from_the_current_folder() -> None:
    """``skills.ports.isolation`` makes their command lines; the benchmarks are found in the checkout."""
    makers = {
        str(path.relative_to(ROOT)) for path in sources() if "sys.executable" in path.read_text("utf-8")
    }
    assert makers == {"skills/ports/isolation.py", "executive/cli/commands/bench_command.py"}
