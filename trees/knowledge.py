"""What the trees know: the beliefs that the skills publish, the site, and the robot's description."""

from __future__ import annotations

from typing import Final, Protocol, TypeVar

from tandem.skills.ports.actions.arm import ArmStatus, arm_status
from tandem.skills.ports.actions.bimanual import PAIR, ZONES, Zones
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import CLOCK, DESCRIPTION, STOP_STATE, Latest, Nothing
from tandem.skills.ports.message import HandName, RobotTime
from tandem.skills.ports.reflex import BASE, HEAD, PipelineState, hand_resource, pipeline_state
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.whereabouts import Neighbours
from tandem.skills.ports.world import ROBOT_POSE, SCENE, WORLD, PlanningScene, RobotPose, WorldState

ASSUMED: Final = PAIR
"""The hands of a robot that has not told its own yet."""
ASK_AGAIN: Final = 0.5
"""Host seconds between two questions for the robot's description."""
STALE: Final = 3.0
"""Robot seconds after which what a pipeline told, which it does once a second, says nothing any more."""


class _Stamped(Protocol):
    """What tells when it was so."""

    @property
    def stamp(self) -> RobotTime:
        """When."""
        ...


S = TypeVar("S", bound=_Stamped)


class Knowledge:
    """Reads ``world/...`` and what the arms and the hardware tell; the trees' conditions read this alone.

    What was told before the hardware's present boot is not known.

    Args:
        bus: where the skills are.
        clocks: host time, for asking again.
        site: what was known beforehand.
        neighbours: the other robots of the site; unless given there are none.
    """

    def __init__(self, bus: Bus, clocks: Clocks, site: Site, neighbours: Neighbours | None = None) -> None:
        self.neighbours = Neighbours(None, clocks, "") if neighbours is None else neighbours
        """The other robots of the site, as they tell of themselves."""
        self.site = site
        self.description: RobotDescription | None = None
        self._bus, self._clocks = bus, clocks
        self._world = Latest(bus, WORLD)
        self._scene = Latest(bus, SCENE, depth=4)
        self._robot = Latest(bus, ROBOT_POSE)
        self._stop = Latest(bus, STOP_STATE)
        self._zones = Latest(bus, ZONES, depth=4)
        self._whole = {each: Latest(bus, pipeline_state(each)) for each in (BASE, HEAD)}
        self._limbs: dict[str, Latest[PipelineState]] = {}
        self._arms: dict[HandName, Latest[ArmStatus]] = {}
        self.assume_hands(ASSUMED)
        self._ticks = Latest(bus, CLOCK, depth=4)
        self._tick_heard_at: float | None = None
        self._boot: str | None = None
        self._restarted = False
        """Whether the hardware has started anew, and not all has been told since."""
        self._asked: Pending | None = None
        self._asked_at = float("-inf")

    def refresh(self) -> bool:
        """Take in what has arrived; return whether a belief that a condition reads has changed."""
        before = self._believed()
        self._world.refresh()
        self._robot.refresh()
        self._stop.refresh()
        self.neighbours.refresh()
        for pipeline in self._pipelines.values():
            pipeline.refresh()
        self._hear_hardware()
        for latest in self._arms.values():
            latest.refresh()
        if self.description is None:
            self._ask_for_description()
        return before != self._believed()

    @property
    def hands(self) -> tuple[HandName, ...]:
        """The robot's hands in its description's order; before it was heard, those that are assumed."""
        return tuple(self._arms)

    def assume_hands(self, hands: tuple[HandName, ...]) -> None:
        """Take the robot to have these hands until its description says which it has."""
        if hands == self.hands:
            return
        for latest in self._arms.values():
            latest.close()
        for pipeline in self._limbs.values():
            pipeline.close()
        limbs = [name for hand in hands for name in (f"arm_{hand}", hand_resource(hand))]
        self._limbs = {name: Latest(self._bus, pipeline_state(name)) for name in limbs}
        self._arms = {hand: Latest(self._bus, arm_status(f"arm_{hand}")) for hand in hands}

    def _believed(self) -> tuple[object, ...]:
        told = (self.world, self.robot_localised, self.stopped)
        taken = (self.taken(resource) for resource in self._pipelines)
        return (*told, *taken, *(self.arm(hand) for hand in self.hands))

    @property
    def world(self) -> WorldState | None:
        """The keeper's facts, or None before they came."""
        return self._current(self._world.value)

    def may_hold(self, side: HandName) -> bool:
        """Whether there may be something in a hand: unless it is known to be empty."""
        return self.world is None or self.world.in_hand(side) is not None

    @property
    def scene(self) -> PlanningScene | None:
        """What stands around, or None before it came; read when asked for, which is seldom."""
        return self._current(self._scene.refresh())

    @property
    def robot(self) -> RobotPose | None:
        """The robot's pose, or None before it came."""
        return self._current(self._robot.value)

    @property
    def robot_localised(self) -> bool:
        """Whether the robot knows where it is."""
        return self.robot is not None and self.robot.localised

    @property
    def stopped(self) -> StopState:
        """Whether the hardware's stop is set, and by whom."""
        return self._stop.value or StopState(stopped=False)

    @property
    def _pipelines(self) -> dict[str, Latest[PipelineState]]:
        return self._whole | self._limbs

    def reflex_of(self, resource: str) -> PipelineState | None:
        """Return what a pipeline told last, if a reflex has its resource; None if none has, or it is silent.

        Args:
            resource: as leaves name what they need: ``base``, ``head``, ``arm_left``, ``gripper_left``.
        """
        heard = self._pipelines.get(resource)
        state, now = None if heard is None else self._current(heard.value), self._clocks.robot()
        if state is None or not state.reflex:
            return None
        age = None if now is None else now.since(state.stamp)
        return None if age is not None and age > STALE else state

    def taken(self, resource: str) -> str:
        """Return which reflex has a resource, and what it saw, in words; nothing when none has it."""
        state = self.reflex_of(resource)
        if state is None:
            return ""
        saw = "" if state.why is None else f": {state.why.message}"
        return f"reflex {state.reflex} has the {resource}{saw}"

    @property
    def base_reflex(self) -> PipelineState | None:
        """What the base's pipeline told last, if a reflex has it."""
        return self.reflex_of(BASE)

    @property
    def base_taken(self) -> str:
        """Which reflex has the base, and what it saw, in words; nothing when none has it."""
        return self.taken(BASE)

    @property
    def hardware_silent_for(self) -> float:
        """Host seconds since the hardware's clock was heard; 0.0 when it never was: it isn't watched then.

        Hardware that has started anew counts as silent until all has been told that a task needs: what was
        told before says nothing about now.
        """
        return 0.0 if self._tick_heard_at is None else self._clocks.monotonic() - self._tick_heard_at

    def arm(self, side: HandName) -> ArmStatus | None:
        """Return what the arm tells, or None before it did."""
        latest = self._arms.get(side)
        return None if latest is None else self._current(latest.value)

    @property
    def zones(self) -> Zones | None:
        """Where which hand gets to, or None before it came; read when asked for, which is seldom."""
        return self._current(self._zones.refresh())

    def missing(self) -> tuple[str, ...]:
        """Return the names of what has not been heard yet and no task can do without."""
        parts = {
            "hw/description": self.description,
            "world/state": self.world,
            "world/robot": self.robot,
            **{f"skill/arm_{side}/state": self.arm(side) for side in self.hands},
        }
        return tuple(name for name, value in parts.items() if value is None)

    def close(self) -> None:
        """End the subscriptions."""
        self._world.close()
        self._scene.close()
        self._robot.close()
        self._stop.close()
        self.neighbours.close()
        self._zones.close()
        self._ticks.close()
        for pipeline in self._pipelines.values():
            pipeline.close()
        for latest in self._arms.values():
            latest.close()

    def _hear_hardware(self) -> None:
        last, now = self._ticks.value, self._clocks.robot()
        ticked = self._ticks.refresh() is not last
        if now is not None and now.boot != self._boot:
            self._restarted, self._boot = self._boot is not None, now.boot
            if self._restarted:  # perhaps as another robot
                self.description, self._asked, self._asked_at = None, None, float("-inf")
        if ticked and not (self._restarted and self.missing()):
            self._restarted = False
            self._tick_heard_at = self._clocks.monotonic()

    def _current(self, message: S | None) -> S | None:
        """Return a message of the hardware's present boot, or None."""
        now = self._clocks.robot()
        if message is None or (now is not None and now.since(message.stamp) is None):
            return None
        return message

    def _ask_for_description(self) -> None:
        now = self._clocks.monotonic()
        answer = None if self._asked is None else self._asked.poll()
        if answer is not None:
            self.description = DESCRIPTION.decode_answer(answer)
            self._bus.ear.know(self.description)
            self.assume_hands(self.description.hands)
        elif (self._asked is None or self._asked.done()) and now - self._asked_at > ASK_AGAIN:
            self._asked, self._asked_at = DESCRIPTION.query(self._bus, Nothing()), now
