"""Find the tasks: each file in ``trees/tasks/`` is one, and so is each entry point under ``tandem.tasks``."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping

from tandem.skills.ports.message import Message
from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, load
from tandem.trees import tasks
from tandem.trees.task import TaskType


def discover(left_out: Mapping[str, str] = UNTRIED) -> dict[str, TaskType[Message]]:
    """Return the tasks by name, in alphabetical order: those that ship, and those of plug-ins that load.

    Args:
        left_out: plug-ins that are known not to load (``tandem.skills.ports.plugins.load``).

    Raises:
        TypeError: for a file of ours without a ``TASK``, and for two tasks of one name; names the file.
    """
    return dict(sorted({**shipped(), **plugged(left_out).found}.items()))


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[TaskType[Message]]:
    """Return the tasks of other packages."""
    return load(Group.TASKS, _checked, taken=shipped(), left_out=left_out)


def shipped() -> dict[str, TaskType[Message]]:
    """Return the tasks whose files are in ``trees/tasks/``. Raises as ``discover``."""
    found: dict[str, TaskType[Message]] = {}
    for module in sorted(pkgutil.iter_modules(tasks.__path__), key=lambda each: each.name):
        task = getattr(importlib.import_module(f"{tasks.__name__}.{module.name}"), "TASK", None)
        if not isinstance(task, TaskType):
            raise TypeError(f"trees/tasks/{module.name}.py: expected a TaskType named TASK")
        if task.name in found:
            raise TypeError(f"trees/tasks/{module.name}.py: there is a task {task.name!r} already")
        found[task.name] = task
    return found


def _checked(name: str, value: object) -> TaskType[Message]:
    if not isinstance(value, TaskType):
        raise TypeError(f"expected a TaskType; found {type(value).__name__}")
    if value.name != name:
        raise TypeError(f"the entry point is called {name!r} and its task {value.name!r}; expected one name")
    return value
