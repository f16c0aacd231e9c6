"""What is stored of a task beside its status, so that what was acknowledged holds after a crash, too.

It is derived from the task's run, and on disk before a verb is answered and before a goal is sent. So no verb
can be forgotten: what changes the run's behaviour changes this.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, JsonValue

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import HandName, Message
from tandem.skills.ports.tasks import ForcedStatus, Span

Winding = Literal["", "begun", "left"]
"""What is done after a cancel: not begun; begun; or left, because the task was cancelled once more."""


class Held(Message):
    """A breakpoint."""

    node: str
    """The node's path."""
    before: bool


class TaskMemory(Message):
    """One task's memory. Each field says what a restart would forget otherwise."""

    notes: dict[str, JsonValue] = Field(default_factory=dict)
    """What the tree noted (``TreeContext.keep``): what its wind-down needs."""
    hands: tuple[HandName, ...] = ()
    """The robot's hands, which its tree was made for; none before it was made."""
    breakpoints: tuple[Held, ...] = ()
    forced: dict[str, ForcedStatus] = Field(default_factory=dict)
    """The status that a node ends with instead of working, by its path."""
    answers: dict[str, str] = Field(default_factory=dict)
    """An operator's answers that the tree has not taken yet, by the node that asked."""
    step: Literal["", "leaf", "tick"] = ""
    """How far it goes on before it is paused again."""
    go_on: bool = False
    """Whether an operator had it go on after a restart, and it has not done anything yet."""
    winding: Winding = ""
    given_up: Failure | None = None
    """Why it ends INTERRUPTED, once that has been decided."""
    in_order: bool = False
    """Whether the executive ended in order while it was at the task; else it crashed."""
    crashes: Annotated[int, Field(ge=0)] = 0
    """How often it crashed at the task since the task last came further."""
    came: Annotated[int, Field(ge=0)] = 0
    """Nodes whose goals had ended well, at the last crash."""
    fraction: Annotated[float, Field(ge=0.0, le=1.0)] = 0.0
    """The task's progress at the last crash."""
    spans: tuple[Span, ...] = ()
    """When which node ran, once the task has ended or was left."""
