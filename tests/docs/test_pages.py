"""What the pages say is there, and what they show runs."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from tandem.executive.cli.commands.request_command import command_of
from tandem.executive.cli.commands.run_task_command import command_of as run_command_of
from tandem.executive.cli.main import build
from tandem.executive.cli.pages import fill, tables
from tandem.executive.service.intake.kind_schemas import kinds_offered
from tandem.trees.registry import discover

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
FENCED = re.compile(r"^```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)")
MEASURED_LATER = {"docs/benchmarks.md"}
"""Made by `make bench`; a link to it stands before the page does."""


def named(path: Path) -> str:
    return str(path.relative_to(ROOT))


def blocks(language: str) -> list[tuple[str, str]]:
    """Return page and text of each block of a language."""
    return [
        (f"{named(page)}:{number}", text)
        for page in PAGES
        for number, (kind, text) in enumerate(FENCED.findall(page.read_text("utf-8")))
        if kind == language
    ]


def anchors(page: Path) -> set[str]:
    heads = re.findall(r"^#+ (.+)$", page.read_text("utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_links_lead_somewhere(page: Path) -> None:
    text = FENCED.sub("", page.read_text("utf-8"))
    broken = []
    for link in LINK.findall(text):
        file, _, anchor = link.partition("#")
        if "://" in link:
            continue
        target = page if not file else (page.parent / file).resolve()
        if not target.exists():
            if named(target) not in MEASURED_LATER:
                broken.append(link)
        elif anchor and anchor not in anchors(target):
            broken.append(link)
    assert broken == []


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_tables_made_from_the_code_are_up_to_date(page: Path) -> None:
    text = page.read_text("utf-8")
    assert fill(text) == text, f"run: python -m tandem.executive.cli.pages {named(page)}"


def test_the_reference_has_every_command_and_exit_code() -> None:
    reference = (ROOT / "docs" / "interface.md").read_text("utf-8")
    assert tables()["commands"] in reference
    assert tables()["exit_codes"] in reference


def test_every_task_stands_in_the_readme() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    assert [name for name in discover() if f"`{name}`" not in readme] == []


def test_every_skill_is_named_where_skills_are_described() -> None:
    interface = (ROOT / "docs" / "interface.md").read_text("utf-8")
    assert tables()["actions"] in interface


@pytest.mark.parametrize(("where", "text"), blocks("python"), ids=lambda value: value.split("\n")[0][:40])
def test_python_compiles(where: str, text: str) -> None:
    compile(text, where, "exec")


WHOLE = [(where, text) for where, text in blocks("python") if "bench.run(" in text]


@pytest.mark.parametrize(("where", "text"), WHOLE, ids=lambda value: value.split("\n")[0][:40])
def test_benches_run(where: str, text: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", text], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 0, f"{where}: {done.stderr}"


@cache
def command() -> TyperGroup:
    made = get_command(build())
    assert isinstance(made, TyperGroup)
    request = made.commands["request"]
    assert isinstance(request, TyperGroup)
    kinds = kinds_offered(discover()).kinds
    request.commands.update({kind.name: command_of(kind) for kind in kinds})
    request.commands["KIND"] = command_of(kinds[0])  # as the table names them all
    run = made.commands["run"]
    assert isinstance(run, TyperGroup)
    run.commands |= {kind.name: run_command_of(kind) for kind in discover().values()}
    # `tandem new` makes a tour, and the page on extending one's own task make_way.
    run.commands |= dict.fromkeys(("KIND", "tour", "make_way"), run.commands["fetch"])
    return made


def problem_with(words: list[str]) -> str:
    """Return what is wrong with a call of ``tandem``; nothing when there are such a command and options."""
    at: object = command()
    rest = words[1:]
    while isinstance(at, TyperGroup) and rest and not rest[0].startswith("-"):
        if rest[0] not in at.commands:
            return f"no command {rest[0]!r}"
        at, rest = at.commands[rest[0]], rest[1:]
    assert isinstance(at, TyperGroup | TyperCommand)
    known = {option for parameter in at.params for option in (*parameter.opts, *parameter.secondary_opts)}
    unknown = [word for word in rest if word.startswith("-") and word not in {*known, "--help"}]
    return f"no option {unknown[0]}" if unknown else ""


def shell_lines() -> list[tuple[str, str]]:
    lines = [(where, line) for where, text in blocks("sh") for line in text.splitlines()]
    inline = [
        (named(page), text)
        for page in PAGES
        for text in re.findall(r"`(tandem [^`]+|make \w+)`", FENCED.sub("", page.read_text("utf-8")))
    ]
    return [(where, line.split("  #")[0].strip()) for where, line in [*lines, *inline] if line.strip()]


@pytest.mark.parametrize(("where", "line"), shell_lines(), ids=str)
def test_shell_commands_exist(where: str, line: str) -> None:
    words = shlex.split(line.replace("|", "-or-").replace("<name>", "fetch"))
    makefile = (ROOT / "Makefile").read_text("utf-8")
    if words[0] == "make":
        assert all(f"\n{target}:" in makefile for target in words[1:]), where
    elif words[0] == "tandem" and not {"look_around", "count_items"} & {*words}:
        assert problem_with(words) == "", where
    elif words[0] == "cp":
        assert (ROOT / words[1]).exists(), where
        assert (ROOT / words[2]).exists(), where


def test_pictures_are_small() -> None:
    most = {".webp": 450_000}  # a moving one is many
    pictures = (ROOT / "docs" / "images").iterdir()
    assert [path.name for path in pictures if path.stat().st_size > most.get(path.suffix, 200_000)] == []


def tandem(*words: str) -> str:
    program = "from tandem.executive.cli.main import run; run()"
    done = subprocess.run(
        [sys.executable, "-c", program, *words], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return done.stdout


def test_the_tree_in_the_readme_is_what_the_command_draws() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    texts = [text for kind, text in FENCED.findall(readme) if kind == "text"]
    assert tandem("tree", "render", "fetch").strip() in [text.strip() for text in texts]


def test_the_tree_as_a_picture_is_up_to_date(tmp_path: Path) -> None:
    made = tmp_path / "tree.svg"
    tandem("tree", "render", "fetch", "-f", "svg", "-o", str(made))
    kept = ROOT / "docs" / "images" / "fetch-tree.svg"
    assert made.read_bytes() == kept.read_bytes(), (
        "run: tandem tree render fetch --format svg --output docs/images/fetch-tree.svg"
    )
