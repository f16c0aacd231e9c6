"""Nobody reckons with a stamp's seconds: stamps of two boots would compare without a word.

``RobotTime`` answers ``since``, ``is_after`` and ``is_fresh`` itself, and None for another boot. Timers read
``Clocks.passed``. Source that reads ``.seconds`` may show it to people; what else there is stands below.
"""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tandem.skills.ports.message import RobotTime

ROOT = Path(__file__).parents[2]
ROOMS = ("executive", "skills", "sim", "trees")
EXCEPTIONS = {
    "skills/ports/message.py": "the type itself",
    "sim/camera.py": "the hardware counts these seconds, and makes its parts anew with each boot",
    "sim/events.py": "as the camera",
    "sim/parts.py": "as the camera",
    "sim/trouble.py": "as the camera",
    "executive/trials/campaigns/crash_physics.py": "orders what was told in a run: one start of the hardware",
    "executive/trials/experiments/witness.py": "notes when two bodies touched, for a report",
    "executive/trials/rocs/run.py": "notes when two bodies touched, for a report",
    "executive/records/foxglove_view.py": "written down, for a viewer that knows one boot",
    "executive/records/lines_file.py": "written down with its boot",
    "executive/records/mcap_writing.py": "written down with its boot, and with what makes it one over boots",
    "executive/telemetry/traces.py": "an attribute of a span, for people",
    "skills/ports/checks.py": "whether a stamp is a plausible number at all",
    "skills/perception/eye.py": "a failure's evidence, for people",
    "skills/ros/inputs.py": "as the camera, of a robot that speaks ROS",
    "skills/ros/poses.py": "as the camera, of a robot that speaks ROS",
    "skills/world/keeper.py": "a line of the log, for people",
}
"""Files that may read ``.seconds``, and why."""
OTHER_CLASSES = {
    "self.seconds": "a field of another class: only skills/ports/message.py is RobotTime's own",
    "self.clocks.seconds": "lockstep's simulated seconds, over all boots",
    "context.seconds": "TreeContext's: a timer's reading",
    "parent.seconds": "a branch's TreeContext",
    "asked.seconds": "of a part of a course; of a moment with its boot (executive/web/kept_records.py)",
    "result.seconds": "for how long a robot was followed (skills/ports/actions/base.py)",
    "goal.seconds": "for how long a robot is followed (skills/ports/actions/base.py)",
    "made.seconds": "how long a trial took (executive/trials/trial.py)",
    "before.seconds": "how long two bodies have touched (sim/disturbances.py)",
}
"""Expressions that read ``seconds`` of something that is no stamp, by their last two or three words."""


def sources() -> list[Path]:
    return sorted(path for room in ROOMS for path in (ROOT / room).rglob("*.py"))


def reckonings(source: str) -> list[str]:
    """Return the reads of ``.seconds`` that are neither shown in a text nor called."""
    tree = ast.parse(source)
    shown = {
        id(inner)
        for node in ast.walk(tree)
        if isinstance(node, ast.FormattedValue) and isinstance(node.value, ast.Attribute)
        for inner in (node.value,)
    }
    called = {id(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    return sorted(
        ast.unparse(node)
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute)
        and node.attr == "seconds"
        and isinstance(node.ctx, ast.Load)
        and id(node) not in shown | called
    )


@pytest.mark.parametrize("path", sources(), ids=lambda path: str(path.relative_to(ROOT)))
def test_nobody_reckons_with_a_stamps_seconds(path: Path) -> None:
    if str(path.relative_to(ROOT)) in EXCEPTIONS:
        return
    found = [
        read
        for read in reckonings(path.read_text("utf-8"))
        if not any(read == known or read.endswith((f".{known}", f"_{known}")) for known in OTHER_CLASSES)
    ]
    assert found == [], "ask the stamp: since, is_after, is_fresh; a timer reads robot_seconds(clocks)"


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("age = now.seconds - told.stamp.seconds", ["now.seconds", "told.stamp.seconds"]),
        ("bisect_left(kept, stamp.seconds)", ["stamp.seconds"]),
        ("text = f'{stamp.seconds:.1f} s'", []),
        ("text = f'{now.seconds - stamp.seconds:.1f} s'", ["now.seconds", "stamp.seconds"]),
        ("length = space.seconds(a, b)", []),
    ],
)
def test_the_rule_finds_reckoning_and_leaves_words_alone(source: str, found: list[str]) -> None:
    assert reckonings(source) == found


def test_stamps_have_no_order_of_their_own() -> None:
    """What could be written by mistake raises: the type has no ``<`` and no ``-``."""
    stamp = RobotTime(boot="a", seconds=1.0)
    assert not {"__lt__", "__gt__", "__le__", "__ge__", "__sub__"} & set(vars(RobotTime))
    assert stamp.since(RobotTime(boot="b", seconds=0.5)) is None


def test_each_exception_is_still_one() -> None:
    assert [name for name in EXCEPTIONS if not reckonings((ROOT / name).read_text("utf-8"))] == []
