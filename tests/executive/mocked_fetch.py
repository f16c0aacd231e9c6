"""A whole robot of mocked skills and an executive over the bus in memory, with a recorder that hears them."""

from __future__ import annotations

from pathlib import Path

from surroundings import WAIT, Surroundings

from tandem.executive.records.boxes import Boxes
from tandem.executive.records.ears import MemoryEars
from tandem.executive.records.recorder import Recorder, Sink
from tandem.executive.records.recording import Facts
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.hardware import Clock, StopState
from tandem.skills.ports.keys import CLOCK, STOP_STATE
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.tasks import TaskState
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.trees.registry import shipped

TAG = Pose(position=(0.5, 0.5, 0.74), orientation=from_axes((0, -1, 0), (0, 0, 1), (-1, 0, 0)))
FACTS = Facts(site="lab", robot="tiago", scenario="mocked", release="0.1.0", began=0.0)
FETCH: dict[str, object] = {"task": "fetch", "item": 29}


class MockedFetch(Surroundings):
    """The system; time is simulated.

    Args:
        folder: of the black boxes.
        sinks: who else takes what the recorder hears.
    """

    def __init__(self, folder: Path, *sinks: Sink) -> None:
        super().__init__(kinds={**shipped(), "wait": WAIT})
        robot = self.hub.endpoint()
        self.robot = MockRobot(robot, self.clocks, load("lab"), items={29: TAG}, duration=0.05)
        self.published: list[tuple[str, bytes]] = []
        self.hub.watch(lambda kind, key, data: self.published.append((key, data)) if kind == "put" else None)
        ears = MemoryEars(self.hub, self.clocks.monotonic)
        boxes = Boxes(folder)
        self.end = self.hub.endpoint()
        self.recorder = Recorder(self.end, ears, self.clocks, facts=FACTS, boxes=boxes, sinks=sinks)
        self.tick = 0

    def step(self, times: int = 1, seconds: float = 0.01) -> None:
        """Let time pass; the recorder looks at every tenth step."""
        for _ in range(times):
            self.clocks.advance(seconds)
            if hasattr(self, "recorder"):
                self.tick += 1
                stamp = self.clocks.robot()
                assert stamp is not None
                CLOCK.publish(self.bus, Clock(stamp=stamp, tick=self.tick))
                if self.tick % 50 == 0:
                    self.robot.tell()
                self.robot.step()
            self.executive.step()
            if hasattr(self, "recorder") and self.tick % 10 == 0:
                self.recorder.step()

    def fetch(self) -> str:
        """Carry a fetch out to its end; return the task's id."""
        return self._to_its_end(FETCH)

    def fail(self) -> str:
        """Carry out a task that fails, two seconds long; return its id."""
        self.robot.believe()
        self.step(200)
        self.robot.believe()  # the second version of the world is the one that the task fails at
        return self._to_its_end({"task": "wait", "item": 1})

    def _to_its_end(self, request: dict[str, object]) -> str:
        answer = self.ask(request)
        for _ in range(20_000):
            status = self.executive.book.find(answer.task)
            if status is not None and status.state.terminal:
                return answer.task
            self.step()
        raise AssertionError("the task has not ended")

    def state(self, task: str) -> TaskState:
        """Return a task's state."""
        status = self.executive.book.find(task)
        assert status is not None
        return status.state

    def stop(self) -> None:
        """Have the hardware say that its stop is set."""
        STOP_STATE.publish(self.bus, StopState(stopped=True, by="anna", reason="a test"))

    def black_boxes(self) -> tuple[Path, ...]:
        """Return the files, once those that are due are written."""
        self.step(300)
        if self.recorder._writing is not None:
            self.recorder._writing.join()
        assert self.recorder._boxes is not None
        return self.recorder._boxes.paths()
