"""Files with a mistake in them, given to the command.

A user would have seen: of a key that stands twice only the last value, without a word; item 29 where the file
says ``item: 035``; items, obstacles and the robot thrown about at the start as two were in one place; and
exit code 70 with a traceback in the log for 3,000 brackets. Right is exit code 2, and a line with the file,
the path in it, the line, and the reason, from each command that reads such a file.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

TANDEM = Path(sys.executable).with_name("tandem")
ROOT = Path(__file__).parents[2]
WITHIN = 60.0
"""Seconds for a command that starts nothing; it takes about one."""

HEAD = "name: mine\nsite: lab\nstart: {x: -0.8, y: 1.2, yaw: 0.0}\n"
ITEM = "  - {item: 29, support: table, x: 0.50, y: 0.62}\n"
MUG = """\
  - name: mug
    support: table
    x: 0.53
    y: 0.62
    shape: {kind: cylinder, radius: 0.04, height: 0.1}
"""
BOX = "  - {name: box, x: 1.3, y: -2.75, shape: {kind: box, size: [0.2, 0.2, 0.2]}}\n"

WRONG = {
    "a key twice": (
        f"{HEAD}items:\n{ITEM}noise: {{laser_sigma: 0.01, laser_sigma: 0.02}}\n",
        r"noise\.laser_sigma \(line 6\): duplicate key; first used in line 6",
    ),
    "the same key further down": (f"{HEAD}items: []\nname: other\n", r"name \(line 5\): .* line 1"),
    "an octal number": (
        f"{HEAD}items:\n  - {{item: 035, support: table, x: 0.5, y: 0.6}}\n",
        r"items\.0\.item \(line 5\): 035 .*octal",
    ),
    "a number in sixties": (f"{HEAD}camera_rate: 1:30\n", r"camera_rate \(line 4\): 1:30 .*base 60"),
    "a number beyond all": (
        f"{HEAD}camera_rate: 1e300\n",
        r"camera_rate \(line 4\): expected a number below",
    ),
    "a number with underscores": (f"{HEAD}camera_rate: 1_0\n", r"camera_rate \(line 4\): 1_0 .*underscores"),
    "a word that some read as false": ("name: no\n", r"name \(line 1\): no .*true or false"),
    "a truth value for a number": (
        f"{HEAD}items:\n  - {{item: true, support: table, x: 0.5, y: 0.6}}\n",
        r"items\.0\.item \(line 5\): expected a whole number, found true",
    ),
    "text for a number": (
        f"{HEAD}camera_rate: '5'\n",
        r'camera_rate \(line 4\): expected a number, found "5"',
    ),
    "two items in one place": (
        f"{HEAD}items:\n{ITEM}  - {{item: 42, support: table, x: 0.52, y: 0.63}}\n",
        r"items\.1 \(line 6\): item_42 is in one place with item_29",
    ),
    "an item inside an obstacle": (
        f"{HEAD}items:\n{ITEM}obstacles:\n{MUG}",
        r"obstacles\.0 \(line 7\): mug is in one place with item_29",
    ),
    "an obstacle inside furniture": (
        f"{HEAD}obstacles:\n{BOX}",
        r"obstacles\.0 \(line 5\): box is in one place with cabinet\.0",
    ),
    "a robot inside the table": (
        "name: mine\nsite: lab\nstart: {x: 1.0, y: 0.5, yaw: 0.0}\n",
        r"start \(line 3\): the robot at \(1, 0\.5\) .* inside table\.0",
    ),
    "an unknown field": (f"{HEAD}colour: red\n", r"colour \(line 4\): expected no such field"),
    "an object of Python": (
        f"{HEAD}items: !!python/name:os.system\n",
        r"items \(line 4\): tags are not allowed",
    ),
    "two documents": (f"{HEAD}---\n{HEAD}", r"line 4: expected one document"),
    "brackets without end": ("[" * 3000, r"at most 32 levels"),
    "aliases of aliases": (
        "a: &a [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n"
        + "".join(
            f"{new}: &{new} [{', '.join(['*' + old] * 10)}]\n"
            for old, new in zip("abcdefg", "bcdefgh", strict=True)
        ),
        r"at most 100000 values",
    ),
    "an item twice": (f"{HEAD}items:\n{ITEM}{ITEM}", r"expected each item once; several times there: 29$"),
    "half a letter": ('name: "\\uD800"\n', r"name \(line 1\): expected Unicode text, found half a surr"),
    "a control character": ('name: "a\\e[2J"\nsite: lab\n', r"name \(line 1\): expected"),
    "no text": (b"name: \xff\xfe", "not UTF-8"),
}


def tandem(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run the command to its end; give what it said, in one line of plain text."""
    env = {**os.environ, "NO_COLOR": "1", "COLUMNS": "400"}
    return subprocess.run(
        [TANDEM, *arguments], capture_output=True, text=True, timeout=WITHIN, check=False, env=env
    )


def written(folder: Path, content: str | bytes) -> str:
    file = folder / "mine.yaml"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return str(file)


def refused(run: subprocess.CompletedProcess[str], file: str, reason: str) -> None:
    said = run.stdout + run.stderr
    assert run.returncode == 2, said
    assert re.search(rf"{re.escape(file)}: .*{reason}|{re.escape(file)}: {reason}", said), said
    assert "Traceback" not in said


@pytest.mark.parametrize("kind", WRONG)
def test_a_wrong_scenario_is_refused(kind: str, tmp_path: Path) -> None:
    content, reason = WRONG[kind]
    file = written(tmp_path, content)
    refused(tandem("scenario", "check", file), file, reason)


@pytest.mark.parametrize(
    "command",
    [
        ("up", "--scenario"),
        ("demo", "--scenario"),
        ("campaign", "fetch", "--runs", "1", "--scenario"),
        ("campaign", "recovery", "--runs", "1", "--hopeless", "0", "--scenario"),
    ],
    ids=" ".join,
)
@pytest.mark.parametrize("kind", ["two items in one place", "brackets without end"])
def test_each_command_refuses_it(kind: str, command: tuple[str, ...], tmp_path: Path) -> None:
    content, reason = WRONG[kind]
    file = written(tmp_path, content)
    refused(tandem(*command, file), file, reason)


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("faults: []\nfaults: []\n", r"faults \(line 2\): duplicate key"),
        ("faults: [{kind: item_gone, item: 035}]\n", r"faults\.0\.item \(line 1\): 035 .*octal"),
        (
            "faults:\n- kind: obstacle_appears\n  x: 1.3\n  y: -2.75\n",
            r"faults\.0 \(line 2\): .* in one place with cabinet\.0",
        ),
        ("{" * 3000, "expected a name as key"),
    ],
)
def test_a_wrong_file_of_faults_is_refused(content: str, reason: str, tmp_path: Path) -> None:
    file = written(tmp_path, content)
    refused(tandem("scenario", "check", "Demo", "--faults", file), file, reason)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (("item: 29", "item: 035"), r"items\.\d+\.item \(line \d+\): 035 .*octal"),
        (("name: lab", "name: lab\nname: lab"), r"name \(line \d+\): duplicate key"),
        (("home: {x: -0.8, y: 1.2", "home: {x: 1.0, y: 0.5"), r"home \(line \d+\): .* inside furniture"),
    ],
)
def test_a_wrong_site_is_refused(change: tuple[str, str], reason: str, tmp_path: Path) -> None:
    lab = (Path(__file__).parents[2] / "skills" / "sites" / "lab.yaml").read_text("utf-8")
    assert change[0] in lab
    file = written(tmp_path, lab.replace(*change))
    refused(tandem("tree", "render", "fetch", "--site", file), file, reason)


def test_what_is_clear_is_taken(tmp_path: Path) -> None:
    """Quoted text that looks like a number, numbers as JSON writes them, and things side by side."""
    content = (
        "name: '007'\nsite: lab\nstart: {x: -8e-1, y: 1.2, yaw: 0}\nitems:\n"
        "  - &item {item: 29, support: table, x: 0.50, y: 0.60}\n"
        "  - {item: 42, support: table, x: 0.56, y: 0.60}\n"
    )
    run = tandem("scenario", "check", written(tmp_path, content))
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.mark.parametrize(
    ("declared", "reason"),
    [
        (
            "avoid_colision",
            "no reflex 'avoid_colision'; expected one of cliff, bumper, base_guard, avoid_collision",
        ),
        (
            "avoid_collision, parameters: {ahead: {fires: 0.3, releases: 0.2}}",
            "contradictory thresholds: expected releases above fires",
        ),
    ],
)
@pytest.mark.parametrize("command", [("up",), ("run", "go_to", "--x", "1.0", "--y", "0.0", "--lockstep")])
def test_a_site_with_a_wrong_reflex_is_refused(
    command: tuple[str, ...], declared: str, reason: str, tmp_path: Path
) -> None:
    shipped = (ROOT / "skills" / "sites" / "rocs.yaml").read_text("utf-8")
    file = written(tmp_path, f"{shipped}\nreflexes:\n  - {{reflex: {declared}}}\n")
    refused(tandem(*command, "--scenario", "RocsP3dx", "--site", file), file, rf"reflexes\.0: .*{reason}")
