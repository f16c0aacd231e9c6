"""Routes left and right of somebody are kept and compared; old bands are carried on."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.base.band.elastic import Elastic
from tandem.skills.base.band.limits import Begin
from tandem.skills.base.band.routes import along, carried
from tandem.skills.ports.pose import FloorPose
from tests.skills.base.band.tasks import WAY, done, task
from tests.skills.base.people.test_keeping_away import track

STANDS = track(1.1, 0.0, 0.0, 0.0)


def test_both_ways_round_somebody_are_kept_and_the_cheaper_one_is_taken() -> None:
    elastic = Elastic()
    made = task(track(1.1, 0.08, 0.0, 0.0))
    route = done(elastic.plan(made, WAY, 0.0))
    assert route is not None
    sides = {np.sign(each.band.poses[0, 7, 1]) for each in elastic.routes}
    assert sides == {-1.0, 1.0}
    assert route.band.poses[0, 7, 1] < 0.0
    assert route.price == min(each.price for each in elastic.routes)


def test_a_route_is_not_left_for_one_that_is_hardly_cheaper() -> None:
    elastic = Elastic()
    first = done(elastic.plan(task(track(1.1, 0.03, 0.0, 0.0)), WAY, 0.0))
    second = done(elastic.plan(task(track(1.1, -0.03, 0.0, 0.0)), WAY, 0.0))
    assert first is not None
    assert second is not None
    assert second.name == first.name
    # ... but for one that is much cheaper it is.
    third = done(elastic.plan(task(track(1.1, -0.45, 0.0, 0.0)), WAY, 0.0))
    assert third is not None
    assert third.band.poses[0, 7, 1] > 0.0


def test_without_a_way_there_is_no_route() -> None:
    # Somebody comes straight on and is there before the base could be out of the way.
    assert done(Elastic().plan(task(track(1.3, 0.0, -1.2, 0.0)), WAY, 0.0)) is None


def test_alone_there_is_one_route() -> None:
    elastic = Elastic()
    assert done(elastic.plan(task(), WAY, 0.0)) is not None
    assert len(elastic.routes) == 1


def test_a_band_is_carried_on_from_where_the_base_is() -> None:
    old = along(WAY, task())
    begin = Begin(FloorPose(x=0.3, y=0.02, yaw=0.1), 0.5, 0.0)
    on = carried(old, 0.5, begin, np.array([[2.1, 0.0], [2.2, 0.0]]), 0.7)
    assert on is not None
    assert on.poses[0, 0] == pytest.approx((0.3, 0.02, 0.1))
    assert on.poses[0, -1, :2] == pytest.approx((2.2, 0.0))
    assert on.lasts[0] == pytest.approx(old.lasts[0] - 0.5 + 0.2 / 0.7)
    assert carried(old, 30.0, begin, np.empty((0, 2)), 0.7) is None


def test_what_is_no_number_gives_no_route() -> None:
    assert done(Elastic().plan(task(linear=float("nan")), WAY, 0.0)) is None
    assert done(Elastic().plan(task(), WAY * float("nan"), 0.0)) is None
