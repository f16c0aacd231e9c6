"""``tandem new``: makes a project folder that works without changes."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Final

import typer

from tandem.executive.cli.errors import CommandError

FILES: Final[Mapping[str, str]] = MappingProxyType(
    {
        "pyproject.toml": "pyproject.toml",
        "tandem.yaml": "tandem.yaml",
        "README.md": "README.md",
        ".gitignore": "gitignore",
        ".github/workflows/test.yml": "ci.yml",
        "src/{{ package }}/__init__.py": "package.py",
        "src/{{ package }}/tour.py": "tour.py",
        "src/{{ package }}/recoveries.py": "recoveries.py",
        "src/{{ package }}/rooms.py": "rooms.py",
        "src/{{ package }}/workshop.yaml": "workshop.yaml",
        "src/{{ package }}/first.yaml": "first.yaml",
        "tests/test_{{ task }}.py": "test_tour.py",
    }
)
"""Files of the project, and the templates that they are made of."""
NAME: Final = re.compile(r"[a-z][a-z0-9_]{0,63}")


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("new")(new)


def new(
    name: Annotated[
        str, typer.Argument(metavar="NAME", help="Name of the package: small letters, digits and _.")
    ],
) -> None:
    """Make a folder for a project of your own: a task, a site, a scenario, tests and tandem.yaml."""
    folder = Path(_checked(name))
    try:
        for path, text in project(name).items():
            file = folder / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
    except OSError as error:
        raise CommandError(f"{folder}: cannot write: {error.strerror}") from error
    typer.echo(f"{folder}: {len(FILES)} files; README.md says what is where")
    typer.echo(f'next: cd {folder} && pip install -e ".[test]" && pytest && tandem up')


def project(name: str) -> dict[str, str]:
    """Return the text of each file of a new project, by its path."""
    from importlib.metadata import version  # noqa: PLC0415
    from importlib.resources import files  # noqa: PLC0415

    named = {
        "package": name,
        "distribution": name.replace("_", "-"),
        "task": "tour",
        "version": version("tandem-executive"),
    }
    templates = files("tandem.executive.cli") / "template"

    def filled(text: str) -> str:
        for key, value in named.items():
            text = text.replace(f"{{{{ {key} }}}}", value)
        return text

    return {
        filled(path): filled(templates.joinpath(f"{template}.in").read_text("utf-8"))
        for path, template in FILES.items()
    }


def _checked(name: str) -> str:
    """Return the name, when a package can be called so and nothing is in its place.

    Raises:
        CommandError: saying why not.
    """
    from importlib.util import find_spec  # noqa: PLC0415

    if NAME.fullmatch(name) is None or keyword.iskeyword(name):
        raise CommandError(f"NAME: expected small letters, digits and _, like my_robot_app; found {name!r}")
    if Path(name).exists():
        raise CommandError(f"{name} exists already; choose another name, or another folder to be in")
    if find_spec(name) is not None:
        raise CommandError(f"NAME: a module {name!r} is installed already; choose another name")
    return name
