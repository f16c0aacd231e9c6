"""The page that is shipped is made of its sources."""

from __future__ import annotations

import shutil
import subprocess
import sys
from importlib.resources import files
from pathlib import Path

import pytest

from tandem.executive.web.app import BUNDLE

AGAIN = "run: python page/types_of_schemas.py page/src/types.ts"
PAGE = Path(__file__).parents[3] / "page"
SHIPPED = files("tandem.executive.web").joinpath("bundle")


def test_the_types_are_those_of_the_schemas(tmp_path: Path) -> None:
    made = tmp_path / "types.ts"
    subprocess.run([sys.executable, PAGE / "types_of_schemas.py", made], cwd=PAGE.parent, check=True,
                   env={"PYTHONPATH": "."})  # fmt: skip
    assert made.read_text("utf-8") == (PAGE / "src" / "types.ts").read_text("utf-8"), AGAIN


def test_nothing_is_loaded_from_elsewhere() -> None:
    document = SHIPPED.joinpath("index.html").read_text("utf-8")
    assert "://" not in document
    assert "style=" not in document


@pytest.mark.skipif(not (PAGE / "node_modules").is_dir(), reason="no page/node_modules: run `make page`")
def test_the_bundle_is_what_its_sources_make(tmp_path: Path) -> None:
    node = shutil.which("node")
    assert node is not None
    subprocess.run([node, "build.mjs", tmp_path], cwd=PAGE, check=True)
    for name in ("index.html", *BUNDLE):
        assert tmp_path.joinpath(name).read_bytes() == SHIPPED.joinpath(name).read_bytes(), "run `make page`"
