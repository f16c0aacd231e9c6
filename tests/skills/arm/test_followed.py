"""Has the item that a motion was planned for been moved since?"""

from __future__ import annotations

import pytest

from tandem.skills.arm.followed import FollowedItem
from tandem.skills.geometry.poses import compose, from_rpy
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.message import HandName, RobotTime, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import WORLD, ItemFact, WorldState
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.field_rig import CUBE, TAG_ON_ITEM

ITEM = 29
FOLLOWS = MoveGoal(posture="home", follows_item=ITEM, follow_tolerance=0.02)


class Beliefs:
    def __init__(self, goal: MoveGoal = FOLLOWS) -> None:
        self.bus, self._version = MemoryBus(), 0
        self.followed = FollowedItem(self.bus, "arm_left/move")
        self.tell(0.6)
        self.followed.begin(goal)

    def tell(
        self,
        x: float | None,
        yaw: float = 0.0,
        held: HandName | None = None,
        *,
        pitch: float = 0.0,
        size: Vector3 = CUBE,
    ) -> None:
        """Have the item be believed to stand there, seen by the tag of whichever side ``yaw`` turns to us."""
        self._version += 1
        stamp = RobotTime(boot="test", seconds=float(self._version))
        facts = ()
        if x is not None:
            centre = Pose(position=(x, 0.1, 0.745), orientation=from_rpy(0.0, pitch, yaw))
            tag = compose(centre, TAG_ON_ITEM)
            facts = (
                ItemFact(
                    item=ITEM,
                    size=size,
                    tag_in_map=tag,
                    seen=stamp,
                    quality=1.0,
                    position_sigma=0.002,
                    held=held,
                ),
            )
        WORLD.publish(self.bus, WorldState(stamp=stamp, version=self._version, items=facts))


def test_it_stands_where_it_stood() -> None:
    beliefs = Beliefs()
    beliefs.tell(0.615)
    assert beliefs.followed.moved() is None


def test_another_side_of_it_is_not_another_place() -> None:
    beliefs = Beliefs()
    beliefs.tell(0.6, yaw=1.5708)
    assert beliefs.followed.moved() is None


@pytest.mark.parametrize(
    ("x", "held", "words"),
    [(0.63, None, "has moved by 0.030 m"), (None, None, "stand anywhere"), (0.6, "right", "stand anywhere")],
    ids=["moved", "gone", "in a hand"],
)
def test_it_is_gone(x: float | None, held: HandName | None, words: str) -> None:
    beliefs = Beliefs()
    beliefs.tell(x, held=held)
    failure = beliefs.followed.moved()
    assert failure is not None
    assert failure.kind is FailureKind.ITEM_GONE
    assert words in failure.message


def test_a_motion_that_follows_nothing_minds_nothing() -> None:
    beliefs = Beliefs(MoveGoal(posture="home"))
    beliefs.tell(None)
    assert beliefs.followed.moved() is None


def test_an_item_that_has_fallen_over_does_not_stand_there_any_more() -> None:
    beliefs = Beliefs()
    beliefs.tell(0.6, pitch=-1.5708, size=(0.07, 0.07, 0.2))
    failure = beliefs.followed.moved()
    assert failure is not None
    assert failure.kind is FailureKind.ITEM_GONE
