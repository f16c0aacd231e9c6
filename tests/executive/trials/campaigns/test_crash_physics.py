"""What the campaign of crashes in the physics kills at, and what it finds wrong afterwards."""

from __future__ import annotations

import pytest

from tandem.executive.render.example import tree_of
from tandem.executive.trials.campaigns.crash_physics import (
    MOMENTS,
    REQUESTS,
    SCENARIOS,
    Moment,
    wrong_in_truth,
)
from tandem.sim.scenario import load_scenario
from tandem.sim.truth import TrueBody, TrueContact, Truth
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import IDENTITY, Pose
from tandem.skills.ports.tasks import TreeNode
from tandem.skills.site import load
from tandem.trees.registry import discover


def leaves(node: TreeNode) -> list[str]:
    return [leaf for child in node.children for leaf in leaves(child)] if node.children else [node.name]


@pytest.mark.parametrize("moment", MOMENTS, ids=lambda each: f"{each.kind}, {each.phase}")
def test_each_moment_is_a_leaf_of_its_task(moment: Moment) -> None:
    site = load(load_scenario(SCENARIOS[moment.kind]).site)
    tree = tree_of(discover()[moment.kind], site, REQUESTS[moment.kind])
    assert moment.leaf in leaves(tree)


def truth(*touches: tuple[str, str], at: Pose = IDENTITY) -> Truth:
    stamp = RobotTime(boot="test", seconds=1.0)
    bodies = (TrueBody(name="item_29", pose=at, item=29), TrueBody(name="item_42", pose=at, item=42))
    contacts = tuple(TrueContact(first=first, second=second, force=1.0) for first, second in touches)
    return Truth(stamp=stamp, base_in_map=IDENTITY, bodies=bodies, contacts=contacts)


LEFT = ("robot/gripper_left_left_finger_link", "item_29")
RIGHT = ("item_42", "robot/gripper_right_left_finger_link")


@pytest.mark.parametrize(
    ("touches", "wrong"),
    [
        ((LEFT, RIGHT), 0),
        ((LEFT,), 1),
        ((LEFT, RIGHT, ("item_29", "table.0")), 1),
        ((("robot/gripper_right_left_finger_link", "item_29"), RIGHT), 1),
        ((), 2),
    ],
)
def test_both_items_must_truly_be_in_their_own_hands_alone(
    touches: tuple[tuple[str, str], ...], wrong: int
) -> None:
    assert len(wrong_in_truth("pick_two", truth(*touches), "TwoArms")) == wrong


def test_a_fetched_item_must_truly_lie_in_the_depot() -> None:
    assert wrong_in_truth("fetch", truth(), "Demo") == ("item 29 does not lie in the depot",)
