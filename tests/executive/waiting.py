"""A kind of task whose tree waits for ever."""

from __future__ import annotations

from typing import Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.behaviours import Running

from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.context import TreeContext
from tandem.trees.task import TaskType


class WaitRequest(Message):
    task: Literal["wait"] = "wait"
    item: int


def build(asked: WaitRequest, context: TreeContext) -> Behaviour:  # noqa: ARG001 - as builders are called
    return Running("wait")


def fits(asked: WaitRequest, site: Site) -> tuple[Problem, ...]:  # noqa: ARG001 - as checks are called
    return ()


WAITING: Final = TaskType("wait", "Wait.", WaitRequest, fits, build)
WAIT: Final = {"task": "wait", "item": 29}
