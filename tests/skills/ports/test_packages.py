"""Where the files of a robot's description are found."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.skills.ports.packages import resolve


def test_a_mesh_lies_in_a_python_package_of_the_users(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mesh = tmp_path / "app_of_meshes" / "meshes" / "arm.stl"
    mesh.parent.mkdir(parents=True)
    (tmp_path / "app_of_meshes" / "__init__.py").write_text(
        "raise RuntimeError('nobody imports it')\n", "utf-8"
    )
    mesh.write_bytes(b"")
    monkeypatch.syspath_prepend(str(tmp_path))
    assert resolve("package://app_of_meshes/meshes/arm.stl") == mesh


def test_a_package_that_is_not_installed_is_named() -> None:
    with pytest.raises(FileNotFoundError, match="the package 'nowhere_at_all', installed"):
        resolve("package://nowhere_at_all/arm.stl")
