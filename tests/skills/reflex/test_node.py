"""The reflex tells 50 times a second while an arm moves, once a second at rest, and each change at once."""

from __future__ import annotations

from tandem.skills.ports.actions.bimanual import CROSSING, Crossing
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.reflex.process import nodes
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus
from tests.skills.reflex.two_arms import ASIDE, IN_FRONT, joint_states, positions, robot


def told(frames: list[tuple[dict[str, float], float]]) -> list[Crossing]:
    """Run through positions and speeds, one each 10 ms; return what was told."""
    description, hulls = robot()
    bus = MemoryBus()
    (reflex,) = nodes(bus, description, load("bimanual"), hulls)
    heard = Latest(bus, CROSSING)
    for k, (at, speed) in enumerate(frames):
        JOINT_STATES.publish(bus, joint_states(0.01 * k, at, {"arm_left_1_joint": speed}))
        reflex.step()
        reflex.step()
    return heard.take()


def test_at_rest_it_tells_once_a_second() -> None:
    assert [each.stamp.seconds for each in told([(positions(), 0.0)] * 201)] == [0.0, 1.0, 2.0]


def test_while_an_arm_moves_it_tells_at_50_hertz() -> None:
    assert len(told([(positions(ASIDE, ASIDE), 0.1)] * 101)) == 51


def test_a_change_is_told_at_once() -> None:
    apart, close = (positions(ASIDE, ASIDE), 0.0), (positions(IN_FRONT, IN_FRONT), 0.0)
    verdicts = [(each.stamp.seconds, each.near) for each in told([apart] * 3 + [close] * 2 + [apart] * 2)]
    assert verdicts == [(0.0, False), (0.03, True), (0.05, False)]


def test_a_robot_without_parameters_has_no_reflex() -> None:
    description, hulls = robot()
    without = description.model_copy(update={"arms_crossing": None})
    assert nodes(MemoryBus(), without, load("bimanual"), hulls) == ()
