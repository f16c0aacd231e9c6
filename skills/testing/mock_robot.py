"""A whole robot of mocked skills: it believes, looks, drives and grasps in an instant.

Give it faults by action and number of the call, run any tree against it, and see what the tree does:

    robot = MockRobot(bus, clocks, site, items={29: tag_in_map})
    robot.faults("gripper_left/grip")[2] = Fault(failure=...)
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Protocol, TypeVar

from tandem.skills.geometry.poses import wrap
from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.actions.approach import (
    ApproachFeedback,
    ApproachGoal,
    ApproachPhase,
    ApproachResult,
    approach,
)
from tandem.skills.ports.actions.arm import (
    ArmState,
    ArmStatus,
    MoveFeedback,
    MoveGoal,
    MovePhase,
    MoveResult,
    SurveyFeedback,
    SurveyGoal,
    SurveyResult,
    arm_status,
    move,
    survey,
)
from tandem.skills.ports.actions.base import (
    DRIVE,
    FOLLOW,
    GO,
    LOCALISE,
    ROTATE,
    DriveFeedback,
    DriveGoal,
    DriveResult,
    FollowFeedback,
    GoFeedback,
    LocaliseFeedback,
    LocaliseGoal,
    LocaliseResult,
    RotateFeedback,
    RotateGoal,
    RotateResult,
)
from tandem.skills.ports.actions.bimanual import (
    COORDINATE,
    CROSSING,
    PAIR,
    TWO_HANDS,
    ZONES,
    CoordinateFeedback,
    Crossing,
    TwoHands,
    TwoHandsFeedback,
    TwoHandsGoal,
    TwoHandsResult,
)
from tandem.skills.ports.actions.gripper import Grip, GripFeedback, GripGoal, GripResult, grip
from tandem.skills.ports.actions.perception import (
    LOOK,
    TRACK,
    TURN_HEAD,
    LookFeedback,
    LookGoal,
    LookResult,
    TurnHeadResult,
)
from tandem.skills.ports.actions.world import EDIT, EditFeedback, EditGoal, EditResult, SceneEdit
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import DESCRIPTION
from tandem.skills.ports.message import HandName, Message, RobotTime, Vector3
from tandem.skills.ports.node import Node
from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.pose import IDENTITY, FloorPose, Pose
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import ActionType, Outcome, failed, succeeded
from tandem.skills.ports.world import (
    ROBOT_POSE,
    SCENE,
    WORLD,
    Box,
    HeldItem,
    ItemFact,
    Placed,
    PlanningScene,
    RobotPose,
    SceneObject,
    Sighting,
    WorldState,
)
from tandem.skills.server import ActionServer
from tandem.skills.testing.mock_base import MockBase
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.testing.mock_skill import Fault, MockSkill
from tandem.skills.testing.mock_zones import mock_zones

G = TypeVar("G", bound=Message)
F = TypeVar("F", bound=Message)
R = TypeVar("R", bound=Message)

TUCKED: Final = 0.20
STRETCHED: Final = 0.75
AWAKE_AT_LOOK: Final = 1


class ClosableBus(Bus, Protocol):
    """An end of a bus that can be left."""

    def close(self) -> None:
        """Leave it."""
        ...


class _Mortal:
    """An end of a bus whose process can die: from then on nothing leaves it."""

    def __init__(self, bus: ClosableBus) -> None:
        self._bus, self._dead, self.ear = bus, False, bus.ear
        self.subscribe, self.serve, self.query = bus.subscribe, bus.serve, bus.query
        self.listened, self.announce = bus.listened, bus.announce
        self.alive, self.awake, self.lease = bus.alive, bus.awake, bus.lease

    def publish(self, key: str, payload: bytes) -> None:
        """Send, unless it is dead."""
        if not self._dead:
            self._bus.publish(key, payload)

    def die(self) -> None:
        """Take back all names, and say nothing more."""
        self._dead = True
        self._bus.close()


@dataclass(eq=False)
class _Served:
    """A skill, its server, and how to make another one."""

    make: Callable[[Bus], Node]
    server: Node
    bus: _Mortal | None
    there: bool = True


class MockRobot:
    """Skills, keeper and description in one node.

    Args:
        bus: where the trees are.
        clocks: robot time.
        site: what is known beforehand.
        items: tags in the map of the items that can be seen.
        seen_at_look: the number of the look from which on the items are seen (1: the first).
        duration: robot seconds that each skill takes.
        localised: whether the robot knows its pose from the start.
        ends: makes ends of the same bus; with it each skill gets one of its own, and can be lost alone.
    """

    name = "mock robot"

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        site: Site,
        *,
        items: dict[int, Pose],
        seen_at_look: int = AWAKE_AT_LOOK,
        duration: float = 0.0,
        localised: bool = False,
        ends: Callable[[], ClosableBus] | None = None,
    ) -> None:
        self.base = FloorPose(x=0.0, y=0.0, yaw=0.0)
        self.localised = localised
        self.hands: dict[HandName, int | None] = {"left": None, "right": None}
        """What each hand holds in truth."""
        self.world = WorldState(stamp=RobotTime(boot="mock", seconds=0.0), version=0)
        self.bus = bus
        self.zones = mock_zones(self.world.stamp)
        """What both hands reach; told with all other beliefs."""
        self.knows_zones = True
        """Whether the zones are told at all."""
        self._before: dict[HandName, int] = {}
        self.out_of_reach = 0
        """How many of a survey's first base poses are out of reach."""
        self.bus, self._clocks, self._site, self._items = bus, clocks, site, dict(items)
        self._seen_at_look, self._duration = seen_at_look, duration
        self._extent: dict[HandName, float] = {"left": TUCKED, "right": TUCKED}
        self.description = mock_description()
        """What it says that it is."""
        self._endpoints = Endpoints(
            bus, clocks.monotonic, (answering(DESCRIPTION, lambda _: self.description),)
        )
        self._faults: dict[str, dict[int, Fault]] = {}
        self.leaf_faults: dict[str | tuple[str, int], Fault] = {}
        """Faults by the leaf that sent the goal, at each of its attempts or at one (1 is the first)."""
        self.calls: list[tuple[str, Message]] = []
        self._recorded: list[_Clearable] = []
        """Each goal that was run, with its action's name, in order."""
        self.watch: Callable[[str, str, str, Message], None] = lambda *_: None
        """Told "began" and "ended" of each goal, with action, id and goal."""
        self._ends, self._servers = ends, dict[str, _Served]()
        self._clutter: tuple[SceneObject, ...] = ()
        self.occupied: Occupancy | None = None
        """Space that depth shows to be occupied; told with ``tell``."""
        self._told = False
        self._serve(LOOK, LookFeedback(pictures=0, seen=()), self._look)
        base = FloorPose(x=0.0, y=0.0, yaw=0.0)
        self.wheels = MockBase(self)
        """Goes straight, follows, and has a reflex that takes the base."""
        self._serve(GO, GoFeedback(base_in_map=base, remaining=0.0, doing=("GoTo", "TurnTo")), self.wheels.go)
        chasing = FollowFeedback(base_in_map=base, distance=1.3, doing=("Follow", "GoTo"))
        self._serve(FOLLOW, chasing, self.wheels.follow)
        self._serve(DRIVE, DriveFeedback(base_in_map=base, remaining=0.0, progress=0.0), self._drive)
        self._serve(ROTATE, RotateFeedback(remaining=0.0), self._rotate)
        self._serve(LOCALISE, LocaliseFeedback(progress=0.0), self._localise)
        self._serve(EDIT, EditFeedback(), self._edit)
        self._serve(COORDINATE, CoordinateFeedback(episode=0), succeeded, endless=True)
        self._serve(TRACK, LookFeedback(pictures=0, seen=()), succeeded, endless=True)
        head = TurnHeadResult(positions=())
        self._serve(TURN_HEAD, LookFeedback(pictures=0, seen=()), lambda _: succeeded(head))
        hands = TwoHandsFeedback(left_force=0.0, right_force=0.0, progress=0.0)
        self._serve(TWO_HANDS, hands, self._two_hands)
        for side in PAIR:
            self._serve_side(side)

    def faults(self, action: str) -> dict[int, Fault]:
        """Return the faults of an action by the number of the call; put more in."""
        return self._faults[action]

    def calls_of(self, action: str) -> int:
        """Return how often an action was run."""
        return sum(1 for name, _ in self.calls if name == action)

    def forget_calls(self) -> None:
        """Count calls from zero again: a mock that lives for long must not keep all of them."""
        self.calls.clear()
        for calls in self._recorded:
            calls.clear()

    def step(self) -> bool:
        """Answer, and tell what is believed."""
        self._endpoints.step()
        if not self._told:
            self._told = True
            self.tell()
        self.wheels.step()
        more = [served.server.step() for served in self._servers.values() if served.there]
        return any(more)

    def close(self) -> None:
        """End all skills."""
        for served in self._servers.values():
            served.server.close()
        self._endpoints.close()

    @property
    def now(self) -> RobotTime:
        """The robot's time, or that of the beliefs while there is none."""
        return self._clocks.robot() or self.world.stamp

    def tell(self) -> None:
        """Publish all beliefs."""
        stamp = self.now
        self.world = self.world.model_copy(update={"stamp": stamp})
        WORLD.publish(self.bus, self.world)
        scene = PlanningScene(
            stamp=stamp, version=self.world.version, objects=self._clutter, occupied=self.occupied
        )
        SCENE.publish(self.bus, scene)
        pose = RobotPose(
            stamp=stamp,
            localised=self.localised,
            base_in_map=self.base,
            odom_in_map=FloorPose(x=0.0, y=0.0, yaw=0.0),
            position_sigma=0.01,
            yaw_sigma=0.01,
            moving=False,
        )
        ROBOT_POSE.publish(self.bus, pose)
        for side in PAIR:
            group = f"arm_{side}"
            status = ArmStatus(stamp=stamp, group=group, state=ArmState.ARM_IDLE, extent=self._extent[side])
            arm_status(group).publish(self.bus, status)
        if self.knows_zones:
            ZONES.publish(self.bus, self.zones.model_copy(update={"stamp": stamp}))

    def cross(self, *, risk: bool) -> None:
        """Have the reflex tell that the arms come into each other's way, or that they no longer do."""
        stamp = self.now
        distance = 0.1 if risk else 0.4
        message = Crossing(stamp=stamp, risk=risk, distance=distance, threshold=0.2, clearance=0.5 * distance)
        CROSSING.publish(self.bus, message)

    def believe(self, **changes: object) -> None:
        """Change the keeper's facts and tell."""
        document = {**dict(self.world), "version": self.world.version + 1, **changes}
        self.world = WorldState.model_validate(document)
        self.tell()

    def serve(self, action: ActionType[G, F, R], idle: F, effect: Callable[[G], Outcome[R]]) -> None:
        """Mock one more skill, such as one of your own.

        Args:
            action: its contract.
            idle: the feedback while it runs.
            effect: returns how a goal ends.
        """
        self._serve(action, idle, effect)

    def _serve(self, action: ActionType[G, F, R], idle: F, effect: object, *, endless: bool = False) -> None:
        def recorded(goal: G) -> Outcome[R]:
            outcome: Outcome[R] = effect(goal)  # type: ignore[operator]
            self.tell()
            return outcome

        faults = self._faults.setdefault(action.name, {})
        fault_of = self._hangs if endless else self._fault_of
        skill = MockSkill(action, self._clocks, idle, recorded, self._duration, faults, fault_of)
        skill.calls = _Recorded(self.calls, action.name)
        self._recorded.append(skill.calls)
        skill.began = lambda goal_id, goal: self.watch("began", action.name, goal_id, goal)
        skill.ended = lambda goal_id, goal: self.watch("ended", action.name, goal_id, goal)
        mortal = None if self._ends is None else _Mortal(self._ends())

        def serve(at: Bus) -> Node:
            return ActionServer(at, self._clocks, skill)

        self._servers[action.name] = _Served(serve, serve(mortal or self.bus), mortal)

    def _fault_of(self, goal_id: str) -> Fault | None:
        _, _, rest = goal_id.partition("/")
        leaf, _, attempt = rest.rpartition("/")
        return self.leaf_faults.get((leaf, int(attempt))) or self.leaf_faults.get(leaf)

    def _hangs(self, goal_id: str) -> Fault:
        return self._fault_of(goal_id) or Fault(hangs=True)

    def lose(self, action: str) -> None:
        """Have the process of a skill die: its name goes, and its goal with it."""
        served = self._servers[action]
        assert served.bus is not None, "give the robot ``ends`` to lose a skill alone"
        if served.there:
            served.there = False
            served.bus.die()
            served.server.close()

    def bring_back(self, action: str) -> None:
        """Have it started anew: it knows nothing of its goals."""
        served = self._servers[action]
        if not served.there and self._ends is not None:
            served.bus = _Mortal(self._ends())
            served.server, served.there = served.make(served.bus), True

    @property
    def busy(self) -> tuple[str, ...]:
        """The names of the actions that have a goal under way."""
        return tuple(
            name
            for name, served in self._servers.items()
            if served.there and isinstance(served.server, ActionServer) and served.server.busy
        )

    @property
    def arms_out(self) -> bool:
        """Whether an arm is out."""
        return any(extent > TUCKED for extent in self._extent.values())

    def put_arms(self, left: float, right: float | None = None) -> None:
        """Have the arms be out or in, whatever they were at: STRETCHED or TUCKED (m); both unless said."""
        self._extent = {"left": left, "right": left if right is None else right}
        self.tell()

    def drop(self, side: HandName) -> None:
        """Let what the hand holds fall where nobody sees it happen: the keeper learns from the hand."""
        item, self.hands[side] = self.hands[side], None
        held = tuple(hand for hand in self.world.held if hand.side != side)
        self.believe(held=held, items=tuple(fact for fact in self.world.items if fact.item != item))

    def put_in(self, slot: Vector3, name: str = "clutter_1") -> None:
        """Have something untagged stand at a point of the map (m)."""
        x, y, z = slot
        box = Box(size=(0.08, 0.08, 0.12), pose=Pose(position=(x, y, z + 0.06)))
        self._clutter = (*self._clutter, SceneObject(name=name, kind="clutter", box=box))
        self.tell()

    def _serve_side(self, side: HandName) -> None:
        self._serve(
            move(f"arm_{side}"),
            MoveFeedback(phase=MovePhase.MOVING, progress=0.0),
            lambda goal: self._move(side, goal),
        )
        self._serve(
            approach(f"arm_{side}"),
            ApproachFeedback(phase=ApproachPhase.FIELD, distance=0.0),
            lambda goal: self._approach(side, goal),
        )
        self._serve(survey(f"arm_{side}"), SurveyFeedback(looked_at=0, found=0), self._survey)
        self._serve(grip(side), GripFeedback(width=0.0, force=0.0), lambda goal: self._grip(side, goal))

    def _look(self, goal: LookGoal) -> Outcome[LookResult]:
        looks = self.calls_of(LOOK.name)
        seen = self._items if looks >= self._seen_at_look else {}
        stamp = self.now
        sightings = tuple(
            Sighting(
                item=item,
                stamp=stamp,
                tag_in_map=tag,
                tag_in_base=IDENTITY,
                tag_in_camera=IDENTITY,
                distance=1.0,
                quality=1.0,
                position_sigma=0.002,
            )
            for item, tag in seen.items()
            # One that a hand has closed on stands there and is seen until it is lifted, which is after it is
            # believed to be held.
            if item not in {hand.item for hand in self.world.held}
        )
        known = {fact.item: fact for fact in self.world.items}
        for sighting in sightings:
            site_item = self._site.item(sighting.item)
            known[sighting.item] = ItemFact(
                item=sighting.item,
                size=(0.06, 0.06, 0.06) if site_item is None else site_item.size,
                shape="box" if site_item is None else site_item.shape,
                tag_in_map=sighting.tag_in_map,
                seen=stamp,
                quality=1.0,
                position_sigma=0.002,
            )
        self.believe(items=tuple(known.values()))
        return succeeded(LookResult(found=goal.item in seen, sightings=sightings))

    def _drive(self, goal: DriveGoal) -> Outcome[DriveResult]:
        self.base = goal.poses[0]
        return succeeded(DriveResult(pose=0, base_in_map=self.base, position_error=0.0, yaw_error=0.0))

    def _rotate(self, goal: RotateGoal) -> Outcome[RotateResult]:
        self.base = self.base.model_copy(update={"yaw": wrap(self.base.yaw + goal.angle)})
        return succeeded(RotateResult(turned=goal.angle))

    def _localise(self, _: LocaliseGoal) -> Outcome[LocaliseResult]:
        self.localised = True
        return succeeded(LocaliseResult(base_in_map=self.base, fit=1.0, runner_up=0.3))

    def _move(self, side: HandName, goal: MoveGoal) -> Outcome[MoveResult]:
        self._extent[side] = TUCKED if goal.posture in {"home", "carry"} else STRETCHED
        if goal.follows_item is not None or goal.touch_item is not None:
            self._before[side] = goal.follows_item or goal.touch_item or 0
        return succeeded(MoveResult(positions=(0.0,), error=0.0, planning_steps=1, duration=0.0))

    def _approach(self, side: HandName, goal: ApproachGoal) -> Outcome[ApproachResult]:
        fact = self.world.item(goal.item)
        if fact is None:
            message = f"item {goal.item} is not believed to be anywhere"
            where = approach(f"arm_{side}").name
            return failed(Failure(kind=FailureKind.ITEM_GONE, message=message, where=where))
        self._extent[side], self._before[side] = STRETCHED, goal.item
        at = standing_in_map(fact.tag_in_map, fact) or Pose(position=fact.tag_in_map.position)
        return succeeded(ApproachResult(grasp=0, positions=(0.0,), error=0.0, item_in_map=at, duration=0.0))

    def _two_hands(self, goal: TwoHandsGoal) -> Outcome[TwoHandsResult]:
        force = 0.0 if goal.do is TwoHands.RELEASE else goal.force or 40.0
        self._extent = dict.fromkeys(PAIR, STRETCHED)
        return succeeded(TwoHandsResult(left_force=force, right_force=force, item_in_map=goal.to))

    def _survey(self, goal: SurveyGoal) -> Outcome[SurveyResult]:
        good = range(self.out_of_reach, len(goal.bases))
        return succeeded(SurveyResult(bases=tuple(good[: goal.enough])))

    def _grip(self, side: HandName, goal: GripGoal) -> Outcome[GripResult]:
        if goal.grip is Grip.GRASP:
            self.hands[side] = self._before.get(side, next(iter(self._items), None))
        elif goal.grip is Grip.OPEN:
            self.hands[side] = None
        full = self.hands[side] is not None
        return succeeded(
            GripResult(width=goal.width if full else 0.0, force=10.0 if full else 0.0, full=full)
        )

    def _edit(self, goal: EditGoal) -> Outcome[EditResult]:
        if goal.edit is SceneEdit.SELECT and goal.near is not None:
            return self._select(goal.item, goal.near)
        held = {hand.item: hand for hand in self.world.held}
        placed = {each.item: each for each in self.world.placed}
        if goal.edit is SceneEdit.ATTACH and goal.side is not None:
            pose = goal.item_in_tool or IDENTITY
            held[goal.item] = HeldItem(side=goal.side, item=goal.item, item_in_tool=pose)
        elif goal.edit is SceneEdit.DETACH:
            held.pop(goal.item, None)
            if goal.depot is not None and goal.slot is not None:
                placed[goal.item] = Placed(item=goal.item, depot=goal.depot, slot=goal.slot)
        forgotten = goal.item if goal.edit is SceneEdit.FORGET else None
        items = tuple(
            fact.model_copy(update={"held": held[fact.item].side if fact.item in held else None})
            for fact in self.world.items
            if fact.item != forgotten
        )
        self.believe(items=items, held=tuple(held.values()), placed=tuple(placed.values()))
        return succeeded(EditResult(version=self.world.version))

    def _select(self, item: int, near: tuple[float, float]) -> Outcome[EditResult]:
        there = self.world.those(item)
        first, *others = sorted(there, key=lambda fact: math.dist(fact.tag_in_map.position[:2], near))
        items = tuple(first if fact.item == item else fact for fact in self.world.items)
        strangers = tuple(fact for fact in self.world.doubles if fact.item != item)
        self.believe(items=items, doubles=(*strangers, *others))
        return succeeded(EditResult(version=self.world.version))


class _Clearable(Protocol):
    def clear(self) -> None: ...


class _Recorded(list[G]):
    """A skill's calls that also go, with the action's name, into the robot's."""

    def __init__(self, calls: list[tuple[str, Message]], action: str) -> None:
        super().__init__()
        self._calls, self._action = calls, action

    def append(self, goal: G) -> None:
        """Keep the call in both places."""
        super().append(goal)
        self._calls.append((self._action, goal))
