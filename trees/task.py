"""What a kind of task is: its request's model, the checks on a request, and the builder of its tree."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

from py_trees.behaviour import Behaviour

from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.context import TreeContext
from tandem.trees.knowledge import Knowledge

Asked = TypeVar("Asked", bound=Message)


def _for_nothing(_: Knowledge) -> str:
    return ""


@dataclass(frozen=True)
class TaskType(Generic[Asked]):
    """One file in ``trees/tasks/`` defines one of these, named ``TASK``.

    Args:
        name: the value of ``task`` in a request.
        summary: one line for people.
        request: the model of a request; has a field ``task``.
        problems: what is wrong with a well-formed request, given the site; empty when nothing is.
        build: makes the tree.
        waits: what a task of this kind has to wait for before it can begin, in words after "waits for", from
            what is known now; nothing when it can.
    """

    name: str
    summary: str
    request: type[Asked]
    problems: Callable[[Asked, Site], tuple[Problem, ...]]
    build: Callable[[Asked, TreeContext], Behaviour]
    waits: Callable[[Knowledge], str] = _for_nothing
