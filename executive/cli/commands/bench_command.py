"""``tandem bench``: the figures, measured on this machine. The benchmarks come with a checkout alone."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Annotated

import typer

from tandem.executive.cli.errors import CommandError
from tandem.skills.ports import isolation

Names = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]...", help="Benchmarks to run. Default: all.")
]
ListThem = Annotated[bool, typer.Option("--list", help="List the benchmarks and exit.")]
Quick = Annotated[
    bool, typer.Option("--quick", help="Run short versions that only check that the benchmarks work.")
]
ReportFile = Annotated[
    Path | None, typer.Option("--report", metavar="FILE", help="Write the results to this JSON file.")
]
Page = Annotated[
    Path | None, typer.Option("--markdown", metavar="FILE", help="Write the results to this Markdown file.")
]


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("bench")(bench)


def bench(
    names: Names = None,
    *,
    list_them: ListThem = False,
    quick: Quick = False,
    report: ReportFile = None,
    markdown: Page = None,
) -> None:
    """Run the benchmarks and print the results with their targets. Needs a checkout."""
    from tandem.executive.cli.opening import checked_roles, refuse_without_extras  # noqa: PLC0415

    if not list_them:
        refuse_without_extras(checked_roles(None))
    files = {"--report": report, "--markdown": markdown}
    options = [part for option, path in files.items() if path for part in (option, str(path.resolve()))]
    flags = [flag for flag, on in (("--list", list_them), ("--quick", quick)) if on]
    argv = [sys.executable, "-m", "benchmarks.run", *flags, *options, *(names or ())]
    # The benchmarks are no installed package: they are found in the checkout's folder, which is ours.
    env = {name: value for name, value in os.environ.items() if name != isolation.VARIABLE}
    done = subprocess.run(  # noqa: S603 - our own code
        argv, check=False, cwd=checkout(), env=env, stdout=sys.stdout, stderr=sys.stderr
    )
    raise typer.Exit(done.returncode)


def checkout() -> Path:
    """Return the folder of the checkout that this program runs from.

    Raises:
        CommandError: when there is none: the program was installed without its benchmarks.
    """
    folder = Path(__file__).resolve().parents[3]
    if not (folder / "benchmarks" / "run.py").is_file() or not (folder / "pyproject.toml").is_file():
        raise CommandError(
            "the benchmarks are not part of the installed package; clone the repository and run `make bench`"
        )
    return folder
