"""The sim's own controls: things are put, moved and taken away, and what is wrong is answered."""

from __future__ import annotations

import json

import pytest

from tandem.sim.camera import Studio
from tandem.sim.controls import FAULT, MOVE, PHOTOGRAPH, PLACE_ITEM, PLACE_OBSTACLE, REMOVE, RESET, Controls
from tandem.sim.faults import CameraDark, Fault
from tandem.sim.render import Done, Job
from tandem.sim.scenario import Scenario
from tandem.sim.truth import TRUTH, Truth, lies_on
from tandem.skills.ports.hardware import Answer
from tandem.skills.wire.memory import MemoryBus
from tests.sim.rooms import Room, at


class FakeRenderer:
    """Answers each job with its view's size."""

    def __init__(self) -> None:
        self.done: list[Done] = []

    def request(self, job: Job) -> None:
        self.done.append(Done(job.number, f"{job.view.width}x{job.view.height}".encode()))

    def poll(self) -> Done | None:
        return self.done.pop(0) if self.done else None

    def close(self) -> None:
        pass


class Asking:
    """Asks the controls something and returns the answer's bytes."""

    def __init__(self, room: Room) -> None:
        self.resets: list[int] = []
        self._bus = MemoryBus()
        studio = Studio(room.world, (room.robot,), FakeRenderer(), noise=room.scenario.noise, seed=1)
        self.faults: list[Fault] = []
        self._controls = Controls(
            self._bus, room.site, room.world, room.robot, studio, reset=self._reset, fault=self._fault
        )

    def __call__(self, key: str, document: object) -> bytes:
        text = document if isinstance(document, bytes) else json.dumps(document).encode()
        pending = self._bus.query(key, text)
        self._controls.step(at(1.0))
        answer = pending.poll()
        assert answer is not None
        return answer

    def _fault(self, fault: Fault) -> Answer:
        self.faults.append(fault)
        return Answer(accepted=True)

    def _reset(self, seed: int, scenario: Scenario | None) -> None:
        assert scenario is None
        self.resets.append(seed)


@pytest.fixture
def ask(room: Room) -> Asking:
    return Asking(room)


def accepted(answer: bytes) -> Answer:
    return Answer.model_validate_json(answer)


def test_an_item_is_placed_on_its_support(room: Room, ask: Asking) -> None:
    assert accepted(ask(PLACE_ITEM.key, {"item": 29, "support": "depot", "x": -2.5, "y": -1.2})).accepted
    room.world.settle()
    truth = Truth.model_validate_json(ask(TRUTH.key, {}))
    assert lies_on(truth, room.site, 29, "depot")
    assert not lies_on(truth, room.site, 42, "depot")
    assert truth.item(29).pose.position == pytest.approx((-2.5, -1.2, 0.74), abs=0.002)
    assert "depot.0" in truth.touching("item_29")


def test_what_was_written_up_to_release_0_1_0_says_tag(ask: Asking) -> None:
    assert accepted(ask(PLACE_ITEM.key, {"tag": 29, "support": "depot", "x": -2.5, "y": -1.2})).accepted
    told = Truth.model_validate_json(ask(TRUTH.key, {}))
    before = told.model_dump_json().replace('"item":', '"tag":')
    assert Truth.model_validate_json(before) == told


def test_an_obstacle_is_placed_moved_and_removed(room: Room, ask: Asking) -> None:
    box = {"name": "suitcase", "shape": {"kind": "box", "size": [0.3, 0.2, 0.5]}, "x": 0.0, "y": -2.0}
    assert accepted(ask(PLACE_OBSTACLE.key, box)).accepted
    pose = {"position": [0.5, -2.0, 0.25], "orientation": [0, 0, 0, 1]}
    assert accepted(ask(MOVE.key, {"name": "suitcase", "pose": pose})).accepted
    assert room.world.pose("suitcase").position == pytest.approx((0.5, -2.0, 0.25))
    assert accepted(ask(REMOVE.key, {"name": "suitcase"})).accepted
    assert "suitcase" not in room.world.movable()


@pytest.mark.parametrize(
    ("key", "document", "said"),
    [
        (PLACE_ITEM.key, b"{", "a JSON object with"),
        (PLACE_ITEM.key, {"item": 500, "support": "table", "x": 1, "y": 0.5}, "knows no item 500"),
        (PLACE_ITEM.key, {"item": 29, "support": "sofa", "x": 1, "y": 0.5}, "no furniture 'sofa'"),
        (REMOVE.key, {"name": "nothing"}, "nothing movable is called 'nothing'"),
        (MOVE.key, {"name": "mug", "pose": {"position": [0, 0]}}, "pose.position"),
        (RESET.key, {"seed": -1}, "seed"),
        (FAULT.key, {"fault": {"kind": "camera_blue"}}, "camera_dark"),
        (PHOTOGRAPH.key, {"eye": [0, 0, 3], "target": [0, 0, 0]}, "differ in x or y"),
        (PLACE_ITEM.key, b" " * 70000, "at most 65536 bytes"),
    ],
)
def test_what_is_wrong_is_answered(room: Room, ask: Asking, key: str, document: object, said: str) -> None:
    revision = room.world.revision
    answer = accepted(ask(key, document))
    assert not answer.accepted
    assert said in answer.reason
    assert room.world.revision == revision


def test_a_reset_is_passed_on_with_its_seed(ask: Asking) -> None:
    assert accepted(ask(RESET.key, {"seed": 7})).accepted
    assert ask.resets == [7]


def test_a_fault_is_passed_on(ask: Asking) -> None:
    assert accepted(ask(FAULT.key, {"fault": {"kind": "camera_dark", "lasts": 2}})).accepted
    assert ask.faults == [CameraDark(lasts=2.0)]


def test_a_photograph_is_answered_with_its_picture(ask: Asking) -> None:
    assert ask(PHOTOGRAPH.key, {"width": 64, "height": 32}) == b"64x32"
