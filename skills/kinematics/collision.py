"""Whether a group's joints can stand somewhere: the moving links against the rest and the world.

A checker is made for one group with everything else standing still, which leaves few bodies and few
pairs: about 20 us a state.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.bodies import Carried, CellsShape, Obstacle
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.moving_spheres import MovingSpheres
from tandem.skills.kinematics.pair_tables import CONTACT, DOUBT, FREE
from tandem.skills.kinematics.pairs import Bodies
from tandem.skills.kinematics.transforms import Array
from tandem.skills.kinematics.world_field import Around, WorldField

if TYPE_CHECKING:
    from tandem.skills.kinematics.quick import Quick


@dataclass(frozen=True)
class Contact:
    """Two bodies that overlap, by ``depth`` metres. Links, obstacles and carried things by name."""

    first: str
    second: str
    depth: float


@dataclass(frozen=True)
class Clearance:
    """The two bodies that are nearest, and the metres between them (below zero: they overlap)."""

    distance: float
    first: str
    second: str


@dataclass(frozen=True)
class _Resting:
    """A pair that was in contact in a reference configuration, and may go on being so near it."""

    pair: int
    moving: int
    depth: float
    position: Array


MAX_RESTING_DEPTH = 0.02
"""Metres: contacts deeper than this are no resting but an error."""
RESTING_REACH = 0.05
"""Metres: how far the moving body may go while it is still said to rest."""
DEEPER = 0.002
"""Metres: how much deeper than in the reference a resting contact may become."""
BEFORE = 700
"""Checks that coal makes before the field is made, which costs about as much: many plans need no more."""


class CollisionChecker:
    """The collisions of one group's motion.

    Args:
        hulls: the robot's bodies.
        joints: those that move; the order of every array (n,) here.
        positions: where the others stand.
        obstacles: the world, in the base frame.
        carried: what hands hold (of this group or another).
        allowed: pairs of names (links, obstacles, carried things) that may be in contact.
        touchable: pairs of names that may be in contact while ``touch`` allows it.
        world: decides most of many states at once; without it coal decides each. The answers are the same.
    """

    def __init__(  # noqa: PLR0917 - the world's parts, in one order everywhere
        self,
        hulls: RobotHulls,
        joints: Sequence[str],
        positions: Mapping[str, float],
        obstacles: Sequence[Obstacle] = (),
        carried: Sequence[Carried] = (),
        allowed: Sequence[tuple[str, str]] = (),
        touchable: Sequence[tuple[str, str]] = (),
        world: WorldField | None = None,
    ) -> None:
        self.chain = Chain(hulls.robot, joints, positions)
        self.joints = self.chain.joints
        self.checks = 0
        _, reduced = pin.buildReducedModel(
            hulls.robot.model, hulls.geometry, self.chain.locked, self.chain.reference
        )
        self._bodies = Bodies(hulls, self.chain, reduced)
        self._bodies.add_carried(carried)
        self._bodies.add_obstacles(obstacles)
        self._geometry, self._touchable = self._bodies.build(allowed, touchable)
        self.names = tuple(self._bodies.names)
        self._data, self._geometry_data = self.chain.model.createData(), self._geometry.createData()
        self._manager = pin.BroadPhaseManager_NaiveCollisionManager(
            self.chain.model, self._geometry, self._geometry_data
        )
        self._resting: tuple[_Resting, ...] = ()
        self._touching = False
        self._first_obstacle = len(hulls.links) + len(carried)
        self.obstacles = tuple(obstacles)
        # Occupied cells are larger in the field than they are, and take it long: coal decides among them.
        cells = any(isinstance(each.shape, CellsShape) for each in obstacles)
        self._world, self._carried = None if cells else world, tuple(carried)
        self._permitted = {name for pair in (*allowed, *touchable) for name in pair}
        self._quick: Quick | None = None

    def spheres(self) -> MovingSpheres:
        """Return the bodies that move, and those of the robot that they must not meet, as spheres."""
        names = list(self.chain.model.names)[1:]
        columns = np.array([self.joints.index(name) for name in names])
        return MovingSpheres(self.chain.model, self._geometry, columns, self._first_obstacle)

    def touch(self, *, allowed: bool) -> None:
        """Say whether the touchable pairs may be in contact from now on."""
        if allowed == self._touching:
            return
        self._touching = allowed
        resting = {each.pair for each in self._resting}
        for k in self._touchable:
            if allowed:
                self._geometry_data.deactivateCollisionPair(k)
            elif k not in resting:
                self._geometry_data.activateCollisionPair(k)

    @property
    def pairs(self) -> int:
        """How many pairs of bodies are checked."""
        return len(self._geometry.collisionPairs)

    def free(self, q: Array) -> bool:
        """Say whether the group can stand at q (n,)."""
        self.checks += 1
        quick = self._looks()
        if quick is None:
            return self._free(q)
        answer = quick.look(np.asarray(q, dtype=float)[None])[0]
        return bool(answer == FREE) or (bool(answer == DOUBT) and self._free(q))

    def _free(self, q: Array) -> bool:
        """Ask coal."""
        at = self.chain.to_model(q)
        if pin.computeCollisions(self.chain.model, self._data, self._manager, at, True):
            return False
        return not self._resting or self._rests()

    def first_contact(self, path: Array) -> int | None:
        """Return the index of the first state of the path (m, n) that is not free, or None."""
        quick = self._looks()
        if quick is None:
            return next((i for i, q in enumerate(path) if not self.free(q)), None)
        states = np.ascontiguousarray(path, dtype=float)
        found = np.empty(len(states), dtype=np.int8)
        at = -1
        while (at := quick.first(states, at + 1, found)) < len(states):
            if found[at] == CONTACT or not self._free(states[at]):
                self.checks += at + 1
                return at
        self.checks += len(states)
        return None

    def look(self, states: Array) -> npt.NDArray[np.int8]:
        """Return what the field alone says about states (m, n): ``FREE``, ``CONTACT`` or ``DOUBT`` (m,)."""
        if self._world is None:
            return np.full(len(states), DOUBT, dtype=np.int8)
        return self._made(self._world).look(states)

    def _looks(self) -> Quick | None:
        """Return what looks at many states, once it pays to make it."""
        if self._world is None or (self._quick is None and self.checks < BEFORE):
            return None
        return self._made(self._world)

    def _made(self, world: WorldField) -> Quick:
        if self._quick is None:
            pairs = self._geometry.collisionPairs
            loose = [each.pair for each in self._resting] + list(self._touchable)
            resting = frozenset((int(pairs[k].first), int(pairs[k].second)) for k in loose)
            named = {k for k, name in enumerate(self.names) if name in self._permitted}
            may_touch = frozenset(named.union(*resting))
            around = Around(self._carried, self.obstacles, may_touch, resting)
            self._quick = world.quick(self.chain, self._geometry, around)
        world.hold(self._quick.field, self.obstacles)
        return self._quick

    def contacts(self, q: Array) -> tuple[Contact, ...]:
        """Return all pairs that overlap at q, deepest first; those that may rest as they do are left out."""
        self._place(q)
        found = []
        for k in self._counted():
            depth = -self._distance(k)
            if depth > 0.0 and not self._may_rest(k, depth):
                found.append(Contact(*self._names_of(k), depth))
        return tuple(sorted(found, key=lambda contact: (-contact.depth, contact.first, contact.second)))

    def clearance(self, q: Array, *, to_world: bool = False) -> Clearance | None:
        """Return the nearest pair at q, or None if there is none.

        Args:
            q: joint positions (n,).
            to_world: leave out the pairs of two links of the robot.
        """
        self._place(q)
        numbers = [
            k
            for k in self._counted()
            if not to_world or self._bodies.has_world(self._geometry.collisionPairs[k])
        ]
        if not numbers:
            return None
        distances = [self._distance(k) for k in numbers]
        nearest = int(np.argmin(distances))
        return Clearance(distances[nearest], *self._names_of(numbers[nearest]))

    def let_rest(
        self, q: Array, *, carried_only: bool = False, deepest: float = MAX_RESTING_DEPTH
    ) -> tuple[Contact, ...]:
        """Permit the shallow contacts that there are at q, as long as they get no deeper nearby.

        So an item can be lifted from the table on which it stands, set down on it, and a hand can leave
        what it touches: a pair in contact at q may stay so while the moving body is within
        ``RESTING_REACH`` of where it is at q, and the overlap grows by no more than ``DEEPER``.

        Args:
            q: the reference configuration (n,): the start, or the place to set down.
            carried_only: permit the contacts of carried things, not of links.
            deepest: metres of overlap beyond which a contact is not permitted.

        Returns:
            The contacts that are too deep, or of a link though ``carried_only``.
        """
        if self.free(q):
            return ()
        self._place(q)
        refused, resting = [], list(self._resting)
        for k in self._counted():
            depth = -self._distance(k)
            if depth <= 0.0:
                continue
            pair = self._geometry.collisionPairs[k]
            carried = self._bodies.is_carried(pair.first) or self._bodies.is_carried(pair.second)
            if depth > deepest or (carried_only and not carried):
                if not self._may_rest(k, depth):
                    refused.append(Contact(*self._names_of(k), depth))
                continue
            moving = int(pair.first if self._moves(pair.first) else pair.second)
            resting.append(_Resting(k, moving, depth, self._position(moving)))
        self._resting = tuple(resting)
        self._quick = None
        for each in resting:
            self._geometry_data.deactivateCollisionPair(each.pair)
        return tuple(sorted(refused, key=lambda contact: -contact.depth))

    def _counted(self) -> Sequence[int]:
        """Return the pairs whose contact counts."""
        if not self._touching:
            return range(self.pairs)
        return [k for k in range(self.pairs) if k not in self._touchable]

    def _place(self, q: Array) -> None:
        at = self.chain.to_model(q)
        pin.updateGeometryPlacements(self.chain.model, self._data, self._geometry, self._geometry_data, at)

    def _distance(self, pair: int) -> float:
        return float(pin.computeDistance(self._geometry, self._geometry_data, pair).min_distance)

    def _position(self, body: int) -> Array:
        return np.array(self._geometry_data.oMg[body].translation)

    def _moves(self, body: int) -> bool:
        return bool(self._geometry.geometryObjects[int(body)].parentJoint > 0)

    def _names_of(self, pair: int) -> tuple[str, str]:
        numbers = self._geometry.collisionPairs[pair]
        return self.names[numbers.first], self.names[numbers.second]

    def _rests(self) -> bool:
        done: list[int] = []
        for each in self._resting:
            if each.pair in done:
                continue
            done.append(each.pair)
            depth = -self._distance(each.pair)
            if depth > 0.0 and not self._may_rest(each.pair, depth):
                return False
        return True

    def _may_rest(self, pair: int, depth: float) -> bool:
        return any(
            each.pair == pair
            and depth <= each.depth + DEEPER
            and float(np.linalg.norm(self._position(each.moving) - each.position)) <= RESTING_REACH
            for each in self._resting
        )
