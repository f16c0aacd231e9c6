"""The sim's own controls on the bus: what a person would do in the room, and what only a stand-in can do.

Moving a thing by hand means taking it away and making it anew elsewhere, at rest.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Final, Protocol

from pydantic import Field

from tandem.sim.faults import Fault, FaultEvent, FaultRequest
from tandem.sim.scenario import Scenario, ScenarioError
from tandem.sim.scene import item_body, obstacle_body
from tandem.sim.things import Name, Obstacle, TrueItem
from tandem.sim.truth import TRUTH, read_truth
from tandem.skills.ports.endpoint import Call, answering, endpoint
from tandem.skills.ports.hardware import Answer
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.message import MOST, Message, RobotTime, RobotTimer, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.serving import Endpoints

if TYPE_CHECKING:
    from collections.abc import Callable

    from tandem.sim.body import RobotBody
    from tandem.sim.camera import Studio
    from tandem.sim.scene import SceneBody
    from tandem.sim.world import World
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.site import Site

Pixels = Annotated[int, Field(ge=16, le=2048)]


class ResetRequest(Message):
    """Restart with a seed; without a scenario, with the current one."""

    seed: Annotated[int, Field(ge=0, le=MOST)]
    scenario: Scenario | None = None


class MoveRequest(Message):
    """Move an existing body, by its name, so that its centre is at a pose in map."""

    name: str
    pose: Pose


class RemoveRequest(Message):
    """Remove a body, by its name (``item_29``, or an obstacle's)."""

    name: Name


class PhotographRequest(Message):
    """A picture for people: from ``eye`` to ``target`` in map. The answer is a PNG."""

    eye: Vector3 = (-2.8, -2.7, 2.3)
    target: Vector3 = (0.0, 0.4, 0.5)
    width: Pixels = 1280
    height: Pixels = 800


RESET: Final = Service("sim/reset", ResetRequest, Answer)
PLACE_ITEM: Final = Service("sim/place/item", TrueItem, Answer)
PLACE_OBSTACLE: Final = Service("sim/place/obstacle", Obstacle, Answer)
MOVE: Final = Service("sim/move", MoveRequest, Answer)
REMOVE: Final = Service("sim/remove", RemoveRequest, Answer)
FAULT: Final = Service("sim/fault", FaultRequest, Answer)
FAULTS: Final = Topic("sim/faults", FaultEvent)
"""What began, ended or could not be made, as it does."""
PHOTOGRAPH: Final = Service("sim/photograph", PhotographRequest, Answer, reads=True, exact=True)
"""Answered with a PNG, or with an Answer when it is refused."""


DONE: Final = Answer(accepted=True)


class Resetter(Protocol):
    """Whoever owns the whole sim and can begin it anew."""

    def __call__(self, seed: int, scenario: Scenario | None) -> None:
        """Begin anew; ScenarioError, before anything has changed, when the scenario doesn't fit the site."""
        ...


class Controls:
    """Serves ``sim/...``. Call ``step`` between two physics steps.

    Args:
        bus: where the queries come from.
        site: sizes of items and heights of furniture.
        world: what is changed.
        robot: whose true pose is told.
        studio: makes the photographs.
        reset: begins the sim anew; it calls ``restart`` here with the new world and robot.
        fault: has a fault happen, or says why not.
    """

    def __init__(
        self,
        bus: Bus,
        site: Site,
        world: World,
        robot: RobotBody,
        studio: Studio,
        *,
        reset: Resetter,
        fault: Callable[[Fault], Answer],
    ) -> None:
        self._site = site
        self._world = world
        self._robot = robot
        self._studio = studio
        self._reset = reset
        self._fault = fault
        self._photographs: list[tuple[int, Call[PhotographRequest]]] = []
        self._now, self._timer = RobotTime(boot="", seconds=0.0), RobotTimer(0.0)
        self._endpoints = Endpoints(
            bus,
            lambda: self._timer.reading,
            (
                answering(RESET, self._on_reset),
                answering(PLACE_ITEM, self._on_place_item),
                answering(PLACE_OBSTACLE, self._on_place_obstacle),
                answering(MOVE, self._on_move),
                answering(REMOVE, self._on_remove),
                answering(FAULT, lambda asked: self._fault(asked.fault)),
                answering(TRUTH, lambda _: read_truth(self._world, self._robot, self._now)),
                endpoint(PHOTOGRAPH, self._on_photograph),
            ),
        )

    def restart(self, world: World, robot: RobotBody) -> None:
        """Control another world from now on; photographs under way are refused."""
        self._world = world
        self._robot = robot
        for _, call in self._photographs:
            call.reply(_document(_refused("the sim was reset")))
        self._photographs.clear()

    def step(self, now: RobotTime) -> None:
        """Do what was asked since the last step."""
        self._timer.read(now)
        self._now = now
        self._endpoints.step()
        self._send_photographs()

    def close(self) -> None:
        """Stop serving. Closing twice is allowed."""
        self._endpoints.close()

    def _on_photograph(self, call: Call[PhotographRequest]) -> Answer | None:
        asked = call.document
        try:
            number = self._studio.order_photograph(asked.eye, asked.target, asked.width, asked.height)
        except ValueError as error:
            return _refused(str(error))
        self._photographs.append((number, call))
        return None

    def _send_photographs(self) -> None:
        waiting = []
        for number, call in self._photographs:
            png = self._studio.fetch(number)
            if png is None:
                waiting.append((number, call))
            else:
                call.reply(png)
        self._photographs = waiting

    def _on_reset(self, asked: ResetRequest) -> Answer:
        try:
            self._reset(asked.seed, asked.scenario)
        except ScenarioError as error:
            return _refused(str(error))
        return DONE

    def _on_place_item(self, item: TrueItem) -> Answer:
        return self._put(lambda: item_body(self._site, item))

    def _on_place_obstacle(self, obstacle: Obstacle) -> Answer:
        there = self._world.bodies.get(obstacle.name)
        if there is not None and there.label is not None:
            return _refused(f"{obstacle.name} is an item's name")
        return self._put(lambda: obstacle_body(self._site, obstacle))

    def _on_move(self, asked: MoveRequest) -> Answer:
        return self._unknown(asked.name) or self._put(
            lambda: replace(self._world.bodies[asked.name], pose=asked.pose)
        )

    def _on_remove(self, asked: RemoveRequest) -> Answer:
        refused = self._unknown(asked.name)
        if refused is not None:
            return refused
        self._world.remove(asked.name)
        return DONE

    def _put(self, make: Callable[[], SceneBody]) -> Answer:
        try:
            self._world.put(make())
        except (KeyError, ValueError, ScenarioError) as error:
            return _refused(str(error.args[0]))
        return DONE

    def _unknown(self, name: str) -> Answer | None:
        movable = self._world.movable()
        if name in movable:
            return None
        return _refused(f"nothing movable is called {name!r}; there are {', '.join(movable)}")


def _refused(reason: str) -> Answer:
    return Answer(accepted=False, reason=reason)


def _document(message: Message) -> bytes:
    return message.model_dump_json().encode()
