"""The kinds of task that the robot offers, asked of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tandem.executive.config.run_options import BusOptions
    from tandem.skills.ports.tasks import KindOfTask


def kinds_of_robot(options: BusOptions, *, within: float | None = None) -> tuple[KindOfTask, ...]:
    """Return the kinds of task that the executive accepts; ``within`` as for a ``Connection``.

    Raises:
        CommandError: NOBODY_THERE without an answer, REFUSED when the key does not allow the question.
    """
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.tasks import TASK_KINDS  # noqa: PLC0415

    with Connection(options, within=within) as connection:
        return connection.ask(TASK_KINDS, Nothing()).kinds
