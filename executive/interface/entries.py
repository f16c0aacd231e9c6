"""The keys of the interface, and what travels on each: read from the modules that define them."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterator
from types import ModuleType

from tandem.sim import controls
from tandem.skills.ports import action, actions, keys, records, reflex, tasks, world
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType
from tandem.skills.wire import loop

Entry = Topic[Message] | Service[Message, Message]
"""A key and what travels on it."""


def entries() -> dict[str, list[Entry]]:
    """Return the keys of the interface, by who they are for."""
    return {
        "clients": task_entries(),
        "world": entries_of(world),
        "skills": [*entries_of(action), *entries_of(reflex), *status_entries()],
        "hardware": entries_of(keys),
        "stand-in": sim_entries(),
    }


def entries_of(module: ModuleType) -> list[Entry]:
    """Return the topics and services that a module defines; functions get their arguments' names."""
    found: list[Entry] = []
    for value in vars(module).values():
        made = _called(module, value) if inspect.isfunction(value) else value
        if isinstance(made, Topic | Service):
            found.append(made)
    return found


def _called(module: ModuleType, function: Callable[..., object]) -> object:
    returned = str(inspect.signature(function).return_annotation)
    if function.__module__ != module.__name__ or not returned.startswith(("Topic", "Service", "ActionType")):
        return None
    names = inspect.signature(function).parameters
    return function(*(f"<{name.rstrip('_')}>" for name in names))


def task_entries() -> list[Entry]:
    """Return the keys of the executive."""
    return [*entries_of(tasks), *entries_of(records)]


def _action_modules() -> Iterator[ModuleType]:
    for module in sorted(pkgutil.iter_modules(actions.__path__), key=lambda each: each.name):
        yield importlib.import_module(f"{actions.__name__}.{module.name}")


def status_entries() -> list[Entry]:
    """Return the keys of the skills' statuses."""
    return [entry for module in _action_modules() for entry in entries_of(module)]


def all_actions() -> list[ActionType[Message, Message, Message]]:
    """Return every action; names in angle brackets stand for groups and sides."""
    found = []
    for module in _action_modules():
        for value in vars(module).values():
            made = _called(module, value) if inspect.isfunction(value) else value
            if isinstance(made, ActionType):
                found.append(made)
    return found


def sim_entries() -> list[Entry]:
    """Return the keys of the simulated hardware alone."""
    return [*entries_of(controls), *entries_of(loop)]


def all_entries() -> list[Entry]:
    """Return every topic and service of the interface."""
    return [entry for group in entries().values() for entry in group]
