"""Kill -9 in each phase of a fetch and of a two-armed pick, in the physics, and look at the truth afterwards.

The hardware and the router live on: the one is the world, and nobody can do without the other.
"""

from __future__ import annotations

import os
import random
import signal
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, Literal

from pydantic import JsonValue

from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.trials.campaigns.crash_world import Deed, wrong_deeds
from tandem.executive.trials.demo import truth_of
from tandem.executive.trials.experiments.timeline import Timeline
from tandem.executive.trials.trial import trial
from tandem.sim.scenario import load_scenario
from tandem.sim.scene import item_name
from tandem.sim.truth import Truth, lies_on
from tandem.skills.ports.action import GoalStatus, node_of
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import HandName, Message, RobotTime
from tandem.skills.ports.world import WORLD, WorldState
from tandem.skills.site import load

Kind = Literal["fetch", "pick_two"]
ITEM: Final = 29
RIGHT_ITEM: Final = 42
DEPOT: Final = "depot"
REQUESTS: Final[dict[Kind, dict[str, JsonValue]]] = {
    "fetch": {"task": "fetch", "item": ITEM, "to": DEPOT, "arm": "left"},
    "pick_two": {"task": "pick_two", "left": ITEM, "right": RIGHT_ITEM},
}
SCENARIOS: Final[dict[Kind, str]] = {"fetch": "Demo", "pick_two": "TwoArms"}
DELAY: Final = (0.0, 0.6)
"""Robot seconds after a leaf's begin at which the kill is drawn."""
TASK_WITHIN: Final = 900.0
"""Robot seconds."""


@dataclass(frozen=True)
class Moment:
    """A leaf of a task's tree, and whose process works for it."""

    kind: Kind
    phase: str
    leaf: str
    skill: str


MOMENTS: Final = (
    Moment("fetch", "request", "localise", "base"),
    Moment("fetch", "search", "look here", "perception"),
    Moment("fetch", "pick", "grasp", "arm_left"),
    Moment("fetch", "place", "put down", "arm_left"),
    Moment("fetch", "home", "home: drive", "base"),
    Moment("pick_two", "request", "look at table", "perception"),
    Moment("pick_two", "approach", "left arm: approach", "arm_left"),
    Moment("pick_two", "grasp", "left arm: grasp", "arm_left"),
    Moment("pick_two", "lift", "right arm: lift", "arm_right"),
    Moment("pick_two", "to safety", "right arm: to safety", "arm_right"),
)
OTHERS: Final[tuple[str, ...]] = ("keeper", "bimanual", "perception")


class PhysicsRun(Message):
    """One run, and what was wrong with it: nothing, as a rule."""

    run: int
    kind: Kind
    phase: str
    leaf: str
    victim: str
    after: float
    """Robot seconds after the leaf's begin."""
    killed_at: float | None
    """Robot seconds; None: the leaf never ran."""
    state: str
    begun: int = 0
    """How often the tree began."""
    seconds: float = 0.0
    """Robot seconds from the request to the end."""
    failure: Failure | None = None
    wrong: tuple[str, ...] = ()


class PhysicsCampaign(Message):
    """All of it, for the report."""

    seed: int
    right: int
    runs: tuple[PhysicsRun, ...]


def physics_runs(
    folder: Path, endpoint: str, runs: int, seed: int, *, first: int = 0, speed: float | None = 1.0
) -> Iterator[PhysicsRun]:
    """Yield runs, each in a system of its own.

    The moments are gone through in turn: the executive is killed in the first round, the process at work in
    the second, and one of the others in each that follows.
    """
    for run in range(first, first + runs):
        moment = MOMENTS[run % len(MOMENTS)]
        draw = random.Random(f"{seed}/{run}")  # noqa: S311 - no secret
        rounds = run // len(MOMENTS)
        victim: str = "executive" if rounds == 0 else moment.skill if rounds == 1 else draw.choice(OTHERS)
        options = RunOptions(
            bus=BusOptions(endpoint=endpoint, site="crash"),
            scenario=SCENARIOS[moment.kind],
            seed=seed * 1000 + run,
            speed=speed,
            data=folder / str(run),
        )
        yield _one_run(options, run, moment, victim, round(draw.uniform(*DELAY), 3))


def _one_run(options: RunOptions, run: int, moment: Moment, victim: str, after: float) -> PhysicsRun:
    with ProcessSystem(options) as system:
        killer = Killer(system, moment, victim, after)
        made = trial(system, REQUESTS[moment.kind], within=TASK_WITHIN, also=killer)
        wrong: list[str] = []
        if made.status is not None:
            wrong += wrong_in_truth(moment.kind, truth_of(system), options.scenario)
        killer.close()
    if not made.succeeded:
        wrong.append(f"{made.task} ended as {made.state}")
    if killer.killed_at is None:
        wrong.append(f"'{moment.leaf}' never ran: nobody was killed")
    wrong += wrong_deeds(killer.deeds, lambda _: None)
    return PhysicsRun(
        run=run,
        kind=moment.kind,
        phase=moment.phase,
        leaf=moment.leaf,
        victim=victim,
        after=after,
        killed_at=killer.killed_at,
        state=made.state,
        begun=0 if made.status is None else made.status.begun,
        seconds=made.lasted,
        failure=made.failure,
        wrong=tuple(wrong),
    )


def wrong_in_truth(kind: Kind, truth: Truth, scenario: str) -> tuple[str, ...]:
    """Return what is not where the task should have brought it."""
    if kind == "fetch":
        lies = lies_on(truth, load(load_scenario(scenario).site), ITEM, DEPOT)
        return () if lies else (f"item {ITEM} does not lie in the {DEPOT}",)
    hands: tuple[tuple[HandName, int], ...] = (("left", ITEM), ("right", RIGHT_ITEM))
    return tuple(
        f"item {item} is not in the {side} hand alone: it touches {', '.join(touched) or 'nothing'}"
        for side, item in hands
        if not _in_hand(side, touched := truth.touching(item_name(item)))
    )


def _in_hand(side: HandName, touched: tuple[str, ...]) -> bool:
    return bool(touched) and all(each.startswith(f"robot/gripper_{side}_") for each in touched)


@dataclass(eq=False)
class Killer:
    """Kills once, some time after a leaf began, and notes what the skills were at; step it along.

    Args:
        system: whose process.
        moment: the leaf.
        victim: the process.
        after: robot seconds after the leaf's begin.
    """

    system: ProcessSystem
    moment: Moment
    victim: str
    after: float
    killed_at: float | None = None
    deeds: list[Deed] = field(default_factory=list)
    name: Final = "killer"

    def __post_init__(self) -> None:
        """Listen."""
        bus = self.system.bus
        self._timeline = Timeline(bus, self.system.clocks)
        self._world, self._beliefs = Latest(bus, WORLD, depth=1024), list[WorldState]()
        self._statuses = Heard(bus, "skill/*/*/status", GoalStatus.model_validate_json, depth=4096)
        self._open: set[str] = set()

    def step(self) -> bool:
        """Take in what was told; kill when the time has come."""
        self._timeline.step()
        self._beliefs += self._world.take()
        self._note_goals()
        span = next(iter(self._timeline.of(self.moment.leaf)), None)
        now = robot_seconds(self.system.clocks)
        if self.killed_at is None and span is not None and now - span.begin >= self.after:
            os.kill(self.system.pids()[self.victim], signal.SIGKILL)
            self.killed_at = round(now, 2)
            if self.victim != "executive":
                self.deeds.append(Deed(what="born", at=_at(self.system.clocks.robot())))
        return False

    def close(self) -> None:
        """Stop listening."""
        self._timeline.close()
        self._world.close()
        self._statuses.close()

    def _note_goals(self) -> None:
        told = [
            (key.removeprefix("skill/").removesuffix("/status"), status)
            for key, status, _ in self._statuses.take()
        ]
        told.sort(key=lambda each: _at(each[1].stamp))
        for action, status in told:
            at = _at(status.stamp)
            goal = status.goal_id
            if status.state.terminal and goal in self._open:
                self._open.discard(goal)
                self.deeds.append(Deed(what="ended", at=at, action=action, goal_id=goal))
            elif not status.state.terminal and goal not in self._open:
                self._open.add(goal)
                done = self._done_before(goal, at)
                self.deeds.append(Deed(what="began", at=at, action=action, goal_id=goal, done_before=done))

    def _done_before(self, goal_id: str, at: float) -> bool:
        """Say whether it was believed at that time that what a hand is to bring about was so already."""
        node = node_of(goal_id)
        world = next((each for each in reversed(self._beliefs) if _at(each.stamp) < at), None)
        if world is None:
            return False
        if node.endswith("close"):
            side: HandName = "right" if node.startswith("right") else "left"
            return world.in_hand(side) is not None
        return node == "let go" and any(each.item == ITEM for each in world.placed)


def _at(stamp: RobotTime | None) -> float:
    """Return the robot seconds of a stamp: the hardware of a run is started once."""
    return 0.0 if stamp is None else stamp.seconds


def _quiet(_: str) -> None:
    """Tell nobody."""
