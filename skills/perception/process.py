"""The nodes of the perception process."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from tandem.skills.claimed import Claimed
from tandem.skills.limbs import Limb, head
from tandem.skills.perception.detectors import Detector
from tandem.skills.perception.head_reflexes import OWNER
from tandem.skills.perception.jobs import warm_up
from tandem.skills.perception.look import Look
from tandem.skills.perception.mapper import Mapper
from tandem.skills.perception.snapshot import Snapshots
from tandem.skills.perception.track import Track
from tandem.skills.perception.turn_head import TurnHead
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.node import Node
from tandem.skills.ports.reflex import HEAD
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import F, G, R, Skill
from tandem.skills.reflex_owners import resources_of
from tandem.skills.server import ActionServer


def nodes(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    compute: Compute,
    *,
    detectors: Mapping[str, Detector] | None = None,
    charge: bool = False,
    map_file: Path | None = None,
    left_out: Mapping[str, str] | None = None,
) -> tuple[Node, ...]:
    """Return the servers of the actions, the snapshots, and the mapper where the site wants one.

    ``compute`` reads pictures, with the ``detectors``; ``charge`` is the server's, for lockstep;
    ``map_file`` is where the map of occupied space is saved; ``left_out`` are the plug-ins that are known not
    to load, None for all of them. A robot with a head has its reflexes stepped first.

    The worker is started now: its first picture should not wait for OpenCV to load.
    """
    compute.submit(warm_up, 64, cost=0.0)
    mapper = None
    if site.occupancy is not None:
        mapper = Mapper(bus, clocks, description, site, site.occupancy, compute, map_file)
    look = Look(
        bus,
        clocks,
        description,
        site,
        compute,
        detectors=detectors,
        taken=None if mapper is None else mapper.offer,
    )
    track = Track(bus, clocks, description, site, compute, detectors=detectors)
    turn, limb = TurnHead(bus, clocks, description), _head(bus, clocks, description, site, left_out)
    return (
        *(() if limb is None else (limb,)),
        _served(bus, clocks, look, limb, charge=charge),
        _served(bus, clocks, track, limb, charge=charge),
        _served(bus, clocks, turn, limb, charge=charge),
        Snapshots(bus, clocks, compute, tuple(each.name for each in description.cameras)),
        *(() if mapper is None else (mapper,)),
    )


def _head(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    left_out: Mapping[str, str] | None,
) -> Limb | None:
    """Return the head, or None of a robot whose camera nothing turns."""
    if HEAD not in resources_of(description):
        return None
    choice = OWNER.chosen_for(OWNER.types(left_out), description, site, f"site {site.name}")
    return Limb(head(bus, clocks, description), choice)


def _served(
    bus: Bus, clocks: Clocks, skill: Skill[G, F, R], limb: Limb | None, *, charge: bool
) -> ActionServer[G, F, R]:
    """Return the server of a skill that turns the head."""
    if limb is None:
        return ActionServer(bus, clocks, skill, charge=charge)
    pipeline = limb.pipeline(HEAD)
    return ActionServer(bus, clocks, Claimed(skill, pipeline), charge=charge, pipelines=(pipeline,))
