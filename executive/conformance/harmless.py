"""Commands that move nothing even if they are obeyed: what to send when a refusal is expected."""

from __future__ import annotations

from collections.abc import Generator
from typing import TYPE_CHECKING

from tandem.executive.conformance.clause import Broken, Skip
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Answer, GripperCommand, TrajectoryGoal, TrajectoryPoint

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.lease import Lease
    from tandem.skills.ports.robot_description import JointGroup


def standing(bench: Bench, group: JointGroup) -> tuple[float, ...]:
    """Return where a group's joints stand (rad or m)."""
    state = bench.recording.latest(keys.JOINT_STATES)
    if state is None or not set(group.joints) <= set(state.names):
        raise Broken(f"joint states of {group.name}", "none")
    return state.position_of(group.joints)


def send_harmless(bench: Bench, lease: Lease | None) -> Generator[None, None, Answer]:
    """Command the first group, or else the first hand, to stay as it is, under a lease."""
    robot = bench.robot
    if robot.groups:
        group = robot.groups[0]
        positions = standing(bench, group)
        points = tuple(
            TrajectoryPoint(time=time, positions=positions, velocities=(0.0,) * len(positions))
            for time in (0.0, 0.1)
        )
        goal = TrajectoryGoal(id=bench.new_id(), points=points, lease=lease)
        return (yield from bench.ask(keys.group_goal(group.name), goal))
    if robot.end_effectors:
        hand = robot.end_effectors[0]
        state = bench.recording.latest(keys.gripper_state(hand.side))
        if state is None:
            raise Broken(f"a state of gripper {hand.side}", "none")
        gripper = hand.gripper
        command = GripperCommand(
            id=bench.new_id(),
            width=max(0.0, state.width),
            speed=gripper.speed,
            force=gripper.force,
            lease=lease,
        )
        return (yield from bench.ask(keys.gripper_command(hand.side), command))
    raise Skip("the robot has neither groups nor hands, so no command is answered")


def expect_refusal(bench: Bench, lease: Lease | None, of: str) -> Generator[None, None, None]:
    """Broken unless a harmless command under this lease is refused; ``of`` names it in words."""
    answer = yield from send_harmless(bench, lease)
    if answer.accepted:
        raise Broken(f"{of} refused", "accepted")
