"""Inverse kinematics: joint positions that bring a frame to poses.

Damped least squares with the damping of Sugihara, "Solvability-Unconcerned Inverse Kinematics by the
Levenberg-Marquardt Method" (IEEE T-RO 27(5), 2011, eq. 20), from several starts at once: the present
configuration, and those of a table whose hands are nearest to the pose. Everything is bounded by counts, and
nothing is drawn but the table, so the same generator gives the same solutions.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.batch import BatchChain, left
from tandem.skills.kinematics.model import Chain, Limits
from tandem.skills.kinematics.transforms import Array
from tandem.skills.kinematics.turning import TurningChain, Vertical, widened

SIX = 6
"""Ways in which a body can move."""
TURN_WEIGHT = 0.25
"""Metres that a radian counts when the table's nearest hands are looked for."""
HOPELESS_AFTER = 8
"""Iterations after which a start that is still far away is given up."""
ENOUGH_AFTER = 6
"""Iterations after which it is enough when half of the starts got there."""
NEARLY = 0.1
"""Radians: a hand turned less is told to be as far away as its origin."""
FAR = 0.25
"""Metres and radians, together."""
SPREAD = 8
"""Configurations, spread over the limits, at which it is asked in which ways a hand can move: one might be
singular."""
RIGID = 1e-6
"""Metres and radians a radian: below it, no joint moves the hand in some way. Rounding gives 1e-16, the
shipped arms of six joints or more 0.003 to 0.17."""


@dataclass(frozen=True)
class IkSettings:
    """Bounds and tolerances."""

    starts: int = 6
    """Of each pose."""
    iterations: int = 16
    position_tolerance: float = 2e-4
    """Metres."""
    angle_tolerance: float = 1e-3
    """Radians."""
    damping: float = 0.05
    largest_step: float = 0.6
    """Radians a joint may go in one iteration."""
    apart: float = 0.25
    """Radians by which some joint of two distinct solutions differs."""


@dataclass(frozen=True)
class IkAnswer:
    """What was found for one pose.

    Attributes:
        solutions: joint positions, nearest to the reference first, each (n,); collisions are not looked at.
        distance: metres from the pose that the best start ended at (0 when reached).
    """

    solutions: tuple[Array, ...]
    distance: float


class Descends(Protocol):
    """A chain that goes down towards targets: ``BatchChain``, or one whose targets turn."""

    def root(self, chain: Chain) -> pin.SE3:
        """Return the first joint's frame in the base."""

    def error(self, q: Array, targets: Array) -> tuple[Array, Array]:
        """Return the twists (m, 6) from the tip to the targets (m, 4, 4), and their Jacobians (m, 6, n)."""

    def descend(
        self, q: Array, targets: Array, limits: Limits, *, damping: float, largest: float
    ) -> tuple[Array, Array]:
        """Return one step's q (m, n), and the twists (m, 6) that were left before it."""


class Seeds(Protocol):
    """Where to start."""

    def nearest(self, targets: Array, count: int) -> Array:
        """Return configurations (t, count, n) for targets (t, 4, 4)."""


class SeedTable:
    """Configurations spread over the limits, with their hands' poses.

    Args:
        batch: of the chain.
        limits: of its joints.
        rng: draws them.
        usable: says which configurations (n,) are worth a start (free of collision with the robot itself).
        size: how many are drawn.
    """

    def __init__(
        self,
        batch: BatchChain,
        limits: Limits,
        rng: np.random.Generator,
        usable: Callable[[Array], bool],
        size: int = 3000,
    ) -> None:
        drawn = rng.uniform(limits.lower, limits.upper, size=(size, len(limits.lower)))
        self.q: Array = drawn[[usable(each) for each in drawn]]
        self._features = _features(batch.frames(self.q)[1])
        self._squares = np.einsum("ij,ij->i", self._features, self._features)

    def nearest(self, targets: Array, count: int) -> Array:
        """Return the configurations (t, count, n) whose hands are nearest to the targets (t, 4, 4)."""
        distances = self._squares[:, None] - 2.0 * self._features @ _features(targets).T
        count = min(count, len(self.q))
        rows = np.argpartition(distances, count - 1, axis=0)[:count]
        return np.asarray(self.q[rows.T])


class _Unturned:
    """A table's configurations, each with a turn of 0 behind its joints."""

    def __init__(self, table: Seeds) -> None:
        self._table = table

    def nearest(self, targets: Array, count: int) -> Array:
        """Return configurations (t, count, n + 1)."""
        return np.pad(self._table.nearest(targets, count), ((0, 0), (0, 0), (0, 1)))


class Solver:
    """Solves for one frame of a chain.

    Args:
        batch: the chain.
        limits: of its joints.
        table: where to start.
        settings: bounds.
    """

    def __init__(
        self, batch: Descends, limits: Limits, table: Seeds, settings: IkSettings | None = None
    ) -> None:
        self.batch, self.limits = batch, limits
        self._table, self.settings = table, settings or IkSettings()

    @cached_property
    def exact(self) -> bool:
        """Whether the hand can move in all six ways at once: the arm takes any pose within reach as it is.

        A number of joints does not tell: an arm that goes up and down, turns about the vertical, bends three
        times and rolls has six, and can't turn its hand about the vertical where it is.
        """
        number, span = len(self.limits.lower), self.limits.upper - self.limits.lower
        shares = np.outer(np.arange(1, SPREAD + 1), np.sqrt(np.arange(2.0, number + 2.0))) % 1.0
        q = self.limits.lower + (0.1 + 0.8 * shares) * span
        _, jacobians = self.batch.error(q, np.broadcast_to(np.eye(4), (SPREAD, 4, 4)))
        least = np.linalg.svd(jacobians, compute_uv=False)[:, -1]
        return number >= SIX and float(least.max()) > RIGID

    def turning(self, chain: Chain, vertical: Vertical) -> Solver:
        """Return a solver whose targets may turn about a vertical: by how much is its last column."""
        batch = TurningChain(self.batch, chain, vertical)
        return Solver(batch, widened(self.limits, vertical.most), _Unturned(self._table), self.settings)

    def solve(
        self, chain: Chain, targets_in_base: Sequence[pin.SE3], reference: Array, starts: int
    ) -> Generator[int, None, tuple[IkAnswer, ...]]:
        """Look for joint positions at which the frame is at the targets, each by itself.

        Args:
            chain: the joints, the others locked where they stand now.
            targets_in_base: where the frame shall be.
            reference: joint positions (n,) to be near to, and the first start.
            starts: of each target.

        Yields:
            The units of each iteration.
        """
        targets = self.in_root(chain, targets_in_base)
        number = len(targets)
        first = np.broadcast_to(reference, (number, 1, len(reference)))
        begin = np.concatenate((first, self._table.nearest(targets, starts - 1)), axis=1)
        per = begin.shape[1]
        q, metres, radians = yield from self.descend(
            begin.reshape(number * per, -1), np.repeat(targets, per, axis=0), several=True
        )
        reached = self.reached(metres, radians)
        answers = []
        for k in range(number):
            rows = range(k * per, (k + 1) * per)
            good = sorted(
                (q[i] for i in rows if reached[i]), key=lambda each: travel(each, reference, self.limits)
            )
            turned = radians > NEARLY
            nearest = min(float(metres[i] + turned[i] * radians[i]) for i in rows)
            answers.append(IkAnswer(self._distinct(good), 0.0 if good else nearest))
        return tuple(answers)

    def descend(
        self, q: Array, targets: Array, *, rough: bool = False, several: bool = False
    ) -> Generator[int, None, tuple[Array, Array, Array]]:
        """Go down from q (m, n) towards the targets (m, 4, 4), told in the chain's root.

        Args:
            q: where to start.
            targets: one for each.
            rough: end where the error is ten times the tolerances.
            several: the rows are starts of which not all need to get there: the slow ones are given up.

        Returns:
            The joints (m, n), and the metres and radians (m,) that are left.
        """
        settings, limits = self.settings, self.limits
        q = np.minimum(np.maximum(q, limits.lower), limits.upper)
        metres, radians = np.full(len(q), np.inf), np.full(len(q), np.inf)
        going = np.arange(len(q))
        scale = 0.1 if rough else 1.0
        for number in range(settings.iterations):
            further, twist = self.batch.descend(
                q[going], targets[going], limits, damping=settings.damping, largest=settings.largest_step
            )
            yield 4 + len(going) // 4
            metres[going], radians[going] = left(twist)
            on = ~self.reached(scale * metres[going], scale * radians[going])
            if several and number >= HOPELESS_AFTER:
                on &= metres[going] + radians[going] < FAR
            going = going[on]
            if not len(going) or (several and number >= ENOUGH_AFTER and 2 * len(going) <= len(q)):
                break
            if number + 1 < settings.iterations:
                q[going] = further[on]
        return q, metres, radians

    def in_root(self, chain: Chain, targets_in_base: Sequence[pin.SE3]) -> Array:
        """Return poses (m, 4, 4) as the chain's first joint sees them."""
        inverse = self.batch.root(chain).inverse()
        return np.array([(inverse * target).homogeneous for target in targets_in_base])

    def reached(self, metres: Array, radians: Array) -> npt.NDArray[np.bool_]:
        """Return which of them are within the tolerances (m,)."""
        settings = self.settings
        return np.asarray((metres <= settings.position_tolerance) & (radians <= settings.angle_tolerance))

    def _distinct(self, solutions: Sequence[Array]) -> tuple[Array, ...]:
        kept: list[Array] = []
        for q in solutions:
            if all(float(np.max(np.abs(q - other))) > self.settings.apart for other in kept):
                kept.append(q)
        return tuple(kept)


def travel(a: Array, b: Array, limits: Limits) -> float:
    """Return the seconds from a to b if each joint went at its full speed at once."""
    return float(np.max(np.abs(a - b) / limits.velocity))


def _features(poses: Array) -> Array:
    """Return rows (m, 12) whose Euclidean distance is that of the poses, about.

    Two rotations an angle apart have matrices sqrt(8) sin(angle / 2) apart (Frobenius): sqrt(2) a radian.
    """
    turns = poses[:, :3, :3].reshape(-1, 9) * (TURN_WEIGHT / np.sqrt(2.0))
    return np.concatenate((poses[:, :3, 3], turns), axis=1)
