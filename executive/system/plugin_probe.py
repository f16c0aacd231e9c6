"""Tries all plug-ins in a process of its own: one that hangs or ends its process costs that process only.

The child tells on a pipe which plug-in it loads next, and at last how each fared. A child that falls silent
is ended, and another one goes on without the plug-in it was at.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping
from dataclasses import asdict
from typing import Final

from tandem.executive.config.extras import words_on_module
from tandem.executive.system.plugins import GROUPS
from tandem.skills.ports.message import Message
from tandem.skills.ports.plugin_memory import remember
from tandem.skills.ports.plugin_trials import STARTS_WITHIN, ChildEndedError, told_by_child
from tandem.skills.ports.plugins import LOADS_WITHIN, OURS, Broken, Group, Plugin, in_words, installed

_MODULE: Final = "tandem.executive.system.plugin_probe"
"""This module: in the child it is ``__main__``."""


class Fared(Message):
    """How one plug-in fared: ``error`` is empty when it loads."""

    group: Group
    name: str
    package: str
    version: str
    target: str
    error: str

    def plugin(self) -> Plugin:
        """Return which one."""
        return Plugin(self.group, self.name, self.package, self.version, self.target)


class _Told(Message):
    """What the child tells: what it loads next, or at last how all fared."""

    next: str = ""
    fared: tuple[Fared, ...] | None = None


def broken(*, within: float = LOADS_WITHIN) -> tuple[Broken, ...]:
    """Return the plug-ins that can't be loaded. Starts no process where only Tandem's own are installed."""
    if all(plugin.package == OURS for group in Group for plugin in installed(group)):
        return ()
    return tuple(Broken(each.plugin(), each.error) for each in probe(within=within) if each.error)


def probe(*, within: float = LOADS_WITHIN) -> tuple[Fared, ...]:
    """Return how each plug-in fares.

    Args:
        within: seconds for the import of one.
    """
    left_out: dict[str, str] = {}
    while True:
        fared, at, why = _run_child(left_out, within)
        if fared is not None:
            remember({each.plugin(): left_out.get(each.plugin().key, "") for each in fared})
            return fared
        if not at:
            raise RuntimeError(f"the process that tries the plug-ins {why}")
        left_out[at] = f"its import {why}"


def _run_child(left_out: Mapping[str, str], within: float) -> tuple[tuple[Fared, ...] | None, str, str]:
    """Return what the child found; or where it was when it ended or fell silent, and which of the two."""

    def patience(last: bytes) -> float:
        return within if last and _Told.model_validate_json(last).next else STARTS_WITHIN

    at = ""
    try:
        for line in told_by_child(_MODULE, json.dumps(dict(left_out)), patience):
            told = _Told.model_validate_json(line)
            if told.fared is not None:
                return told.fared, "", ""
            at = told.next
    except ChildEndedError as ended:
        return None, at, str(ended)
    return None, at, "told nothing"


def _try_all(pipe: int, left_out: Mapping[str, str]) -> None:
    def tell(told: _Told) -> None:
        os.write(pipe, told.model_dump_json().encode() + b"\n")

    errors = dict(left_out)
    for plugin in (each for group in Group for each in installed(group)):
        if plugin.key not in errors:
            tell(_Told(next=plugin.key))
            try:
                plugin.load()
            except BaseException as raised:  # noqa: BLE001 - it may raise SystemExit and worse
                errors[plugin.key] = in_words(raised)
    tell(_Told())  # what follows is our own work
    plugins = [plugin for group in GROUPS for plugin in installed(group)]
    found: dict[Plugin, str] = {}
    for group in GROUPS:
        try:
            found |= {each.plugin: each.error for each in GROUPS[group](errors).broken}
        except ModuleNotFoundError as missing:
            why = words_on_module(missing, group.entry_points) or in_words(missing)
            found |= {plugin: why for plugin in plugins if plugin.group is group}
    tell(_Told(fared=tuple(Fared(**asdict(plugin), error=found.get(plugin, "")) for plugin in plugins)))


if __name__ == "__main__":
    _try_all(int(sys.argv[1]), json.loads(sys.argv[2]))
