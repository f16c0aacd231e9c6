"""Transforms as tf tells them: each frame in its parent, the newest of each."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from tandem.skills.geometry.poses import compose
from tandem.skills.ports.pose import Pose
from tandem.skills.ros.readings import pose_of

if TYPE_CHECKING:
    from tandem.skills.ros.messages import TransformStamped

DEEPEST: Final = 32
"""Links of a chain; a longer one is a ring."""


@dataclass(frozen=True)
class _Link:
    parent: str
    child_in_parent: Pose


@dataclass(eq=False)
class Frames:
    """What is known of the tree of frames."""

    _links: dict[str, _Link] = field(default_factory=dict)

    def learn(self, told: TransformStamped) -> str:
        """Take a transform in; return the frame that it places.

        Raises:
            UnfitError: its numbers are no pose.
        """
        child, parent = told.child_frame_id.lstrip("/"), told.header.frame_id.lstrip("/")
        placed = pose_of(told.transform.translation, told.transform.rotation)
        self._links[child] = _Link(parent, placed)
        return child

    def chain(self, child: str, parent: str) -> tuple[str, ...]:
        """Return the frames from the child up to the parent, without it; none where a link is missing."""
        found: list[str] = []
        while child != parent:
            link = self._links.get(child)
            if link is None or len(found) >= DEEPEST:
                return ()
            found.append(child)
            child = link.parent
        return tuple(found)

    def find(self, child: str, parent: str) -> Pose | None:
        """Return the child's pose in the parent; None where a link is missing."""
        frames = self.chain(child, parent)
        if not frames:
            return None
        pose = self._links[frames[0]].child_in_parent
        for each in frames[1:]:
            pose = compose(self._links[each].child_in_parent, pose)
        return pose
