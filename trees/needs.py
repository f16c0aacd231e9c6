"""What a kind of task needs of a robot, and what a robot lacks of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from tandem.skills.ports.message import HandName
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.robot_description import RobotDescription

_COUNTS: Final = {1: "a gripper", 2: "two hands"}


@dataclass(frozen=True)
class Needs:
    """The parts of a robot that a task can't do without.

    Args:
        hands: how many, whichever they are.
        named: hands that must be called so.
        drive: whether the base must drive.
        camera: whether something must see.
        place: whether a sensor must tell where it is in the map: a laser or a pose sensor.
        robots: whether a sensor must see other robots.
    """

    hands: int = 0
    named: tuple[HandName, ...] = ()
    drive: bool = False
    camera: bool = False
    place: bool = False
    robots: bool = False

    def missing(self, robot: RobotDescription) -> tuple[str, ...]:
        """Return the parts that a robot lacks, in words after "needs"."""
        return tuple(self._missing(robot))

    def _missing(self, robot: RobotDescription) -> Iterator[str]:
        if len(robot.hands) < self.hands:
            yield _COUNTS.get(self.hands, f"{self.hands} hands")
        lacking = [hand for hand in self.named if hand not in robot.hands]
        if lacking:
            there = ", ".join(robot.hands) or "none"
            yield f"hands called {' and '.join(self.named)} (there are: {there})"
        if self.drive and robot.drive is None:
            yield "a base that drives"
        if self.camera and not robot.cameras:
            yield "a camera"
        if self.place and not (robot.lasers or robot.pose_sensors):
            yield "a laser or a pose sensor, to know where it is"
        if self.robots and not robot.robot_sensors:
            yield "a sensor for other robots"


def unable(task: str, needs: Needs, robot: RobotDescription) -> str:
    """Return why a robot can't do a task, in words; nothing when it can."""
    missing = needs.missing(robot)
    return f"{task} needs {' and '.join(missing)}" if missing else ""


def no_such_hand(path: str, asked: HandName | None, robot: RobotDescription) -> tuple[Problem, ...]:
    """Return what is wrong with a hand that a request names, if it names one that the robot lacks."""
    if asked is None or asked in robot.hands:
        return ()
    return (Problem(path=path, expected=f"one of the robot's hands: {', '.join(robot.hands)}", found=asked),)
