"""How a robot's description, or a site's file, declares a reflex."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, JsonValue, model_validator

from tandem.skills.ports.message import Message

ReflexName = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]{0,63}$")]


class Threshold(Message):
    """A bound with hysteresis on something that must not become too small.

    A reflex fires below ``fires`` and holds until the value is above ``releases``, so that noise at one bound
    does not make it flicker.
    """

    fires: Annotated[float, Field(gt=0.0)]
    releases: Annotated[float, Field(gt=0.0)]

    @model_validator(mode="after")
    def _apart(self) -> Threshold:
        if self.releases <= self.fires:
            raise ValueError(
                f"contradictory thresholds: expected releases above fires, "
                f"found {self.releases:g} and {self.fires:g}"
            )
        return self

    def below(self, value: float, *, holds: bool) -> bool:
        """Say whether the reflex fires, or goes on when it ``holds`` already."""
        return value < (self.releases if holds else self.fires)


class Excess(Message):
    """A bound with hysteresis on something that must not become too large, as ``Threshold`` is for too small.

    A reflex fires above ``fires`` and holds until the value is below ``releases``.
    """

    fires: Annotated[float, Field(gt=0.0)]
    releases: Annotated[float, Field(gt=0.0)]

    @model_validator(mode="after")
    def _apart(self) -> Excess:
        if self.releases >= self.fires:
            raise ValueError(
                f"contradictory thresholds: expected releases below fires, "
                f"found {self.releases:g} and {self.fires:g}"
            )
        return self

    def above(self, value: float, *, holds: bool) -> bool:
        """Say whether the reflex fires, or goes on when it ``holds`` already."""
        return value > (self.releases if holds else self.fires)


class ReflexSetting(Message):
    """A reflex as a robot's description or a site's file declares it."""

    reflex: ReflexName
    armed: bool = True
    """False: it is switched off from the start."""
    parameters: dict[str, JsonValue] = Field(default_factory=dict)
    """Those that differ from what the reflex says by itself."""
