"""Skills behind their server, each with what it drives, so that one suite can be run with all of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Final

from tandem.skills.gripper.process import nodes as gripper_nodes
from tandem.skills.ports.action import (
    AskResult,
    GoalCommand,
    GoalStatus,
    SendGoal,
    command_service,
    goal_service,
    result_service,
)
from tandem.skills.ports.actions.base import RotateGoal
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.actions.gripper import Grip, GripGoal
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import ActionType, Command, Skill, failed, succeeded
from tandem.skills.server import ActionServer
from tandem.skills.site import load
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.testing.mock_skill import MockSkill
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.world.process import nodes as world_nodes
from tests.fakes.arm_rig import PANDA_HOME, ArmRig, panda
from tests.fakes.base_rig import make_rig
from tests.fakes.planar_robot import PlanarNoise
from tests.skills.gripper.test_grip import Fingers

Document = dict[str, Any]
PERIOD: Final = 0.02


@dataclass(eq=False)
class Stage:
    """A skill's server on a bus.

    ``goal`` takes a second at the least, unless the skill is ``instant``; ``wrong`` fits the action's model,
    but the skill can't take it now (None: there is no such goal); ``misfit`` does not fit the model.
    """

    bus: MemoryBus
    action: str
    goal: Document
    misfit: Document
    wrong: Document | None
    step: Callable[[], None]
    at_rest: Callable[[], bool]
    starts: Callable[[], int]
    """How often the skill was run."""
    instant: bool = False

    def send(
        self, goal: Document | None = None, goal_id: str = "task/node/1", client: str = ""
    ) -> GoalStatus:
        """Send a goal; return the answer, which must come at once."""
        document = self.goal if goal is None else goal
        sent = SendGoal(goal_id=goal_id, client=client, goal=document)
        return self.answer(goal_service(self.action).query(self.bus, sent))

    def command(self, command: Command, goal_id: str = "task/node/1") -> GoalStatus:
        """Send a command; return the answer."""
        service = command_service(self.action)
        return self.answer(service.query(self.bus, GoalCommand(goal_id=goal_id, command=command)))

    def ask(self, goal_id: str = "task/node/1") -> GoalStatus:
        """Ask how a goal stands."""
        return self.answer(result_service(self.action).query(self.bus, AskResult(goal_id=goal_id)))

    def answer(self, pending: Pending) -> GoalStatus:
        """Return the answer to a query, which must be there after one step."""
        self.step()
        payload = pending.poll()
        assert payload is not None, "a query was not answered at once"
        return GoalStatus.model_validate_json(payload)

    def until_ended(self, goal_id: str = "task/node/1", *, steps: int = 3000) -> GoalStatus:
        """Go on until a goal has ended."""
        for _ in range(steps):
            status = self.ask(goal_id)
            if status.state.terminal:
                return status
        raise AssertionError(f"goal {goal_id} has not ended: {status}")


def _count(skill: Skill[Any, Any, Any]) -> Callable[[], int]:
    """Count a skill's runs from now on."""
    runs: list[str] = []
    run = skill.run

    def counted(goal: Message, goal_id: str) -> object:
        runs.append(goal_id)
        return run(goal, goal_id)

    skill.run = counted  # type: ignore[method-assign, assignment]
    return lambda: len(runs)


def _stage(
    server: ActionServer[Any, Any, Any],
    bus: MemoryBus,
    goal: Message,
    *,
    misfit: Document,
    wrong: Document | None,
    step: Callable[[], None],
    at_rest: Callable[[], bool],
) -> Stage:
    return Stage(
        bus=bus,
        action=server.name,
        goal=goal.model_dump(mode="json"),
        misfit=misfit,
        wrong=wrong,
        step=step,
        at_rest=at_rest,
        starts=_count(server._skill),
    )


class Wait(Message):
    """Wait; a negative number can't be waited, and 13 crashes."""

    number: int = 1


class Nothing(Message):
    """Nothing to tell."""


def mock() -> Stage:
    """Return the public mock."""
    bus, clocks = MemoryBus(), SteppedClocks("test")

    class Choosy(MockSkill[Wait, Nothing, Wait]):
        def check(self, goal: Wait) -> Failure | None:
            refused = Failure(kind=FailureKind.NOT_READY, message="less than nothing can't be waited")
            return refused if goal.number < 0 else super().check(goal)

    def effect(goal: Wait) -> Any:
        if goal.number == 13:
            raise ZeroDivisionError("a mistake in the skill")
        if goal.number == 2:
            return failed(Failure(kind=FailureKind.NO_PATH, message="as the test asked"))
        return succeeded(goal)

    action = ActionType("test/wait", Wait, Nothing, Wait, timeout=10.0)
    server = ActionServer(bus, clocks, Choosy(action, clocks, Nothing(), effect, duration=1.5))

    def step() -> None:
        clocks.advance(PERIOD)
        server.step()

    return _stage(
        server,
        bus,
        Wait(),
        misfit={"number": "many"},
        wrong={"number": -1},
        step=step,
        at_rest=lambda: True,  # it moves nothing
    )


def edit() -> Stage:
    """Return the keeper's edits: done at once, nothing moves."""
    bus, clocks = MemoryBus(), SteppedClocks("test")
    keeper, server = world_nodes(bus, clocks, load("lab"), PAIR)
    assert isinstance(server, ActionServer)

    def step() -> None:
        clocks.advance(PERIOD)
        stamp = clocks.robot()
        assert stamp is not None
        CLOCK.publish(bus, Clock(stamp=stamp, tick=1))
        keeper.step()
        server.step()

    pose = {"position": (0.0, 0.0, 0.0), "orientation": (0.0, 0.0, 0.0, 1.0)}
    stage = _stage(
        server,
        bus,
        server._skill.action.goal(edit="attach", item=29, side="left", item_in_tool=pose),
        misfit={"edit": "explode", "item": 29},
        wrong={"edit": "add", "item": 500},
        step=step,
        at_rest=lambda: True,
    )
    return replace(stage, instant=True)


def gripper() -> Stage:
    """Return a gripper whose pads move at 5 cm/s."""
    bus, clocks = MemoryBus(), SteppedClocks("test")
    fingers = Fingers(bus, clocks)
    fingers.width = 0.0
    (server, _) = gripper_nodes(bus, clocks, mock_description(), "left")
    assert isinstance(server, ActionServer)
    widths = [0.0, 0.0]

    def step() -> None:
        clocks.advance(PERIOD)
        fingers.step()
        server.step()
        widths[:] = [widths[1], fingers.width]

    for _ in range(5):
        step()
    return _stage(
        server,
        bus,
        GripGoal(grip=Grip.OPEN),
        misfit={"grip": "open", "width": -1.0},
        wrong={"grip": "open", "width": 3.0},
        step=step,
        at_rest=lambda: widths[0] == widths[1],
    )


def rotate() -> Stage:
    """Return the base's turn, on a planar robot."""
    rig = make_rig(load("lab"), FloorPose(x=-0.8, y=1.2, yaw=0.0), noise=PlanarNoise())
    clocks = rig.robot.clocks
    server = ActionServer(rig.bus, clocks, rig.base.rotate)

    def step() -> None:
        rig.tick()
        while server.step():
            pass

    return _stage(
        server,
        rig.bus,
        RotateGoal(angle=2.0),
        misfit={"angle": "half"},
        wrong=None,
        step=step,
        at_rest=lambda: abs(rig.robot.linear) < 1e-3 and abs(rig.robot.angular) < 1e-2,
    )


def arm() -> Stage:
    """Return the move of another robot's arm."""
    rig = ArmRig(panda(), "arm")
    server = next(node for node in rig._nodes if isinstance(node, ActionServer) and node.name == "arm/move")
    goal = [*PANDA_HOME[:-1], PANDA_HOME[-1] + 1.5]
    return Stage(
        bus=rig.bus,
        action="arm/move",
        goal={"joints": goal, "speed": 0.5},
        misfit={"joints": goal, "posture": "home"},
        wrong={"posture": "handstand"},
        step=lambda: rig.rounds(1),
        at_rest=lambda: rig.hardware._active is None,
        starts=_count(server._skill),
    )
