"""The head has one goal at a time, and reflexes of other packages; without a head there is neither."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from tandem.skills.perception.process import nodes
from tandem.skills.ports.action import GoalStatus, SendGoal, goal_service
from tandem.skills.ports.bus import Pending
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.node import Node
from tandem.skills.ports.reflex import pipeline_state
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.site import load
from tandem.skills.wire.workers import InlineCompute
from tests.fakes.packages import Installed
from tests.skills.perception.pictures import picture
from tests.skills.perception.stage import DESCRIPTION, Stage

POST = DESCRIPTION.model_copy(update={"groups": ()})
STARES = """
from tandem.api.reflexes import HEAD, Failure, FailureKind, LimbSurroundings, Message, ReflexType


class Nothing(Message):
    pass


class Stares:
    def __init__(self, at: LimbSurroundings, parameters: Nothing) -> None:
        self.at = at

    def look(self, *, holds: bool) -> Failure | None:
        return Failure(kind=FailureKind.OTHER, message="an eclipse")

    def act(self):
        return self.at.halt("stares")

    def close(self) -> None:
        pass


STARES = ReflexType(
    name="stares", about="a script", resources=(HEAD,), rank=70, parameters=Nothing,
    needs=lambda robot: "", make=Stares,
)
"""


def stage_with(description: RobotDescription, *, plugs: bool = False) -> tuple[Stage, Sequence[Node]]:
    stage = Stage(lambda _pose, _now: picture((), np.random.default_rng(1)))
    made = nodes(
        stage.bus,
        stage.clocks,
        description,
        load("lab"),
        InlineCompute(stage.clocks),
        left_out={} if plugs else None,
    )
    return stage, made


def send(stage: Stage, made: Sequence[Node], action: str) -> GoalStatus:
    goal = SendGoal(goal_id=f"t/{action}/1", client="", goal={"tilts": [-0.4]} if "look" in action else {})
    pending: Pending = goal_service(action).query(stage.bus, goal)
    for node in made:
        node.step()
    return GoalStatus.model_validate_json(pending.poll() or b"")


@pytest.mark.parametrize(("description", "refused"), [(DESCRIPTION, FailureKind.BUSY), (POST, None)])
def test_who_looks_keeps_others_from_the_head_if_there_is_one(
    description: RobotDescription, refused: FailureKind | None
) -> None:
    stage, made = stage_with(description)
    assert send(stage, made, "perception/look").failure is None
    failure = send(stage, made, "perception/track").failure
    assert (None if failure is None else failure.kind) is refused


def test_a_reflex_of_another_package_takes_the_head(installed: Installed) -> None:
    installed.add("eyes", {"eyes": STARES}, {"tandem.reflexes": {"stares": "eyes:STARES"}})
    stage, made = stage_with(DESCRIPTION, plugs=True)
    told = Latest(stage.bus, pipeline_state("head"))
    failure = send(stage, made, "perception/look").failure
    assert failure is not None
    assert failure.message == "reflex stares has the head: an eclipse"
    state = told.refresh()
    assert state is not None
    assert (state.reflex, state.doing) == ("stares", ("Halt",))
