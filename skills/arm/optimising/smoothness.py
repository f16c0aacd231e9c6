"""How smooth a path is: the integral of its squared accelerations, from rest to rest.

A path has N points between two fixed ends, one unit of time in all. It rests at both ends: the points beyond
them are the ends themselves (Kalakrishnan et al., "STOMP: Stochastic Trajectory Optimization for Motion
Planning", ICRA 2011, eq. 2 and 3; Zucker et al., "CHOMP: Covariant Hamiltonian Optimization for Motion
Planning", IJRR 32(9), 2013, 3.2).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tandem.skills.kinematics.transforms import Array


@dataclass(frozen=True)
class Smoothness:
    """The quadratic form of paths with N points between their ends.

    Attributes:
        differences: K (N + 2, N); K x + e are the accelerations, with e from the ends.
        matrix: A = K^T K h (N, N), with h the time between two points: R of STOMP.
        inverse: A^-1 (N, N).
        noise: lower triangle L (N, N); L z has the covariance A^-1, scaled to at most one.
        smoothing: M (N, N) of STOMP: A^-1, each column scaled to a greatest element of 1 / N.
    """

    differences: Array
    matrix: Array
    inverse: Array
    noise: Array
    smoothing: Array

    @property
    def count(self) -> int:
        """N."""
        return len(self.matrix)

    def accelerations(self, path: Array) -> Array:
        """Return them at all points of a path (..., N + 2, n), ends included; the same shape."""
        padded = np.concatenate((path[..., :1, :], path, path[..., -1:, :]), axis=-2)
        return np.asarray(np.diff(padded, n=2, axis=-2) * (self.count + 1) ** 2)

    def costs(self, path: Array) -> Array:
        """Return each point's share of the cost (..., N + 2): half its squared acceleration times h."""
        squared = np.sum(self.accelerations(path) ** 2, axis=-1)
        return np.asarray(0.5 * squared / (self.count + 1))

    def gradient(self, path: Array) -> Array:
        """Return the cost's gradient (N, n) at the points between the ends of a path (N + 2, n)."""
        return np.asarray(self.differences.T @ self.accelerations(path) / (self.count + 1))

    def smoothest(self, start: Array, end: Array) -> Array:
        """Return the path (N + 2, n) of the least cost: the straight line, slow at both ends."""
        line = np.linspace(start, end, self.count + 2)
        line[1:-1] -= self.inverse @ self.gradient(line)
        return line


@lru_cache(maxsize=8)
def smoothness(count: int) -> Smoothness:
    """Return the form for so many points between the ends."""
    rate = (count + 1) ** 2
    differences = np.zeros((count + 2, count))
    for i in range(count):
        differences[i, i] += 1.0
        differences[i + 1, i] -= 2.0
        differences[i + 2, i] += 1.0
    differences *= rate
    matrix = differences.T @ differences / (count + 1)
    inverse = np.linalg.inv(matrix)
    inverse = 0.5 * (inverse + inverse.T)
    noise = np.linalg.cholesky(inverse) / np.sqrt(np.max(np.diag(inverse)))
    smoothing = inverse / np.max(np.abs(inverse), axis=0) / count
    return Smoothness(differences, matrix, inverse, noise, smoothing)
