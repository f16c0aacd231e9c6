"""The chain reader against pinocchio's kinematics."""

import math

import numpy as np
import pytest

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import distance
from tandem.skills.ports.packages import resolve

TIAGO = "package://example-robot-data/robots/tiago_description/robots/tiago_dual.urdf"

SLIDE = """<robot name="r">
  <link name="a"/><link name="b"/><link name="c"/>
  <joint name="ab" type="prismatic"><parent link="a"/><child link="b"/>
    <origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/><axis xyz="2 0 0"/></joint>
  <joint name="bc" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0.5 0 0"/></joint>
</robot>"""


def test_a_sliding_joint_moves_along_its_own_axis_of_unit_length() -> None:
    chain = Chain.from_urdf(SLIDE, "a", "c")
    assert chain.joints == ("ab",)
    assert chain.pose({"ab": 0.25}).position == pytest.approx((0.0, 0.75, 1.0))


def test_a_missing_position_is_named() -> None:
    with pytest.raises(KeyError, match="ab"):
        Chain.from_urdf(SLIDE, "a", "c").pose({})


def test_a_tip_that_is_not_below_the_root_is_refused() -> None:
    with pytest.raises(ValueError, match="below 'b'"):
        Chain.from_urdf(SLIDE, "b", "a")


def test_the_camera_of_tiago_is_where_pinocchio_says() -> None:
    pinocchio = pytest.importorskip("pinocchio")
    text = resolve(TIAGO).read_text(encoding="utf-8")
    model = pinocchio.buildModelFromXML(text)
    data = model.createData()
    chain = Chain.from_urdf(text, "base_footprint", "xtion_rgb_optical_frame")
    rng = np.random.default_rng(1)
    for _ in range(5):
        positions = dict(zip(chain.joints, rng.uniform(-0.3, 0.3, len(chain.joints)).tolist(), strict=True))
        q = pinocchio.neutral(model)
        for name, value in positions.items():
            q[model.joints[model.getJointId(name)].idx_q] = value
        pinocchio.framesForwardKinematics(model, data, q)
        at = [data.oMf[model.getFrameId(f)] for f in ("base_footprint", "xtion_rgb_optical_frame")]
        expected = at[0].actInv(at[1])
        found = chain.pose(positions)
        assert found.position == pytest.approx(tuple(expected.translation), abs=1e-9)
        quaternion = pinocchio.Quaternion(expected.rotation).coeffs()
        assert abs(abs(float(np.dot(quaternion, found.orientation))) - 1.0) < 1e-9
    assert math.isclose(distance(found, found), 0.0)
