"""What every robot's URDF says for those who draw it."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from tandem.sim.robots.registry import robot_model


@pytest.mark.parametrize("robot", ["p3dx", "summit_xl", "panda", "tiago"])
def test_each_colour_that_is_named_is_defined(robot: str) -> None:
    model = robot_model(robot)
    for text in (model.physics_urdf, model.description.urdf):
        root = ET.fromstring(text)  # noqa: S314 - our own
        used = {each.get("name") for each in root.iterfind("link/visual/material")}
        defined = {each.get("name") for each in root.iter("material") if each.find("color") is not None}
        assert used <= defined
