"""The base's process: its monitors and its action servers, put together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from tandem.skills.base.cliffs import Cliffs
from tandem.skills.base.company import Company
from tandem.skills.base.drive import Drive
from tandem.skills.base.fixed import FixedBase
from tandem.skills.base.follow_robot import Follow
from tandem.skills.base.go import Go
from tandem.skills.base.guard import Guard
from tandem.skills.base.journey_context import JourneyContext
from tandem.skills.base.localise import Localise
from tandem.skills.base.localiser import Localiser
from tandem.skills.base.map import build_map, floor_field
from tandem.skills.base.obstacles import Obstacles
from tandem.skills.base.occupied import OccupiedFloor
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.people.tracker import Tracker
from tandem.skills.base.pose_filter import PoseTracker
from tandem.skills.base.reflexes.registry import OWNER, BaseReflex
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.rotate import Rotate
from tandem.skills.base.sights import Sights
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.surround import Surround
from tandem.skills.base.way_back import WayBack
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.actions.base import LOCALISE
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.node import Node
from tandem.skills.ports.reflex import BASE
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.whereabouts import Neighbours
from tandem.skills.reflexes import Fitted, Reflexes, fitted
from tandem.skills.server import ActionServer


@dataclass(frozen=True)
class Base:
    """The parts of the base: monitors first, in the order in which they are stepped, then the skills."""

    localiser: Localiser
    people: Tracker | None
    """Who walks about; None where the site's local planner does not care."""
    cliffs: Cliffs | None
    """Where the floor ends; None of a robot without cliff sensors."""
    obstacles: Obstacles
    board: BaseStatusBoard
    reflexes: Reflexes
    drive: Drive
    rotate: Rotate
    localise: Localise


def assemble(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    types: Sequence[BaseReflex] = tuple(OWNER.shipped.values()),
) -> Base:
    """Return the parts, wired to each other. Takes some 0.2 s: the map is worked out."""
    site_map = build_map(site, description)
    localiser = Localiser(bus, clocks, description, site_map)
    occupied = None if site.occupancy is None else OccupiedFloor(bus, description.height, site_map.plan)
    people = None
    if site.local_planner != "pursuit":
        people = Tracker(bus, description.laser, site_map, localiser)
    cliffs = _cliffs(bus, clocks, description, localiser)
    obstacles = Obstacles(
        clocks, description.laser, site_map, localiser, occupied, people=people, cliffs=cliffs
    )
    pipeline = Pipeline(BASE)
    board = BaseStatusBoard(bus, clocks, pipeline)
    guard = Guard(bus, clocks, description, localiser)
    drive, radius = description.driven, description.footprint_radius
    caution = None if people is None else Caution(people, site_map.plan, drive, radius, clocks)
    bends = site.local_planner == "band"
    course = JourneyContext(site_map, obstacles, localiser, drive, radius, guard, caution, bends, cliffs)
    around = BaseSurroundings(bus, clocks, description, localiser, guard, board, cliffs=cliffs)
    return Base(
        localiser=localiser,
        people=people,
        cliffs=cliffs,
        obstacles=obstacles,
        board=board,
        reflexes=Reflexes(bus, clocks, (pipeline,), _fitted(types, around, site)),
        drive=Drive(bus, clocks, course, board),
        rotate=Rotate(bus, clocks, drive, localiser, guard=guard, board=board, caution=caution),
        localise=Localise(
            clocks,
            site_map,
            localiser,
            guard=guard,
            board=board,
            wheels=Wheels(bus, clocks, description.driven, lambda: pipeline.normal(LOCALISE.name)),
            radius=description.footprint_radius,
        ),
    )


def build(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    *,
    charge: bool = False,
    left_out: Mapping[str, str] | None = None,
    neighbours: Neighbours | None = None,
) -> list[Node]:
    """Return the nodes of the base's process, in the order in which they are to be stepped.

    Args:
        bus: the hardware, the arms and the clients.
        clocks: robot time.
        description: the robot.
        site: the map.
        charge: make a computation's slices cost their declared robot time (lockstep).
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
        neighbours: what the other robots of the site tell of themselves; None: there are none.
    """
    types = OWNER.types(left_out)
    if description.drive is None:
        return [FixedBase(bus, clocks, site.home)]
    if not description.lasers:
        others = neighbours or Neighbours(None, clocks, description.name)
        return _by_pose_sensor(bus, clocks, description, site, types, neighbours=others, charge=charge)
    base = assemble(bus, clocks, description, site, types)
    return [
        base.localiser,
        *([base.people] if base.people is not None else []),
        *([base.cliffs] if base.cliffs is not None else []),
        base.obstacles,
        base.board,
        base.reflexes,
        *(
            ActionServer(bus, clocks, skill, charge=charge, pipelines=(base.board.pipeline,))
            for skill in (base.localise, base.drive, base.rotate)
        ),
    ]


def _by_pose_sensor(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    types: Sequence[BaseReflex],
    *,
    neighbours: Neighbours,
    charge: bool,
) -> list[Node]:
    """Return the nodes of a base that is told where it is, and knows no obstacles but those that it sees."""
    if not description.pose_sensors:
        return []
    drive, pipeline = description.driven, Pipeline(BASE)
    tracker, board = PoseTracker(bus, clocks, description), BaseStatusBoard(bus, clocks, pipeline)
    cliffs = _cliffs(bus, clocks, description, tracker)
    guard, sees = (
        Guard(bus, clocks, description, tracker),
        Surround(bus, clocks, description, lambda: tracker.moving, cliffs),
    )
    ranges = sees if description.range_sensors else None
    around = BaseSurroundings(bus, clocks, description, tracker, guard, board, ranges, cliffs)
    floor = floor_field(site, description.height)
    company = Company(clocks, tracker, neighbours, floor, description.footprint_radius)
    go = Go(bus, clocks, drive, tracker, guard=guard, board=board, surround=sees, company=company)
    follow = Follow(
        bus,
        clocks,
        drive,
        tracker,
        sees,
        sights=Sights(clocks, tracker, sees, neighbours),
        way_back=WayBack(floor, description.footprint_radius),
        guard=guard,
        board=board,
    )
    servers = [
        ActionServer(bus, clocks, skill, charge=charge, pipelines=(pipeline,)) for skill in (go, follow)
    ]
    runner = Reflexes(bus, clocks, (pipeline,), _fitted(types, around, site))
    return [tracker, sees, *([] if cliffs is None else [cliffs]), board, runner, *servers]


def _cliffs(bus: Bus, clocks: Clocks, description: RobotDescription, monitor: Whereabouts) -> Cliffs | None:
    if not description.cliff_sensors:
        return None
    return Cliffs(bus, clocks, description, lambda: monitor.moving)


def _fitted(types: Sequence[BaseReflex], around: BaseSurroundings, site: Site) -> list[Fitted]:
    choice = OWNER.chosen_for(types, around.description, site, f"site {site.name}")
    return fitted(choice, around, {BASE: around.board.pipeline})
