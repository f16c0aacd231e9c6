"""The whole stand-in: what its reset leaves alone, and pictures that nobody wants."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tandem.sim.camera import Studio
from tandem.sim.render import Done, Job
from tandem.sim.scenario import ScenarioError, load_scenario
from tandem.sim.station import Station, StationSettings
from tandem.sim.things import TrueItem
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus
from tests.sim.rooms import Room


@pytest.fixture
def station() -> Iterator[Station]:
    made = Station(MemoryBus(), load("lab"), load_scenario("Defaults"), StationSettings(boot="b", seed=1))
    yield made
    made.close()


@pytest.mark.parametrize(
    ("update", "said"),
    [
        ({"items": (TrueItem(item=29, support="sofa", x=0.0, y=0.0),)}, "sofa"),
        ({"site": "elsewhere"}, "site: expected lab, found elsewhere"),
    ],
)
def test_a_reset_that_is_refused_changes_nothing(
    station: Station, update: dict[str, object], said: str
) -> None:
    for _ in range(3):
        station.step()
    before = station.truth()
    wrong = load_scenario("Demo").model_copy(update=update)
    with pytest.raises(ScenarioError, match=said):
        station.reset(2, wrong)
    assert station.truth() == before
    assert station.scenario == load_scenario("Defaults")
    station.step()
    assert station.hardware.tick == 4


def test_a_reset_begins_anew_with_the_other_scenario(station: Station) -> None:
    station.step()
    station.reset(2, load_scenario("Demo"))
    assert station.hardware.tick == 0
    assert station.hardware.now.boot == "b.1"
    assert "item_42" in [body.name for body in station.truth().bodies]


class Instant:
    """A renderer whose pictures are empty and there at once."""

    def __init__(self) -> None:
        self.done: list[Done] = []

    def request(self, job: Job) -> None:
        self.done.append(Done(job.number, b"picture"))

    def poll(self) -> Done | None:
        return self.done.pop(0) if self.done else None

    def close(self) -> None:
        """Nothing to end."""


def test_the_picture_that_warms_up_is_not_kept(room: Room) -> None:
    studio = Studio(room.world, (room.robot,), Instant(), noise=room.scenario.noise, seed=1)
    studio.warm_up()
    number = studio.order_photograph((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), 16, 16)
    assert [studio.fetch(number), studio.fetch(number)] == [None, b"picture"]
    assert studio.unfetched == 0
