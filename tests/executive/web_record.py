"""A mocked fetch in memory: what its page was told at ten moments, and a record of it."""

from __future__ import annotations

import json
from pathlib import Path

from tandem.executive.records.known import ALIVE, Alive
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.recording import Attachment, Cause, Facts, Recorded, Span
from tandem.executive.service.executive import Executive
from tandem.executive.web.feed import Feed
from tandem.executive.web.viewers import Update, merge
from tandem.sim.robots.registry import robot_model
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK, DESCRIPTION
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.tasks import REQUEST, TASK_SITE, TASK_TIMELINE, NameTask
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryHub
from tandem.trees.registry import discover

STEP = 0.05
SECOND = 20
"""Steps in a second."""
MOMENTS = tuple(range(30, 330, 30))
"""Ten: 1.5 s, 3 s, and so on."""
ITEM = Pose(position=(0.5, 0.5, 0.74), orientation=from_axes((0, -1, 0), (0, 0, 1), (-1, 0, 0)))
PASSING = ("now", "link", "whole", "replay")
"""Parts that say when something was told, rather than what."""


class Run:
    """A mocked fetch in memory: what the page was told at some moments, and a record of it."""

    def __init__(self, path: Path) -> None:
        self.hub, self.clocks, self.site = MemoryHub(), SteppedClocks("b"), load("lab")
        self.messages: list[Recorded] = []
        self.hub.watch(self.hear)
        self.shown: dict[int, Update] = {}
        self.live(path)

    def hear(self, kind: str, key: str, payload: bytes) -> None:
        if kind == "put":
            at = self.clocks.seconds
            self.messages.append(Recorded(key, at, RobotTime(boot="b", seconds=at), round(at * 1e9), payload))

    def live(self, path: Path) -> None:
        bus = self.hub.endpoint()
        robot = MockRobot(self.hub.endpoint(), self.clocks, self.site, items={29: ITEM}, duration=0.3)
        executive = Executive(self.hub.endpoint(), self.clocks, self.site, discover(), version="test")
        self.messages.append(
            Recorded(
                ALIVE, 0.0, RobotTime(boot="b", seconds=0.0), 0,
                Alive(names=tuple(sorted(bus.alive()))).model_dump_json().encode(),
            )
        )  # fmt: skip
        feed, tick = Feed(self.hub.endpoint(), self.clocks.monotonic), 0
        known: Update = {}
        for tick in range(MOMENTS[-1] + 1):
            self.clocks.advance(STEP)
            CLOCK.publish(bus, Clock(stamp=RobotTime(boot="b", seconds=self.clocks.seconds), tick=tick))
            if tick == SECOND:
                bus.query(REQUEST, json.dumps({"task": "fetch", "item": 29}).encode())
            if tick % SECOND == 0:
                robot.tell()
            robot.step()
            executive.step()
            merge(known, feed.poll())
            if tick in MOMENTS:
                self.shown[tick] = whole(feed)
        (task,) = known["tasks"]  # type: ignore[misc]
        timeline = TASK_TIMELINE.query(bus, NameTask(task=str(task)))
        executive.step()
        description = robot_model("tiago_dual").description
        attached = (
            Attachment(DESCRIPTION.key, 0.0, description.model_dump_json().encode()),
            Attachment(f"{TASK_TIMELINE.key}/{task}", self.clocks.seconds, timeline.poll() or b""),
            Attachment(TASK_SITE.key, 0.0, self.site.model_dump_json().encode()),
        )
        cause = Cause(kind="asked", words="a test asked for it", at=3.0)
        facts = Facts(site="lab", robot="tiago", release="0.1.0", began=1_764_250_000.0, causes=(cause,))
        write_lines(path, facts, Span(0.0, self.clocks.seconds), attached, self.messages)


def whole(feed: Feed) -> Update:
    return {part: value for part, value in feed.whole().items() if part not in PASSING}


def record(path: Path) -> Run:
    """Write a record."""
    return Run(path)
