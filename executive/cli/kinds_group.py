"""A command with a command for each kind of task, which is known only when the command runs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, ClassVar

import typer
from typer.core import TyperCommand, TyperGroup

from tandem.executive.cli.errors import CommandError

if TYPE_CHECKING:
    from typer._click import Command, Context

IN_THE_CODE = "json"
"""The command beside those of kinds; it takes the same options, but for the fields of a request."""


class KindsGroup(TyperGroup):
    """Its commands are those in the code, and those that ``kinds`` makes."""

    unknown: ClassVar[str] = "no task {name!r}; expected one of {known}"
    """What is said of a kind that there is none of."""

    def kinds(
        self, words: Sequence[str], defaults: Mapping[str, object], *, quick: bool
    ) -> Iterable[TyperCommand]:
        """Return a command for each kind there is.

        Args:
            words: that follow the command's name.
            defaults: of a project, for the options that all commands share.
            quick: whether somebody waits for a completed word.

        Raises:
            CommandError: when the kinds can't be known.
        """
        raise NotImplementedError

    def list_commands(self, ctx: Context) -> list[str]:
        """Return the names of all commands; where the kinds can't be known, of those in the code."""
        with suppress(CommandError):
            self._add_kinds(ctx, (), quick=ctx.resilient_parsing)
        return super().list_commands(ctx)

    def resolve_command(self, ctx: Context, args: list[str]) -> tuple[str | None, Command | None, list[str]]:
        """Return the command that the words name."""
        name = args[0]
        if ctx.resilient_parsing:  # the shell completes a word: nothing is said, and nothing takes long
            with suppress(Exception):  # a half-typed line may be wrong in any way
                self._add_kinds(ctx, args[1:], quick=True)
        elif name not in self.commands and not name.startswith("-"):
            known = self._add_kinds(ctx, args[1:])
            if name not in known:
                raise CommandError(self.unknown.format(name=name, known=", ".join(known) or "none"))
        return super().resolve_command(ctx, args)

    def _add_kinds(self, ctx: Context, words: Sequence[str], *, quick: bool = False) -> list[str]:
        defaults = {} if ctx.default_map is None else ctx.default_map  # of the project's tandem.yaml
        shared = defaults.get(IN_THE_CODE, {})
        added = {str(each.name): each for each in self.kinds(words, shared, quick=quick)}
        for name, command in added.items():
            self.commands.setdefault(name, command)
            defaults.setdefault(name, shared)
        return list(added)


def single(name: str, text: str, function: Callable[..., None]) -> TyperCommand:
    """Return a function as a command of its own."""
    app = typer.Typer(add_completion=False, context_settings={"help_option_names": ["-h", "--help"]})
    app.command(name, help=text)(function)
    made = typer.main.get_command(app)
    assert isinstance(made, TyperCommand)
    return made
