"""``tandem.yaml``: what would be typed on the command line, kept beside a project's files.

A key is a long option without its dashes, with ``_`` for ``-``. What is typed beats a variable of the
environment, that beats the file, and the file beats the default.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from tandem.executive.config.on_restart import OnRestart
from tandem.skills.ports.message import MOST, Message
from tandem.skills.ports.sources import DocumentError
from tandem.skills.site import SUFFIXES
from tandem.skills.yaml_file import read_document, validate

Text = Annotated[str, Field(min_length=1, max_length=4096)]


class Project(Message):
    """What the file says; None where it says nothing. Paths are relative to the file."""

    scenario: Text | None = None
    """Name of a scenario, or path of its file."""
    site: Text | None = None
    """Name of a site, or path of its file, instead of the scenario's."""
    faults: Text | None = None
    seed: Annotated[int, Field(ge=0, le=MOST)] | None = None
    speed: Annotated[float, Field(ge=0.01, le=100.0)] | Literal["max"] | None = None
    connect: Text | None = None
    """Endpoint of the router."""
    site_key: Text | None = None
    """First part of every topic."""
    robot: Text | None = None
    """Second part of every topic."""
    keys: Text | None = None
    """Folder of TLS keys."""
    holder: Annotated[Text | None, Field(alias="as")] = None
    """Whose key is shown."""
    data: Text | None = None
    """Folder of the ledger."""
    on_restart: OnRestart | None = None
    listen: tuple[Text, ...] | None = None
    only: tuple[Text, ...] | None = None
    insecure: bool | None = None
    metrics: Text | None = None
    traces: Text | None = None
    web: bool | None = None
    """Whether the page is served."""
    silent_after: Annotated[float, Field(ge=0.2, le=10.0)] | None = None

    def beside(self, file: Path) -> Project:
        """Return it with paths that hold in any folder."""
        update = {
            key: str((file.parent / value).absolute())
            for key in ("faults", "keys", "data")
            if (value := getattr(self, key)) is not None
        }
        for key in ("scenario", "site"):
            value = getattr(self, key)
            if value is not None and value.endswith(SUFFIXES):
                update[key] = str((file.parent / value).absolute())
        return self.model_copy(update=update)


def find_project(named: Path | None, here: Path) -> Path:
    """Return the project's file: the one that is named or lies in the folder that is named, or the one here.

    Raises:
        DocumentError: when there is none where it is named.
    """
    if named is None:
        return here
    path = named / here.name if named.is_dir() else named
    if not path.is_file():
        raise DocumentError(f"--project {named}: expected a folder with {here.name} in it, or such a file")
    return path


def read_project(path: Path) -> Project:
    """Return what a project's file says.

    Raises:
        DocumentError: naming the file, the key and its line, and what was expected.
    """
    data, source = read_document(path)
    return validate({} if data is None else data, source, Project).beside(path)
