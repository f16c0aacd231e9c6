"""Long lists come in pages; whoever wants all of a list asks for one page after the other."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.tasks import AskTasks, TaskList, TaskStatus


def listed(ask: Callable[[AskTasks], TaskList]) -> tuple[TaskStatus, ...]:
    """Return the tasks that the executive remembers, oldest first. ``ask`` gets one page."""
    asked, pages = AskTasks(), list[TaskList]()
    while True:
        pages.append(ask(asked))
        if not pages[-1].more:
            return tuple(status for page in reversed(pages) for status in page.tasks)
        asked = AskTasks(before=pages[-1].more)
