"""What every robot's URDF says for those who draw it."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from tandem.sim.robots.finishing import finish
from tandem.sim.robots.registry import robot_model
from tandem.sim.urdf import UrdfDocument


@pytest.mark.parametrize("robot", ["p3dx", "summit_xl", "panda", "tiago"])
def test_each_colour_that_is_named_is_defined(robot: str) -> None:
    model = robot_model(robot)
    for text in (model.physics_urdf, model.description.urdf):
        root = ET.fromstring(text)  # noqa: S314 - our own
        used = {each.get("name") for each in root.iterfind("link/visual/material")}
        defined = {each.get("name") for each in root.iter("material") if each.find("color") is not None}
        assert used <= defined


CHILD_FIRST = """<robot name="two">
  <link name="base_footprint"/>
  <link name="hand"/>
  <link name="finger"/>
  <link name="arm"/>
  <joint name="wrist" type="revolute"><parent link="arm"/><child link="hand"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="knuckle" type="revolute"><parent link="hand"/><child link="finger"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="shoulder" type="revolute"><parent link="base_footprint"/><child link="arm"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>"""


def test_links_come_after_their_parents() -> None:
    """The physics says NaN of the force at a wrist whose link stands before the arm's."""
    document = UrdfDocument(CHILD_FIRST)
    finish(document, ())
    assert document.links() == ["base_footprint", "arm", "hand", "finger"]
