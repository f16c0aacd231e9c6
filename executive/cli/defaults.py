"""Makes the defaults of the commands' options out of a project's file (``executive.config.project``)."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Final

from typer.core import TyperCommand, TyperGroup

from tandem.executive.config.project import Project

SYSTEM: Final = ("up", "run")
"""Commands that start the project's system; ``demo`` is Tandem's own, and takes nothing from a project."""
EVERYWHERE: Final = frozenset({"--scenario", "--site", "--data"})
"""Options that mean the same wherever they stand: the room, and the folder of ledger, logs and records."""


def defaults(command: object, project: Project) -> dict[str, object]:
    """Return a command's defaults as click's ``default_map`` has them: by its options, or by its commands."""
    said = {
        f"--{key.replace('_', '-')}": ",".join(value) if key == "only" else value
        for key, value in project.model_dump(by_alias=True, exclude_none=True).items()
    }
    assert isinstance(command, TyperGroup), "the command as a whole is a group"
    return {
        name: _of(each, said, whole=name in SYSTEM)
        for name, each in command.commands.items()
        if name != "demo"
    }


def _of(command: object, said: Mapping[str, object], *, whole: bool) -> dict[str, object]:
    if isinstance(command, TyperGroup):
        return {name: _of(each, said, whole=whole) for name, each in command.commands.items()}
    assert isinstance(command, TyperCommand), "a command is typer's"
    found: dict[str, object] = {}
    options = {option for parameter in command.params for option in parameter.opts}
    if "--scenario" in said and "--scenario" not in options and _draws_for_a_site(command):
        said = {"--site": partial(_site_of, str(said["--scenario"])), **said}
    for parameter in command.params:
        for option in said.keys() & set(parameter.opts):
            shared = getattr(parameter, "envvar", None) or option in EVERYWHERE
            if (whole or shared) and parameter.name is not None:
                found[parameter.name] = said[option]
    return found


def _draws_for_a_site(command: TyperCommand) -> bool:
    """Say whether a command needs a site: where ``--site`` may be empty, it replaces that of a scenario."""
    return any("--site" in parameter.opts and parameter.default for parameter in command.params)


def _site_of(scenario: str) -> str:
    """Return the site that a scenario names; asked only when a command uses it."""
    from tandem.sim.scenario import load_scenario  # noqa: PLC0415 - most commands need none

    return load_scenario(scenario).site
