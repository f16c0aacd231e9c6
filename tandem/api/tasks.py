"""Tasks: a request's model, the checks on a request, and the building blocks of its tree."""

from __future__ import annotations

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.act import Act
from tandem.trees.behaviours.again import Again
from tandem.trees.behaviours.ask import Ask
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.give_up import GiveUp
from tandem.trees.behaviours.guarded import Guarded
from tandem.trees.behaviours.interruptible import Interruptible
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.pause import Pause
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.remember import afterwards
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.conditions.localised import localised
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.item_number import ItemNumber
from tandem.trees.knowledge import Knowledge
from tandem.trees.leaves.localise import localise
from tandem.trees.leaves.rotate import rotate
from tandem.trees.needs import Needs
from tandem.trees.recovery_kinds import another_way_helps
from tandem.trees.subtrees.arms_in import tuck
from tandem.trees.task import TaskType

__all__ = [
    "Act",
    "Again",
    "Ask",
    "Check",
    "Decide",
    "Each",
    "Failure",
    "FailureKind",
    "FloorPose",
    "GiveUp",
    "Guarded",
    "Interruptible",
    "ItemNumber",
    "Knowledge",
    "Message",
    "Needs",
    "Note",
    "Pause",
    "Phase",
    "Pose",
    "Problem",
    "Recovery",
    "RecoveryStep",
    "Site",
    "TaskType",
    "TreeContext",
    "WaitFor",
    "afterwards",
    "another_way_helps",
    "localise",
    "localised",
    "rotate",
    "tuck",
    "unheard",
]
