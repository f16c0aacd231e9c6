"""Tells the other robots of the site where this one is and what it does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tandem.skills.ports.whereabouts import EVERY, LARGEST, Following, RobotWhereabouts, whereabouts

if TYPE_CHECKING:
    from tandem.skills.ports.bus import Commons
    from tandem.skills.ports.clocks import Clocks
    from tandem.skills.ports.robot_description import RobotDescription
    from tandem.skills.ports.tasks import TaskStatus
    from tandem.skills.ports.world import RobotPose


class Whereabouts:
    """Call ``step`` in each step of the executive.

    Args:
        commons: where it is told.
        clocks: they say when.
        robot: the robot's name, the last part of its prefix.
        start: names this start of the executive.
    """

    def __init__(self, commons: Commons, clocks: Clocks, robot: str, start: str) -> None:
        self._commons, self._clocks, self._robot, self._start = commons, clocks, robot, start
        self._topic = whereabouts(robot)
        self._sequence = 0
        self._told_at = float("-inf")

    def step(
        self,
        pose: RobotPose | None,
        status: TaskStatus | None,
        follows: Following | None = None,
        description: RobotDescription | None = None,
    ) -> None:
        """Tell, if it is time to.

        Args:
            pose: the robot's, as far as it is known.
            status: of the task that runs.
            follows: whom that task follows.
            description: the robot's, once it is known: others are told how large it is.
        """
        now = self._clocks.passed()
        if now - self._told_at < EVERY - 1e-9:
            return
        self._told_at = now
        told = RobotWhereabouts(
            name=self._robot,
            start=self._start,
            sequence=self._sequence,
            base_in_map=None if pose is None or not pose.localised else pose.base_in_map,
            task="" if status is None else status.task,
            kind="" if status is None else status.kind,
            phase="" if status is None else status.progress.phase[:200],
            follows=follows,
            radius=None if description is None else min(description.footprint_radius, LARGEST),
            height=None if description is None else min(description.height, LARGEST),
        )
        self._topic.publish(self._commons, told)
        self._sequence += 1
