"""The rooms: the architecture page's table is what the imports say, and large rooms have a floor plan."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TOPS = ("executive", "skills", "sim", "trees")
ROW = re.compile(r"^\| `([a-z_/]+)` \| [^|]* \|([^|]*)\|$", re.MULTILINE)
DOZEN = 12


def drawn() -> dict[str, set[str]]:
    """Return what the page says: each room, and the rooms that it imports."""
    page = (ROOT / "docs" / "architecture.md").read_text("utf-8")
    section = page[page.index("## Rooms") : page.index("### Where the next things go")]
    return {room: set(re.findall(r"`([a-z_/]+)`", imports)) for room, imports in ROW.findall(section)}


def room_of(parts: tuple[str, ...]) -> str:
    """Return the room of a module or package, by the names on its way from the repository's root."""
    if parts[0] == "executive":
        return "/".join(parts[:2])
    if parts[0] == "skills" and len(parts) > 1 and (ROOT / "skills" / parts[1]).is_dir():
        return "/".join(parts[:2])
    return parts[0]


def imported(path: Path) -> Iterator[tuple[str, ...]]:
    """Yield all modules of ours that a file imports, anywhere in it."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        names: list[str] = []
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "tandem":
            names = [f"{node.module}.{each.name}" for each in node.names]
        elif isinstance(node, ast.Import):
            names = [each.name for each in node.names if each.name.startswith("tandem.")]
        for name in names:
            parts = tuple(name.split(".")[1:])
            while parts and not (
                (ROOT.joinpath(*parts)).is_dir() or ROOT.joinpath(*parts).with_suffix(".py").exists()
            ):
                parts = parts[:-1]
            if parts:
                yield parts


def built() -> dict[str, set[str]]:
    """Return what the imports say, in the same form."""
    found: dict[str, set[str]] = {}
    for path in (path for top in TOPS for path in (ROOT / top).rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        if parts[-1] == "__init__" and len(parts) == 2:
            continue
        here = room_of(parts)
        others = {room_of(each) for each in imported(path)} - {here}
        found.setdefault(here, set()).update(others)
    return found


def test_the_pages_table_is_what_the_imports_say() -> None:
    assert drawn() == built()


ROOMS = sorted(
    {path.parent for top in TOPS for path in (ROOT / top).rglob("*.py")}, key=lambda path: path.as_posix()
)


@pytest.mark.parametrize("folder", ROOMS, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_room_of_more_than_a_dozen_files_has_a_floor_plan(folder: Path) -> None:
    """Its docstring names every file."""
    files = {path.stem for path in folder.glob("*.py")} - {"__init__"}
    if len(files) > DOZEN:
        plan = set(
            re.findall(
                r"[a-z_0-9]+", ast.get_docstring(ast.parse((folder / "__init__.py").read_text())) or ""
            )
        )
        assert files <= plan, f"not in the floor plan: {sorted(files - plan)}"
