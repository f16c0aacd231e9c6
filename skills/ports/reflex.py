"""Pipelines and reflexes on the wire: who has a resource of the robot, and which reflex is switched off.

A resource is what one goal at a time commands: the base, an arm, its hand, the head. Its pipeline has two
priorities (RoCS paper, 4.2 and 5.1): goals of the tree are normal, reflexes are high.
"""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.message import Count, Message, PartName, RobotTime
from tandem.skills.ports.reflex_setting import ReflexName

BASE: Final = "base"
"""The resource of whoever drives."""
ARM: Final = "arm"
"""In a reflex's file, any of the robot's arms: one reflex of each, on the pipeline of the arm's group."""
HAND: Final = "hand"
"""In a reflex's file, the hand of that arm: on the pipeline ``gripper_<side>``. An arm and its hand have one
owner, which is why a reflex may take both."""
HEAD: Final = "head"
"""The resource of whoever looks."""
OWNED: Final = ((BASE,), (ARM, HAND), (HEAD,))
"""What one process owns, in the words of reflexes' files. A reflex takes its resources beside their owner."""


class PipelineState(Message):
    """What has a resource now; told on each change and once a second."""

    stamp: RobotTime
    resource: PartName
    holder: str = ""
    """The action that has it at normal priority; empty: nobody."""
    reflex: str = ""
    """The reflex that has it at high priority; empty: none."""
    why: Failure | None = None
    """What the reflex saw."""
    doing: tuple[str, ...] = ()
    """The action at work, outermost first, such as ``GoTo``, ``TurnTo``, ``TurnAngle``."""
    overridden: Count = 0
    """Goals that reflexes have taken the resource from, since the process began."""


class ReflexSwitch(Message):
    """Switch a reflex on or off, with the name of the person."""

    on: bool
    by: Annotated[str, Field(min_length=1, max_length=80)]


class ReflexState(Message):
    """A reflex as it is now."""

    reflex: ReflexName
    on: bool
    by: str = ""
    """Who switched it last; empty: it is as declared."""
    declared: bool = True
    """Whether it is on as the robot and its site declare it, before somebody switches it."""
    resources: tuple[PartName, ...]
    rank: Count
    holds: bool
    fired: Count
    """Times that it has taken its resources since the process began."""
    about: str
    """One sentence: what it watches, and what it does."""
    protects: str = ""
    """Whom or what from what; empty: nobody, and it may be switched off without a question."""


def before_off(state: ReflexState) -> str:
    """Return what whoever switches a reflex off is told first, and has to confirm; "" when nothing is asked.

    The page and ``tandem reflex off`` ask with these words.
    """
    if not state.on or not state.protects:
        return ""
    lasts = "It stays off until somebody switches it on, or its process starts anew."
    return f"It protects {state.protects}. {lasts}"


def hand_resource(side: str) -> str:
    """Return the name of a hand's pipeline."""
    return f"gripper_{side}"


def pipeline_state(resource: str) -> Topic[PipelineState]:
    """Return the topic on which a resource's owner tells who has it."""
    return Topic(f"skill/pipeline/{resource}", PipelineState)


def reflex_switch(reflex: str) -> Service[ReflexSwitch, ReflexState]:
    """Return the service that switches a reflex."""
    return Service(f"skill/reflexes/{reflex}/switch", ReflexSwitch, ReflexState)


def reflex_state(reflex: str) -> Topic[ReflexState]:
    """Return the topic on which a reflex tells how it is, on each change and once a second."""
    return Topic(f"skill/reflexes/{reflex}/state", ReflexState)
