"""What all TIAGos have above the base: a torso that lifts, a head with a camera."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.sim.robots import pmb2
from tandem.sim.robots.joint_limits import Smoothness
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.robot_description import Posture

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from tandem.sim.urdf import UrdfDocument

FOLDER: Final = "package://example-robot-data/robots/tiago_description/robots"
PERIOD: Final = 0.01
"""Seconds between two messages of the clock and of the joints' state."""
HEIGHT: Final = 1.6
"""Metres, with the torso up."""
CAMERA_FRAME: Final = "xtion_rgb_optical_frame"
TURNING: Final = Smoothness(acceleration=5.0, jerk=50.0)
"""Of arms and head. Ours: the URDF names none."""
LIFTING: Final = Smoothness(acceleration=0.35, jerk=3.5)
"""Of the torso. Ours."""
GROUPS: Final[Mapping[str, tuple[Sequence[str], Smoothness]]] = {
    "torso": (("torso_lift_joint",), LIFTING),
    "head": (("head_1_joint", "head_2_joint"), TURNING),
}
POSTURES: Final = (
    Posture(name="home", group="torso", positions=(0.30,)),
    Posture(name="home", group="head", positions=(0.0, -0.3)),
    Posture(name="ahead", group="head", positions=(0.0, 0.0)),
    Posture(name="table", group="head", positions=(0.0, -0.55)),
)


def load(file: str) -> UrdfDocument:
    """Return one of the installed URDFs, on a base that the physics can roll.

    Raises:
        FileNotFoundError: when example-robot-data is not installed.
    """
    from tandem.sim.urdf import UrdfDocument  # noqa: PLC0415 - loads numpy; the room it takes is known without

    document = UrdfDocument(resolve(f"{FOLDER}/{file}").read_text(encoding="utf-8"))
    pmb2.fit(document)
    return document


def cut_hand(document: UrdfDocument, mount: str) -> None:
    """Cut off all that hangs on a wrist's last link."""
    from tandem.sim.urdf import end_of  # noqa: PLC0415 - as above

    hand = [joint for joint in document.joints() if end_of(joint, "parent") == mount]
    for link in [end_of(joint, "child") for joint in hand]:
        document.cut(link)
