"""What the reflex sees: Algorithm 2 while both arms are out, the true clearance always, a little ahead."""

from __future__ import annotations

import pytest

from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.collision import Clearance
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box, PlanningScene, SceneObject
from tandem.skills.reflex.crossing_watch import ArmsWatch, Seen
from tandem.skills.site import load
from tests.skills.reflex.two_arms import ASIDE, IN_FRONT, joint_states, positions, robot

SITE = load("bimanual")
SHOULDERS = ("arm_left_1_joint", "arm_right_1_joint")


@pytest.fixture(scope="module")
def watch() -> ArmsWatch:
    description, hulls = robot()
    assert description.arms_crossing is not None
    return ArmsWatch(hulls, description, description.arms_crossing, SITE)


def look(
    watch: ArmsWatch, at: dict[str, float], speed: float = 0.0, scene: PlanningScene | None = None
) -> Seen:
    return watch.look(joint_states(0.0, at, dict.fromkeys(SHOULDERS, speed)), scene)


def held(item: int, size: tuple[float, float, float], out: float) -> PlanningScene:
    box = Box(size=size, pose=Pose(position=(out, 0.0, 0.0)))
    thing = SceneObject(name=f"item_{item}", kind="item", box=box, item=item, attached_to="left")
    return PlanningScene(stamp=RobotTime(boot="test", seconds=0.0), version=1, objects=(thing,))


def test_arms_at_home_are_no_risk(watch: ArmsWatch) -> None:
    seen = look(watch, positions())
    assert (seen.risk, seen.near, seen.moving) == (False, False, False)
    assert seen.distance > 0.4


def test_arms_nearer_than_the_bound_are_a_risk(watch: ArmsWatch) -> None:
    seen = look(watch, positions(IN_FRONT, IN_FRONT))
    assert seen.near
    assert seen.risk
    assert seen.clearance == pytest.approx(0.0256, abs=1e-3)


def test_hands_that_are_close_are_a_risk_before_the_arms_are(watch: ArmsWatch) -> None:
    seen = look(watch, positions(IN_FRONT, (0.09, *IN_FRONT[1:])))
    assert seen.risk
    assert not seen.near
    assert seen.distance < seen.threshold


def test_an_arm_in_its_safe_place_is_in_nobodys_way(watch: ArmsWatch) -> None:
    far_over = (0.9, *IN_FRONT[1:])
    seen = look(watch, positions(far_over, None))
    assert seen.distance < seen.threshold
    assert not seen.risk


def test_arms_that_are_about_to_meet_are_near_already(watch: ArmsWatch) -> None:
    at = positions((0.24, *IN_FRONT[1:]), (0.24, *IN_FRONT[1:]))
    assert not look(watch, at).near
    assert look(watch, at, speed=1.0).near
    assert not look(watch, at, speed=-1.0).near


def test_what_a_hand_holds_counts(watch: ArmsWatch) -> None:
    at = positions((0.09, *IN_FRONT[1:]), (0.09, *IN_FRONT[1:]))
    empty, full = look(watch, at), look(watch, at, scene=held(29, (0.1, 0.3, 0.05), 0.05))
    assert full.clearance < empty.clearance - 0.05


def test_what_both_hands_hold_is_in_neithers_way(watch: ArmsWatch) -> None:
    """The carton is attached to one hand and touches the other, and both hands stay where they are."""
    seen = look(watch, positions(ASIDE, ASIDE), scene=held(0, (0.3, 0.4, 0.4), 0.2))
    assert not seen.risk


def test_each_place_on_the_way_to_rest_is_looked_at_once(
    watch: ArmsWatch, monkeypatch: pytest.MonkeyPatch
) -> None:
    places: list[tuple[float, ...]] = []
    at = ArmsClearance.at

    def noted(bodies: ArmsClearance, q: Array) -> Clearance:
        places.append(tuple(q))
        return at(bodies, q)

    monkeypatch.setattr(ArmsClearance, "at", noted)
    look(watch, positions(IN_FRONT, IN_FRONT), speed=1.0)
    assert len(places) == len(set(places)) == 3
