"""The wheel and the source distribution: what they hold, and what they say about themselves."""

from __future__ import annotations

import email
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from email.message import Message
from pathlib import Path
from typing import Any, Final

import pytest

from tests.outside._command import ROOT, environment

pytestmark = pytest.mark.xdist_group("processes")
WITHIN: Final = 300.0
PARTS: Final = ("executive", "skills", "sim", "trees", "tandem", "pyproject.toml", "README.md", "LICENSE")
PROJECT: Final[Mapping[str, Any]] = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
BUILD: Final = """
import sys
from setuptools import build_meta
print(getattr(build_meta, sys.argv[1])(sys.argv[2]))
"""


@dataclass(frozen=True)
class Built:
    """The source distribution, a wheel of the checkout, and a wheel of the source distribution."""

    source: Path
    wheel: Path
    wheel_of_source: Path


def build(what: str, folder: Path, into: Path) -> Path:
    """Build a distribution of a folder, as pip does, without the network."""
    into.mkdir(exist_ok=True)
    done = subprocess.run(
        [sys.executable, "-c", BUILD, what, str(into)],
        cwd=folder,
        env=environment(),
        capture_output=True,
        text=True,
        check=False,
        timeout=WITHIN,
    )
    assert done.returncode == 0, done.stderr
    return into / done.stdout.strip().splitlines()[-1]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Built:
    place = tmp_path_factory.mktemp("distributions")
    checkout = place / "checkout"
    for part in PARTS:
        if (ROOT / part).is_dir():
            ignored = shutil.ignore_patterns("__pycache__")
            shutil.copytree(ROOT / part, checkout / part, symlinks=True, ignore=ignored)
        else:
            shutil.copy(ROOT / part, checkout / part)
    source = build("build_sdist", checkout, place / "source")
    wheel = build("build_wheel", checkout, place / "wheel")
    with tarfile.open(source) as archive:
        archive.extractall(place / "unpacked", filter="data")
    (unpacked,) = (place / "unpacked").iterdir()
    return Built(source, wheel, build("build_wheel", unpacked, place / "again"))


def files(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


def metadata(wheel: Path) -> Message:
    with zipfile.ZipFile(wheel) as archive:
        (name,) = (each for each in archive.namelist() if each.endswith(".dist-info/METADATA"))
        return email.message_from_bytes(archive.read(name))


def test_they_are_called_by_the_version(built: Built) -> None:
    version = PROJECT["version"]
    assert built.source.name == f"tandem_executive-{version}.tar.gz"
    assert built.wheel.name == f"tandem_executive-{version}-py3-none-any.whl"


def test_the_metadata_is_that_of_the_project(built: Built) -> None:
    told = metadata(built.wheel)
    assert told["Name"] == "tandem-executive"
    assert told["Version"] == PROJECT["version"]
    assert told["License-Expression"] == "Apache-2.0"
    assert set(told["Requires-Python"].split(",")) == set(PROJECT["requires-python"].split(","))
    assert set(told.get_all("Provides-Extra", [])) == set(PROJECT["optional-dependencies"])
    bare = [each for each in told.get_all("Requires-Dist", []) if "extra ==" not in each]
    assert sorted(bare) == sorted(PROJECT["dependencies"])
    readme = told.get_payload(decode=True)
    assert isinstance(readme, bytes)
    assert readme.decode().strip() == (ROOT / "README.md").read_text("utf-8").strip()


def test_the_wheel_has_the_package_and_nothing_else(built: Built) -> None:
    tops = {name.split("/")[0] for name in files(built.wheel)}
    assert tops == {"tandem", f"tandem_executive-{PROJECT['version']}.dist-info"}
    wanted = {"tandem/skills/sites/lab.yaml", "tandem/sim/scenarios/Demo.yaml"}
    assert wanted <= files(built.wheel)
    assert any(name.endswith(".dist-info/licenses/LICENSE") for name in files(built.wheel))


def test_a_wheel_of_the_source_distribution_is_the_same(built: Built) -> None:
    assert files(built.wheel_of_source) == files(built.wheel)
    assert metadata(built.wheel_of_source).as_bytes() == metadata(built.wheel).as_bytes()
