"""Kinematics against pybullet's and against differences; collisions against sums done by hand."""

from __future__ import annotations

import math
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin
import pybullet
import pytest

from tandem.skills.geometry.poses import angle_between, distance, from_rpy
from tandem.skills.kinematics.batch import BatchChain
from tandem.skills.kinematics.bodies import BoxShape, Carried, CylinderShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.ik import SeedTable, Solver
from tandem.skills.kinematics.model import RobotKinematics, UnknownNameError
from tandem.skills.kinematics.transforms import to_se3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.steps import run_through
from tests.fakes.arm_rig import PANDA_HOME, panda

JOINTS = panda().group("arm").joints
TOOL = "panda_hand_tcp"
HOME = dict(zip(JOINTS, PANDA_HOME, strict=True))
FAR_BOX = Obstacle("box", BoxShape((0.1, 0.1, 0.1)), Pose(position=(3.0, 0.0, 0.5)))


@pytest.fixture(scope="module")
def hulls() -> RobotHulls:
    description = panda()
    robot = RobotKinematics(description.urdf, {"arm": JOINTS})
    return RobotHulls(robot, [HOME], np.random.default_rng(0), samples=60)


@pytest.fixture(scope="module")
def robot(hulls: RobotHulls) -> RobotKinematics:
    return hulls.robot


def test_frames_are_where_pybullet_puts_them(robot: RobotKinematics, tmp_path: Path) -> None:
    path = tmp_path / "panda.urdf"
    path.write_text(robot.urdf)
    client = pybullet.connect(pybullet.DIRECT)
    try:
        body = pybullet.loadURDF(str(path), useFixedBase=True, physicsClientId=client)
        numbers = range(pybullet.getNumJoints(body, physicsClientId=client))
        facts = [pybullet.getJointInfo(body, i, physicsClientId=client) for i in numbers]
        rng = np.random.default_rng(3)
        for _ in range(5):
            limits = robot.limits(JOINTS)
            q = dict(zip(JOINTS, map(float, rng.uniform(limits.lower, limits.upper)), strict=True))
            for fact in facts:
                pybullet.resetJointState(body, fact[0], q.get(fact[1].decode(), 0.0), physicsClientId=client)
            for fact in facts:
                state = pybullet.getLinkState(
                    body, fact[0], computeForwardKinematics=True, physicsClientId=client
                )
                ours = robot.pose(fact[12].decode(), q)
                assert math.dist(ours.position, state[4]) < 1e-5
                assert angle_between(ours.orientation, state[5]) < 1e-3
    finally:
        pybullet.disconnect(client)


def test_the_jacobian_is_the_derivative_of_the_pose(robot: RobotKinematics) -> None:
    chain = robot.chain(JOINTS[::-1], HOME)
    q = np.array(PANDA_HOME[::-1])
    jacobian = chain.jacobian(q, TOOL)
    for i in range(len(q)):
        step = np.zeros(len(q))
        step[i] = 1e-6
        ahead, behind = chain.placement(q + step, TOOL), chain.placement(q - step, TOOL)
        assert np.allclose((ahead.translation - behind.translation) / 2e-6, jacobian[:3, i], atol=1e-6)


def test_the_error_twist_is_the_one_whose_jacobian_is_given(robot: RobotKinematics) -> None:
    chain = robot.chain(JOINTS, HOME)
    q = np.array(PANDA_HOME)
    target = chain.placement(q, TOOL)
    error, _ = chain.twist_to(q + 1e-4, TOOL, target)
    _, jacobian = chain.twist_to(q, TOOL, target)
    assert np.allclose(error, jacobian @ np.full(7, -1e-4), atol=1e-7)


def test_an_unknown_joint_is_named(robot: RobotKinematics) -> None:
    with pytest.raises(UnknownNameError, match="panda_joint1"):
        robot.joint_index("elbow")


def test_a_box_at_the_tool_is_hit_and_one_beside_it_is_not(hulls: RobotHulls) -> None:
    tool = hulls.robot.pose(TOOL, HOME).position
    q = np.array(PANDA_HOME)
    hit = Obstacle("hit", BoxShape((0.1, 0.1, 0.1)), Pose(position=tool))
    beside = Obstacle("beside", CylinderShape(0.05, 0.1), Pose(position=(tool[0] + 0.3, tool[1], tool[2])))
    assert not CollisionChecker(hulls, JOINTS, HOME, [hit]).free(q)
    assert CollisionChecker(hulls, JOINTS, HOME, [beside]).free(q)
    contact = CollisionChecker(hulls, JOINTS, HOME, [hit]).contacts(q)[0]
    assert "hit" in {contact.first, contact.second}


def test_the_clearance_is_the_gap_that_was_left(hulls: RobotHulls) -> None:
    """A carried cube is held 5 cm above a plate: both are boxes, so the gap is known."""
    tool = hulls.robot.pose(TOOL, HOME).position
    cube = Carried(
        "cube", BoxShape((0.04, 0.04, 0.04)), TOOL, Pose(position=(0.0, 0.0, 0.1)), ("panda_hand",)
    )
    low = tool[2] - 0.1 - 0.02
    plate = Obstacle(
        "plate", BoxShape((0.2, 0.2, 0.02)), Pose(position=(tool[0], tool[1], low - 0.05 - 0.01))
    )
    clearance = CollisionChecker(hulls, JOINTS, HOME, [plate], [cube]).clearance(
        np.array(PANDA_HOME), to_world=True
    )
    assert clearance is not None
    assert {clearance.first, clearance.second} == {"cube", "plate"}
    assert clearance.distance == pytest.approx(0.05, abs=2e-3)


def _carrying(hulls: RobotHulls, gap: float) -> tuple[CollisionChecker, np.ndarray]:
    tool = hulls.robot.pose(TOOL, HOME).position
    cube = Carried(
        "cube", BoxShape((0.04, 0.04, 0.04)), TOOL, Pose(position=(0.0, 0.0, 0.03)), ("panda_hand",)
    )
    top = tool[2] - 0.03 - 0.02 - gap
    plate = Obstacle("plate", BoxShape((0.2, 0.2, 0.02)), Pose(position=(tool[0], tool[1], top - 0.01)))
    return CollisionChecker(hulls, JOINTS, HOME, [plate], [cube]), np.array(PANDA_HOME)


def test_what_stands_on_its_support_may_be_lifted_but_not_pushed_in(hulls: RobotHulls) -> None:
    checker, q = _carrying(hulls, -0.005)
    assert not checker.free(q)
    assert checker.let_rest(q) == ()
    assert checker.free(q)
    up, down = q.copy(), q.copy()
    up[1] -= 0.03
    down[1] += 0.03
    assert checker.free(up)
    assert not checker.free(down)


def test_a_deep_contact_is_no_resting(hulls: RobotHulls) -> None:
    checker, q = _carrying(hulls, -0.03)
    refused = checker.let_rest(q)
    assert {refused[0].first, refused[0].second} == {"cube", "plate"}
    assert not checker.free(q)


def test_allowed_pairs_may_touch(hulls: RobotHulls) -> None:
    tool = hulls.robot.pose(TOOL, HOME).position
    item = Obstacle("item", BoxShape((0.03, 0.2, 0.03)), Pose(position=tool))
    fingers = [("item", "panda_leftfinger"), ("item", "panda_rightfinger")]
    q = np.array(PANDA_HOME)
    assert not CollisionChecker(hulls, JOINTS, HOME, [item]).free(q)
    assert CollisionChecker(hulls, JOINTS, HOME, [item], allowed=fingers).free(q)


def test_the_broad_phase_agrees_with_all_pairs(hulls: RobotHulls) -> None:
    table = Obstacle("table", BoxShape((0.8, 1.0, 0.05)), Pose(position=(0.5, 0.0, 0.3)))
    checker = CollisionChecker(hulls, JOINTS, HOME, [table, FAR_BOX])
    limits = hulls.robot.limits(JOINTS)
    rng = np.random.default_rng(5)
    for _ in range(150):
        q = rng.uniform(limits.lower, limits.upper)
        assert checker.free(q) == (not checker.contacts(q))


def solver(hulls: RobotHulls) -> Solver:
    checker = CollisionChecker(hulls, JOINTS, HOME)
    batch, limits = BatchChain(checker.chain, TOOL), hulls.robot.limits(JOINTS)
    return Solver(batch, limits, SeedTable(batch, limits, np.random.default_rng(2), checker.free, size=500))


def test_many_configurations_at_once_agree_with_one_by_one(hulls: RobotHulls) -> None:
    chain, limits = hulls.robot.chain(JOINTS, HOME), hulls.robot.limits(JOINTS)
    batch = BatchChain(chain, TOOL)
    q = np.random.default_rng(5).uniform(limits.lower, limits.upper, size=(6, len(JOINTS)))
    root = batch.root(chain).homogeneous
    tips = batch.frames(q)[1]
    for one, tip in zip(q, tips, strict=True):
        assert np.allclose(root @ tip, chain.placement(one, TOOL).homogeneous, atol=1e-9)
    _, jacobians = batch.error(q, tips)
    turn = np.kron(np.eye(2), root[:3, :3])
    for one, jacobian in zip(q, jacobians, strict=True):
        assert np.allclose(turn @ jacobian, chain.jacobian(one, TOOL), atol=1e-9)


def test_inverse_kinematics_reaches_the_poses_and_alike_each_time(hulls: RobotHulls) -> None:
    chain = hulls.robot.chain(JOINTS, HOME)
    poses = [
        Pose(position=(0.45, y, 0.35), orientation=from_rpy(math.pi, 0.0, 0.3)) for y in (-0.3, 0.0, 0.3)
    ]
    found = [
        run_through(solver(hulls).solve(chain, [to_se3(each) for each in poses], np.array(PANDA_HOME), 8))
        for _ in range(2)
    ]
    for pose, one, other in zip(poses, *found, strict=True):
        assert len(one.solutions) == len(other.solutions) >= 1
        for q, same in zip(one.solutions, other.solutions, strict=True):
            assert np.array_equal(q, same)
            reached = hulls.robot.pose(TOOL, dict(zip(JOINTS, map(float, q), strict=True)))
            assert distance(reached, pose) < 5e-4
            assert angle_between(reached.orientation, pose.orientation) < 2e-3


def test_what_is_out_of_reach_tells_how_far(hulls: RobotHulls) -> None:
    chain = hulls.robot.chain(JOINTS, HOME)
    far = to_se3(Pose(position=(2.0, 0.0, 0.4), orientation=from_rpy(math.pi, 0.0, 0.0)))
    (answer,) = run_through(solver(hulls).solve(chain, [far], np.array(PANDA_HOME), 8))
    assert answer.solutions == ()
    assert 0.8 < answer.distance < 2.0


def test_pairs_that_are_left_out_are_never_in_contact(hulls: RobotHulls) -> None:
    """Against all pairs of bodies that are not harmless: nothing that touches is missed."""
    box = Obstacle("post", BoxShape((0.2, 0.2, 1.0)), Pose(position=(0.5, 0.2, 0.5)))
    checker = CollisionChecker(hulls, JOINTS, HOME, [box, FAR_BOX])
    everything = pin.GeometryModel(hulls.geometry)
    placed = pin.SE3(np.eye(3), np.array((0.5, 0.2, 0.5)))
    post = everything.addGeometryObject(pin.GeometryObject("post", 0, placed, coal.Box(0.2, 0.2, 1.0)))
    matrix = np.zeros((post + 1, post + 1), dtype=bool)
    matrix[:post, :post] = np.triu(~hulls.harmless, 1)
    matrix[:post, post] = [body.parentJoint > 0 for body in everything.geometryObjects][:post]
    everything.setCollisionPairs(matrix)
    data, geometry_data = hulls.robot.model.createData(), everything.createData()
    limits, rng = hulls.robot.limits(JOINTS), np.random.default_rng(4)
    for _ in range(200):
        q = rng.uniform(limits.lower, limits.upper)
        full = hulls.robot.configuration({**HOME, **dict(zip(JOINTS, map(float, q), strict=True))})
        hit = pin.computeCollisions(hulls.robot.model, data, everything, geometry_data, full, True)
        assert checker.free(q) is not hit


def test_touchable_pairs_may_touch_only_while_it_is_allowed(hulls: RobotHulls) -> None:
    at_tool = hulls.robot.pose(TOOL, HOME)
    item = Obstacle("item", BoxShape((0.03, 0.03, 0.03)), at_tool)
    touchable = [("item", link) for link in ("panda_leftfinger", "panda_rightfinger", "panda_hand")]
    checker = CollisionChecker(hulls, JOINTS, HOME, [item], touchable=touchable)
    q = np.array(PANDA_HOME)
    assert not checker.free(q)
    checker.touch(allowed=True)
    assert checker.free(q)
    assert checker.contacts(q) == ()
    checker.touch(allowed=False)
    assert not checker.free(q)
