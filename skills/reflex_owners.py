"""Which reflexes run beside which owner: those that come along, and the entry points ``tandem.reflexes``.

A resource has one owner, the process that commands it. A reflex runs beside the owner of all of its
resources; each owner makes its own reflexes and none of the others'.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, Final, Generic, TypeVar

from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, installed, load
from tandem.skills.ports.reflex import ARM, BASE, HAND, HEAD, OWNED
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import DocumentError
from tandem.skills.reflexes import Chosen, ReflexType, chosen

W = TypeVar("W")
COME_ALONG: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "cliff": (BASE,),
        "bumper": (BASE,),
        "base_guard": (BASE,),
        "avoid_collision": (BASE,),
        "approach": (BASE,),
        "arm_guard": (ARM,),
    }
)
"""The resources of the reflexes that come along, by name: an owner knows the others' names without loading
their files. A test compares it with the owners' tables."""


@dataclass(frozen=True)
class Owner(Generic[W]):
    """What one process commands, and the reflexes that come along for it.

    Args:
        resources: what it owns, one of ``OWNED``.
        shipped: the reflexes, by name.
    """

    resources: tuple[str, ...]
    shipped: Mapping[str, ReflexType[W, Any]]

    def types(self, left_out: Mapping[str, str] | None = UNTRIED) -> tuple[ReflexType[W, Any], ...]:
        """Return its reflexes, those that come along first, then those of other packages.

        Args:
            left_out: plug-ins that are known not to load; None: all plug-ins are left out.
        """
        others = {} if left_out is None else plugged(left_out).found
        mine = tuple(each for each in others.values() if set(each.resources) <= set(self.resources))
        return (*self.shipped.values(), *mine)

    def chosen_for(
        self,
        types: Sequence[ReflexType[W, Any]],
        robot: RobotDescription,
        site: Site,
        site_called: str,
        part: str = "",
    ) -> list[Chosen[W]]:
        """Return the reflexes that a robot has here, as its description and then the site declare them.

        Where a robot may have several of what is owned, ``part`` says which one it is. Then a reflex is
        called ``<name>_<part>``; a declaration of ``<name>`` is one for each part, and what is declared for
        one part counts more.

        Args:
            types: its reflexes.
            robot: the description.
            site: where the robot is.
            site_called: what to call the site's file in an error.
            part: the side of an arm; empty: there is one at the most.

        Raises:
            DocumentError: as ``tandem.skills.reflexes.chosen``.
        """
        there = resources_of(robot)
        told = declared(robot, site, site_called)
        _refuse_absent(told, there)
        ours = [each.name for each in types]
        if not part:
            return chosen(types, robot, there, told, elsewhere=known_names(robot))
        parts = [replace(each, name=f"{each.name}_{part}") for each in types]
        for_all = [
            (where, each.model_copy(update={"reflex": f"{each.reflex}_{part}"}))
            for where, each in told
            if each.reflex in ours
        ]
        for_one = [(where, each) for where, each in told if each.reflex not in ours]
        return chosen(parts, robot, there, [*for_all, *for_one], elsewhere=known_names(robot, ours))


def declared(robot: RobotDescription, site: Site, site_called: str) -> list[tuple[str, ReflexSetting]]:
    """Return what a robot and then the site declare, each with what to call the place."""
    return [
        *((f"robot {robot.name}: reflexes.{at}", each) for at, each in enumerate(robot.reflexes)),
        *((f"{site_called}: reflexes.{at}", each) for at, each in enumerate(site.reflexes)),
    ]


def known_names(robot: RobotDescription, ours: Collection[str] = ()) -> tuple[str, ...]:
    """Return all names that may be declared: of every owner's reflexes, and of plug-ins, loaded or not.

    Args:
        robot: the description: it says which arms there are.
        ours: names of reflexes that the asking owner has.
    """
    others = [each.name for each in installed(Group.REFLEXES)]
    limbs = [name for name, takes in COME_ALONG.items() if ARM in takes or HAND in takes]
    each_arm = [f"{name}_{side}" for name in (*limbs, *others, *ours) for side in robot.hands]
    return tuple(dict.fromkeys([*COME_ALONG, *others, *ours, *each_arm]))


def resources_of(robot: RobotDescription) -> frozenset[str]:
    """Return what a robot has that a reflex may take, in the words of reflexes' files."""
    limbs = {ARM, HAND} if robot.hands else set()
    heads = {HEAD} if any(group.name == HEAD for group in robot.groups) else set()
    return frozenset({BASE} | limbs | heads)


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[ReflexType[Any, Any]]:
    """Return the reflexes of other packages, whoever owns what they take."""
    return load(Group.REFLEXES, _checked, taken=COME_ALONG, left_out=left_out)


def _refuse_absent(told: Sequence[tuple[str, ReflexSetting]], there: frozenset[str]) -> None:
    """Refuse to have a reflex declared for what the robot lacks, so that no process would run it."""
    for where, each in told:
        absent = [resource for resource in COME_ALONG.get(each.reflex, ()) if resource not in there]
        if absent:
            raise DocumentError(
                f"{where}: reflex {each.reflex!r} needs the {absent[0]}, which this robot lacks"
            )


def _checked(name: str, value: object) -> ReflexType[Any, Any]:
    if not isinstance(value, ReflexType):
        raise TypeError(f"expected a ReflexType; found {type(value).__name__}")
    if value.name != name:
        raise TypeError(
            f"the entry point is called {name!r} and its reflex {value.name!r}; expected one name"
        )
    if not value.resources or not any(set(value.resources) <= set(each) for each in OWNED):
        owned = ", or ".join(" and ".join(each) for each in OWNED)
        raise TypeError(
            f"reflex {name!r}: expected resources of one owner ({owned}); found {value.resources}"
        )
    return value
