"""The nodes of an arm's process: moves of its groups, and its gripper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tandem.skills.arm.doubt import Doubt
from tandem.skills.arm.field.approach import Approach
from tandem.skills.arm.move import Move
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.status import ArmStatusBoard
from tandem.skills.arm.survey import Survey
from tandem.skills.claimed import Claimed
from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.server import ActionServer


def nodes(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    groups: Sequence[str],
    *,
    hulls: RobotHulls | None = None,
    settings: PlannerSettings | None = None,
    seed: int = 0,
    charge: bool = False,
    compute: Compute | None = None,
    pipelines: Mapping[str, Pipeline] | None = None,
) -> tuple[Node, ...]:
    """Return the state boards and the servers of the groups.

    Each group has a ``<group>/move``; one with a hand has ``<group>/survey`` and ``<group>/approach`` too.

    Args:
        bus: the hardware, the world, the clients.
        clocks: robot time.
        description: the robot.
        groups: the groups to serve, such as ``arm_left`` or ``torso``.
        hulls: the robot's bodies, if they are at hand (see ``load_hulls``).
        settings: the planner and its bounds.
        seed: seeds the plans, with the goals' ids.
        charge: make a computation's slices cost their declared robot time (lockstep).
        compute: plans what can't be sliced (AORRTC); without one it is done in place, in one long step.
        pipelines: of the groups, by name; a group that has none here gets one that no reflex takes.

    Raises:
        KeyError: for a group that the robot does not have.
    """
    bodies = load_hulls(description, seed) if hulls is None else hulls
    made: list[Node] = []
    for name in groups:
        # In lockstep plans are charged by counts, and they are the same: nothing is gained there.
        field = settings is not None and settings.field and not charge
        arm = Arm(bodies, description, name, field=field)
        board = ArmStatusBoard(bus, clocks, arm)
        doubt, pipeline = Doubt(), (pipelines or {}).get(name) or Pipeline(name)
        skill = Move(
            bus, clocks, arm, board, settings or PlannerSettings(), seed=seed, compute=compute, doubt=doubt
        )
        made += [
            board,
            ActionServer(bus, clocks, Claimed(skill, pipeline), charge=charge, pipelines=(pipeline,)),
        ]
        if arm.hand is not None:
            look = Survey(bus, clocks, arm, settings or PlannerSettings(), seed)
            made.append(ActionServer(bus, clocks, look, charge=charge))
            near = Approach(
                bus,
                clocks,
                arm,
                board,
                settings or PlannerSettings(),
                seed=seed,
                compute=compute,
                doubt=doubt,
            )
            made.append(
                ActionServer(bus, clocks, Claimed(near, pipeline), charge=charge, pipelines=(pipeline,))
            )
    return tuple(made)
