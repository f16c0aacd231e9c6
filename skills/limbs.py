"""An arm with its hand, or the head, as its owner has it: pipelines, the reflexes on them, and their ground.

The process that moves an arm has its hand too, so both have one owner. They are two pipelines, since the tree
moves both at once: a hand opens while its arm brings it before an item. A reflex may take either or both.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.hardware import CancelMotion, GroupStatus, JointStates
from tandem.skills.ports.keys import JOINT_STATES, Latest, group_cancel, group_status
from tandem.skills.ports.reflex import ARM, HAND, HEAD, hand_resource
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.reflex_owners import Owner
from tandem.skills.reflexes import Act, Chosen, Reflexes, fitted

HEARD_AFTER: Final = 0.1
"""Robot seconds after a cancel in which the group's status has come: the hardware tells it on each change,
and ten of its periods pass. A motion that was just sent is not told of before."""
CANCEL_AGAIN: Final = 0.5
"""Robot seconds after which a cancel is sent again, until the group is at rest: as often as a move's own."""
RESTS_WITHIN: Final = 4.0
"""Robot seconds after which hardware that tells of no rest is not waited for any more: as long as a move
that is cancelled waits."""


@dataclass(frozen=True, eq=False)
class LimbSurroundings:
    """What a reflex of an arm, or of the head, may look at, and command once it has the limb.

    Args:
        bus: the hardware and the world.
        clocks: robot time.
        description: the robot.
        group: the joints: an arm's, or the head's.
        part: the arm's side; empty for the head.
        pipelines: by the words of reflexes' files: of the arm and its hand, or of the head.
        joints: the joint states, all groups' in one message.
        status: what the hardware tells of the group.
    """

    bus: Bus
    clocks: Clocks
    description: RobotDescription
    group: str
    part: str
    pipelines: Mapping[str, Pipeline]
    joints: Latest[JointStates]
    status: Latest[GroupStatus]

    def called(self, reflex: str) -> str:
        """Return what a reflex is called here, given its name in its file."""
        return f"{reflex}_{self.part}" if self.part else reflex

    def halt(self, reflex: str) -> Act:
        """Bring the group to rest, whatever moves it, as long as the reflex has it."""
        pipeline, name = self.pipelines[ARM if ARM in self.pipelines else HEAD], self.called(reflex)
        service, began, asked_at = group_cancel(self.group), robot_seconds(self.clocks), -math.inf
        while pipeline.has(name):
            now, status = robot_seconds(self.clocks), self.status.refresh()
            at_rest = status is None or status.at_rest
            if (at_rest and now - began >= HEARD_AFTER) or now - began >= RESTS_WITHIN:
                return
            if now - asked_at >= CANCEL_AGAIN:
                asked_at = now
                service.query(self.bus, CancelMotion(id=""))
            yield ("Halt",)


LimbOwner = Owner[LimbSurroundings]
"""The owner of arms with their hands, or of the head."""


class Limb:
    """Runs a limb's reflexes, and tells who has it; a ``Node``, stepped before the limb's skills.

    Args:
        around: what its reflexes are made with.
        reflexes: those that the robot has here.
    """

    def __init__(self, around: LimbSurroundings, reflexes: Sequence[Chosen[LimbSurroundings]]) -> None:
        self._around = around
        made = fitted(reflexes, around, around.pipelines)
        self._runner = Reflexes(around.bus, around.clocks, tuple(around.pipelines.values()), made)

    @property
    def name(self) -> str:
        """The node's name."""
        return f"{self._around.group}/reflexes"

    @property
    def busy(self) -> bool:
        """Whether a reflex has any of it."""
        return any(pipeline.override is not None for pipeline in self._around.pipelines.values())

    def pipeline(self, resource: str) -> Pipeline:
        """Return the pipeline of ``ARM``, ``HAND`` or ``HEAD``; KeyError when it is no part of this limb."""
        return self._around.pipelines[resource]

    def step(self) -> bool:
        """Have the reflexes look and act."""
        return self._runner.step()

    def close(self) -> None:
        """End what acts, and the subscriptions."""
        self._runner.close()
        self._around.joints.close()
        self._around.status.close()


def arm(bus: Bus, clocks: Clocks, description: RobotDescription, side: str) -> LimbSurroundings:
    """Return what the reflexes of an arm with its hand are made with; KeyError when there is no such hand."""
    group = description.end_effector(side).group
    pipelines = {ARM: Pipeline(group), HAND: Pipeline(hand_resource(side))}
    return _around(bus, clocks, description, group, pipelines, part=side)


def head(bus: Bus, clocks: Clocks, description: RobotDescription) -> LimbSurroundings:
    """Return what the reflexes of the head are made with."""
    return _around(bus, clocks, description, HEAD, {HEAD: Pipeline(HEAD)})


def _around(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    group: str,
    pipelines: Mapping[str, Pipeline],
    *,
    part: str = "",
) -> LimbSurroundings:
    return LimbSurroundings(
        bus=bus,
        clocks=clocks,
        description=description,
        group=group,
        part=part,
        pipelines=MappingProxyType(pipelines),
        joints=Latest(bus, JOINT_STATES),
        status=Latest(bus, group_status(group)),
    )
