"""A package that somebody has installed: modules with entry points in a folder, as pip leaves them."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from textwrap import dedent

import pytest


def write_package(
    folder: Path,
    name: str,
    modules: Mapping[str, str],
    entries: Mapping[str, Mapping[str, str]],
    *,
    version: str = "1.0",
) -> Path:
    """Write a package and its metadata into a folder of installed packages; return the folder.

    Args:
        folder: as site-packages is.
        name: of the package.
        modules: sources by module.
        entries: targets by group (``tandem.tasks``) and name.
        version: of the package.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for module, source in modules.items():
        (folder / f"{module}.py").write_text(dedent(source), "utf-8")
    about = folder / f"{name.replace('-', '_')}-{version}.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n", "utf-8")
    lines = [
        line
        for group, targets in entries.items()
        for line in (f"[{group}]", *(f"{entry} = {target}" for entry, target in targets.items()))
    ]
    (about / "entry_points.txt").write_text("\n".join((*lines, "")), "utf-8")
    return folder


class Installed:
    """A folder of installed packages that this process and those that it starts see."""

    def __init__(self, folder: Path, patch: pytest.MonkeyPatch) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        patch.syspath_prepend(str(folder))
        before = os.environ.get("PYTHONPATH")
        patch.setenv("PYTHONPATH", f"{folder}{os.pathsep}{before}" if before else str(folder))
        self._modules: set[str] = set()

    def add(self, name: str, modules: Mapping[str, str], entries: Mapping[str, Mapping[str, str]]) -> None:
        """Install a package."""
        write_package(self.folder, name, modules, entries)
        self._modules |= modules.keys()
        importlib.invalidate_caches()

    def forget(self) -> None:
        """Have none of its modules imported any more."""
        for module in self._modules:
            sys.modules.pop(module, None)
