"""Reflexes on pipelines: when they fire, who wins, and what no schedule of theirs can do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import ReflexSwitch, pipeline_state, reflex_switch
from tandem.skills.ports.reflex_setting import ReflexSetting, Threshold
from tandem.skills.ports.sources import DocumentError
from tandem.skills.reflexes import Act, Fitted, Reflexes, ReflexType, chosen, fitted
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.planar_robot import describe

WHY = Failure(kind=FailureKind.BASE_BLOCKED, message="a wall")


@dataclass
class Scripted:
    """Fires while it is told to; its action says so many words."""

    fires: bool = False
    words: int = 2
    acted: int = 0
    broken: bool = False
    closed: list[str] = field(default_factory=list)

    def look(self, *, holds: bool) -> Failure | None:  # noqa: ARG002
        if self.broken:
            raise RuntimeError("broken")
        return WHY if self.fires else None

    def act(self) -> Act:
        try:
            for word in range(self.words):
                self.acted += 1
                yield (f"step {word}",)
        finally:
            self.closed.append("ended")

    def close(self) -> None:
        self.closed.append("closed")


@dataclass
class Bench:
    """A bus, pipelines and reflexes on them."""

    pipelines: Sequence[Pipeline]
    reflexes: Sequence[tuple[str, int, Sequence[int]]]

    def __post_init__(self) -> None:
        self.bus, self.clocks = MemoryBus(), SteppedClocks()
        self.scripts = [Scripted() for _ in self.reflexes]
        self.fitted = [
            Fitted(name, "a script", rank, tuple(self.pipelines[index] for index in taken), script)
            for (name, rank, taken), script in zip(self.reflexes, self.scripts, strict=True)
        ]
        self.node = Reflexes(self.bus, self.clocks, self.pipelines, self.fitted)

    def step(self) -> None:
        self.clocks.advance(0.01)
        self.node.step()


def one(*reflexes: tuple[str, int]) -> tuple[Bench, Pipeline]:
    pipeline = Pipeline("base")
    return Bench((pipeline,), [(name, rank, (0,)) for name, rank in reflexes]), pipeline


def test_it_acts_in_the_step_in_which_it_fires_and_holds_until_act_and_cause_are_over() -> None:
    bench, pipeline = one(("avoid", 50))
    pipeline.claim("drive")
    (script,) = bench.scripts
    bench.step()
    assert pipeline.holder == "drive"
    script.fires = True
    bench.step()
    assert (script.acted, pipeline.holder, pipeline.doing) == (1, "", ("step 0",))
    for _ in range(5):
        bench.step()
    assert pipeline.override is not None, "what it saw is still there"
    assert script.acted > 2, "so it acts once more"
    script.fires = False
    for _ in range(3):
        bench.step()
    assert pipeline.override is None
    assert bench.fitted[0].fired == 1


def test_a_higher_one_takes_over_and_the_lower_ones_action_is_closed() -> None:
    bench, pipeline = one(("avoid", 50), ("bumper", 90))
    low, high = bench.scripts
    low.fires = True
    bench.step()
    high.fires = True
    bench.step()
    assert pipeline.high("bumper")()
    bench.step()
    assert low.closed == ["ended"]
    acted = low.acted
    high.fires = low.fires = False
    for _ in range(4):
        bench.step()
    assert pipeline.override is None
    assert low.acted == acted, "what it was at is not gone on with"


def test_one_that_loses_a_part_after_its_action_gives_back_the_rest() -> None:
    left, right = Pipeline("arm_left"), Pipeline("arm_right")
    bench = Bench((left, right), [("both", 50, (0, 1)), ("top", 60, (1,))])
    both, top = bench.scripts
    both.fires = True
    for _ in range(4):
        bench.step()
    top.fires = True
    bench.step()
    assert right.has("top")
    bench.step()
    assert left.override is None, "half of what it takes is none of it"


def test_one_that_raises_is_switched_off_and_gives_back_what_it_had() -> None:
    bench, pipeline = one(("avoid", 50), ("bumper", 90))
    low, high = bench.scripts
    high.fires = True
    bench.step()
    high.broken = True
    low.fires = True
    bench.step()
    assert not bench.fitted[1].on
    assert pipeline.high("avoid")(), "the others go on"


def test_an_operator_switches_it_off_and_on() -> None:
    bench, pipeline = one(("avoid", 50))
    bench.scripts[0].fires = True
    bench.step()
    pending = reflex_switch("avoid").query(bench.bus, ReflexSwitch(on=False, by="Ada"))
    bench.step()
    answer = pending.poll()
    assert answer is not None
    told = reflex_switch("avoid").decode_answer(answer)
    assert (told.on, told.by, told.holds) == (False, "Ada", False)
    assert told.declared, "it would be on"
    assert pipeline.override is None
    reflex_switch("avoid").query(bench.bus, ReflexSwitch(on=True, by="Ada"))
    bench.step()
    assert pipeline.override is not None


def test_what_has_the_resource_is_told_once_for_each_change_and_once_a_second() -> None:
    bench, pipeline = one(("avoid", 50))
    states = Latest(bench.bus, pipeline_state("base"), depth=1024)
    pipeline.claim("drive")
    for _ in range(250):
        bench.step()
    told = [each.stamp.since(before.stamp) for before, each in pairwise(states.take())]
    assert [round(passed or 0.0, 2) for passed in told] == [1.0, 1.0]


def test_what_has_the_resource_is_told_on_each_change() -> None:
    bench, pipeline = one(("avoid", 50))
    states = Latest(bench.bus, pipeline_state("base"), depth=64)
    bench.step()
    pipeline.claim("drive")
    bench.step()
    bench.scripts[0].fires = True
    bench.step()
    told = [(each.holder, each.reflex, each.doing) for each in states.take()]
    assert told == [("", "", ()), ("drive", "", ()), ("", "avoid", ("step 0",))]


class Bounds(Message):
    """As a reflex's file has them."""

    range: Threshold = Threshold(fires=0.3, releases=0.4)
    speed: float = 0.2


def declare(
    settings_of: Sequence[tuple[str, ReflexSetting]],
    *,
    lacks: str = "",
    resources: tuple[str, ...] = ("base",),
) -> list[Fitted]:
    made = ReflexType[str, Bounds](
        name="avoid",
        about="a script",
        resources=resources,
        rank=50,
        parameters=Bounds,
        needs=lambda _: lacks,
        make=lambda _, parameters: Scripted(words=round(parameters.speed * 10.0)),
    )
    choice = chosen((made,), describe(), ("base",), settings_of, elsewhere=("fence",))
    return fitted(choice, "anything", {"base": Pipeline("base")})


def test_what_is_declared_later_wins_and_the_rest_stays_as_the_reflex_says() -> None:
    robot = ("robot p3dx", ReflexSetting(reflex="avoid", parameters={"speed": 0.5}))
    site = ("lab.yaml: reflexes.0", ReflexSetting(reflex="avoid", armed=False, parameters={"speed": 0.7}))
    (made,) = declare((robot, site))
    assert isinstance(made.reflex, Scripted)
    assert (made.reflex.words, made.on) == (7, False)


BAD = [
    ("avoid", {"range": {"fires": 0.4, "releases": 0.3}}, "", ("base",), "contradictory thresholds"),
    ("avoid", {"sped": 0.2}, "", ("base",), "sped"),
    ("avoid", {}, "a range sensor", ("base",), "needs a range sensor, which this robot lacks"),
    ("avoid", {}, "", ("base", "arm_left"), "needs a resource 'arm_left', which this robot lacks"),
    ("avoyd", {}, "", ("base",), "no reflex 'avoyd'; expected one of avoid"),
]


@pytest.mark.parametrize(("name", "parameters", "lacks", "resources", "said"), BAD)
def test_a_declaration_that_can_not_be_is_refused_with_its_place_and_the_reason(
    name: str, parameters: dict[str, object], lacks: str, resources: tuple[str, ...], said: str
) -> None:
    setting = ReflexSetting.model_validate({"reflex": name, "parameters": parameters})
    with pytest.raises(DocumentError, match=r"^lab\.yaml: ") as refused:
        declare((("lab.yaml", setting),), lacks=lacks, resources=resources)
    assert said in str(refused.value)


def test_where_nobody_declares_it_a_robot_without_its_sensor_goes_without_it() -> None:
    assert declare((), lacks="a range sensor") == []


def test_one_of_a_plug_in_that_is_left_out_may_be_declared() -> None:
    (made,) = declare((("lab.yaml", ReflexSetting(reflex="fence")),))
    assert made.name == "avoid"


@pytest.mark.parametrize(
    ("value", "holds", "below"),
    [(0.29, False, True), (0.31, False, False), (0.31, True, True), (0.41, True, False)],
)
def test_a_threshold_releases_later_than_it_fires(value: float, *, holds: bool, below: bool) -> None:
    assert Threshold(fires=0.3, releases=0.4).below(value, holds=holds) == below


EVENTS = st.lists(
    st.one_of(
        st.tuples(st.just("reflex"), st.integers(0, 3)),
        st.tuples(st.just("claim"), st.integers(0, 1)),
        st.tuples(st.just("release"), st.integers(0, 1)),
        st.tuples(st.just("step"), st.just(0)),
    ),
    max_size=60,
)


@settings(max_examples=300, deadline=None)
@given(EVENTS)
def test_whatever_fires_no_resource_obeys_two_and_no_reflex_has_half_of_what_it_takes(
    events: list[tuple[str, int]],
) -> None:
    pipelines = (Pipeline("arm_left"), Pipeline("arm_right"))
    declared = (("left", 40, (0,)), ("right", 50, (1,)), ("both", 60, (0, 1)), ("top", 70, (1,)))
    bench = Bench(pipelines, declared)
    claims = [(pipeline, pipeline.normal("goal"), pipeline.mark()) for pipeline in pipelines]
    for what, index in events:
        if what == "reflex":
            bench.scripts[index].fires = not bench.scripts[index].fires
        elif what == "claim":
            pipeline = pipelines[index]
            assert pipeline.claim("goal") == (pipeline.override is None)
            claims.append((pipeline, pipeline.normal("goal"), pipeline.mark()))
        elif what == "release":
            pipelines[index].release("goal")
        else:
            bench.step()
        for pipeline in pipelines:
            high = [each.name for each in bench.fitted if pipeline.high(each.name)()]
            normal = [may for which, may, _ in claims if which is pipeline and may()]
            assert len(high) <= 1
            assert not (high and normal), "a goal and a reflex both command it"
        for pipeline, may, mark in claims:
            if pipeline.taken_since(mark, "goal") is not None:
                assert not may(), "an overridden goal commands it again"
        for each in bench.fitted:
            has = [pipeline.high(each.name)() for pipeline in each.pipelines]
            if what == "step":
                # What was taken from it by a higher one it gives back whole by the end of the next step.
                higher = [
                    script.fires
                    for other, script in zip(bench.fitted, bench.scripts, strict=True)
                    if other.rank > each.rank
                ]
                assert any(higher) or len(set(has)) == 1


@settings(max_examples=200, deadline=None)
@given(st.lists(st.sampled_from(("first", "second", "third")), min_size=1, max_size=3, unique=True))
def test_of_those_that_fire_at_once_the_highest_has_its_way(firing: list[str]) -> None:
    ranks = {"first": 30, "second": 20, "third": 10}
    bench, pipeline = one(*ranks.items())
    for name, script in zip(ranks, bench.scripts, strict=True):
        script.fires = name in firing
    bench.step()
    assert pipeline.override is not None
    assert pipeline.override.reflex == max(firing, key=lambda name: ranks[name])
