"""The examples do what docs/extending.md says that they do."""

from __future__ import annotations

import ast
import importlib.util
import sys

import pytest
from py_trees.common import Status
from pydantic import TypeAdapter

from tandem.executive.system.roles.skill_type import SkillType
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.geometry.poses import from_axes
from tandem.skills.gripper.grip import Gripping
from tandem.skills.ports.actions.gripper import Grip, GripGoal, grip
from tandem.skills.ports.hardware import BaseVelocity, Odometry
from tandem.skills.ports.keys import BASE_VELOCITY, CLOCK, ODOMETRY, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.problems import Problem
from tandem.skills.server import ActionServer
from tandem.skills.site import load
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.trees import tasks
from tandem.trees.client import ActionClient
from tandem.trees.registry import discover
from tests.fakes.examples import EXAMPLES, example

SITE = load("lab")
TAG = Pose(position=(0.9, 0.1, 0.74), orientation=from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0)))


@pytest.fixture
def look_around(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have the example stand among the tasks, as if its file lay in their folder."""
    monkeypatch.setitem(sys.modules, "tandem.trees.tasks.look_around", example("look_around"))
    folders = [*tasks.__path__, str(EXAMPLES)]
    found = {"fetch", "look_around"}
    listed = importlib.import_module("tandem.trees.registry").pkgutil.iter_modules
    monkeypatch.setattr(
        "tandem.trees.registry.pkgutil.iter_modules",
        lambda _: [module for module in listed(folders) if module.name in found],
    )


@pytest.mark.usefixtures("look_around")
def test_a_task_is_found_by_being_there() -> None:
    assert sorted(discover()) == ["fetch", "look_around"]


@pytest.mark.usefixtures("look_around")
def test_the_task_looks_as_often_as_it_was_asked_to() -> None:
    bench = TreeBench(SITE, items={29: TAG})
    assert bench.run("look_around", {"views": 3}) is Status.SUCCESS
    assert bench.robot.calls_of("perception/look") == 3
    assert bench.robot.calls_of("base/rotate") == 2
    assert bench.context.progress.fraction == 1.0


def test_nothing_in_a_site_contradicts_the_task() -> None:
    module = example("look_around")
    found = module.problems(module.LookAroundRequest(), SITE)
    assert TypeAdapter(tuple[Problem, ...]).validate_python(found) == ()


class Wheels:
    """Odometry of a base that does what it is told at once."""

    def __init__(self, bus: MemoryBus, clocks: SteppedClocks) -> None:
        self._bus, self._clocks, self._told = bus, clocks, Latest(bus, BASE_VELOCITY)
        self.x = 0.0

    def step(self) -> None:
        told = self._told.refresh() or BaseVelocity(linear=0.0, angular=0.0)
        self.x += told.linear * 0.02
        stamp = RobotTime(boot=self._clocks.boot, seconds=self._clocks.seconds)
        pose = FloorPose(x=self.x, y=0.0, yaw=0.0)
        ODOMETRY.publish(self._bus, Odometry(stamp=stamp, base_in_odom=pose, linear=told.linear, angular=0.0))


@pytest.mark.parametrize(("name", "room"), [("back_off", "skills"), ("by_colour", "detectors")])
def test_what_a_project_may_copy_imports_nothing_but_the_api(name: str, room: str) -> None:
    tree = ast.parse((EXAMPLES / f"{name}.py").read_text("utf-8"))
    imported = {each.module or "" for each in ast.walk(tree) if isinstance(each, ast.ImportFrom)}
    assert {each for each in imported if each.startswith("tandem")} == {f"tandem.api.{room}"}


def test_the_skill_may_be_an_entry_point() -> None:
    skill = example("back_off").SKILL
    assert isinstance(skill, SkillType)
    assert skill.tells == ("hw/base/velocity",)


@pytest.mark.parametrize(("cancel_at", "state"), [(None, "SUCCEEDED"), (40, "CANCELED")])
def test_the_skill_backs_off_or_stops(cancel_at: int | None, state: str) -> None:
    module, hub, clocks = example("back_off"), MemoryHub(), SteppedClocks("bench")
    bus = MemoryBus(hub)
    wheels = Wheels(MemoryBus(hub), clocks)
    server = ActionServer(MemoryBus(hub), clocks, module.BackOff(MemoryBus(hub), clocks))
    bus.announce("tester")
    client = ActionClient(bus, clocks, module.BACK_OFF, "tester")
    wheels.step()
    handle = client.start(module.BackOffGoal(distance=0.2), "task/back off/1")
    for step in range(400):
        clocks.advance(0.02)
        wheels.step()
        server.step()
        client.poll()
        if step == cancel_at:
            handle.cancel()
        if handle.ended:
            break
    assert handle.state == state
    assert wheels.x == pytest.approx(-0.2 if cancel_at is None else -0.08, abs=0.02)


@pytest.mark.parametrize(
    ("between", "state", "kind"), [(0.06, "SUCCEEDED", None), (0.0, "FAILED", "GRASP_EMPTY")]
)
def test_the_skill_of_the_gripper_works_with_another_robot(
    between: float, state: str, kind: str | None
) -> None:
    hub, clocks = MemoryHub(), SteppedClocks("one-gripper")
    bus, description = MemoryBus(hub), mock_description()
    robot = example("one_gripper").OneGripper(
        MemoryBus(hub), description, boot="one-gripper", between=between
    )
    skill = Gripping(MemoryBus(hub), clocks, description.end_effector("left"))
    server = ActionServer(MemoryBus(hub), clocks, skill)
    bus.announce("tester")
    client, clock = ActionClient(bus, clocks, grip("left"), "tester"), Latest(bus, CLOCK)
    handle = client.start(GripGoal(grip=Grip.GRASP, width=0.06), "task/close/1")
    for _ in range(800):
        clocks.advance(0.01)
        robot.step()
        server.step()
        client.poll()
        if handle.ended:
            break
    assert handle.state == state
    assert (None if handle.failure is None else handle.failure.kind) == kind
    heard = clock.refresh()
    assert heard is not None
    assert heard.stamp.boot == "one-gripper"
    assert heard.stamp.seconds == pytest.approx(clocks.seconds)


def test_a_task_need_not_be_registered_to_be_tried() -> None:
    bench = TreeBench(SITE, items={29: TAG})
    assert bench.run(example("look_around").TASK, {"views": 2}) is Status.SUCCESS
