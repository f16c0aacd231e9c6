"""Figures in the pages come from files that commands wrote, and name where they come from."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from benchmarks.figures import fill, main, names
from tandem.executive.trials.figure_file import Figures, write_figures
from tandem.executive.trials.provenance import Provenance, provenance
from tandem.skills.ports.message import Message

ROOT = Path(__file__).parents[2]
PAGES = sorted((ROOT / "docs").glob("*.md"))
PAGE = "before\n<!-- begin figures fetch -->\nold\n<!-- end figures fetch -->\nafter\n"
MADE_AT = 1_795_000_000.0
"""2026-11-18, UTC."""


class Result(Message):
    """What a command found out."""

    right: int


def test_a_block_is_filled_with_what_was_printed_and_where_it_comes_from(tmp_path: Path) -> None:
    words = ("/somewhere/bin/tandem", "campaign", "fetch", "--runs", "60")
    made = provenance(words, MADE_AT)
    write_figures(tmp_path / "fetch.json", made, ("60 of 60 right",), Result(right=60))
    assert Figures.model_validate_json((tmp_path / "fetch.json").read_bytes()).made == made
    page = fill(PAGE, tmp_path)
    assert "old" not in page
    assert "```text\n60 of 60 right\n```" in page
    assert f"`tandem campaign fetch --runs 60`: commit `{made.commit[:10]}`" in page
    assert page.startswith("before\n<!-- begin figures fetch -->")
    assert page.endswith("<!-- end figures fetch -->\nafter\n")


def test_a_block_without_a_file_stays_and_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "page.md").write_text(PAGE)
    assert main([str(tmp_path), str(tmp_path / "page.md")]) == 0
    assert (tmp_path / "page.md").read_text() == PAGE
    assert "not made, left as it was: fetch" in capsys.readouterr().err


def test_the_commit_is_the_checkouts() -> None:
    done = subprocess.run(
        ["git", "-C", str(ROOT), "rev-parse", "HEAD"],  # noqa: S607
        capture_output=True,
        text=True,
        check=False,
    )
    made = provenance(("tandem", "bench"), MADE_AT)
    assert made.commit == done.stdout.strip()
    assert made.date == "2026-11-18"


def test_local_changes_are_told() -> None:
    made = provenance(("tandem",), MADE_AT)
    clean = made.model_copy(update={"changed": False, "commit": "a" * 40})
    assert "with local changes" not in clean.line()
    assert "commit `aaaaaaaaaa`, with local changes" in clean.model_copy(update={"changed": True}).line()


def test_outside_a_checkout_no_commit_is_made_up() -> None:
    made = provenance(("tandem",), MADE_AT).model_copy(update={"commit": ""})
    assert isinstance(made, Provenance)
    assert "no checkout" in made.line()


@pytest.mark.parametrize(
    "page", [each for each in PAGES if names(each.read_text("utf-8"))], ids=lambda p: p.name
)
def test_every_block_of_figures_is_made_by_make_figures(page: Path) -> None:
    makefile = (ROOT / "Makefile").read_text("utf-8")
    made = set(re.findall(r"^\$\(FIGURES\)/([\w-]+)\.json:", makefile, re.MULTILINE))
    assert set(names(page.read_text("utf-8"))) <= made


@pytest.mark.parametrize("name", ["campaign_command", "experiment_command", "restart_command"])
def test_no_campaign_writes_a_report_past_the_shared_form(name: str) -> None:
    source = (ROOT / "executive" / "cli" / "commands" / f"{name}.py").read_text("utf-8")
    assert "told(console, report" in source
    assert "report.write_text" not in source
