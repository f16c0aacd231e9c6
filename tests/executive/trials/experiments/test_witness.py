"""What a run's witness counts as a contact, on contacts that are made up."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import TYPE_CHECKING, cast

import pytest

from tandem.executive.trials.experiments.witness import Witness, lean, tilt
from tandem.sim.physics import Contact
from tandem.skills.geometry.poses import about
from tandem.skills.ports.pose import Pose
from tandem.skills.site import load

if TYPE_CHECKING:
    from tandem.sim.station import Station

ROBOT, TABLE, CUBE = 1, 2, 3
LINKS = {"arm_left_6_link": 0, "gripper_right_link": 1}
NAMES = {TABLE: "table.0", CUBE: "item_29"}


@dataclass
class FakeStation:
    """The left hand's cube at a height, and contacts of the robot."""

    height: float = 0.0
    touching: list[Contact] = field(default_factory=list)

    def witness(self) -> Witness:
        station = SimpleNamespace(
            body=SimpleNamespace(body=ROBOT, link_index=LINKS),
            physics=SimpleNamespace(contacts=lambda _: self.touching),
            world=SimpleNamespace(
                names_by_id=lambda: NAMES, pose=lambda _: Pose(position=(0.6, 0.0, self.height))
            ),
            hardware=SimpleNamespace(now=SimpleNamespace(seconds=1.0)),
        )
        cube = load("bimanual").item(29)
        assert cube is not None
        return Witness(cast("Station", station), (cube,))


def touch(link: str, body: int, other: int = -1, force: float = 2.0) -> Contact:
    return Contact(ROBOT, LINKS[link], body, other, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0), force)


@pytest.mark.parametrize(
    ("contact", "lifted", "said"),
    [
        (touch("arm_left_6_link", ROBOT, LINKS["gripper_right_link"]), 0.0, ("left arm", "right arm")),
        (touch("gripper_right_link", TABLE), 0.0, ("right arm", "table")),
        (touch("gripper_right_link", CUBE), 0.1, ("right arm", "what is in the left hand")),
        (touch("gripper_right_link", CUBE), 0.01, None),
        (touch("arm_left_6_link", CUBE), 0.1, None),
        (touch("gripper_right_link", TABLE, force=0.0), 0.0, None),
    ],
    ids=["arms", "table", "what the other holds", "what stands", "what it holds itself", "no force"],
)
def test_contacts(contact: Contact, lifted: float, said: tuple[str, str] | None) -> None:
    station = FakeStation()
    witness = station.witness()
    station.height, station.touching = lifted, [contact]
    witness._contacts()
    assert [(each.first, each.second) for each in witness.touches] == ([] if said is None else [said])


@pytest.mark.parametrize(
    ("turned", "leans", "tilted"),
    [(0.0, 0.0, 0.0), (0.2, 0.2, 0.2), (1.4, 0.1708, 1.4), (math.pi, 0.0, math.pi)],
)
def test_a_cube_leans_from_its_nearest_face_and_is_tilted_from_the_one_it_stood_on(
    turned: float, leans: float, tilted: float
) -> None:
    pose = Pose(position=(0.0, 0.0, 0.0), orientation=about((1.0, 0.0, 0.0), turned))
    assert (lean(pose), tilt(pose)) == (pytest.approx(leans, abs=1e-4), pytest.approx(tilted))
