"""The distance field's answers are coal's, and so are the plans made with them."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.planning import agreement, plan
from benchmarks.planning_sets import SETS, Stand, problem, stand
from tandem.skills.arm.planning.motions import Motions, Space
from tandem.skills.kinematics import collision
from tandem.skills.kinematics.bodies import BoxShape, Carried, CellsShape, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import home_positions
from tandem.skills.kinematics.pair_tables import CONTACT, DOUBT, FREE, SIDE
from tandem.skills.kinematics.transforms import Array
from tandem.skills.kinematics.world_field import WorldField
from tandem.skills.ports.pose import Pose

SHELF = Obstacle("shelf", BoxShape((0.3, 0.8, 0.02)), Pose(position=(0.55, 0.0, 1.0)))
ITEM = Obstacle("item", BoxShape((0.06, 0.06, 0.1)), Pose(position=(0.55, 0.0, 1.07)))


@pytest.fixture(scope="module", params=["panda", "tiago_dual", "locobot"])
def of(request: pytest.FixtureRequest) -> Stand:
    return stand(request.param)


@pytest.fixture(scope="module")
def panda() -> Stand:
    return stand("panda")


def drawn(of: Stand, count: int, seed: int = 0) -> Array:
    limits = of.arm.limits
    return np.random.default_rng(seed).uniform(
        limits.lower - 0.02, limits.upper + 0.02, size=(count, len(limits.lower))
    )


@pytest.mark.parametrize("name", sorted(SETS))
def test_random_states_are_what_coal_says(of: Stand, name: str) -> None:
    found = next(filter(None, (_problem(name, of, k) for k in range(8))))
    asked = agreement(of, found, 400, np.random.default_rng(1))
    assert asked.alike == asked.states
    assert asked.decided > 0.4 * asked.states


def _problem(name: str, of: Stand, number: int):  # type: ignore[no-untyped-def]  # noqa: ANN202
    try:
        return problem(name, of, number)
    except LookupError:
        return None


def test_plans_are_the_same(panda: Stand, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(collision, "BEFORE", 0)
    of_problem = problem("shelf-small", panda, 1)
    alone = Stand(panda.arm, panda.shoulder, panda.scale)
    with_field = plan(panda, of_problem, seed=3)
    world, panda.arm.world = panda.arm.world, None
    by_coal = plan(alone, of_problem, seed=3)
    panda.arm.world = world
    assert with_field.length is not None
    assert (with_field.length, with_field.units) == (by_coal.length, by_coal.units)


def checkers(of: Stand, **world) -> tuple[CollisionChecker, CollisionChecker]:  # type: ignore[no-untyped-def]  # noqa: ANN003
    """Return a checker by coal alone, and one with the field."""
    hulls, joints = of.arm.hulls, of.arm.group.joints
    positions = home_positions(of.arm.description)
    alone = CollisionChecker(hulls, joints, positions, **world)
    return alone, CollisionChecker(hulls, joints, positions, **world, world=WorldField(hulls))


def alike(alone: CollisionChecker, both: CollisionChecker, states: Array) -> None:
    both.checks = collision.BEFORE
    assert [both.free(q) for q in states] == [alone.free(q) for q in states]


def test_what_is_carried_counts(panda: Stand) -> None:
    hand = panda.arm.description.end_effectors[0]
    box = Carried("box", BoxShape((0.1, 0.1, 0.2)), hand.frame, Pose(position=(0.05, 0, 0)), hand.touch_links)
    alone, both = checkers(panda, obstacles=[SHELF], carried=[box])
    alike(alone, both, drawn(panda, 1500))


def test_what_may_touch_is_never_proven_to_be_wrong(panda: Stand) -> None:
    hand = panda.arm.description.end_effectors[0]
    pairs = [("item", link) for link in hand.touch_links]
    alone, both = checkers(panda, obstacles=[SHELF, ITEM], touchable=pairs)
    states = np.concatenate([drawn(panda, 700), _at_item(panda)])
    for allowed in (False, True, False):
        alone.touch(allowed=allowed)
        both.touch(allowed=allowed)
        alike(alone, both, states)


def _at_item(of: Stand) -> Array:
    """Return states whose hands are at or in the item."""
    alone, _ = checkers(of)
    near = drawn(of, 60_000, seed=5)[:, :]
    frame = of.arm.description.end_effectors[0].frame
    tips = np.array([alone.chain.placement(q, frame).translation for q in near[:20_000]])
    apart = np.linalg.norm(tips - np.array(ITEM.pose_in_base.position), axis=1)
    return near[np.argsort(apart)[:200]]


def test_what_rests_may_stay_so(panda: Stand) -> None:
    alone, both = checkers(panda, obstacles=[SHELF])
    deep = next(
        q for q in drawn(panda, 4000) if (c := alone.contacts(q)) and len(c) == 1 and c[0].depth < 0.01
    )
    assert alone.let_rest(deep) == both.let_rest(deep) == ()
    near = deep + np.random.default_rng(2).normal(0.0, 0.02, size=(300, len(deep)))
    alike(alone, both, np.concatenate([deep[None], near, drawn(panda, 300)]))


def test_a_field_shared_by_two_checkers_is_that_of_the_one_that_asks(panda: Stand) -> None:
    world, joints = WorldField(panda.arm.hulls), panda.arm.group.joints
    positions, states = home_positions(panda.arm.description), drawn(panda, 400)
    empty = CollisionChecker(panda.arm.hulls, joints, positions, world=world)
    full = CollisionChecker(panda.arm.hulls, joints, positions, [SHELF, ITEM], world=world)
    first = empty.look(states)
    assert (full.look(states) != first).any()
    assert np.array_equal(empty.look(states), first)


def test_a_checker_keeps_its_world_when_a_larger_field_takes_its_place(panda: Stand) -> None:
    world, joints = WorldField(panda.arm.hulls), panda.arm.group.joints
    positions, states = home_positions(panda.arm.description), drawn(panda, 400)
    hand = panda.arm.description.end_effectors[0]
    pole = Carried(
        "pole", BoxShape((0.6, 0.02, 0.02)), hand.frame, Pose(position=(0.3, 0, 0)), hand.touch_links
    )
    empty = CollisionChecker(panda.arm.hulls, joints, positions, world=world)
    first = empty.look(states)
    CollisionChecker(panda.arm.hulls, joints, positions, [SHELF], world=world).look(states)
    CollisionChecker(panda.arm.hulls, joints, positions, [ITEM], [pole], world=world).look(states)
    assert np.array_equal(empty.look(states), first)


def test_states_that_are_no_numbers_are_in_doubt(panda: Stand) -> None:
    _, both = checkers(panda, obstacles=[SHELF])
    assert (both.look(np.full((3, len(panda.arm.group.joints)), np.nan)) == DOUBT).all()


def test_a_motion_is_checked_as_without(panda: Stand) -> None:
    alone, both = checkers(panda, obstacles=[SHELF])
    space = Space(panda.arm.limits, panda.arm.weights)
    states = [q for q in drawn(panda, 200) if alone.free(q)]
    both.checks = alone.checks = collision.BEFORE
    for a, b in zip(states[::2], states[1::2], strict=False):
        assert Motions(both, space).free(a, b) == Motions(alone, space).free(a, b)
        assert both.checks == alone.checks


def test_easy_plans_never_make_the_field(panda: Stand) -> None:
    _, both = checkers(panda, obstacles=[SHELF])
    both.first_contact(drawn(panda, 50))
    assert both._quick is None


@pytest.mark.parametrize(
    ("first", "second"), [("panda_link5", "panda_link7"), ("panda_link3", "panda_link5")]
)
def test_tables_of_angles_are_what_coal_says(panda: Stand, first: str, second: str) -> None:
    hulls = panda.arm.hulls
    a, b = hulls.links.index(first), hulls.links.index(second)
    table = hulls.tables.table(a, b, panda.arm.group.joints)
    assert table is not None
    alone, _ = checkers(panda)
    columns = [panda.arm.group.joints.index(name) for name in table.joints]
    for q in drawn(panda, 300):
        at = np.floor((q[columns] - table.low) / table.step).astype(int)
        if ((at < 0) | (at >= SIDE)).any():
            continue
        touch = any({c.first, c.second} == {first, second} for c in alone.contacts(q))
        assert table.answers[tuple(at)] in ({CONTACT, DOUBT} if touch else {FREE, DOUBT})


def test_no_table_for_bodies_that_more_joints_part(panda: Stand) -> None:
    hulls = panda.arm.hulls
    a, b = hulls.links.index("panda_link1"), hulls.links.index("panda_link5")
    assert hulls.tables.table(a, b, panda.arm.group.joints) is None
    c = hulls.links.index("panda_link3")
    assert hulls.tables.table(a, c, panda.arm.group.joints[:1]) is None


def test_among_occupied_cells_coal_decides(panda: Stand) -> None:
    shape, frame = CellsShape.of(np.array([[0.5, 0.0, 1.0], [0.55, 0.0, 1.0]]), 0.05)
    alone, both = checkers(panda, obstacles=[Obstacle("occupied_space", shape, Pose(position=frame))])
    states = drawn(panda, 300)
    assert (both.look(states) == DOUBT).all()
    alike(alone, both, states)
