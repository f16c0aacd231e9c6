"""The package without extras: client, command and executive run, and the rest says what it lacks."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import pytest

from tests.fakes.ports import free_endpoint

ROOT = Path(__file__).parents[2]


def _needed(name: str, seen: set[str]) -> Iterator[str]:
    """Yield a distribution and all that it needs, without any extra."""
    if name in seen:
        return
    seen.add(name)
    try:
        requires = distribution(name).requires or []
    except PackageNotFoundError:
        return  # of another platform or Python
    yield name
    for each in requires:
        if "extra ==" not in each:
            yield from _needed(re.split(r"[ >=<;\[!~(]", each)[0], seen)


@pytest.fixture(scope="module")
def bare(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return the environment of a Python that sees the bare package alone."""
    packages = tmp_path_factory.mktemp("packages")
    tops: dict[str, Path] = {}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    for requirement in project["dependencies"]:
        for name in _needed(re.split(r"[>=<;\[]", requirement)[0], set()):
            for file in distribution(name).files or ():
                top = Path(file).parts[0]
                if top not in {"..", "__pycache__"}:
                    tops[top] = Path(str(distribution(name).locate_file(top)))
    for top, path in tops.items():
        (packages / top).symlink_to(path)
    (packages / "tandem").symlink_to(ROOT / "tandem")
    return {**os.environ, "PYTHONPATH": str(packages)}


def _tandem(bare: dict[str, str], *words: str) -> tuple[int, str]:
    done = subprocess.run(
        [sys.executable, "-S", "-m", "tandem", *words],
        env=bare,
        cwd=bare["PYTHONPATH"],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    return done.returncode, done.stdout + done.stderr


@pytest.mark.parametrize("module", ["numpy", "cv2", "pinocchio", "pybullet"])
def test_the_bare_package_has_none_of_the_heavy_ones(bare: dict[str, str], module: str) -> None:
    code = f"import importlib.util, sys; sys.exit(importlib.util.find_spec({module!r}) is not None)"
    assert subprocess.run([sys.executable, "-S", "-c", code], env=bare, check=False).returncode == 0


@pytest.mark.parametrize(
    "words",
    [
        ["--help"],
        ["tree", "list"],
        ["tree", "render", "fetch"],
        ["schema"],
        ["scenario", "list"],
        ["scenario", "check", "Demo"],
        ["doctor"],
    ],
    ids=" ".join,
)
def test_what_needs_no_extra_works(bare: dict[str, str], words: list[str]) -> None:
    code, said = _tandem(bare, *words)
    assert code == 0, said


@pytest.mark.parametrize(
    ("words", "names"),
    [
        (["demo"], ["the role hardware", "pybullet", "tandem-executive[sim]", "tandem-executive[skills]"]),
        (["up", "--only", "base"], ["the role base", "numpy", "tandem-executive[skills]"]),
        (["ros", "--map", "map.yaml"], ["rosbags", "tandem-executive[ros]"]),
        (["web"], ["starlette", "uvicorn", "tandem-executive[web]"]),
        (["zones"], ["numpy", "tandem-executive[all]"]),
        (["campaign", "fetch", "--runs", "1"], ["numpy", "tandem-executive[all]"]),
        (
            ["tree", "render", "fetch", "--format", "png", "--output", "x.png"],
            ["cv2", "tandem-executive[all]"],
        ),
    ],
    ids=" ".join,
)
def test_what_needs_an_extra_says_which(bare: dict[str, str], words: list[str], names: list[str]) -> None:
    code, said = _tandem(bare, *words)
    assert code == 2
    assert "Traceback" not in said
    assert [name for name in names if name not in said] == []


@pytest.mark.processes
@pytest.mark.xdist_group("processes")
def test_an_executive_runs_without_any_extra(bare: dict[str, str], tmp_path: Path) -> None:
    words = ["up", "--only", "router,executive", "--connect", free_endpoint(), "--data", str(tmp_path)]
    with subprocess.Popen(
        [sys.executable, "-S", "-u", "-m", "tandem", *words],
        env=bare,
        cwd=bare["PYTHONPATH"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as up:
        assert up.stdout is not None
        said: list[str] = []
        for line in up.stdout:
            said.append(line)
            if line.startswith(("ready", "error", "refused")):
                break
        up.terminate()
        assert said[-1].startswith("ready"), said
