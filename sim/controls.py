"""The sim's own controls on the bus: what a person would do in the room, and what only a stand-in can do.

Moving a thing by hand means taking it away and making it anew elsewhere, at rest.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, Final, Protocol, TypeVar

from pydantic import Field, ValidationError

from sim.faults import Fault, FaultEvent, FaultRequest
from sim.scenario import Scenario, ScenarioError
from sim.scene import item_body, obstacle_body
from sim.things import Name, Obstacle, TrueItem
from sim.truth import TRUTH, read_truth
from skills.ports.geometry import Pose
from skills.ports.hardware import Answer
from skills.ports.keys import Service, Topic
from skills.ports.message import MAX_REQUEST_BYTES, Message, RobotTime, Vector3

if TYPE_CHECKING:
    from collections.abc import Callable

    from sim.body import RobotBody
    from sim.camera import Studio
    from sim.world import World
    from skills.ports.bus import Bus, Desk, Request
    from skills.ports.site import Site

Asked = TypeVar("Asked", bound=Message)
Pixels = Annotated[int, Field(ge=16, le=2048)]


class ResetRequest(Message):
    """Begin anew with a seed; without a scenario, with the one that runs."""

    seed: Annotated[int, Field(ge=0)]
    scenario: Scenario | None = None


class MoveRequest(Message):
    """Put a body that is there, by its name, with its centre at a pose in map."""

    name: str
    pose: Pose


class RemoveRequest(Message):
    """Take a body away, by its name (``item_29``, or an obstacle's)."""

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
PHOTOGRAPH: Final = "sim/photograph"
"""Asked with a PhotographRequest as JSON; answered with a PNG, or an Answer as JSON when it is refused."""


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
        self._photographs: list[tuple[int, Request]] = []
        self._truth: Desk = bus.serve(TRUTH.key)
        self._photograph: Desk = bus.serve(PHOTOGRAPH)
        self._served: list[tuple[Desk, Callable[[bytes], Answer]]] = [
            (bus.serve(service.key), handler)
            for service, handler in (
                (RESET, self._on_reset),
                (PLACE_ITEM, self._on_place_item),
                (PLACE_OBSTACLE, self._on_place_obstacle),
                (MOVE, self._on_move),
                (REMOVE, self._on_remove),
                (FAULT, self._on_fault),
            )
        ]

    def restart(self, world: World, robot: RobotBody) -> None:
        """Control another world from now on; photographs under way are refused."""
        self._world = world
        self._robot = robot
        for _, request in self._photographs:
            request.reply(_document(Answer(accepted=False, reason="the sim was reset")))
        self._photographs.clear()

    def step(self, now: RobotTime) -> None:
        """Do what was asked since the last step."""
        for desk, handler in self._served:
            for request in desk.drain():
                request.reply(_document(_answer(handler, request.payload)))
        for request in self._truth.drain():
            request.reply(_document(read_truth(self._world, self._robot, now)))
        self._take_photographs()

    def close(self) -> None:
        """Stop serving. Closing twice is allowed."""
        for desk in (self._truth, self._photograph, *(desk for desk, _ in self._served)):
            desk.close()

    def _take_photographs(self) -> None:
        for request in self._photograph.drain():
            try:
                asked = _parse(PhotographRequest, request.payload)
                number = self._studio.order_photograph(asked.eye, asked.target, asked.width, asked.height)
            except ValueError as error:
                request.reply(_document(Answer(accepted=False, reason=_reason(error))))
            else:
                self._photographs.append((number, request))
        waiting = []
        for number, request in self._photographs:
            png = self._studio.fetch(number)
            if png is None:
                waiting.append((number, request))
            else:
                request.reply(png)
        self._photographs = waiting

    def _on_reset(self, payload: bytes) -> Answer:
        asked = _parse(ResetRequest, payload)
        self._reset(asked.seed, asked.scenario)
        return Answer(accepted=True)

    def _on_place_item(self, payload: bytes) -> Answer:
        self._world.put(item_body(self._site, _parse(TrueItem, payload)))
        return Answer(accepted=True)

    def _on_place_obstacle(self, payload: bytes) -> Answer:
        obstacle = _parse(Obstacle, payload)
        there = self._world.bodies.get(obstacle.name)
        if there is not None and there.label is not None:
            return Answer(accepted=False, reason=f"{obstacle.name} is an item's name")
        self._world.put(obstacle_body(self._site, obstacle))
        return Answer(accepted=True)

    def _on_move(self, payload: bytes) -> Answer:
        asked = _parse(MoveRequest, payload)
        self._world.put(replace(self._world.bodies[self._known(asked.name)], pose=asked.pose))
        return Answer(accepted=True)

    def _on_remove(self, payload: bytes) -> Answer:
        self._world.remove(self._known(_parse(RemoveRequest, payload).name))
        return Answer(accepted=True)

    def _on_fault(self, payload: bytes) -> Answer:
        return self._fault(_parse(FaultRequest, payload).fault)

    def _known(self, name: str) -> str:
        movable = self._world.movable()
        if name not in movable:
            raise KeyError(f"nothing movable is called {name!r}; there are {', '.join(movable)}")
        return name


def _answer(handler: Callable[[bytes], Answer], payload: bytes) -> Answer:
    try:
        return handler(payload)
    except (ValueError, KeyError, ScenarioError) as error:
        return Answer(accepted=False, reason=_reason(error))


def _parse(model: type[Asked], payload: bytes) -> Asked:
    if len(payload) > MAX_REQUEST_BYTES:
        raise ValueError(f"at most {MAX_REQUEST_BYTES} bytes were expected, found {len(payload)}")
    return model.model_validate_json(payload)


def _reason(error: Exception) -> str:
    if isinstance(error, ValidationError):
        parts = (f"{'.'.join(map(str, part['loc']))}: {part['msg']}" for part in error.errors())
        return "; ".join(parts)
    return str(error.args[0]) if error.args else str(error)


def _document(message: Message) -> bytes:
    return message.model_dump_json().encode()
