"""What a package of somebody else may import: the pages say it, and no name goes without a new version."""

from __future__ import annotations

from pathlib import Path

from tandem import api
from tandem.executive.interface.api_pages import names, pages

HERE = Path(__file__).parent
DOCS = HERE.parents[1] / "docs" / "api"
HELD = HERE / "public_names.txt"
"""The first line is the version; then one name a line."""


def test_the_pages_say_what_the_modules_hold() -> None:
    told = {path.name: path.read_text("utf-8") for path in DOCS.glob("*.md")}
    assert told == pages(), "run: python -m tandem.executive.interface.api_pages docs/api"


def test_the_public_names_are_those_of_the_version() -> None:
    """Whoever changes them changes ``tandem.api.VERSION``, the CHANGELOG, and this list."""
    version, *held = HELD.read_text("utf-8").splitlines()
    assert (version, held) == (api.VERSION, list(names()))
