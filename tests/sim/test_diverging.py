"""A robot whose file makes the physics diverge is told of in words, with what of the file to look at."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from tandem.sim.body import RobotBody
from tandem.sim.diverging import DivergedError
from tandem.sim.hardware import Hardware
from tandem.sim.physics import Physics
from tandem.sim.robots.p3dx import ROBOT
from tandem.sim.scenario import Noise
from tandem.skills.wire.memory import MemoryBus, MemoryHub


@pytest.mark.parametrize(
    ("mass", "periods", "said"),
    [
        ("1e300", 3, "its base is at (nan"),
        ("1e15", 200, "its base is at ("),  # pressed through the floor, it falls 10 m in 1.4 s
    ],
)
def test_absurd_masses_are_named(mass: str, periods: int, said: str) -> None:
    model = ROBOT.compose()
    text = re.sub(r'(<mass value=")[^"]*', rf"\g<1>{mass}", model.physics_urdf, count=1)
    heavy = replace(model, physics_urdf=text)
    physics = Physics()
    physics.add_floor()
    body = RobotBody(physics, heavy)
    hardware = Hardware(MemoryBus(MemoryHub()), body, boot="a", noise=Noise(), rng=np.random.default_rng(1))

    def run() -> None:
        for _ in range(periods):
            hardware.step()

    with pytest.raises(DivergedError, match=re.escape(said)) as caught:
        run()
    physics.close()
    assert f"{float(mass):.3g} kg" in str(caught.value)
