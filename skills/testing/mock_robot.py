"""A whole robot of mocked skills: it believes, looks, drives and grasps in an instant.

Give it faults by action and number of the call, run any tree against it, and see what the tree does:

    robot = MockRobot(bus, clocks, site, items={29: tag_in_map})
    robot.faults("gripper_left/grip")[2] = Fault(failure=...)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.approach import (
    ApproachFeedback,
    ApproachPhase,
    approach,
)
from tandem.skills.ports.actions.arm import (
    ArmState,
    ArmStatus,
    MoveFeedback,
    MovePhase,
    SurveyFeedback,
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
    TwoHandsFeedback,
)
from tandem.skills.ports.actions.gripper import GripFeedback, grip
from tandem.skills.ports.actions.perception import (
    LOOK,
    TRACK,
    TURN_HEAD,
    LookFeedback,
    LookGoal,
    LookResult,
    TurnHeadResult,
)
from tandem.skills.ports.actions.world import EDIT, EditFeedback
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.keys import DESCRIPTION
from tandem.skills.ports.message import HandName, RobotTime, Vector3
from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.pose import IDENTITY, FloorPose, Pose
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import Outcome, succeeded
from tandem.skills.ports.world import (
    ROBOT_POSE,
    SCENE,
    WORLD,
    Box,
    PlanningScene,
    RobotPose,
    SceneObject,
    Sighting,
    WorldState,
)
from tandem.skills.testing.mock_arms import TUCKED, MockArms
from tandem.skills.testing.mock_base import MockBase
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.testing.mock_keeper import MockKeeper
from tandem.skills.testing.mock_servers import ClosableBus, MockServers
from tandem.skills.testing.mock_zones import mock_zones

AWAKE_AT_LOOK: Final = 1


class MockRobot(MockServers):
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
        super().__init__(bus, clocks, duration=duration, ends=ends)
        self.base = FloorPose(x=0.0, y=0.0, yaw=0.0)
        self.localised = localised
        self.world = WorldState(stamp=RobotTime(boot="mock", seconds=0.0), version=0)
        self.zones = mock_zones(self.world.stamp)
        """What both hands reach; told with all other beliefs."""
        self.knows_zones = True
        """Whether the zones are told at all."""
        self.out_of_reach = 0
        """How many of a survey's first base poses are out of reach."""
        self._items, self._seen_at_look = dict(items), seen_at_look
        self.arms, self._keeper = MockArms(self, next(iter(items), None)), MockKeeper(self, site)
        self.description = mock_description()
        """What it says that it is."""
        self._endpoints = Endpoints(
            bus, clocks.monotonic, (answering(DESCRIPTION, lambda _: self.description),)
        )
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
        self._serve(EDIT, EditFeedback(), self._keeper.edit)
        self._serve(COORDINATE, CoordinateFeedback(episode=0), succeeded, endless=True)
        self._serve(TRACK, LookFeedback(pictures=0, seen=()), succeeded, endless=True)
        head = TurnHeadResult(positions=())
        self._serve(TURN_HEAD, LookFeedback(pictures=0, seen=()), lambda _: succeeded(head))
        hands = TwoHandsFeedback(left_force=0.0, right_force=0.0, progress=0.0)
        self._serve(TWO_HANDS, hands, self.arms.two_hands)
        for side in PAIR:
            self._serve_side(side)

    def step(self) -> bool:
        """Answer, and tell what is believed."""
        self._endpoints.step()
        if not self._told:
            self._told = True
            self.tell()
        self.wheels.step()
        return self._step_servers()

    def close(self) -> None:
        """End all skills."""
        self._close_servers()
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
            status = ArmStatus(
                stamp=stamp, group=group, state=ArmState.ARM_IDLE, extent=self.arms.extent[side]
            )
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

    @property
    def hands(self) -> dict[HandName, int | None]:
        """What each hand holds in truth."""
        return self.arms.hands

    @hands.setter
    def hands(self, truth: dict[HandName, int | None]) -> None:
        self.arms.hands = truth

    @property
    def arms_out(self) -> bool:
        """Whether an arm is out."""
        return any(extent > TUCKED for extent in self.arms.extent.values())

    def put_arms(self, left: float, right: float | None = None) -> None:
        """Have the arms be out or in, whatever they were at: STRETCHED or TUCKED (m); both unless said."""
        self.arms.extent |= {"left": left, "right": left if right is None else right}
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
            lambda goal: self.arms.move(side, goal),
        )
        self._serve(
            approach(f"arm_{side}"),
            ApproachFeedback(phase=ApproachPhase.FIELD, distance=0.0),
            lambda goal: self.arms.approach(side, goal),
        )
        self._serve(survey(f"arm_{side}"), SurveyFeedback(looked_at=0, found=0), self.arms.survey)
        self._serve(grip(side), GripFeedback(width=0.0, force=0.0), lambda goal: self.arms.grip(side, goal))

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
        self._keeper.take_in(sightings)
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
