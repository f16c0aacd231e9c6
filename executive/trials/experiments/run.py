"""One run of an experiment, in lockstep, from its draw to its verdict; success is read from the truth."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from pydantic import JsonValue

from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.experiments.draws import Step, draw_run, scenario_of
from tandem.executive.trials.experiments.mover import Moved, Mover
from tandem.executive.trials.experiments.settings import CARTON, LEFT, RIGHT, Options
from tandem.executive.trials.experiments.timeline import Span, Timeline
from tandem.executive.trials.experiments.witness import Touch, Witness, lean, tilt
from tandem.executive.trials.trial import trial, warm_up
from tandem.skills.ports.actions.bimanual import PAIR, RIGHT_OF_WAY
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import HandName, Message, Vector3
from tandem.skills.ports.site import Site, SiteItem
from tandem.skills.ports.tasks import TaskState
from tandem.skills.site import load

TASK_WITHIN: Final = 240.0
"""Robot seconds for one routine: the thesis's took that long."""
WATCHED_FOR: Final = 0.5
"""Robot seconds for which what is held must be steady in the end."""
STEADY: Final = 0.005
"""Metres by which it may move in them."""
LIFTED: Final = 0.05
"""Metres above where it stood."""
LEVEL: Final = math.radians(3.0)
"""Of the carton. A cube in two fingers may turn a little about them, and has no face that must be up:"""
CUBE_LEVEL: Final = math.radians(10.0)


class ArmRun(Message):
    """What one arm came to."""

    apf: bool | None
    """Whether the field brought it to its proximity pose; None for a method without a field."""
    rrtconnect: bool
    """Whether the motion of the grasp was planned and made."""
    pick: bool
    """Whether, in truth, the item was held, lifted, steady and level."""
    apf_s: float | None = None
    pick_s: float | None = None
    home_s: float | None = None
    """Robot seconds: to the proximity pose; grasping and lifting; back to the safe zone."""
    follows: int = 0
    """How often the grasp was given up because the item had moved."""
    offset: Vector3 | None = None
    """The finger tips' place from the grasp point at the squeeze, in the item's axes (m)."""
    lying: bool = False
    """Whether a cube was picked as it lay: knocked over onto another face than it stood on."""
    path: tuple[Vector3, ...] = ()
    """Of the tool frame in the map (m), ten points a second."""


class ExperimentRun(Message):
    """One run."""

    run: int
    position: int
    state: str
    failure: Failure | None
    moved: tuple[Moved, ...]
    touches: tuple[Touch, ...]
    left: ArmRun
    right: ArmRun
    total_s: float
    """Robot seconds from when the arms may move to when both are back."""
    stops: int
    """How often the coordination stopped the arms."""
    tilt: float = 0.0
    """Largest in truth while lifted (rad)."""

    @property
    def arms(self) -> tuple[ArmRun, ArmRun]:
        """Left and right."""
        return self.left, self.right


class Experiment(Message):
    """All runs of one experiment: what ``--report`` writes."""

    options: Options
    runs: tuple[ExperimentRun, ...]


def run_experiment(options: Options, run: int) -> ExperimentRun:
    """Draw and make run number ``run``; the same options and number give the same run."""
    draw = draw_run(options.kind, options.series, run, np.random.default_rng((options.seed, run)))
    scenario = scenario_of(options.kind, draw)
    system = LockstepSystem(scenario, options.seed * 1000 + run)
    try:
        return _Running(system, load(scenario.site), options).make(run, draw.position, draw.steps)
    finally:
        system.close()


class _Running:
    def __init__(self, system: LockstepSystem, site: Site, options: Options) -> None:
        self._system, self._options = system, options
        self._items = {
            side: _known(site, number)
            for side, number in zip(
                PAIR, (CARTON, CARTON) if options.kind == "coordinated" else (LEFT, RIGHT), strict=True
            )
        }
        self._timeline = Timeline(system.bus, system.clocks)
        things = tuple(dict.fromkeys(self._items.values()))
        self._witness = Witness(system.lockstep.station, things)
        self._offsets: dict[HandName, Vector3] = {}
        self._mover: Mover | None = None
        self._rule, self._stops = Latest(system.bus, RIGHT_OF_WAY), 0

    name = "experiment"

    def make(self, run: int, position: int, steps: tuple[Step, ...]) -> ExperimentRun:
        """Make it."""
        system = self._system
        warm_up(system)
        self._mover = Mover(system.bus, system.clocks, self._timeline, steps, self._options.series)
        made = trial(system, self._request(), within=TASK_WITHIN, also=self)
        picks = self._picks(made.state)
        return ExperimentRun(
            run=run,
            position=position,
            state=made.state,
            failure=made.failure,
            moved=tuple(self._mover.moved),
            touches=tuple(self._witness.touches),
            left=self._arm("left", picks["left"]),
            right=self._arm("right", picks["right"]),
            total_s=self._total(),
            stops=self._stops,
            tilt=round(max(self._witness.tilts.values(), default=0.0), 4),
        )

    def step(self) -> bool:
        """Look on while the task runs."""
        assert self._mover is not None, "it is made before"
        self._timeline.step()
        self._mover.step()
        self._witness.step()
        rule = self._rule.refresh()
        self._stops = self._stops if rule is None else max(self._stops, rule.episode)
        if not self._offsets and self._timeline.succeeded("both hands: squeeze") is not None:
            self._offsets = {side: self._witness.offset(side, self._items[side]) for side in PAIR}
        return False

    def close(self) -> None:
        """Stop listening."""
        self._timeline.close()
        self._rule.close()

    def _request(self) -> dict[str, JsonValue]:
        how: dict[str, JsonValue] = {"method": self._options.method, "mode": self._options.mode}
        if self._options.kind == "coordinated":
            return {"task": "pick_both_hands", "item": CARTON, **how}
        how["sequential"] = self._options.sequential
        return {"task": "pick_two", "left": LEFT, "right": RIGHT, **how}

    def _picks(self, state: str) -> dict[HandName, bool]:
        """Say for each hand whether the pick was right, in truth, and stays so for a while."""
        if self._options.kind == "coordinated":
            item = self._items["left"].item
            lifted = self._witness.heights.get(item, 0.0) >= LIFTED
            level = self._witness.tilts.get(item, math.inf) <= LEVEL
            above = self._witness.pose(item).position[2] - self._items["left"].size[2] / 2 - TABLE
            down = abs(above) < STANDS
            right = state == TaskState.SUCCEEDED.value and lifted and level and down
            return {"left": right, "right": right}
        before = {side: self._witness.pose(each.item) for side, each in self._items.items()}
        held = {side: self._witness.held_by(side, each.item) for side, each in self._items.items()}
        until = robot_seconds(self._system.clocks) + WATCHED_FOR
        while robot_seconds(self._system.clocks) < until:
            self._system.advance()
        return {
            side: held[side]
            and self._witness.held_by(side, each.item)
            and self._witness.heights.get(each.item, 0.0) >= LIFTED
            and math.dist(before[side].position, self._witness.pose(each.item).position) < STEADY
            and lean(self._witness.pose(each.item)) <= CUBE_LEVEL
            for side, each in self._items.items()
        }

    def _arm(self, side: HandName, pick: bool) -> ArmRun:  # noqa: FBT001 - one of its columns
        who, timeline = f"{side} arm", self._timeline
        field = timeline.succeeded(f"{who}: approach")
        near = field or timeline.succeeded(f"{who}: plan before item")
        grasp, lift, safe = (
            timeline.succeeded(leaf) for leaf in (f"{who}: grasp", f"{who}: lift", f"{who}: to safety")
        )
        first = next(iter((*timeline.of(f"{who}: approach"), *timeline.of(f"{who}: plan before item"))), None)
        grasps = timeline.of(f"{who}: grasp")
        return ArmRun(
            apf=field is not None if self._options.method == "apf_rrtconnect" else None,
            rrtconnect=grasp is not None,
            pick=pick,
            apf_s=_between(first, near),
            pick_s=_between(grasp, lift),
            home_s=_between(safe, safe),
            follows=max(0, len(grasps) - 1),
            offset=self._offsets.get(side),
            lying=pick and tilt(self._witness.pose(self._items[side].item)) > LYING,
            path=tuple((round(x, 4), round(y, 4), round(z, 4)) for x, y, z in self._witness.paths[side]),
        )

    def _total(self) -> float:
        whose = ("left arm", "right arm", "both")
        arms = [span for span in self._timeline.spans if span.leaf.startswith(whose)]
        ends = [span.end for span in arms if span.end is not None]
        return round(max(ends) - min(span.begin for span in arms), 2) if ends else 0.0


LYING: Final = math.radians(45.0)
"""Radians by which a cube that has been knocked over leans: half-way to its side."""
STANDS: Final = 0.01
"""Metres by which the carton's underside may be off the table in the end."""
TABLE: Final = 0.71
"""Metres: the height of the table."""


def _known(site: Site, number: int) -> SiteItem:
    item = site.item(number)
    assert item is not None, f"site {site.name} has item {number}"
    return item


def _between(first: Span | None, last: Span | None) -> float | None:
    """Return the seconds from the first's begin to the last's end."""
    if first is None or last is None or last.end is None:
        return None
    return round(last.end - first.begin, 3)


def _quiet(_: str) -> None:
    """Tell nobody."""
