"""Nodes live for one boot of the hardware: their goals fail, and others take their places."""

from __future__ import annotations

from tandem.skills.one_boot import OneBoot
from tandem.skills.ports.action import GoalState, GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.actions.base import ROTATE, RotateFeedback, RotateGoal, RotateResult
from tandem.skills.ports.bus import Bus, Desk, Pending
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import DESCRIPTION, JOINT_STATES, Latest
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.skill import succeeded
from tandem.skills.server import ActionServer
from tandem.skills.testing.mock_skill import MockSkill
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.planar_robot import describe


class Rig:
    """Hardware that the test starts anew, and one skill that takes two seconds."""

    def __init__(self) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("first")
        self.hardware: Desk = self.bus.serve(DESCRIPTION.key)
        self.statuses = Latest(self.bus, status_topic(ROTATE.name))
        self.built: list[RobotDescription] = []
        self.told = describe()
        self.skills = OneBoot("base", self.bus, self.clocks, self.build, self.told)

    def build(self, bus: Bus, description: RobotDescription) -> list[Node]:
        self.built.append(description)
        skill = MockSkill(
            ROTATE,
            self.clocks,
            idle=RotateFeedback(remaining=1.0),
            effect=lambda _: succeeded(RotateResult(turned=1.0)),
            duration=2.0,
        )
        Latest(bus, JOINT_STATES)  # a skill's own: no node closes it
        return [ActionServer(bus, self.clocks, skill)]

    def send(self, goal_id: str) -> Pending:
        goal = RotateGoal(angle=1.0).model_dump(mode="json")
        sent = SendGoal(goal_id=goal_id, client="", goal=goal)
        return goal_service(ROTATE.name).query(self.bus, sent)

    def pass_time(self, seconds: float) -> None:
        for _ in range(round(seconds / 0.1)):
            self.clocks.advance(0.1)
            self.skills.step()
            for request in self.hardware.drain():
                request.reply(self.told.model_dump_json().encode())

    def status(self) -> GoalStatus:
        status = self.statuses.refresh()
        assert status is not None
        return status


def test_a_goal_that_runs_when_the_hardware_starts_anew_fails_and_the_next_one_works() -> None:
    rig = Rig()
    rig.send("t/turn/1")
    rig.pass_time(1.0)
    assert rig.status().state is GoalState.RUNNING
    rig.clocks.reboot("second")
    rig.pass_time(0.1)
    ended = rig.status()
    assert ended.state is GoalState.FAILED
    assert ended.failure is not None
    assert ended.failure.kind is FailureKind.HARDWARE_LOST
    assert "second" in ended.failure.message
    rig.pass_time(1.0)
    rig.send("t/turn/2")
    rig.pass_time(2.5)
    assert (rig.status().goal_id, rig.status().state) == ("t/turn/2", GoalState.SUCCEEDED)


def test_the_new_nodes_are_made_from_what_the_new_hardware_tells() -> None:
    rig = Rig()
    rig.pass_time(0.5)
    assert rig.built == [describe()], "the first boot that is heard is the one that was asked"
    rig.told = describe(radius=0.2)
    rig.clocks.reboot("second")
    rig.pass_time(1.0)
    assert rig.built == [describe(), describe(radius=0.2)]


def test_nothing_is_made_before_the_new_hardware_tells_and_it_is_asked_again() -> None:
    rig = Rig()
    rig.pass_time(0.5)
    rig.hardware.close()
    rig.clocks.reboot("second")
    rig.pass_time(1.0)
    assert rig.skills.nodes == ()
    assert rig.send("t/turn/1").done(), "nobody takes a goal"
    rig.hardware = rig.bus.serve(DESCRIPTION.key)
    rig.pass_time(1.5)
    assert len(rig.skills.nodes) == 1


def test_nothing_that_was_opened_for_one_boot_is_left() -> None:
    rig = Rig()
    rig.pass_time(0.5)
    before = len(rig.bus.hub.inboxes), len(rig.bus.hub.desks)
    for boot in ("second", "third"):
        rig.clocks.reboot(boot)
        rig.pass_time(1.0)
    assert (len(rig.bus.hub.inboxes), len(rig.bus.hub.desks)) == before
    assert len(rig.built) == 3


def test_a_server_alone_ends_the_goal_of_another_boot_too() -> None:
    rig = Rig()
    (server,) = rig.skills.nodes
    rig.send("t/turn/1")
    server.step()
    rig.clocks.reboot("second")
    server.step()
    failure = rig.status().failure
    assert failure is not None
    assert failure.kind is FailureKind.HARDWARE_LOST
