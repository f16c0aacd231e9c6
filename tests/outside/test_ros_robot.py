"""EXP1 of RoCS with a robot that speaks ROS 2: the simulation behind ROS topics, `tandem ros` before them.

Two robots in the keys: ``sim/r2`` is the simulated Pioneer, ``lab/r2`` what Tandem makes of its topics.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np
import pytest
import yaml

from tandem.executive.trials.rocs.draws import draw
from tandem.sim.truth import TRUTH
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.keys import Latest, Nothing
from tandem.skills.wire.zenoh_bus import ZenohBus, wait_until
from tests.outside._command import ROOT, Running, environment, free_port, running, tandem
from tests.outside._up import until

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]

MAP: Final = ROOT / "examples" / "ros" / "p3dx.yaml"
FACE: Final = ROOT / "examples" / "ros" / "robot.py"
"""The simulation's side."""
RUN: Final = 1
"""Number of the draw: a short one, in which the reflex has to act."""


class Speaking:
    """The whole of it, and ends of both buses."""

    def __init__(self, env: dict[str, str], ros: Running) -> None:
        self.env, self.ros = env, ros
        self.sim = ZenohBus(env["TANDEM_CONNECT"], "sim/r2")
        self.odometry: Latest[Odometry] = Latest(self.sim, keys.ODOMETRY)

    def speed(self) -> float:
        """Return the simulated base's speed in m/s, without a sign."""
        told = self.odometry.refresh()
        return 0.0 if told is None else abs(told.linear)

    def off_goal(self) -> float:
        """Return the metres of the simulated base from the origin, in truth."""
        answer = wait_until(self.sim, TRUTH.query(self.sim, Nothing(), timeout=10.0), 10.0)
        assert answer is not None
        x, y, _ = TRUTH.decode_answer(answer).base_in_map.position
        return float(np.hypot(x, y))


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Speaking]:
    folder = tmp_path_factory.mktemp("ros")
    scenario = folder / "exp1.yaml"
    drawn = draw(1, np.random.default_rng((1, RUN)))
    scenario.write_text(yaml.safe_dump(drawn.model_dump(mode="json")), "utf-8")
    endpoint = f"tcp/127.0.0.1:{free_port()}"
    env = {
        "TANDEM_CONNECT": endpoint,
        "TANDEM_SITE": "lab",
        "TANDEM_ROBOT": "r2",
        "XDG_STATE_HOME": str(folder / "state"),
    }
    up = ("up", "--connect", endpoint, "--only")
    with running(*up, "router,hardware", "--scenario", str(scenario), "--site-key", "sim") as simulated:
        simulated.await_word("press Ctrl-C to stop")
        with face(endpoint), running("ros", "--map", str(MAP), env=env) as ros:
            skills = ("keeper,base,executive", "--scenario", "RocsP3dx", "--robot", "r2")
            with running(*up, *skills, env=env) as tandem_up:
                tandem_up.await_word("press Ctrl-C to stop")
                made = Speaking(env, ros)
                yield made
                made.sim.close()


class face:  # noqa: N801 - a context, as ``running`` is
    """The simulated robot's side of ROS."""

    def __init__(self, endpoint: str) -> None:
        self._words = [sys.executable, str(FACE), endpoint, "sim/r2"]

    def __enter__(self) -> Running:
        self._process = subprocess.Popen(
            self._words,
            env=environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._running = Running(self._process)
        self._running.await_word("speaks ROS")
        return self._running

    def __exit__(self, *_: object) -> None:
        self._running.end(signal.SIGTERM)


@pytest.mark.thorough
def test_the_pioneer_goes_to_the_origin_over_ros_with_its_reflex(robot: Speaking) -> None:
    """RoCS paper, 6.3. Sensors and velocities cross ROS; the skill, the reflex and the tree are as always."""
    asked = ("request", "go_to", "--x", "0", "--y", "0", "--tolerance", "0.12", "--wait", "--json")
    done = tandem(*asked, env=robot.env, within=150.0)
    told = done.out
    if done.code != 0 and "no reading of pose sensor" in told:
        # A machine that others use held messages up for half a second: then the base rightly brakes.
        done = tandem(*asked, env=robot.env, within=150.0)
        told += done.out
    assert done.code == 0, done.said + robot.ros.said
    assert robot.off_goal() <= 0.15
    assert "reflex avoid_collision took the base" in told


def test_a_second_one_is_refused_for_the_same_robot(robot: Speaking) -> None:
    done = tandem("ros", "--map", str(MAP), env=robot.env)
    assert done.code == 4, done.said
    assert "plays this role already" in done.err


def test_killed_while_it_drives_the_base_stands(robot: Speaking) -> None:
    """The driver dies without a word: the robot's own dead-man stops it, as any base of ROS must have one."""
    asked = tandem("request", "go_to", "--x", "-1.2", "--y", "-1.2", env=robot.env)
    assert asked.code == 0, asked.said
    until(lambda: robot.speed() > 0.1, 30.0)
    os.kill(robot.ros.process.pid, signal.SIGKILL)
    until(lambda: robot.speed() < 0.01, 10.0)


def test_a_wrong_map_ends_the_command_with_where_and_why(tmp_path: Path) -> None:
    wrong = tmp_path / "map.yaml"
    wrong.write_text(MAP.read_text("utf-8").replace("sensor: left", "sensor: top"), "utf-8")
    done = tandem("ros", "--map", str(wrong), "--check")
    assert done.code == 2
    assert "inputs.4.sensor (line 11): expected one of p3dx's bumpers: front, left, back, right" in done.err
    assert "Traceback" not in done.said


def test_without_a_router_the_command_says_so() -> None:
    done = tandem("ros", "--map", str(MAP), "--connect", "tcp/127.0.0.1:1")
    assert done.code == 3, done.said
    assert "no zenoh router answers at tcp/127.0.0.1:1" in done.err


def test_with_keys_ros_needs_a_router_of_its_own(tmp_path: Path) -> None:
    done = tandem("ros", "--map", str(MAP), "--connect", "tls/127.0.0.1:1", "--keys", str(tmp_path))
    assert done.code == 2
    assert "give ROS a router of its own, with --ros-connect" in done.err


def test_a_map_is_checked_without_a_router() -> None:
    done = tandem("ros", "--map", str(MAP), "--check")
    assert done.code == 0, done.said
    assert "/sonar (sensor_msgs/msg/Range) -> range" in done.out
