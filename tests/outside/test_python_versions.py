"""Tandem on a Python that it does not run on.

A user would have seen, on Python 3.12 with the README's first command: four minutes of compiling, or a
compiler's error; on 3.10 or 3.14 a traceback or an unmet dependency. Right is one sentence at once: which
versions it runs on, which this one is, and what to do.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PRETEND = "import sys; sys.version_info = ({major}, {minor}, 0, 'final', 0); "


def pretender(folder: Path, major: int, minor: int) -> Path:
    """Write an interpreter that takes itself for another version: ``python -c CODE`` is all it can."""
    program = PRETEND.format(major=major, minor=minor) + "exec(sys.argv[2])"
    file = folder / "python"
    file.write_text(f'#!/bin/sh\nexec "{sys.executable}" -c "{program}" "$@"\n', encoding="utf-8")
    file.chmod(0o755)
    return file


@pytest.mark.parametrize(("major", "minor"), [(3, 9), (3, 10), (3, 14), (3, 20)])
def test_make_refuses_it_before_it_makes_anything(major: int, minor: int, tmp_path: Path) -> None:
    venv = tmp_path / "venv"
    run = subprocess.run(
        [  # noqa: S607 - the user's make, wherever it is
            "make",
            f"PYTHON={pretender(tmp_path, major, minor)}",
            f"VENV={venv}",
            "setup",
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert run.returncode != 0
    assert f"tandem needs Python 3.11 to 3.13, and this is {major}.{minor}" in run.stderr
    assert "Traceback" not in run.stderr
    assert not venv.exists()


@pytest.mark.parametrize("minor", [10, 14])
def test_the_command_refuses_it(minor: int) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    module, function = project["scripts"]["tandem"].split(":")
    program = PRETEND.format(major=3, minor=minor) + f"from {module} import {function}; {function}()"
    run = subprocess.run(
        [sys.executable, "-c", program, "doctor"], capture_output=True, text=True, timeout=60, check=False
    )
    assert run.returncode == 2
    assert run.stderr.startswith(f"error: tandem needs Python 3.11 to 3.13, and this is 3.{minor}; ")
    assert "Traceback" not in run.stderr


def test_the_readme_and_the_package_say_the_same_versions() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert project["requires-python"] == ">=3.11,<3.14"
    readme = (ROOT / "README.md").read_text("utf-8")
    assert "Python 3.11, 3.12 or 3.13" in readme


def test_each_python_gets_one_build_of_pybullet() -> None:
    """Both in one environment would overwrite each other's files."""
    text = (ROOT / "pyproject.toml").read_text("utf-8")
    found = re.findall(r'"(pybullet[\w-]*)>=[\d.]+; python_version ([<>=]+ \'3\.12\')"', text)
    assert sorted(found) == [("pybullet", "< '3.12'"), ("pybullet-arm64", ">= '3.12'")]
    pinned = (ROOT / "constraints.txt").read_text("utf-8")
    assert "pybullet==" in pinned
    assert "pybullet-arm64==" in pinned
