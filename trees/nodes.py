"""Nodes for trees that other packages add: each entry point under ``tandem.nodes`` makes one.

An entry point names a callable ``(name, context, **arguments)`` that returns a node, as ``drive`` and
``look`` in ``trees/leaves`` do. Trees that are written in Python import what they need; this is where nodes
are found by name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from py_trees.behaviour import Behaviour

from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, load

MakeNode = Callable[..., Behaviour]
"""Takes the node's name, the task's context, and what else it needs."""


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[MakeNode]:
    """Return the nodes of other packages.

    Args:
        left_out: plug-ins that are known not to load (``tandem.skills.ports.plugins.load``).
    """
    return load(Group.NODES, _checked, left_out=left_out)


def _checked(_: str, value: object) -> MakeNode:
    if not callable(value):
        raise TypeError(f"expected a callable that makes a node; found {type(value).__name__}")
    make: MakeNode = value
    return make
