"""The keeper hears what the hands are at: what fell out of one is held no more."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.skills.ports.actions.gripper import HandState, HandStatus, hand_status
from tandem.skills.ports.actions.world import SceneEdit
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.ports.pose import Pose
from tests.skills.world.test_edit import Desk

E = SceneEdit


def tell(desk: Desk, state: HandState, *, side: HandName = "left", ago: float = 0.0, boot: str = "b") -> None:
    stamp = RobotTime(boot=boot, seconds=desk.clocks.seconds - ago)
    status = HandStatus(stamp=stamp, side=side, state=state, width=0.0, force=0.0)
    hand_status(side).publish(desk.bus, status)
    desk.step()


def holds(desk: Desk) -> bool:
    world = desk.world.refresh()
    assert world is not None
    return world.in_hand("left") is not None


def holding(journal: Path | None = None) -> Desk:
    desk = Desk(journal)
    desk.see(29)
    desk.edit(E.ATTACH, 29, side="left", item_in_tool=Pose())
    desk.clocks.advance(0.1)
    desk.step()
    assert holds(desk)
    return desk


def test_what_fell_is_in_no_hand_and_nobody_knows_where(tmp_path: Path) -> None:
    desk = holding(tmp_path / "journal")
    tell(desk, HandState.EMPTY)
    assert not holds(desk)
    world, scene = desk.world.refresh(), desk.scene.refresh()
    assert world is not None
    assert scene is not None
    assert world.item(29) is None
    assert [each for each in scene.objects if each.item == 29] == []
    again = Desk(tmp_path / "journal")
    again.step()
    assert not holds(again), "it was written down"


@pytest.mark.parametrize("state", [HandState.OPEN, HandState.HOLDING])
def test_a_hand_that_is_let_go_or_holds_has_lost_nothing(state: HandState) -> None:
    desk = holding()
    tell(desk, state)
    assert holds(desk)


def test_the_other_hand_does_not_matter() -> None:
    desk = holding()
    tell(desk, HandState.EMPTY, side="right")
    assert holds(desk)


def test_news_from_before_the_grasp_does_not_matter() -> None:
    desk = holding()
    tell(desk, HandState.EMPTY, ago=1.0)
    assert holds(desk)


def test_a_new_boot_of_the_hardware_counts() -> None:
    desk = holding()
    tell(desk, HandState.EMPTY, ago=4.0, boot="c")
    assert not holds(desk)


def test_a_keeper_that_starts_again_believes_the_hand_rather_than_its_journal(tmp_path: Path) -> None:
    holding(tmp_path / "journal").step()
    again = Desk(tmp_path / "journal")
    again.step()
    assert holds(again)
    tell(again, HandState.EMPTY)
    assert not holds(again)


@pytest.mark.parametrize("state", [HandState.OPEN, HandState.EMPTY])
def test_after_another_boot_a_hand_that_holds_nothing_is_empty(tmp_path: Path, state: HandState) -> None:
    """The simulation begins at its scenario's start; a real gripper may have let go without power."""
    desk = after_another_boot(tmp_path)
    tell(desk, HandState.EMPTY, boot="b")
    assert desk.world.refresh() is None, "what was told before says nothing"
    for count in range(8):
        known = desk.world.refresh()
        assert count > 5 or known is None, "what is not known is not told"
        desk.clocks.advance(0.1)
        tell(desk, state, boot="c")
    assert not holds(desk)
    again = Desk(tmp_path / "journal")
    again.clocks.reboot("c")
    again.step()
    assert not holds(again), "it was written down"


def test_after_another_boot_a_hand_that_presses_still_holds(tmp_path: Path) -> None:
    desk = after_another_boot(tmp_path)
    tell(desk, HandState.OPEN, boot="c")
    desk.clocks.advance(0.1)
    tell(desk, HandState.HOLDING, boot="c")
    desk.step()
    assert holds(desk)


def after_another_boot(folder: Path) -> Desk:
    holding(folder / "journal")
    desk = Desk(folder / "journal")
    desk.clocks.reboot("c")
    desk.step()
    return desk
