"""How a command says that it can't: one exception with words for the user and an exit code.

``main`` writes the words to standard error, so that standard output holds only what was asked for.
"""

from __future__ import annotations

from tandem.executive.cli.exit_codes import ExitCode


class CommandError(Exception):
    """Ends the command with a message for the user, and no trace."""

    def __init__(self, message: str, code: ExitCode = ExitCode.BAD_INPUT) -> None:
        """``message``: what is wrong, and what to do."""
        super().__init__(message)
        self.code = code
