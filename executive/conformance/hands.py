"""Moving clauses about grippers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import GripperCommand, GripperMotion, GripperState

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.robot_description import EndEffector

SHARES: Final = (0.8, 0.4, 0.8)
"""Widths that the pads are sent to, as shares of the largest."""
OFF: Final = 0.005
"""Metres by which a width may be off."""
PATIENCE: Final = 2.0
"""Robot seconds beyond what the way takes at full speed."""


def _moves(bench: Bench) -> Steps:
    if not bench.robot.hands:
        raise Skip("the robot has no hands")
    for hand in bench.robot.end_effectors:
        for share in SHARES:
            yield from _move(bench, hand, share * hand.gripper.max_width)


def _move(bench: Bench, hand: EndEffector, width: float) -> Steps:
    gripper, lease = hand.gripper, (yield from bench.leased())
    command = GripperCommand(
        id=bench.new_id(), width=width, speed=gripper.speed, force=gripper.force, lease=lease
    )
    answer = yield from bench.ask(keys.gripper_command(hand.side), command)
    if not answer.accepted:
        raise Broken(f"a width of {width:.3f} m of {hand.side} accepted", f"refused: {answer.reason}")
    topic = keys.gripper_state(hand.side)

    def done() -> GripperState | None:
        state = bench.recording.latest(topic)
        over = (
            state is not None and state.command_id == command.id and state.motion is not GripperMotion.MOVING
        )
        return state if over else None

    yield from bench.until(lambda: done() is not None, gripper.max_width / gripper.speed + PATIENCE)
    state = done()
    if state is None:
        raise Broken(f"the end of a command of gripper {hand.side}", "none in time")
    if state.motion is not GripperMotion.AT_WIDTH or abs(state.width - width) > OFF:
        raise Broken(f"{hand.side} AT_WIDTH {width:.3f} m", f"{state.motion} {state.width:.3f} m")


CLAUSES: Final = (
    Clause(
        "gripper_moves",
        "Each gripper goes to the commanded width, with nothing between its pads.",
        "interface.md#grippercommand",
        _moves,
        moving=True,
    ),
)
