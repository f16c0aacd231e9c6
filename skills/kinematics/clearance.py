"""The true distance between the two arms' bodies, with what they hold.

Only pairs of one body of each arm are looked at: about 150 of convex bodies, 0.1 ms together. A broad phase
is left out: coal needs less for the distances of that many pairs than for moving its trees.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.bodies import Carried, geometry
from tandem.skills.kinematics.collision import Clearance
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.robot_description import RobotDescription

AHEAD: Final = (0.5, 1.0)
"""Shares of the way to rest at which the clearance is looked at, besides where the joints are."""


class ArmsClearance:
    """Distances between the two arms; everything else (torso, head) stands where ``positions`` say.

    Args:
        hulls: the robot's bodies.
        description: the robot; it has a hand ``left`` and a hand ``right``.
        positions: where the joints stand that are of neither arm; fingers too.
        carried: what the hands hold.
        together: names of carried things that both hands hold: their distances don't count.
    """

    def __init__(
        self,
        hulls: RobotHulls,
        description: RobotDescription,
        positions: Mapping[str, float],
        carried: Sequence[Carried] = (),
        together: Sequence[str] = (),
    ) -> None:
        robot = hulls.robot
        groups = [description.group(description.end_effector(side).group) for side in PAIR]
        self.joints: tuple[str, ...] = tuple(joint for group in groups for joint in group.joints)
        """Left arm's joints, then the right arm's: the order of every array (n,) here."""
        limits = [limit for group in groups for limit in group.limits]
        self._acceleration = np.array([limit.acceleration for limit in limits])
        self._jerk = np.array([limit.jerk for limit in limits])
        self._left = len(groups[0].joints)
        moving = {robot.joint_index(joint) + 1 for joint in self.joints}
        locked = [i for i in range(1, robot.model.njoints) if i not in moving]
        self._model, self._geometry = pin.buildReducedModel(
            robot.model, hulls.geometry, locked, robot.configuration(positions)
        )
        names = list(self._model.names)[1:]
        self._order = np.array([self.joints.index(name) for name in names])
        self.names = [*hulls.links]
        frames = {frame.name: frame for frame in self._model.frames}
        for each in carried:
            frame = frames[each.link]
            placement = frame.placement * to_se3(each.pose_in_link)
            label = f"{each.name}#{len(self.names)}"
            body = pin.GeometryObject(label, int(frame.parentJoint), placement, geometry(each.shape))
            self._geometry.addGeometryObject(body)
            self.names.append(each.name)
        self._geometry.setCollisionPairs(self._pairs(len(groups[0].joints), set(together)))
        self._data, self._results = self._model.createData(), self._geometry.createData()

    def _pairs(self, left: int, together: set[str]) -> Array:
        """Return the upper triangle of the bodies' pairs that are looked at."""
        firsts = [self._model.getJointId(self.joints[k]) for k in (0, left)]
        sides = [
            next(
                (
                    k
                    for k, joint in enumerate(firsts)
                    if joint in list(self._model.supports[body.parentJoint])
                ),
                -1,
            )
            if body.parentJoint > 0 and name not in together
            else -1
            for name, body in zip(self.names, self._geometry.geometryObjects, strict=True)
        ]
        side = np.array(sides)
        pairs = np.triu(side[:, None] + side[None, :] == 1, 1)
        pairs &= (side[:, None] >= 0) & (side[None, :] >= 0)
        return np.asarray(pairs)

    def at(self, q: Array) -> Clearance:
        """Return the two nearest bodies, one of each arm, at the joints' positions q (n,)."""
        nearest = pin.computeDistances(self._model, self._data, self._geometry, self._results, q[self._order])
        pair = self._geometry.collisionPairs[nearest]
        metres = float(self._results.distanceResults[nearest].min_distance)
        return Clearance(metres, self.names[pair.first], self.names[pair.second])

    def to_rest(self, velocity: Array, late: float) -> Array:
        """Return the radians (n,) that the joints go to rest, if they brake after ``late`` seconds."""
        ways = [
            braking_way(velocity[arm], self._acceleration[arm], self._jerk[arm])
            for arm in (slice(None, self._left), slice(self._left, None))
        ]
        return np.asarray(np.concatenate(ways) + velocity * late)

    def ahead(self, now: Clearance, q: Array, velocity: Array, late: float) -> Clearance:
        """Return the least clearance on the way to rest, if all joints began to brake after ``late`` seconds.

        Args:
            now: what ``at(q)`` returned: all distances are looked at once for each place.
            q: positions (n,).
            velocity: rad/s (n,).
            late: seconds in which the joints go on as they do.
        """
        way = self.to_rest(velocity, late)
        if float(np.max(np.abs(way))) < 1e-3:  # noqa: PLR2004 - a thousandth of a radian: at rest
            return now
        return min((now, *(self.at(q + share * way) for share in AHEAD)), key=lambda each: each.distance)


def braking_way(velocity: Array, acceleration: Array, jerk: Array) -> Array:
    """Return the radians (n,) in which joints come to rest in step, with bounded deceleration and jerk.

    From a steady speed v, in a time that is mirrored about its middle: so v / 2 over all of it. That is
    v / a + a / j where the greatest deceleration a is reached, else 2 sqrt(v / j); the joint that needs
    longest sets it for all.

    Args:
        velocity: rad/s (n,).
        acceleration: rad/s2 (n,).
        jerk: rad/s3 (n,).
    """
    speed = np.abs(velocity)
    reached = speed >= acceleration**2 / jerk
    time = np.where(reached, speed / acceleration + acceleration / jerk, 2.0 * np.sqrt(speed / jerk))
    return np.asarray(0.5 * velocity * np.max(time))
