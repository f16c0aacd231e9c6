"""Each file of the repository that a page or a docstring names is there: files move, and prose stays."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NAMED = re.compile(
    r"(?<![\w./-])((?:executive|skills|sim|trees|tests|benchmarks|examples|docs)/[\w/.-]+\.(?:py|md|yaml|json|svg))\b"
)
YOURS = {"tests/test_count_items.py"}
"""Files of a reader's own project."""
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
SOURCES = sorted(
    path
    for room in ("executive", "skills", "sim", "trees", "benchmarks")
    for path in (ROOT / room).rglob("*.py")
)


@pytest.mark.parametrize("page", PAGES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_page_names_files_that_are_there(page: Path) -> None:
    named = set(NAMED.findall(page.read_text("utf-8"))) - YOURS
    assert [each for each in sorted(named) if not (ROOT / each).exists()] == []


def test_docstrings_and_comments_name_files_that_are_there() -> None:
    gone = {
        (str(path.relative_to(ROOT)), each)
        for path in SOURCES
        for each in NAMED.findall(path.read_text("utf-8"))
        if not (ROOT / each).exists()
    }
    assert gone == set()
