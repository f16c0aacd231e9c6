"""The pages about the papers name files that are there and leave nothing out; the code cites nothing else."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAPERS = ROOT / "docs" / "papers"
NAMES = {
    "order-picking paper": "order-picking.md",
    "RoCS paper": "rocs.md",
    "two-arm thesis": "two-arms.md",
}


def _words(text: str) -> list[str]:
    return text.split()


def _numbered(kind: str, chapter: str, last: int) -> list[str]:
    return [f"{kind} {chapter}{number}" for number in range(1, last + 1)]


PARTS = {
    "order-picking.md": [
        *_words("I II II-A II-B II-C III III-A III-A.1 III-A.2 III-A.3 III-A.4 III-B III-C"),
        *_words("III-D III-D.1 III-D.2 IV IV-A IV-B V"),
        *_numbered("eq.", "", 3),
        *_numbered("Fig.", "", 11),
    ],
    "rocs.md": [
        *_words("1 2 2.1 2.2 3 4 4.1 4.2 4.3 5 5.1 5.2 5.3 6 6.1 6.2 6.3 6.4 6.5 6.6 7 8"),
        *_numbered("Table", "", 2),
        *_numbered("Fig.", "", 10),
    ],
    "two-arms.md": [
        *_words("1 1.1 1.2 1.3 1.4 2 2.1 2.2 2.3 2.4 3 3.1 3.2 3.3 3.4 3.5"),
        *_words("4 4.1 4.1.1 4.1.2 4.2 4.2.1 4.3 4.3.1 5 5.1 5.2 5.3 5.4 5.4.1 5.4.2 5.4.3 5.5 6"),
        *_numbered("eq.", "4.", 2),
        *_numbered("Algorithm", "", 3),
        *_numbered("Table", "5.", 7),
        *_numbered("Fig.", "1.", 2),
        *_numbered("Fig.", "3.", 3),
        *_numbered("Fig.", "4.", 15),
        *_numbered("Fig.", "5.", 13),
    ],
}
"""The headings of each document: sections, equations, algorithms, tables, figures."""

WHERE = ("benchmarks", "docs", "examples", "executive", "sim", "skills", "tests", "trees")
FILE = re.compile(r"`([\w-]+(?:/[\w.-]+)*\.(?:md|png|py|svg|toml|yaml))`")
NUMBER = r"(?:[IV]+(?:-[A-D](?:\.\d)?)?|\d(?:\.\d)*|(?:eq\.|fig\.|algorithm|table) \d+(?:\.\d+)?)\b"
CITED = re.compile(rf"\b([\w-]+ (?:paper|thesis))((?:, {NUMBER}(?: and [\d.]*\d)?)+)", re.IGNORECASE)
BARE = re.compile(r"\b[Dd]ocuments? 00\d|(?<![\w.,/-])00[0-2], ")


def _rows(page: str) -> list[list[str]]:
    lines = (PAPERS / page).read_text("utf-8").splitlines()
    rows = [
        [cell.strip() for cell in line.strip("|").split(" | ")] for line in lines if line.startswith("| ")
    ]
    return [row for row in rows if row[0] not in {"part", "---"}]


@cache
def _texts() -> dict[str, str]:
    """Return what may cite a paper, by the file's name, with each text on one line."""
    found = [*ROOT.glob("*.md")]
    for folder in WHERE:
        found += [file for end in ("py", "md", "yaml") for file in (ROOT / folder).rglob(f"*.{end}")]
    here = Path(__file__)
    return {str(file.relative_to(ROOT)): file.read_text("utf-8") for file in found if file != here}


@pytest.mark.parametrize("page", PARTS)
def test_each_part_has_its_row_and_each_row_all_cells(page: str) -> None:
    rows = _rows(page)
    assert [row for row in rows if len(row) != 7] == []
    assert sorted({row[0] for row in rows}) == sorted(PARTS[page])


@pytest.mark.parametrize("page", PARTS)
def test_each_file_is_there(page: str) -> None:
    named = FILE.findall((PAPERS / page).read_text("utf-8"))
    assert named
    assert [file for file in named if not (ROOT / file).is_file()] == []


def test_whoever_is_cited_has_a_page_and_what_is_cited_a_row() -> None:
    wrong = []
    for file, text in _texts().items():
        for name, numbers in CITED.findall(" ".join(text.split())):
            known = next((page for short, page in NAMES.items() if short.lower() == name.lower()), None)
            parts = {part.lower() for part in PARTS.get(known or "", [])}
            cited = re.findall(f", ({NUMBER})", numbers, re.IGNORECASE)
            wrong += [f"{file}: {name}, {part}" for part in cited if part.lower() not in parts]
    assert wrong == []


@pytest.mark.parametrize(("name", "page"), NAMES.items())
def test_each_page_tells_its_short_name(name: str, page: str) -> None:
    assert f"*{name}*" in (PAPERS / page).read_text("utf-8")
    assert f"| {name} | [{page}]({page}) |" in (PAPERS / "README.md").read_text("utf-8")


def test_nobody_cites_by_the_number_of_a_file() -> None:
    found = {file: BARE.findall(text) for file, text in _texts().items()}
    assert {file: each for file, each in found.items() if each} == {}
