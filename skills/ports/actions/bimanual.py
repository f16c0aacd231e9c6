"""Both arms: who may go (two-arm thesis, Algorithms 2 and 3), and two hands on one thing (eq. 4.2)."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Final, Literal

from pydantic import Field

from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import MOST, Count, HandName, Message, RobotTime, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.skill import ActionType

PAIR: Final[tuple[HandName, HandName]] = ("left", "right")
"""The hands of a robot that has these skills; the tasks for two hands name them."""


class Crossing(Message):
    """State of the arms crossing control; owner: the reflex. 50 Hz while an arm moves, and on each change.

    ``risk`` is Algorithm 2's verdict, or the true distance between the arms' geometry below its bound.
    """

    stamp: RobotTime
    risk: bool
    distance: float
    """d: metres between the hands along the base's y; negative once they have crossed (eq. 4.1)."""
    threshold: float
    """K: metres, after the hands' orientations."""
    clearance: float
    """Metres between the arms' geometry, including what they hold; negative if they overlap."""
    near: bool = False
    """Whether the clearance is below its bound, now or on the way to rest; ``risk`` is true then."""


class Order(StrEnum):
    """What an arm is allowed to do."""

    GO = "GO"
    HOLD = "HOLD"
    """Come to rest, stand, and go on with GO."""
    BACK = "BACK"
    """Go back along the record to a sample of it and stand there; who has no record holds."""
    STOP = "STOP"
    """Come to rest and give up: the goal fails as ARMS_CROSSING."""


class ArmOrder(Message):
    """One arm's order. ``sample``: for BACK, the sample of its record to which it goes back."""

    side: HandName
    order: Order
    sample: Annotated[int, Field(ge=0, le=MOST)] = 0


class RightOfWay(Message):
    """Which arm may move; owner: the coordination. 20 Hz, and on each change.

    Approaches and moves obey it at once. No message for ``ORDER_LOST_AFTER`` while an episode is open means
    HOLD for both.
    """

    stamp: RobotTime
    episode: Count
    """Counts the stops; 0 before the first."""
    open: bool = False
    """Whether an arm is held or sent back."""
    leader: HandName | None = None
    orders: tuple[ArmOrder, ...] = ()

    def of(self, side: str) -> ArmOrder | None:
        """Return the order of a side; None means GO."""
        return next((each for each in self.orders if each.side == side), None)


ORDER_LOST_AFTER: Final = 0.5
"""Robot seconds."""


class CoordinateGoal(Message):
    """Coordinate both arms until cancelled (two-arm thesis, Algorithm 3). Ends by a cancel only, at rest.

    ``faithful``: the arm that backed up continues when the leader has picked and is back in its safe
    place. ``eager``: if the announced paths come close, the arms don't wait for a risk. One goes as far as it
    stays out of the other's path, and continues as soon as the true clearance along its own path allows.
    """

    mode: Literal["faithful", "eager"] = "eager"
    phi: Annotated[float, Field(gt=0.0, le=60.0)] | None = None
    """Robot seconds between two samples of the record that are kept; the robot's own unless given."""


class CoordinateFeedback(Message):
    """How often the arms were stopped, which one leads, and whether both are safe."""

    episode: Count
    leader: HandName | None = None
    left_safe: bool = True
    right_safe: bool = True


class CoordinateResult(Message):
    """How often the arms were stopped (in case it ever ends without a cancel)."""

    episodes: Count


class TwoHands(StrEnum):
    """What two hands do with one object."""

    SQUEEZE = "squeeze"
    """Close in until both wrists feel the force; then hold it."""
    MOVE = "move"
    """Bring the thing to ``to`` with the hands' distance and attitude to each other kept (eq. 4.2)."""
    RELEASE = "release"
    """Let go, both at once, and draw the hands apart."""


class TwoHandsGoal(Message):
    """Squeeze, move or release the item between the hands.

    ``to``: for MOVE, the item's centre frame in the map. ``force``: newtons of each hand; the robot's own
    choice for the item unless given. ``apart``: metres by which RELEASE draws each hand back.
    """

    do: TwoHands
    item: Annotated[int, Field(ge=0, le=MOST)]
    to: Pose | None = None
    force: Annotated[float, Field(gt=0.0)] | None = None
    apart: Annotated[float, Field(ge=0.0)] = 0.10
    touch_support: bool = False
    """Whether the item may touch its support, for lifting it and putting it down."""


class TwoHandsFeedback(Message):
    """Newtons at each wrist along the squeeze, and how far the motion is."""

    left_force: float
    right_force: float
    progress: Annotated[float, Field(ge=0.0, le=1.0)]


class TwoHandsResult(Message):
    """How it ended: forces in newtons, and where the item is believed to be in the hands' middle frame."""

    left_force: float
    right_force: float
    item_in_map: Pose | None = None
    tilt: float = 0.0
    """Tilt of the hands' common frame in radians, from the joints."""


class ZoneRow(Message):
    """One row of the workspace at constant x: its cells along y, from ``y0`` on."""

    x: float
    cells: str
    """One letter per cell: L (S_L), R (S_R), C (common), U (unreachable)."""


class Zones(Message):
    """The workspace of both hands at one height, in the base (two-arm thesis, 4.1.1); owner: bimanual.

    A cell is reachable if the hand has a grasp there with collision-free joint positions.
    """

    stamp: RobotTime
    height: float
    """Metres above the floor."""
    torso: float
    """Torso position (m) that it is valid for."""
    cell: float
    """Edge of a cell in metres."""
    y0: float
    """y of the first cell's centre."""
    rows: tuple[ZoneRow, ...]

    def at(self, point: Vector3) -> Literal["L", "R", "C", "U"]:
        """Return the zone of a point in the base; beyond the grid everything is unreachable."""
        for row in self.rows:
            if abs(point[0] - row.x) <= self.cell / 2.0:
                index = round((point[1] - self.y0) / self.cell)
                if 0 <= index < len(row.cells):
                    letter = row.cells[index]
                    return "L" if letter == "L" else "R" if letter == "R" else "C" if letter == "C" else "U"
        return "U"


CROSSING: Final = Topic("skill/reflex/crossing", Crossing)
RIGHT_OF_WAY: Final = Topic("skill/bimanual/right_of_way", RightOfWay)
ZONES: Final = Topic("world/zones", Zones)
COORDINATE: Final = ActionType(
    "bimanual/coordinate", CoordinateGoal, CoordinateFeedback, CoordinateResult, timeout=600.0
)
TWO_HANDS: Final = ActionType(
    "bimanual/two_hands", TwoHandsGoal, TwoHandsFeedback, TwoHandsResult, timeout=60.0
)
