"""How paths are optimised: typed, frozen. All bounds are counts, so that a seed gives one path."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from tandem.skills.ports.message import Message

Few = Annotated[int, Field(gt=0, le=10_000)]
Amount = Annotated[float, Field(gt=0.0)]


class OptimiserSettings(Message):
    """What STOMP and CHOMP have in common."""

    points: Annotated[int, Field(ge=5, le=200)] = 30
    """Between the ends of a path."""
    iterations: Few = 120
    """After so many the optimiser gives up."""
    polish: Annotated[int, Field(ge=0, le=10_000)] = 24
    """Iterations after the first free path; the cheapest free one is taken."""
    check_every: Few = 3
    """Iterations between two checks by the exact checker."""
    margin: Amount = 0.03
    """Metres from a sphere to what is around from which on nearness costs something."""
    obstacle_weight: Amount = 1500.0
    """What nearness weighs beside smoothness."""
    follow: Amount = 3000.0
    """How closely a path begins to the one that it is seeded with, beside smoothness."""


class ChompSettings(OptimiserSettings):
    """Of CHOMP."""

    rate: Annotated[float, Field(gt=0.0, le=1.0)] = 0.1
    """Share of the covariant step that is gone: 1 / eta."""
    stride: Amount = 0.06
    """Metres (weighed) that no point goes beyond in one iteration."""


class StompSettings(OptimiserSettings):
    """Of STOMP."""

    rollouts: Annotated[int, Field(ge=2, le=200)] = 12
    """Noisy paths of one iteration."""
    kept: Annotated[int, Field(ge=0, le=200)] = 6
    """The cheapest rollouts, which count in the next iteration too."""
    at_once: Few = 2
    """Rollouts that are costed between two chances to be stopped."""
    noise: Amount = 0.15
    """Metres (weighed): standard deviation of the noise where it is greatest."""
    decay: Annotated[float, Field(gt=0.0, le=1.0)] = 0.99
    """By which the noise shrinks with each iteration."""
    settled: Annotated[float, Field(gt=0.0, le=1.0)] = 0.2
    """Share of the noise that is left once a free path has been found."""
    sensitivity: Amount = 10.0
    """h: how much more cheap rollouts count than dear ones."""
