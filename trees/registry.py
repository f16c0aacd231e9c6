"""Find the tasks: each file in ``trees/tasks/`` is one."""

from __future__ import annotations

import importlib
import pkgutil
from typing import TypeVar

from tandem.skills.ports.message import Message
from tandem.trees import tasks
from tandem.trees.task import TaskType

Asked = TypeVar("Asked", bound=Message)


def discover() -> dict[str, TaskType[Message]]:
    """Return the tasks by name, in alphabetical order.

    Raises:
        TypeError: for a file without a ``TASK``, and for two tasks of one name; names the file.
    """
    found: dict[str, TaskType[Message]] = {}
    for module in sorted(pkgutil.iter_modules(tasks.__path__), key=lambda each: each.name):
        task = getattr(importlib.import_module(f"{tasks.__name__}.{module.name}"), "TASK", None)
        if not isinstance(task, TaskType):
            raise TypeError(f"trees/tasks/{module.name}.py: expected a TaskType named TASK")
        if task.name in found:
            raise TypeError(f"trees/tasks/{module.name}.py: there is a task {task.name!r} already")
        found[task.name] = task
    return found
