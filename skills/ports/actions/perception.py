"""Look and track: tags and clutter out of the head camera."""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.message import MOST, Count, Message, Vector3
from tandem.skills.ports.skill import ActionType
from tandem.skills.ports.world import Sighting


class LookGoal(Message):
    """Point the head, take pictures, and report what is there.

    Looks at ``at`` (a point in the map) or else through the ``tilts`` (radians, down is negative), straight
    ahead. Ends early once ``item`` has been seen. With ``clutter``, what is untagged is measured from the
    depth image and goes into the planning scene; with ``around`` too, on all furniture that is near, for an
    arm must know what it may meet.
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


class TrackGoal(Message):
    """Tell the tags of ``items`` (all of them unless given) from each picture, until cancelled.

    What an arm hides is not told to be gone (two-arm thesis, Algorithm 1). The head follows what stands of
    ``gaze``, and looks for what is gone of it; between its motions only, pictures are read. Without, it stays
    as it stands.
    """

    items: tuple[Annotated[int, Field(ge=0, le=MOST)], ...] = ()
    gaze: tuple[Annotated[int, Field(ge=0, le=MOST)], ...] = ()


class TrackResult(Message):
    """Number of pictures read (in case it ever ends without a cancel)."""

    pictures: Count


PICTURE: Final = "skill/perception/picture"
"""Asked with nothing; answered with the head camera's next picture as JPEG, or empty when none comes."""
LOOK: Final = ActionType("perception/look", LookGoal, LookFeedback, LookResult, timeout=30.0)
TRACK: Final = ActionType("perception/track", TrackGoal, LookFeedback, TrackResult, timeout=600.0)
