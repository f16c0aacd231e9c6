"""Robots that the sim can stand in for. Needs the extra ``sim``."""

from __future__ import annotations

from tandem.sim.model import RobotModel
from tandem.sim.robots.robot import Robot
from tandem.skills.ports.hardware import RobotDescription

__all__ = ["Robot", "RobotDescription", "RobotModel"]
