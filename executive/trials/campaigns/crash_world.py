"""The mocked robot of the campaign of crashes: a process whose truth and whose deeds outlive it, on disk."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, Literal

from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.actions.gripper import Grip, GripGoal
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.fencing import Grantor
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK, Service
from tandem.skills.ports.message import HandName, Message, RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import WorldState
from tandem.skills.testing.mock_robot import MockRobot

ITEM: Final = 29
ITEMS: Final = {
    ITEM: Pose(position=(0.5, 0.5, 0.74), orientation=from_axes((0, -1, 0), (0, 0, 1), (-1, 0, 0)))
}
SKILL_SECONDS: Final = 0.02
"""Robot seconds of a mocked skill: not 0, so that a crash may fall into one, and short for many runs."""
TICK: Final = 0.01
"""Host seconds between two words of the clock."""
TRUTH: Final = "truth.json"
DEEDS: Final = "deeds.jsonl"


class AskReset(Message):
    """Put everything back to where it was at first."""

    by: str


class Reset(Message):
    """The answer: all is as at the beginning."""

    done: bool = True


RESET: Final = Service("sim/mock/reset", AskReset, Reset)
"""For this campaign's mock only."""


class Truth(Message):
    """What is so, whoever lives or dies."""

    base: FloorPose
    localised: bool
    left: int | None
    right: int | None
    world: WorldState

    @property
    def untouched(self) -> bool:
        """Whether the item is where it was at first."""
        return ITEM not in {self.left, self.right} and all(each.item != ITEM for each in self.world.placed)


class Deed(Message):
    """A line of what the robot did."""

    what: Literal["born", "began", "ended"]
    at: float
    """UTC seconds."""
    action: str = ""
    goal_id: str = ""
    done_before: bool = False
    """Whether world/state said at its beginning that what it was to bring about was so already."""


@dataclass(eq=False)
class LastingRobot:
    """A node: the mocked robot and its clock.

    Args:
        bus: where the executive is.
        clocks: of this process.
        site: what is known beforehand.
        folder: of truth and deeds.
        boot: names this start of the hardware.
    """

    bus: Bus
    clocks: Clocks
    site: Site
    folder: Path
    boot: str
    name: Final = "lasting robot"
    _ticks: int = 0
    _began: float = field(init=False)
    _told_at: float = float("-inf")

    def __post_init__(self) -> None:
        self._grantor = Grantor(self.bus, self.boot, self.clocks.monotonic)
        self._endpoints = Endpoints(
            self.bus,
            self.clocks.monotonic,
            (*self._grantor.endpoints(), answering(RESET, self._reset)),
        )
        self._began = self.clocks.monotonic()
        self.robot = MockRobot(self.bus, self.clocks, self.site, items=ITEMS, duration=SKILL_SECONDS)
        self.robot.watch = self._watch
        self._first = self._truth()
        path = self.folder / TRUTH
        if path.exists():
            self._become(Truth.model_validate_json(path.read_text("utf-8")))
        self._write(Deed(what="born", at=self.clocks.utc()))

    def step(self) -> bool:
        """Tick the clock, answer, work."""
        now = self.clocks.monotonic()
        seconds = now - self._began
        if seconds >= self._ticks * TICK:
            self._ticks = int(seconds / TICK) + 1
            stamp = RobotTime(boot=self.boot, seconds=seconds)
            CLOCK.publish(self.bus, Clock(stamp=stamp, tick=self._ticks))
        self._grantor.step()
        self._endpoints.step()
        if now - self._told_at > 1.0:
            self._told_at = now
            self.robot.tell()
        return self.robot.step()

    def close(self) -> None:
        """End all skills."""
        self.robot.close()
        self._endpoints.close()

    def _reset(self, _: AskReset) -> Reset:
        self._become(self._first)
        self.robot.forget_calls()
        self._keep()
        return Reset()

    def _watch(self, what: str, action: str, goal_id: str, goal: Message) -> None:
        now = self.clocks.utc()
        if what == "began":
            done = _done_before(self.robot.world, action, goal_id, goal)
            self._write(Deed(what="began", at=now, action=action, goal_id=goal_id, done_before=done))
        else:
            self._keep()
            self._write(Deed(what="ended", at=now, action=action, goal_id=goal_id))

    def _truth(self) -> Truth:
        robot = self.robot
        return Truth(
            base=robot.base,
            localised=robot.localised,
            left=robot.hands["left"],
            right=robot.hands["right"],
            world=robot.world,
        )

    def _become(self, truth: Truth) -> None:
        robot = self.robot
        robot.base, robot.localised = truth.base, truth.localised
        robot.hands = {"left": truth.left, "right": truth.right}
        robot.world = truth.world.model_copy(
            update={"version": robot.world.version + truth.world.version + 1}
        )
        robot.tell()

    def _keep(self) -> None:
        beside = self.folder / f"{TRUTH}.new"
        beside.write_text(self._truth().model_dump_json(), "utf-8")
        beside.replace(self.folder / TRUTH)

    def _write(self, deed: Deed) -> None:
        with (self.folder / DEEDS).open("a", encoding="utf-8") as file:
            file.write(f"{deed.model_dump_json()}\n")


def _done_before(world: WorldState, action: str, goal_id: str, goal: Message) -> bool:
    """Say whether it is believed that what a gripper is to bring about is so already."""
    if not isinstance(goal, GripGoal):
        return False
    side: HandName = "left" if "left" in action else "right"
    holds = any(hand.side == side for hand in world.held)
    if goal.grip is Grip.GRASP:
        return holds
    # A hand that is empty may be opened again, to draw it back; what is placed must not be put down again.
    return "/let go/" in goal_id and any(each.item == ITEM for each in world.placed)


def deeds(folder: Path) -> tuple[Deed, ...]:
    """Return what was done, in order; a line torn by a crash is none."""
    lines = (folder / DEEDS).read_text("utf-8").splitlines()
    return tuple(Deed.model_validate_json(line) for line in lines if line.endswith("}"))


def wrong_deeds(done: Iterable[Deed], ended: Callable[[str], float | None]) -> tuple[str, ...]:
    """Return what must not have been done.

    Args:
        done: in order.
        ended: UTC seconds at which a task ended, or None.
    """
    found, begun, at_work = list[str](), set[str](), dict[str, str]()
    for deed in done:
        parts = _parts(deed)
        if deed.what == "born":
            at_work.clear()  # a goal dies with its process
        elif deed.what == "ended":
            at_work = {part: goal for part, goal in at_work.items() if part not in parts}
        else:
            if deed.goal_id in begun:
                found.append(f"{deed.goal_id} was started twice")
            meanwhile = next((at_work[part] for part in parts if part in at_work), "")
            if meanwhile:
                found.append(f"{deed.goal_id} was started while {meanwhile} was under way")
            if deed.done_before:
                found.append(f"{deed.goal_id} was started although what it brings about was so already")
            end = ended(deed.goal_id.partition("/")[0])
            if end is not None and deed.at > end:
                found.append(f"{deed.goal_id} was started after its task had ended")
            begun.add(deed.goal_id)
            at_work |= dict.fromkeys(parts, deed.goal_id)
    return tuple(found)


def _parts(deed: Deed) -> tuple[str, ...]:
    """Return what a deed moves, in which no other may meddle; an action that only looks has itself.

    A hand that holds something, or is about to, goes with its arm. One that is empty may open and close while
    its arm moves, but not twice at once.
    """
    part, _, what = deed.action.partition("/")
    if what in {"survey", "look", "edit"}:
        return (deed.action,)
    side = part.removeprefix("gripper_").removeprefix("arm_")
    if what != "grip":
        return (side,) if side else ()
    empty = any(node in deed.goal_id for node in ("/open/", "/close empty/"))
    return (part,) if empty else (part, side)
