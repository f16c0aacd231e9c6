"""What a kind of task is: its request's model, the checks on a request, and the builder of its tree."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Generic, TypeVar, get_args

from py_trees.behaviour import Behaviour
from pydantic import JsonValue

from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.whereabouts import Following
from tandem.trees.context import TreeContext
from tandem.trees.knowledge import Knowledge
from tandem.trees.needs import Needs, unable
from tandem.trees.node_paths import check_paths

MAX_RESULT_BYTES: Final = 16 * 1024
"""Of a result as JSON. Each status carries it, and a page of the history has a hundred; what is larger
belongs into a file that the result names."""
Asked = TypeVar("Asked", bound=Message)
UNABLE: Final = "UNABLE"
"""Code of the problem that the robot lacks a part."""
RESERVED: Final = frozenset({"by", "id"})
"""Fields of a request that say who asks: the executive reads them, whatever the kind."""
_NOTHING: Final = Needs()


def _for_nothing(_: Knowledge) -> str:
    return ""


def _fits_any(_: Message, __: RobotDescription) -> tuple[Problem, ...]:
    return ()


def _follows_nobody(_: Message) -> None:
    return None


def _problems(told: object, whose: str) -> tuple[Problem, ...]:
    """Return what a kind's own check returned; TypeError unless it is problems."""
    if not isinstance(told, tuple | list) or not all(isinstance(each, Problem) for each in told):
        raise TypeError(f"expected a tuple of Problem from {whose}, found {told!r}")
    return tuple(told)


@dataclass(frozen=True)
class TaskType(Generic[Asked]):
    """One file in ``trees/tasks/`` defines one of these, named ``TASK``.

    Args:
        name: the value of ``task`` in a request.
        summary: one line for people.
        request: the model of a request; has a field ``task``.
        problems: what is wrong with a well-formed request, given the site; empty when nothing is.
        build: makes the tree.
        result: the model of what a task of this kind tells at its end; None when it tells nothing but that it
            succeeded. Its builder sets ``context.result``.
        waits: what a task of this kind has to wait for before it can begin, in words after "waits for", from
            what is known now; nothing when it can.
        needs: the parts of a robot without which no task of this kind can be done.
        misfits: what of a well-formed request the robot can't do, once its description is known.
        follows: which robot a task of this kind follows, and how far behind; told to the robots of the site.
    """

    name: str
    summary: str
    request: type[Asked]
    problems: Callable[[Asked, Site], tuple[Problem, ...]]
    build: Callable[[Asked, TreeContext], Behaviour]
    waits: Callable[[Knowledge], str] = _for_nothing
    result: type[Message] | None = None
    needs: Needs = _NOTHING
    misfits: Callable[[Asked, RobotDescription], tuple[Problem, ...]] = _fits_any
    follows: Callable[[Asked], Following | None] = _follows_nobody

    def __post_init__(self) -> None:
        """Refuse a kind whose requests nobody could send.

        Raises:
            TypeError: a field of its request has a name that the executive reads itself, or its field
                ``task`` takes another name, as in a copy of another task's file.
        """
        if taken := sorted(RESERVED & self.request.model_fields.keys()):
            raise TypeError(
                f"task {self.name!r}: {self.request.__name__} has a field {taken[0]!r}, "
                "by which the executive knows who asks; expected another name"
            )
        field = self.request.model_fields.get("task")
        names = () if field is None else get_args(field.annotation)
        if field is None or (names and self.name not in names):
            found = "no field task" if field is None else f"task: {' or '.join(map(repr, names))}"
            raise TypeError(
                f"task {self.name!r}: {self.request.__name__} has {found}; "
                f'expected task: Literal["{self.name}"] = "{self.name}"'
            )

    def against(self, request: Asked, robot: RobotDescription | None) -> tuple[Problem, ...]:
        """Return why a robot can't do what is asked; nothing when it can, or is not known yet."""
        if robot is None:
            return ()
        why = unable(self.name, self.needs, robot)
        if why:
            return (
                Problem(path="task", expected=f"a task that {robot.name} can do", found=why, code=UNABLE),
            )
        return _problems(self.misfits(request, robot), f"`misfits` of {self.name}")

    def contradictions(self, request: Asked, site: Site) -> tuple[Problem, ...]:
        """Return what is wrong with a request, given the site.

        Raises:
            TypeError: when the kind's own ``problems`` returns something else than problems.
        """
        return _problems(self.problems(request, site), f"`problems` of {self.name}")

    def tree(self, request: Asked, context: TreeContext) -> Behaviour:
        """Build the tree.

        Raises:
            TypeError: when the kind's own ``build`` returns no node, or a tree with two nodes that nothing
                tells apart (``tandem.trees.node_paths``).
        """
        root: object = self.build(request, context)
        if not isinstance(root, Behaviour):
            raise TypeError(f"expected a node of py_trees from `build`, found {root!r}")
        for each in (root, context.wind_down):
            if each is not None:
                check_paths(each)
        return root

    def following(self, request: Asked) -> Following | None:
        """Return whom a task follows, None: nobody.

        Raises:
            TypeError: when the kind's own ``follows`` returns something else.
        """
        told: object = self.follows(request)
        if not (told is None or isinstance(told, Following)):
            raise TypeError(f"expected a Following or None from `follows` of {self.name}, found {told!r}")
        return told

    def waiting(self, knowledge: Knowledge) -> str:
        """Return what a task has to wait for, in words; nothing when it can begin.

        Raises:
            TypeError: when the kind's own ``waits`` returns no text.
        """
        why: object = self.waits(knowledge)
        if not isinstance(why, str):
            raise TypeError(f"expected text, found {why!r}")
        return why

    def result_of(self, context: TreeContext, *, succeeded: bool) -> dict[str, JsonValue] | None:
        """Return what the task tells at its end, as the document that is stored and published.

        Args:
            context: what the tree was built with.
            succeeded: whether it must tell what it declares; a task that did not may have nothing to tell.

        Raises:
            ResultError: when it tells something else than it declares, or too much.
        """
        told = None if context.result is None else context.result()
        if told is None and (self.result is None or not succeeded):
            return None
        if told is None or self.result is None or not isinstance(told, self.result):
            raise ResultError(f"{self.name}: expected {_named(self.result)} as result, found {told!r}")
        size = len(told.model_dump_json().encode())
        if size > MAX_RESULT_BYTES:
            raise ResultError(
                f"{self.name}: expected a result of at most {MAX_RESULT_BYTES} bytes, found {size}"
            )
        return told.model_dump(mode="json")


class ResultError(Exception):
    """A task's result is not what its kind declares: a mistake in the task."""


def _named(model: type[Message] | None) -> str:
    return "nothing" if model is None else model.__name__
