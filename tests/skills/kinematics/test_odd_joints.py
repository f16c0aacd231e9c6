"""Robots with joints that not every robot has: floating, planar, mimicking, endless, wrongly limited.

A user would have seen an arm with another joint's limits, fingers that don't follow each other, or an arm
that never finds a way. Right is the right number, or a refusal with the joint's name. The robot's description
comes from its hardware alone, so no file or key of tests/outside reaches this.
"""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from pydantic import ValidationError

from tandem.sim.robots.registry import robot_model
from tandem.skills.kinematics.described import check_reach, load_hulls
from tandem.skills.kinematics.model import RobotKinematics
from tandem.skills.ports.robot_description import JointGroup, JointLimit
from tandem.skills.ports.urdf_check import UrdfError, check_fingers, parsed
from tests.fakes.arm_rig import panda

ARM = ("shoulder", "elbow")
LINKS = ("world", "base", "upper", "lower", "finger", "thumb")
LIMITS = {"shoulder": (-1.0, 2.0, 1.5), "elbow": (-0.5, 0.25, 0.7)}


def joint(name: str, parent: str, child: str, kind: str = "revolute", inside: str = "") -> str:
    low, high, fast = LIMITS.get(name, (-0.1, 0.1, 0.3))
    limit = f'<limit lower="{low}" upper="{high}" velocity="{fast}" effort="5"/>'
    if kind in {"fixed", "floating"}:
        limit = ""
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="0 0 0.5"/><axis xyz="0 0 1"/>{inside or limit}</joint>'
    )


def robot(*joints: str) -> str:
    named = [name for name in LINKS if any(f'link="{name}"' in each for each in joints)]
    return f'<robot name="odd">{"".join(f"<link name={name!r}/>" for name in named)}{"".join(joints)}</robot>'


def armed(first: str, *more: str, elbow: str = "") -> str:
    return robot(
        joint("root", "world", "base", first),
        joint("shoulder", "base", "upper"),
        joint("elbow", "upper", "lower", inside=elbow),
        *more,
    )


ONE_LIMIT = '<limit lower="-1" upper="1" velocity="1" effort="1"/>'
WEIGHTLESS = '<link name="upper"><inertial><mass value="-2"/></inertial></link>'
FINGERS = (
    joint("finger_joint", "lower", "finger", "prismatic"),
    joint(
        "thumb_joint",
        "lower",
        "thumb",
        "prismatic",
        '<limit lower="-1" upper="1" velocity="1" effort="1"/>'
        '<mimic joint="finger_joint" multiplier="-2" offset="0.01"/>',
    ),
)


@pytest.mark.parametrize("first", ["fixed", "floating", "planar", "revolute", "continuous"])
def test_the_limits_are_those_of_the_joints_whatever_comes_before(first: str) -> None:
    limits = RobotKinematics(armed(first, *FINGERS), {"arm": ARM}).limits(ARM)
    assert limits.lower == pytest.approx([-1.0, -0.5])
    assert limits.upper == pytest.approx([2.0, 0.25])
    assert limits.velocity == pytest.approx([1.5, 0.7])


@pytest.mark.parametrize("first", ["fixed", "floating", "planar"])
def test_the_hand_is_where_the_joints_put_it_whatever_comes_before(first: str) -> None:
    plain = RobotKinematics(armed("fixed", *FINGERS), {"arm": ARM})
    odd = RobotKinematics(armed(first, *FINGERS), {"arm": ARM})
    at = {"shoulder": 0.3, "elbow": 0.2}
    assert odd.pose("lower", at) == plain.pose("lower", at)
    chain = odd.chain(ARM, {})
    assert chain.pose(np.array([0.3, 0.2]), "lower") == odd.pose("lower", at)
    assert chain.jacobian(np.array([0.3, 0.2]), "lower")[5] == pytest.approx([1.0, 1.0])


def test_a_joint_that_mimics_stands_where_that_puts_it() -> None:
    odd = RobotKinematics(armed("fixed", *FINGERS), {"arm": ARM})
    _, _, z = odd.pose("thumb", {"finger_joint": 0.05}).position
    _, _, still = odd.pose("thumb", {"finger_joint": 0.05, "thumb_joint": 0.0}).position
    assert z - still == pytest.approx(-2 * 0.05 + 0.01)


@pytest.mark.parametrize(
    ("urdf", "group", "said"),
    [
        (armed("floating"), ("root", "shoulder"), "joint 'root' is floating"),
        (armed("planar"), ("root", "shoulder"), "joint 'root' is planar"),
        (armed("fixed", *FINGERS), ("thumb_joint",), "joint 'thumb_joint' mimics 'finger_joint'"),
        (armed("fixed", *FINGERS), ("finger_joint",), "joint 'finger_joint' moves 'thumb_joint' too"),
        (
            armed("fixed", elbow='<limit lower="1" upper="-1" velocity="1" effort="1"/>'),
            ARM,
            "joint 'elbow': expected a lower limit of at most the upper one, found 1 and -1",
        ),
        (armed("fixed", elbow='<limit lower="nan" velocity="1" effort="1"/>'), ARM, "'elbow': expected fin"),
        (armed("fixed", elbow='<limit lower="-1" upper="1" effort="1"/>'), ARM, "'elbow': expected velocity"),
        (armed("fixed", elbow="<axis/>"), ARM, "joint 'elbow': a revolute joint needs a <limit>"),
        (armed("ball"), ARM, "joint 'root': expected a type out of"),
        (armed("fixed", joint("elbow", "lower", "finger")), ARM, "joint 'elbow' is there 2 times"),
        (armed("fixed", joint("wrist", "lower", "palm")), ARM, "'wrist': expected a child link"),
        (
            armed("fixed", joint("wrist", "lower", "finger", inside='<limit velocity="1" effort="1"/>'
                                 '<mimic joint="knuckle"/>')),
            ARM,
            "joint 'wrist': it mimics 'knuckle', and there is no such joint",
        ),
        ("<robot", ARM, "no XML"),
        ("<robot/>", ARM, "expected at least one link"),
        (armed("fixed", joint("", "lower", "finger")), ARM, "a joint without a name"),
        (armed("fixed", joint("wrist", "upper", "lower")), ARM, "'lower': expected one joint"),
        (armed("fixed", joint("wrist", "finger", "thumb")), ARM, "no joint, found 'world', 'finger'"),
        (
            armed("fixed", joint("wrist", "finger", "thumb"), joint("knuckle", "thumb", "finger")),
            ARM,
            "these links hang on each other: 'finger', 'thumb'",
        ),
        (armed("fixed").replace("0 0 0.5", "0 nan 0"), ARM, "'elbow': expected three numbers for the"),
        (armed("fixed").replace("0 0 0.5", "0,0,0.5"), ARM, "'elbow': expected three numbers for the"),
        (armed("fixed").replace("0 0 1", "0 0 1e-200"), ARM, "'elbow': expected an axis"),
        (armed("fixed").replace('lower="-0.5"', 'lower="-inf"'), ARM, "'elbow': expected finite limits"),
        (armed("fixed", elbow=ONE_LIMIT + ONE_LIMIT), ARM, "'elbow': expected one <limit>, found several"),
        (
            armed("fixed").replace("<link name='upper'/>", WEIGHTLESS),
            ARM,
            "link 'upper': expected a mass of at least 0, found '-2'",
        ),
    ],
)  # fmt: skip
def test_what_can_not_be_right_is_refused_by_name(urdf: str, group: tuple[str, ...], said: str) -> None:
    with pytest.raises(UrdfError) as caught:
        RobotKinematics(urdf, {"arm": group})
    assert said in str(caught.value)


def test_limits_of_a_joint_that_mimics_are_refused() -> None:
    with pytest.raises(UrdfError, match="'thumb_joint' mimics 'finger_joint'"):
        RobotKinematics(armed("fixed", *FINGERS), {"arm": ARM}).limits(("thumb_joint",))


def test_a_real_robot_with_a_mimicking_finger_is_taken() -> None:
    description = panda()
    known = RobotKinematics(description.urdf, {"arm": description.group("arm").joints})
    left, right = (
        known.pose(f"panda_{side}finger", {"panda_finger_joint1": 0.03}).position
        for side in ("left", "right")
    )
    hand = known.pose("panda_hand", {}).position
    assert math.dist(left, hand) == pytest.approx(math.dist(right, hand))


def test_the_description_takes_no_limits_the_wrong_way_round_and_no_joint_twice() -> None:
    good = JointLimit(joint="j", lower=-1, upper=1, velocity=1, acceleration=1, jerk=1, effort=1)
    with pytest.raises(ValidationError, match="joint 'j': expected a lower limit of at most the upper one"):
        JointLimit.model_validate({**good.model_dump(), "lower": 2.0})
    with pytest.raises(ValidationError, match="group 'arm': expected each joint once"):
        JointGroup(name="arm", limits=(good, good))


@pytest.mark.parametrize(
    ("shapes", "error"),
    [
        ('<capsule radius="0.1" length="0.2"/>', "found capsule; write it as a cylinder and two spheres"),
        (
            '<cone radius="0.1" length="0.2"/>',
            "expected a geometry out of box, cylinder, sphere, mesh, found cone",
        ),
        ('<box size="0.1 0.1"/>', "expected 3 numbers of at least 0 for the box's size, found '0.1 0.1'"),
        ('<sphere radius="-1"/>', "expected a number of at least 0 for the sphere's radius, found '-1'"),
        ("", "expected one geometry, found none"),
        ('<sphere radius="1"/><sphere radius="2"/>', "expected one geometry, found sphere, sphere"),
    ],
)
def test_a_shape_that_no_reader_knows_is_refused_with_its_link(shapes: str, error: str) -> None:
    """It would be left out, and arms would go through the link."""
    link = f'<link name="tip"><collision><geometry>{shapes}</geometry></collision></link>'
    with pytest.raises(UrdfError, match=re.escape("link 'tip': collision: expected")) as found:
        parsed(f'<robot name="odd">{link}</robot>')
    assert error in str(found.value)


@pytest.mark.parametrize(
    "shape", ['<cylinder radius="0.1" length="0.2"/>', '<sphere radius="0.1"/>', '<box size="1 2 3"/>']
)
def test_a_primitive_shape_is_taken(shape: str) -> None:
    link = f'<link name="tip"><collision><geometry>{shape}</geometry></collision></link>'
    assert parsed(f'<robot name="odd">{link}</robot>').find("link") is not None


@pytest.mark.parametrize(
    ("fingers", "said"),
    [
        ((), "expected the joints of two fingers that slide apart, found none"),
        (("finger_joint",), "expected the joints of two fingers that slide apart, found 'finger_joint'"),
        (("elbow", "finger_joint"), "expected a prismatic finger, found 'elbow', which is revolute"),
        (("finger_joint", "suction"), "expected a prismatic finger, found 'suction', which is no joint"),
    ],
)
def test_a_hand_that_is_no_parallel_gripper_is_refused(fingers: tuple[str, ...], said: str) -> None:
    with pytest.raises(UrdfError) as caught:
        check_fingers(parsed(armed("fixed", *FINGERS)), {"single": fingers})
    assert str(caught.value).startswith(f"hand 'single': {said}\nan arm with another hand is a group without")


def test_a_finger_that_mimics_the_other_is_named_too() -> None:
    check_fingers(parsed(armed("fixed", *FINGERS)), {"single": ("finger_joint", "thumb_joint")})


def test_skills_refuse_a_robot_with_a_suction_cup() -> None:
    gripper = panda().end_effectors[0].gripper.model_copy(update={"joints": ()})
    hand = panda().end_effectors[0].model_copy(update={"gripper": gripper})
    with pytest.raises(UrdfError, match=r"^hand '\w+': expected the joints of two fingers"):
        load_hulls(panda().model_copy(update={"end_effectors": (hand,)}))


def test_a_home_with_the_hand_in_the_arm_is_refused_with_both_links() -> None:
    """Such a pair would never be checked again, since what touches at home is taken to be harmless."""
    folded = (0.0, 1.7, 0.0, -3.0, 0.0, 0.5, 0.785)
    posture = panda().postures[0].model_copy(update={"positions": folded})
    with pytest.raises(
        UrdfError, match=r"posture 'home': 'panda_\w+' and 'panda_\w+' are 0\.\d+ m in each other"
    ):
        load_hulls(panda().model_copy(update={"postures": (posture,)}))


def test_an_arm_that_reaches_out_too_far_to_drive_is_refused_with_what_it_may() -> None:
    """The base would hold, at each drive, and say so; nothing could ever tuck such an arm."""
    robot = robot_model("panda").description
    hulls = load_hulls(robot)
    check_reach(robot, hulls)  # it stands
    driving = robot.model_copy(update={"drive": panda().drive})
    with pytest.raises(
        UrdfError, match=r"posture 'home' of 'arm_single' reaches 0\.387 m .* drives with at most 0\.24 m"
    ):
        check_reach(driving, hulls)
    check_reach(driving.model_copy(update={"footprint_radius": 0.36}), hulls)
