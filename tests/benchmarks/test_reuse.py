"""The table of what EXP2 and EXP3 needed beyond EXP1."""

from __future__ import annotations

from pathlib import Path

from benchmarks.reuse import ROOT, ROOTS, lines, reached, table


def test_the_page_has_the_table_that_the_command_prints() -> None:
    page = (ROOT / "docs/papers/rocs-extending.md").read_text("utf-8")
    assert (
        page.partition("<!-- what python -m benchmarks.reuse prints -->")[2]
        .partition("<!-- until here -->")[0]
        .strip()
        == table()
    )


def test_another_robot_needs_its_description_alone() -> None:
    assert reached(ROOTS["EXP2"]) - reached(ROOTS["EXP1"]) == {"sim/robots/summit_xl.py"}


def test_only_lines_with_code_count(tmp_path: Path) -> None:
    file = tmp_path / "a.py"
    file.write_text('"""Text\n\nof two lines."""\n\n# a comment\nX = (\n    1,\n)\n')
    assert lines(str(file)) == 3
