"""An arm with its hand as its owner has it: goals and reflexes of either, and what no schedule can do."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tandem.skills.claimed import Claimed
from tandem.skills.limbs import HEARD_AFTER, RESTS_WITHIN, Limb, LimbSurroundings, arm
from tandem.skills.pipeline import Override, take_all
from tandem.skills.ports.action import GoalState, GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import GroupStatus, MotionState
from tandem.skills.ports.keys import Latest, group_cancel, group_status
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import ARM, HAND, PipelineState, pipeline_state
from tandem.skills.ports.skill import ActionType, Outcome, Run, succeeded
from tandem.skills.reflexes import Act, Chosen, ReflexType
from tandem.skills.server import ActionServer
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.planar_robot import describe

WHY = Failure(kind=FailureKind.ARM_STOPPED, message="it touched something")


class Nothing(Message):
    """Nothing to tell."""


@dataclass
class Mover:
    """A skill that commands its resource in each step, and a last time when its run is closed."""

    name: str
    commands: list[str]
    steps: int = 8
    period: float = 0.01

    @property
    def action(self) -> ActionType[Nothing, Nothing, Nothing]:
        return ActionType(self.name, Nothing, Nothing, Nothing, timeout=10.0)

    def check(self, goal: Nothing) -> Failure | None:  # noqa: ARG002
        return None

    def run(self, goal: Nothing, goal_id: str) -> Run[Nothing, Nothing]:  # noqa: ARG002
        for _ in range(self.steps):
            self.commands.append("goal")
            try:
                yield Nothing()
            except GeneratorExit:
                self.commands.append("stop")
                raise
        return _done()


def _done() -> Outcome[Nothing]:
    return succeeded(Nothing())


@dataclass
class Scripted:
    """Fires while it is told to, and commands what it takes."""

    at: LimbSurroundings
    takes: tuple[str, ...]
    commands: Mapping[str, list[str]]
    fires: bool = False

    def look(self, *, holds: bool) -> Failure | None:  # noqa: ARG002
        return WHY if self.fires else None

    def act(self) -> Act:
        for _ in range(2):
            for resource in self.takes:
                self.commands[resource].append("reflex")
            yield ("Act",)

    def close(self) -> None:
        pass


@dataclass
class Owner:
    """The process of the left arm, with skills and reflexes that do nothing but count."""

    reflexes: tuple[tuple[str, int, tuple[str, ...]], ...] = (("stop", 50, (ARM,)),)
    commands: dict[str, list[str]] = field(default_factory=lambda: {ARM: [], HAND: []})

    def __post_init__(self) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks("test")
        self.scripts: list[Scripted] = []
        around = arm(self.bus, self.clocks, describe(), "left")
        self.limb = Limb(around, [self._chosen(*each) for each in self.reflexes])
        self.skills = {ARM: Mover("arm_left/move", self.commands[ARM])}
        self.skills[HAND] = Mover("gripper_left/grip", self.commands[HAND])
        self.pipelines = {each: self.limb.pipeline(each) for each in (ARM, HAND)}
        self.servers = [
            ActionServer(self.bus, self.clocks, Claimed(skill, pipeline), pipelines=(pipeline,))
            for skill, pipeline in ((self.skills[each], self.pipelines[each]) for each in (ARM, HAND))
        ]
        self.statuses = {each: Latest(self.bus, status_topic(self.skills[each].name)) for each in (ARM, HAND)}
        self.sent = 0

    def _chosen(self, name: str, rank: int, takes: tuple[str, ...]) -> Chosen[LimbSurroundings]:
        def make(at: LimbSurroundings, _: Nothing) -> Scripted:
            self.scripts.append(Scripted(at, takes, self.commands))
            return self.scripts[-1]

        made = ReflexType(
            name=name,
            about="a script",
            resources=takes,
            rank=rank,
            parameters=Nothing,
            needs=lambda _: "",
            make=make,
        )
        return Chosen(made, Nothing(), on=True)

    def send(self, resource: str) -> Callable[[], GoalStatus | None]:
        self.sent += 1
        document = SendGoal(goal_id=f"t/{resource}/{self.sent}", client="", goal={})
        pending = goal_service(self.skills[resource].name).query(self.bus, document)

        def answer() -> GoalStatus | None:
            told = pending.poll()
            return None if told is None else GoalStatus.model_validate_json(told)

        return answer

    def step(self) -> None:
        self.clocks.advance(0.01)
        self.limb.step()
        for server in self.servers:
            server.step()


def test_the_arm_and_its_hand_move_at_once_and_each_pipeline_says_so() -> None:
    owner = Owner()
    told = {each: Latest(owner.bus, pipeline_state(each)) for each in ("arm_left", "gripper_left")}
    owner.send(ARM)
    owner.send(HAND)
    for _ in range(3):
        owner.step()
    holders = [(each.value or PipelineState).holder for each in told.values() if each.refresh()]
    assert holders == ["arm_left/move", "gripper_left/grip"]
    for _ in range(20):
        owner.step()
    ends = [owner.statuses[each].refresh() for each in (ARM, HAND)]
    assert [each and each.state for each in ends] == [GoalState.SUCCEEDED, GoalState.SUCCEEDED]
    assert [each.holder for each in owner.pipelines.values()] == ["", ""]


def test_the_goal_stops_what_it_moves_before_the_reflex_begins_and_ends_when_the_reflex_has_ended() -> None:
    owner = Owner()
    owner.send(ARM)
    for _ in range(3):
        owner.step()
    owner.scripts[0].fires = True
    owner.step()
    assert owner.commands[ARM][-2:] == ["stop", "reflex"]
    running = owner.statuses[ARM].refresh()
    assert running is not None
    assert running.state is GoalState.RUNNING
    owner.scripts[0].fires = False
    for _ in range(4):
        owner.step()
    ended = owner.statuses[ARM].refresh()
    assert ended is not None
    assert ended.failure is not None
    assert (ended.failure.kind, ended.failure.causes) == (FailureKind.OVERRIDDEN, (WHY,))
    assert ended.failure.message == "reflex stop took the arm_left: it touched something"


def test_a_reflex_of_the_arm_alone_leaves_the_hand_to_its_goal() -> None:
    owner = Owner()
    owner.send(HAND)
    owner.step()
    owner.scripts[0].fires = True
    for _ in range(20):
        owner.step()
    ended = owner.statuses[HAND].refresh()
    assert ended is not None
    assert ended.state is GoalState.SUCCEEDED


def test_while_a_reflex_has_the_arm_its_goals_are_refused_with_what_it_saw() -> None:
    owner = Owner()
    owner.scripts[0].fires = True
    owner.step()
    answer = owner.send(ARM)
    owner.step()
    refused = answer()
    assert refused is not None
    assert refused.failure is not None
    assert (refused.state, refused.failure.kind) == (GoalState.REJECTED, FailureKind.BUSY)
    assert refused.failure.causes == (WHY,)


@pytest.mark.parametrize(("rests", "seconds"), [(True, HEARD_AFTER), (False, RESTS_WITHIN)])
def test_halting_tells_the_group_to_stop_until_it_rests_or_nothing_is_heard(
    *, rests: bool, seconds: float
) -> None:
    bus, clocks = MemoryBus(), SteppedClocks("test")
    around = arm(bus, clocks, describe(), "left")
    limb, asked = Limb(around, ()), bus.serve(group_cancel("arm_left").key)
    pipeline = limb.pipeline(ARM)
    pipeline.claim("arm_left/move")
    take_all((pipeline,), Override(around.called("stop"), 50, WHY))
    began, act, cancels = clocks.seconds, around.halt("stop"), 0
    for _ in act:
        clocks.advance(0.01)
        cancels += len(asked.drain())
        now = clocks.robot()
        assert now is not None
        state = MotionState.CANCELED if rests else MotionState.ACTIVE
        status = GroupStatus(stamp=now, group="arm_left", goal_id="a", state=state, at_rest=rests)
        group_status("arm_left").publish(bus, status)
    assert clocks.seconds - began == pytest.approx(seconds, abs=0.011)
    assert (cancels > 1) is not rests


EVENTS = st.lists(
    st.one_of(
        st.tuples(st.just("reflex"), st.integers(0, 3)),
        st.tuples(st.just("send"), st.integers(0, 1)),
        st.tuples(st.just("step"), st.just(0)),
        st.tuples(st.just("step"), st.just(0)),
    ),
    max_size=60,
)
DECLARED = (("arm", 40, (ARM,)), ("hand", 50, (HAND,)), ("both", 60, (ARM, HAND)), ("top", 70, (HAND,)))


@settings(max_examples=200, deadline=None)
@given(EVENTS)
def test_whatever_fires_an_arm_and_its_hand_obey_one_at_a_time(events: list[tuple[str, int]]) -> None:
    owner = Owner(DECLARED)
    seen: dict[str, GoalStatus] = {}
    overridden: set[str] = set()
    for what, index in events:
        if what == "reflex":
            owner.scripts[index].fires = not owner.scripts[index].fires
        elif what == "send":
            owner.send((ARM, HAND)[index])
        else:
            before = {each: len(owner.commands[each]) for each in (ARM, HAND)}
            running = {name: each for name, each in seen.items() if each.state is GoalState.RUNNING}
            owner.step()
            for resource in (ARM, HAND):
                had = owner.pipelines[resource].override
                sent = owner.commands[resource][before[resource] :]
                assert not ({"goal", "reflex"} <= set(sent)), "a goal and a reflex both command it"
                assert "stop" not in sent or sent.index("stop") == 0, "the goal's last word comes first"
                assert had is None or "goal" not in sent, "a goal commands what a reflex has"
                if had is not None:
                    overridden |= {name for name in running if f"/{resource}/" in name}
        for latest in owner.statuses.values():
            seen |= {each.goal_id: each for each in latest.take()}
        wrong = [name for name in overridden if seen[name].state is GoalState.SUCCEEDED]
        assert wrong == [], "an overridden goal succeeded"
