"""Skills: generators that take a goal and return an outcome, and what they are made with."""

from __future__ import annotations

from tandem.executive.system.roles.role import Surroundings
from tandem.executive.system.roles.skill_type import SkillType
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import BaseVelocity, Odometry
from tandem.skills.ports.keys import BASE_VELOCITY, ODOMETRY, Latest, Service, Topic
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.skill import (
    ActionType,
    Command,
    Outcome,
    Run,
    Skill,
    Slice,
    canceled,
    failed,
    succeeded,
)

__all__ = [
    "BASE_VELOCITY",
    "ODOMETRY",
    "ActionType",
    "BaseVelocity",
    "Bus",
    "Clocks",
    "Command",
    "Failure",
    "FailureKind",
    "Latest",
    "Message",
    "Odometry",
    "Outcome",
    "RobotDescription",
    "RobotTime",
    "Run",
    "Service",
    "Skill",
    "SkillType",
    "Slice",
    "Surroundings",
    "Topic",
    "canceled",
    "failed",
    "robot_seconds",
    "succeeded",
]
