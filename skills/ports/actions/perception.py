"""Look and track: tags and clutter out of the head camera."""

from __future__ import annotations

import math
from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.message import MOST, Count, Message, Vector3
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import ActionType
from tandem.skills.ports.world import Sighting


class LookGoal(Message):
    """Point the head, take pictures, and report what is there.

    Looks at ``at`` (a point in the map) or else through the ``tilts`` (radians, down is negative), straight
    ahead. Ends early once ``item`` has been seen. With ``clutter``, untagged objects are measured from the
    depth image and added to the planning scene; with ``around``, also on all nearby furniture, because an
    arm must know what it may hit.
    """

    item: Count | None = None
    at: Vector3 | None = None
    tilts: tuple[float, ...] = (-0.45,)
    pictures: Annotated[int, Field(ge=1, le=20)] = 1
    """Pictures at each head position; tag poses are averaged over them."""
    clutter: bool = False
    around: Annotated[float, Field(ge=0.0, le=5.0)] = 0.0
    """Metres about the base's axis within which the tops of all furniture are looked at, too."""


class LookFeedback(Message):
    """Pictures taken and items seen so far."""

    pictures: Count
    seen: tuple[Count, ...]


class LookResult(Message):
    """Every tag seen; success also when there is none (``found`` tells about ``item``)."""

    found: bool
    sightings: tuple[Sighting, ...]
    hidden: tuple[Count, ...] = ()
    """Items that were not seen because something closer to the camera hides their place."""
    clutter: Count = 0
    """Boxes of clutter measured."""
    head_short: Annotated[float, Field(ge=0.0, le=math.tau)] = 0.0
    """Radians by which the head, held up by something, stopped short of where the goal had it look; 0.0 when
    it got there. What was not seen then may well be there."""


class TrackGoal(Message):
    """Report the tags of ``items`` (default: all) in each picture, until cancelled.

    An item hidden by an arm is not reported as gone (two-arm thesis, Algorithm 1). The head follows the
    visible items of ``gaze`` and searches the lost ones; pictures are read only between its motions. Without
    ``gaze``, the head doesn't move.
    """

    items: tuple[Annotated[int, Field(ge=0, le=MOST)], ...] = ()
    gaze: tuple[Annotated[int, Field(ge=0, le=MOST)], ...] = ()


class TrackResult(Message):
    """Number of pictures read (in case it ever ends without a cancel)."""

    pictures: Count


class TurnHeadGoal(Message):
    """Point the camera at ``at`` (m, in the map) as it will be seen from ``base``, and take no picture.

    For a base that is on its way there: the head has arrived when the base does.
    """

    at: Vector3
    base: FloorPose
    """In the map."""


class TurnHeadResult(Message):
    """Where the head is, by its joints (rad)."""

    positions: tuple[float, ...]


class AskView(Message):
    """Query what a camera sees."""

    camera: Annotated[str, Field(max_length=64)] = ""
    """One of the description's; empty: the first, which perception looks with."""


PICTURE: Final = "skill/perception/picture"
"""Asked with an ``AskView``; answered with the camera's next picture as JPEG, or empty when none comes."""
LOOK: Final = ActionType("perception/look", LookGoal, LookFeedback, LookResult, timeout=30.0)
TRACK: Final = ActionType("perception/track", TrackGoal, LookFeedback, TrackResult, timeout=600.0)
TURN_HEAD: Final = ActionType(
    "perception/turn_head", TurnHeadGoal, LookFeedback, TurnHeadResult, timeout=15.0
)
