"""``tandem new``: from the wheel, in an environment with nothing else of ours, the project works at once."""

from __future__ import annotations

import json
import re
import shutil
import signal
import subprocess
import sys
import time
import venv
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import pytest

from tests.outside._command import ROOT, environment, free_port, users_folder

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]
WITHIN: Final = 300.0
"""Seconds for one command; the longest takes about 30 on an idle machine."""
PARTS: Final = ("executive", "skills", "sim", "trees", "tandem", "pyproject.toml", "README.md", "LICENSE")


@dataclass(frozen=True)
class Place:
    """A project in a folder of the user's, and the programs of its environment."""

    folder: Path
    programs: Path

    def run(self, *words: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
        """Run a program of the environment to its end."""
        return run(str(self.programs / words[0]), *words[1:], cwd=cwd or self.folder)


def run(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        words, cwd=cwd, env=environment(), capture_output=True, text=True, check=False, timeout=WITHIN
    )


@contextmanager
def started(place: Place, *words: str) -> Iterator[str]:
    """Run a system until the context ends; entered with what it said when it was ready."""
    log = place.folder / "up.log"
    with log.open("w") as file:
        process = subprocess.Popen(
            [str(place.programs / "tandem"), *words],
            cwd=place.folder,
            env=environment(),
            stdout=file,
            stderr=file,
        )
        try:
            deadline = time.monotonic() + WITHIN
            while "press Ctrl-C" not in log.read_text("utf-8"):
                assert process.poll() is None, log.read_text("utf-8")
                assert time.monotonic() < deadline, log.read_text("utf-8")
                time.sleep(0.1)
            yield log.read_text("utf-8")
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(60)


def install(python: Path, what: Path, cwd: Path) -> None:
    words = ["--python", str(python), "install", "-q", "--no-deps", "--no-index", "--no-build-isolation"]
    done = run(sys.executable, "-m", "pip", *words, str(what), cwd=cwd)
    assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Place:
    """Build the wheel, install it beside the libraries that are here, make a project, and install that."""
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    for part in PARTS:
        copied = source / part
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, copied, symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(ROOT / part, copied)
    words = ("wheel", "-q", "--no-deps", "--no-index", "--no-build-isolation", "-w", str(folder), str(source))
    built = run(sys.executable, "-m", "pip", *words, cwd=folder)
    assert built.returncode == 0, built.stderr
    (wheel,) = folder.glob("*.whl")
    made = folder / "venv"
    venv.create(made)
    libraries = [path for path in sys.path if "site-packages" in path]
    (packages,) = made.glob("lib/python*/site-packages")
    (packages / "libraries.pth").write_text("\n".join(libraries))
    robots = next(
        Path(path) / "cmeel.prefix" for path in libraries if (Path(path) / "cmeel.prefix/share").is_dir()
    )
    (packages / "cmeel.prefix").symlink_to(robots)  # the robot's files are looked for in the environment
    python = made / "bin" / "python"
    install(python, wheel, folder)
    user = users_folder(folder / "user")
    empty = Place(user, made / "bin")
    new = empty.run("tandem", "new", "my_robot_app")
    assert new.returncode == 0, new.stderr
    project = users_folder(user / "my_robot_app")  # names of ours beside the project's own files, too
    settings = project / "tandem.yaml"
    settings.write_text(settings.read_text("utf-8").replace("7447", str(free_port())), "utf-8")
    install(python, project, folder)
    return Place(project, made / "bin")


def test_what_runs_is_the_wheel(place: Place) -> None:
    done = place.run("python", "-P", "-c", "import tandem.executive; print(tandem.executive.__file__)")
    assert Path(done.stdout.strip()).is_relative_to(place.programs.parent), done.stderr


def test_its_tests_are_green(place: Place) -> None:
    done = place.run("python", "-m", "pytest", "-q", "-p", "no:cacheprovider")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "5 passed" in done.stdout


def test_its_plug_ins_are_found(place: Place) -> None:
    done = place.run("tandem", "plugins", "--json")
    assert done.returncode == 0, done.stdout + done.stderr
    assert [(each["group"], each["name"]) for each in json.loads(done.stdout)] == [
        ("tasks", "tour"),
        ("sites", "workshop"),
    ]


def test_a_name_that_is_taken_or_none_is_refused(place: Place) -> None:
    for name, why in (
        ("tandem", "installed already"),
        ("My-App", "small letters"),
        ("src", "exists already"),
    ):
        done = place.run("tandem", "new", name)
        assert done.returncode == 2
        assert why in done.stderr


def test_its_task_runs_in_lockstep(place: Place) -> None:
    done = place.run("tandem", "run", "tour", "--spots", '["table"]', "--lockstep")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "ok   1. table: look" in done.stdout
    assert "task tour-0001 succeeded" in done.stdout


def test_its_system_starts_where_its_settings_say_and_does_its_task(place: Place) -> None:
    port = re.findall(r"connect: \S+:(\d+)", (place.folder / "tandem.yaml").read_text("utf-8"))[0]
    with started(place, "up", "--speed", "max") as said:
        assert f"ready: {place.folder}/src/my_robot_app/first.yaml on workshop/tiago" in said
        assert f":{port}" in said
        done = place.run("tandem", "request", "tour", "--spots", '["table"]', "--wait")
        assert done.returncode == 0, done.stdout + done.stderr
    assert (place.folder / "data").is_dir()
