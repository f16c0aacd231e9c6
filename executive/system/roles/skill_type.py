"""A skill that another package adds: what its entry point under ``tandem.skills`` names.

Each has a process of its own, so that a skill that crashes takes no other with it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic

from tandem.executive.system.roles.role import Role, Surroundings, always, skill_rights
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.skill import F, G, R, Skill
from tandem.skills.server import ActionServer


@dataclass(frozen=True)
class SkillType(Generic[G, F, R]):
    """A skill, and what it may do.

    Args:
        name: of its entry point, and of the process that serves it.
        make: makes the skill for one boot of the hardware.
        tells: topics that it publishes besides its own status, relative to ``<site>/<robot>``
            (``hw/base/velocity``). Where keys are used, the router lets no other through.
        asks: services that it asks (``hw/group/*/goal``).
        needed: whether a robot of this description has use for it.
    """

    name: str
    make: Callable[[Surroundings], Skill[G, F, R]]
    tells: tuple[str, ...] = ()
    asks: tuple[str, ...] = ()
    needed: Callable[[RobotDescription], bool] = always

    def role(self) -> Role:
        """Return the role of the process that serves it."""
        return Role(
            name=self.name,
            needed=self.needed,
            nodes=self._nodes,
            rights=skill_rights(tells=self.tells, asks=self.asks),
        )

    def _nodes(self, at: Surroundings) -> Sequence[Node]:
        return [ActionServer(at.bus, at.clocks, self.make(at), charge=at.charge)]
