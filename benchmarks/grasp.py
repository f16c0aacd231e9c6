"""How well a grasp by friction holds: lift, arm motions, drive 1 m, turn. ``python -m benchmarks.grasp``."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from benchmarks.rig import GRASP, LIFT, SWING, Rig, slip
from benchmarks.rows import Row
from tandem.skills.ports.hardware import GripperMotion

CASES: Final = ((0.05, 0.05), (0.06, 0.1), (0.07, 0.2))
"""Edge (m) and mass (kg) of the items in the table of figures."""


@dataclass(frozen=True)
class Figures:
    """What one run gave: the stall width and force, and the slip in mm and degrees of each part."""

    width: float
    force: float
    held: bool
    lift: tuple[float, float]
    carry: tuple[float, float]
    drive: tuple[float, float]
    after_down: float
    speed: float


def carry_item(size: float, mass: float, force: float = 16.0) -> Figures:
    """Grip, lift 10 cm, swing the arm for 10 s, drive 1 m and turn by a right angle, put down, open."""
    rig = Rig(size=size, mass=mass)
    began, ticks = time.process_time(), rig.hardware.tick
    rig.ticks(20)
    rig.grip(0.09)
    rig.move("arm_left", GRASP, 1.0)
    full = rig.grip(0.0, force)
    gripped = rig.item_in_hand()
    rig.move("arm_left", LIFT, 1.0)
    lifted = rig.item_in_hand()
    for _ in range(5):
        rig.move("arm_left", SWING, 1.0)
        rig.move("arm_left", LIFT, 1.0)
    carried = rig.item_in_hand()
    rig.drive(-0.2, 0.0, 5.2)
    rig.drive(0.0, 1.0, 1.5)
    rig.drive(0.0, 0.0, 1.2)
    driven = rig.item_in_hand()
    state = rig.gripper()
    before = rig.physics.body_pose(rig.item)[0][2]
    rig.grip(0.09)
    rig.ticks(60)
    fallen = before - rig.physics.body_pose(rig.item)[0][2]
    seconds = (rig.hardware.tick - ticks) * 0.01
    rate = seconds / (time.process_time() - began)
    rig.close()
    return Figures(
        full.width,
        state.force,
        full.motion is state.motion is GripperMotion.STALLED,
        slip(gripped, lifted),
        slip(lifted, carried),
        slip(carried, driven),
        fallen,
        rate,
    )


def empty_width() -> tuple[float, GripperMotion]:
    """Return where the gripper ends when there is nothing to grip."""
    rig = Rig(friction=None)
    rig.grip(0.09)
    state = rig.grip(0.0)
    rig.close()
    return state.width, state.motion


def rows() -> Iterator[Row]:
    """Measure: the corners of what must hold, and the middle."""
    for size, mass in CASES:
        found = carry_item(size, mass)
        what = f"grasp of {size * 1e3:.0f} mm, {mass * 1e3:.0f} g"
        held = "held to the end" if found.held else "LOST"
        yield Row(f"{what}: slip in the lift", found.lift[0], "mm", note=held)
        yield Row(f"{what}: slip in 10 s of arm", found.carry[0], "mm", note=f"{found.carry[1]:.2f} degrees")
        yield Row(f"{what}: slip in a drive", found.drive[0], "mm", note=f"{found.drive[1]:.2f} degrees")


def main() -> None:
    """Print the table."""
    width, motion = empty_width()
    print(f"empty: {width * 1e3:.1f} mm, {motion}")
    print(
        "size mm  mass g  stall mm  force N  held  lift mm/deg  10 s of arm  drive+turn  open: falls  x real"
    )
    for size in (0.05, 0.06, 0.07):
        for mass in (0.05, 0.1, 0.2):
            f = carry_item(size, mass)
            parts = "  ".join(f"{mm:5.2f}/{deg:4.2f}" for mm, deg in (f.lift, f.carry, f.drive))
            print(
                f"{size * 1e3:7.0f}  {mass * 1e3:6.0f}  {f.width * 1e3:8.1f}  {f.force:7.1f}  {f.held!s:>5}"
                f"  {parts}  {f.after_down * 1e2:12.1f} cm  {f.speed:6.1f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
