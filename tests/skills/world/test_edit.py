"""Edits over the bus: what is refused, what is done, and what a restart brings back."""

from pathlib import Path

import pytest

from tandem.skills import site
from tandem.skills.ports.action import (
    AskResult,
    GoalState,
    GoalStatus,
    SendGoal,
    goal_service,
    result_service,
)
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.actions.world import EditGoal, SceneEdit
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.node import Node
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import SCENE, SIGHTINGS, WORLD, Sightings
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.world.process import nodes
from tests.fakes.full_disk import full_at
from tests.skills.world.facts import at, sighting, tag

LAB = site.load("lab")
POSE = Pose(position=(-2.6, -1.1, 0.74))
K, E = FailureKind, SceneEdit


class Desk:
    """The world's process in memory, and a client of it."""

    def __init__(self, journal: Path | None = None, boot: str = "b") -> None:
        self.bus = MemoryBus()
        self.clocks = SteppedClocks(boot)
        self.clocks.advance(5.0)
        self.world = Latest(self.bus, WORLD)
        self.scene = Latest(self.bus, SCENE)
        self.nodes: tuple[Node, ...] = nodes(self.bus, self.clocks, LAB, PAIR, journal)
        self.sent = 0

    def see(self, item: int) -> None:
        SIGHTINGS.publish(
            self.bus,
            Sightings(stamp=at(5.0), sightings=(sighting(item, tag(0.6, 0.5), self.clocks.seconds),)),
        )
        self.step()

    def step(self) -> None:
        for node in self.nodes:
            node.step()
        self.clocks.advance(0.01)

    def edit(self, edit: SceneEdit, item: int, **parts: object) -> GoalStatus:
        self.sent += 1
        goal = EditGoal.model_validate({"edit": edit, "item": item, **parts})
        sent = SendGoal(goal_id=f"t/e/{self.sent}", client="", goal=goal.model_dump(mode="json"))
        pending = goal_service("world/edit").query(self.bus, sent)
        for _ in range(3):
            self.step()
        payload = pending.poll()
        assert payload is not None
        status = GoalStatus.model_validate_json(payload)
        if status.state is GoalState.REJECTED:
            return status
        asked = result_service("world/edit").query(self.bus, AskResult(goal_id=sent.goal_id))
        self.step()
        payload = asked.poll()
        assert payload is not None
        return GoalStatus.model_validate_json(payload)


@pytest.mark.parametrize(
    ("edit", "item", "parts", "kind"),
    [
        (E.ADD, 999, {}, K.ITEM_UNKNOWN),
        (E.ADD, 42, {}, K.NOT_READY),
        (E.ATTACH, 29, {"side": "left"}, K.INVALID_GOAL),
        (E.ATTACH, 29, {"side": "left", "item_in_tool": Pose()}, K.HAND_FULL),
        (E.ATTACH, 7, {"side": "right", "item_in_tool": Pose()}, K.INVALID_GOAL),
        (E.DETACH, 29, {"item_in_map": POSE}, K.INVALID_GOAL),
        (E.DETACH, 7, {"item_in_map": POSE, "depot": "depot"}, K.INVALID_GOAL),
        (E.DETACH, 7, {"item_in_map": POSE, "depot": "moon", "slot": 0}, K.DESTINATION_UNKNOWN),
        (E.DETACH, 7, {"item_in_map": POSE, "depot": "depot", "slot": 99}, K.INVALID_GOAL),
        (E.DETACH, 7, {"item_in_map": POSE, "depot": "depot", "slot": 1}, K.DESTINATION_FULL),
        (E.DETACH, 7, {"item_in_map": POSE, "side": "right"}, K.INVALID_GOAL),
        (E.REMOVE, 7, {}, K.INVALID_GOAL),
        (E.FORGET, 7, {}, K.INVALID_GOAL),
        (E.FORGET, 999, {}, K.ITEM_UNKNOWN),
    ],
)
def test_what_contradicts_what_is_believed_is_refused(
    edit: SceneEdit, item: int, parts: dict[str, object], kind: FailureKind
) -> None:
    """Item 7 is in the left hand, item 11 in slot 1, item 42 was never seen."""
    desk = Desk()
    desk.see(29)
    desk.edit(E.ATTACH, 11, side="left", item_in_tool=Pose())
    desk.edit(E.DETACH, 11, item_in_map=POSE, depot="depot", slot=1)
    desk.edit(E.ATTACH, 7, side="left", item_in_tool=Pose())
    status = desk.edit(edit, item, **parts)
    assert status.state is GoalState.REJECTED
    assert status.failure is not None
    assert status.failure.kind is kind


def test_a_pick_and_a_place_in_edits() -> None:
    desk = Desk()
    desk.see(29)
    assert desk.edit(E.ADD, 29).state is GoalState.SUCCEEDED
    assert desk.edit(E.ATTACH, 29, side="left", item_in_tool=Pose()).state is GoalState.SUCCEEDED
    world, scene = desk.world.refresh(), desk.scene.refresh()
    assert world is not None
    assert scene is not None
    held = world.in_hand("left")
    assert held is not None
    assert held.item == 29
    assert [each.attached_to for each in scene.objects if each.kind == "item"] == ["left"]
    placed = {"item_in_map": POSE, "depot": "depot", "slot": 0}
    assert desk.edit(E.DETACH, 29, **placed).state is GoalState.SUCCEEDED
    assert desk.edit(E.DETACH, 29, **placed).state is GoalState.SUCCEEDED, "the same once more"
    assert desk.edit(E.REMOVE, 29).state is GoalState.SUCCEEDED
    world, scene = desk.world.refresh(), desk.scene.refresh()
    assert world is not None
    assert scene is not None
    assert (world.held, [each.slot for each in world.placed]) == ((), [0])
    assert [each for each in scene.objects if each.kind == "item"] == []


def test_what_is_forgotten_is_nowhere_until_it_is_seen_again() -> None:
    desk = Desk()
    desk.see(29)
    assert desk.edit(E.FORGET, 29).state is GoalState.SUCCEEDED
    assert desk.edit(E.FORGET, 29).state is GoalState.SUCCEEDED, "the same once more"
    world, scene = desk.world.refresh(), desk.scene.refresh()
    assert world is not None
    assert scene is not None
    assert world.item(29) is None
    assert [each for each in scene.objects if each.kind == "item"] == []
    desk.see(29)
    seen = desk.world.refresh()
    assert seen is not None
    assert seen.item(29) is not None


def test_what_is_forgotten_lies_in_no_slot(tmp_path: Path) -> None:
    desk = Desk(tmp_path / "journal")
    desk.edit(E.ATTACH, 11, side="right", item_in_tool=Pose())
    desk.edit(E.DETACH, 11, item_in_map=POSE, depot="depot", slot=1)
    desk.edit(E.FORGET, 11)
    second = Desk(tmp_path / "journal")
    second.step()
    for each in (desk, second):
        world = each.world.refresh()
        assert world is not None
        assert (world.placed, world.items) == ((), ())


def test_a_restart_brings_back_what_no_sensor_can(tmp_path: Path) -> None:
    first = Desk(tmp_path / "journal")
    first.edit(E.ATTACH, 11, side="right", item_in_tool=Pose())
    first.edit(E.DETACH, 11, item_in_map=POSE, depot="depot", slot=1)
    first.edit(E.ATTACH, 29, side="left", item_in_tool=Pose(position=(0.01, 0, 0)))
    second = Desk(tmp_path / "journal")
    second.step()
    world = second.world.refresh()
    assert world is not None
    held = world.in_hand("left")
    assert held is not None
    assert (held.item, held.item_in_tool.position) == (29, (0.01, 0, 0))
    assert [(each.item, each.slot) for each in world.placed] == [(11, 1)]
    fact = world.item(11)
    assert fact is not None
    assert fact.tag_in_map.position == pytest.approx((-2.57, -1.1, 0.74))


def test_latecomers_hear_the_facts_within_a_second() -> None:
    desk = Desk()
    desk.step()
    desk.world.take()
    for _ in range(101):
        desk.step()
    assert len(desk.world.take()) == 1


@pytest.mark.parametrize(("boot", "known"), [("b", [29]), ("c", [])])
def test_what_the_camera_saw_outlives_the_keeper_but_not_the_hardwares_boot(
    tmp_path: Path, boot: str, known: list[int]
) -> None:
    Desk(tmp_path / "journal").see(29)
    again = Desk(tmp_path / "journal", boot)
    again.step()
    world, scene = again.world.refresh(), again.scene.refresh()
    assert world is not None
    assert scene is not None
    assert [fact.item for fact in world.items] == known
    assert [each.item for each in scene.objects if each.kind == "item"] == known


@pytest.mark.parametrize(("boot", "placed"), [("b", [29]), ("c", [])])
def test_what_lies_in_a_slot_outlives_the_keeper_but_not_the_hardwares_boot(
    tmp_path: Path, boot: str, placed: list[int]
) -> None:
    """Believed over a boot, a simulated room that begins anew had its items delivered before anyone moved."""
    desk = Desk(tmp_path / "journal")
    desk.edit(E.ATTACH, 29, side="left", item_in_tool=Pose())
    desk.edit(E.DETACH, 29, side="left", item_in_map=POSE, depot="depot", slot=0)
    again = Desk(tmp_path / "journal", boot)
    again.step()
    world = again.world.refresh()
    assert world is not None
    assert [each.item for each in world.placed] == placed


def test_what_is_in_a_hand_outlives_the_keeper(tmp_path: Path) -> None:
    """``test_hands`` has what becomes of it over another boot of the hardware: the hand itself must tell."""
    Desk(tmp_path / "journal").edit(E.ATTACH, 29, side="left", item_in_tool=Pose())
    again = Desk(tmp_path / "journal")
    again.step()
    world = again.world.refresh()
    assert world is not None
    assert [(each.side, each.item) for each in world.held] == [("left", 29)]


def test_who_comes_late_is_told_at_once() -> None:
    desk = Desk()
    desk.step()
    desk.step()
    desk.world.take()
    desk.step()
    assert not desk.world.take(), "nothing has changed"
    desk.bus.announce("executive")
    desk.step()
    assert len(desk.world.take()) == 1


def test_on_a_full_disk_an_edit_has_not_happened_and_what_is_held_stays_believed(tmp_path: Path) -> None:
    desk = Desk(tmp_path / "journal")
    desk.edit(E.ATTACH, 29, side="left", item_in_tool=Pose())
    with full_at(0):
        refused = desk.edit(E.DETACH, 29, side="left", item_in_map=POSE, depot="depot", slot=0)
        desk.see(42)
    assert refused.failure is not None
    assert refused.failure.kind is K.NOT_STORED
    world = desk.world.refresh()
    assert world is not None
    assert [each.item for each in world.held] == [29]
    assert 42 in [each.item for each in world.items]
    assert desk.edit(E.DETACH, 29, side="left", item_in_map=POSE).state is GoalState.SUCCEEDED


def test_what_was_seen_while_the_disk_was_full_is_written_once_there_is_space(tmp_path: Path) -> None:
    desk = Desk(tmp_path / "journal")
    with full_at(0):
        desk.see(29)
    for _ in range(110):
        desk.step()
    again = Desk(tmp_path / "journal")
    again.step()
    world = again.world.refresh()
    assert world is not None
    assert [each.item for each in world.items] == [29]
