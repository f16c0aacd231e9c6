"""What a run starts from: where things truly are, how noisy the sensors are, where items may be put.

Only the sim reads a scenario; skills know the site file. A scenario is typed, frozen data: an unknown key or
a wrong value is an error that names the file, the path and line in it, and what was expected. (A field can't
be called ``on``: some parsers read that as true.) A file with ``like: OTHER`` says only what is not as in
that scenario: whole fields, not parts of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Annotated, Final

from pydantic import Field, JsonValue, ValidationInfo, field_validator, model_validator

from tandem.sim.demonstration import Demonstration
from tandem.sim.faults import Fault
from tandem.sim.people import MOST_PEOPLE, Person
from tandem.sim.starts import ALONE, MOST_ROBOTS, ROBOT, RobotStart
from tandem.sim.things import Angle, Coordinate, Drop, Name, Obstacle, TrueItem
from tandem.skills.ports.message import PLAIN_TEXT, Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import DocumentError, Source
from tandem.skills.site import load, locate
from tandem.skills.yaml_file import parse_document, read_document, validate

SUFFIXES: Final = (".yaml", ".yml")
LIKE: Final = "like"
"""The key by which a file says from which scenario it takes what it does not say itself."""
ONE_ROBOT: Final = ("robot", "start")
"""The keys of the form for a single robot."""


class ScenarioError(DocumentError):
    """A scenario that can't be used. The text names the file, the path in it and what was expected."""


class Noise(Message):
    """Sensor errors. All sigmas are of normal distributions; zeros make ideal sensors."""

    odometry_scale: float = Field(default=0.0, ge=-0.2, le=0.2)
    """Systematic odometry error, as a fraction of the distance."""
    odometry_turn_scale: float = Field(default=0.0, ge=-0.2, le=0.2)
    """Systematic odometry error, as a fraction of each turn."""
    odometry_drift: float = Field(default=0.0, ge=0.0, le=0.5)
    """Radians of heading per square root of a metre driven."""
    laser_sigma: float = Field(default=0.0, ge=0.0, le=0.2)
    """Metres."""
    range_sigma: float = Field(default=0.0, ge=0.0, le=0.5)
    """Metres: of sonars and other range sensors."""
    depth_sigma: float = Field(default=0.0, ge=0.0, le=0.1)
    """Metres at a range of 1 m; grows with the range squared, as in stereo and structured light."""
    depth_quantum: float = Field(default=0.0, ge=0.0, le=0.1)
    """Step of the disparity, as metres of depth at 1 m; grows with the range squared."""
    image_sigma: float = Field(default=0.0, ge=0.0, le=50.0)
    """Grey levels of 255."""


class SpawnSurface(Message):
    """A strip of a surface where a campaign may put items.

    ``lower`` and ``upper`` are opposite corners in map (the item's centre stays between them); ``facing`` is
    the heading in map that points away from the furniture, towards where a robot would stand.
    """

    name: Name
    support: Name
    lower: tuple[Coordinate, Coordinate]
    upper: tuple[Coordinate, Coordinate]
    facing: Angle

    @model_validator(mode="after")
    def _ordered(self) -> SpawnSurface:
        if self.lower[0] > self.upper[0] or self.lower[1] > self.upper[1]:
            raise ValueError("each coordinate of lower must be at most that of upper")
        return self


class Scenario(Message):
    """The initial state of a run, except the seed."""

    name: Annotated[str, Field(min_length=1, max_length=60, pattern=PLAIN_TEXT)]
    site: Annotated[str, Field(min_length=1, max_length=4096)] = "lab"
    """Name of a site, or the path of a site file, relative to the scenario's."""
    robots: Annotated[tuple[RobotStart, ...], Field(max_length=MOST_ROBOTS)] = ()
    """The robots in it, instead of ``robot`` and ``start``."""
    robot: Name = ROBOT
    """The only robot in it: a file of ``sim/robots/``, or an entry point under ``tandem.robots``."""
    start: FloorPose | None = Field(default=None, validate_default=True)
    """Where the only robot starts. Read ``placed``, which has both forms."""
    items: tuple[TrueItem, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    drop: Drop | None = None
    """Where the floor is lower, which nobody has told the robot."""
    people: Annotated[tuple[Person, ...], Field(max_length=MOST_PEOPLE)] = ()
    """Who walks about in the room."""
    noise: Noise = Noise()
    camera_rate: float = Field(default=5.0, gt=0.0, le=30.0)
    """Pictures a second while there is a subscriber."""
    surfaces: tuple[SpawnSurface, ...] = ()
    faults: tuple[Fault, ...] = ()
    """Faults to inject, each at its time."""
    demo: Demonstration | None = None
    """What ``tandem demo`` shows it with; None: fetching item 29 to the depot."""

    @field_validator("robot")
    @classmethod
    def _not_both(cls, robot: str, info: ValidationInfo) -> str:
        if robot != ROBOT and info.data.get("robots"):
            raise ValueError("expected it in each of robots; found it beside them")
        return robot

    @field_validator("start")
    @classmethod
    def _one_form(cls, start: FloorPose | None, info: ValidationInfo) -> FloorPose | None:
        several = bool(info.data.get("robots", ["wrong"]))
        if start is None and not several:
            raise ValueError("expected a value, or robots; found neither")
        if start is not None and info.data.get("robots"):
            raise ValueError("expected it in each of robots; found it beside them")
        return start

    @model_validator(mode="after")
    def _unique(self) -> Scenario:
        for what, names in (
            ("robot", [each.name for each in self.robots]),
            ("item", [str(item.item) for item in self.items]),
            ("obstacle", [obstacle.name for obstacle in self.obstacles]),
            ("person", [person.name for person in self.people]),
            ("surface", [surface.name for surface in self.surfaces]),
        ):
            twice = sorted({name for name in names if names.count(name) > 1})
            if twice:
                raise ValueError(f"expected each {what} once; several times there: {', '.join(twice)}")
        return self

    @model_validator(mode="after")
    def _on_the_floor(self) -> Scenario:
        if self.drop is not None:
            for each in self.placed:
                if self.drop.has(each.start.x, each.start.y):
                    raise ValueError(f"drop: expected it elsewhere than where {each.name} starts")
        return self

    @model_validator(mode="after")
    def _demo_asks_who_is_there(self) -> Scenario:
        if self.demo is None:
            return self
        there = self.robots_on_the_bus
        named = [self.demo.robot] if self.demo.robot else []
        for name in (*named, *(each.robot for each in self.demo.beside)):
            if name not in there:
                known = ", ".join(there) or "none: there is only one"
                raise ValueError(f"demo: expected a robot with an executive ({known}); found {name!r}")
        return self

    @property
    def placed(self) -> tuple[RobotStart, ...]:
        """Every robot; the only one of the single form is called ``robot``."""
        if self.start is None:
            return self.robots
        return (RobotStart(name=ALONE, robot=self.robot, start=self.start),)

    @property
    def first(self) -> RobotStart:
        """The robot that is meant where none is named: the first with an executive, if any has one."""
        return next((each for each in self.placed if each.drives == "executive"), self.placed[0])

    @property
    def robots_by_name(self) -> Mapping[str, str]:
        """What kind of robot each is, by its name, the first one first."""
        return {each.name: each.robot for each in (self.first, *self.placed)}

    @property
    def robots_on_the_bus(self) -> tuple[str, ...]:
        """Names of the robots with an executive, which are parts of keys; none in the single form."""
        return tuple(each.name for each in self.robots if each.drives == "executive")

    def path_of(self, index: int, field: str) -> str:
        """Return the path in the file of a field of one of ``placed``."""
        return field if self.start is not None else f"robots.{index}.{field}"

    def item(self, number: int) -> TrueItem:
        """Return the item of a number.

        Raises:
            KeyError: naming the numbers there are.
        """
        for item in self.items:
            if item.item == number:
                return item
        known = ", ".join(str(item.item) for item in self.items)
        raise KeyError(f"no item {number}; expected one of {known}")

    def with_item(self, item: TrueItem) -> Scenario:
        """Return the same scenario with this item put, or moved, where it says."""
        others = tuple(other for other in self.items if other.item != item.item)
        return self.model_copy(update={"items": (*others, item)})

    def without_item(self, number: int) -> Scenario:
        """Return the same scenario without the item."""
        return self.model_copy(update={"items": tuple(item for item in self.items if item.item != number)})

    def with_faults(self, faults: tuple[Fault, ...]) -> Scenario:
        """Return the same scenario with more faults, after its own."""
        return self.model_copy(update={"faults": (*self.faults, *faults)})

    def starting_at(self, start: FloorPose) -> Scenario:
        """Return the same scenario with the (first) robot elsewhere."""
        if self.start is not None:
            return self.model_copy(update={"start": start})
        moved = self.first.model_copy(update={"start": start})
        robots = tuple(moved if each is self.first else each for each in self.robots)
        return self.model_copy(update={"robots": robots})


def scenario_names() -> tuple[str, ...]:
    """Return the names of the scenarios that come with the sim, sorted."""
    folder = resources.files("tandem.sim").joinpath("scenarios")
    files = [entry.name for entry in folder.iterdir() if entry.name.endswith(".yaml")]
    return tuple(sorted(name.removesuffix(".yaml") for name in files))


def load_scenario(name_or_path: str | Path, site: str = "") -> Scenario:
    """Return a scenario by the name of one that comes with the sim, or by the path of a YAML file.

    Args:
        name_or_path: of the scenario.
        site: name or path of the site that it is to be in; empty: the one that it names.

    Raises:
        ScenarioError: when there is no such scenario.
        DocumentError: when it has mistakes, or names items of a site that can't be read.
    """
    return read_scenario(name_or_path, site)[0]


def read_scenario(name_or_path: str | Path, site: str = "") -> tuple[Scenario, Source]:
    """Return a scenario as ``load_scenario`` does, and where its parts stand in its file."""
    data, source = _complete(name_or_path, ())
    if site:
        data["site"] = locate(site)
    return validate(data, source, Scenario, knowing=_names_of(data, source)), source


def _names_of(data: Mapping[str, JsonValue], source: Source) -> Site | None:
    """Return the site of a scenario that names items; None for one that numbers them, which needs none."""
    if not any(_name_items(data.get(key)) for key in ("items", "faults")):
        return None
    site = data.get("site", Scenario.model_fields["site"].default)
    try:
        return load(site) if isinstance(site, str) else None
    except DocumentError as error:
        raise ScenarioError(f"{source.at('site')}: {error}") from None


def _name_items(part: JsonValue) -> bool:
    if isinstance(part, list):
        return any(_name_items(each) for each in part)
    if isinstance(part, dict):
        return isinstance(part.get("item"), str) or any(_name_items(each) for each in part.values())
    return False


def _complete(name_or_path: str | Path, asked_by: tuple[str, ...]) -> tuple[dict[str, JsonValue], Source]:
    """Return what a scenario says, with what it takes from the one that it is like, its site located.

    Args:
        name_or_path: of the scenario.
        asked_by: the scenarios that are like it, each like the next one.
    """
    data, source = _document(name_or_path)
    if not isinstance(data, dict):
        raise ScenarioError(f"{source.name}: expected a mapping with name, start, items, ...")
    path, other = _path(name_or_path), data.pop(LIKE, None)
    try:
        if isinstance(data.get("site"), str):
            data["site"] = locate(str(data["site"]), beside=path)
    except DocumentError as error:
        raise ScenarioError(f"{source.at('site')}: {error}") from None
    if other is None:
        return data, source
    if not isinstance(other, str):
        raise ScenarioError(f"{source.at(LIKE)}: expected the name or path of a scenario; found {other!r}")
    if source.name in asked_by:
        raise ScenarioError(
            f"{source.at(LIKE)}: expected no circle; found {' -> '.join((*asked_by, source.name))}"
        )
    named = _path(other) if path is None or _path(other) is None else path.parent / other
    try:
        base, _ = _complete(named or other, (*asked_by, source.name))
    except DocumentError as error:
        raise ScenarioError(f"{source.at(LIKE)}: {error}") from None
    if "robots" in data:  # the two forms exclude each other
        base = {key: value for key, value in base.items() if key not in ONE_ROBOT}
    elif data.keys() & set(ONE_ROBOT):
        base.pop("robots", None)
    return {**base, **data}, source


def _path(name_or_path: str | Path) -> Path | None:
    """Return the path of a scenario's file; None for the name of one that comes with the sim."""
    text = str(name_or_path)
    named = not isinstance(name_or_path, Path) and not text.endswith(SUFFIXES) and "/" not in text
    return None if named else Path(text)


def _document(name_or_path: str | Path) -> tuple[JsonValue, Source]:
    text, path = str(name_or_path), _path(name_or_path)
    if path is not None:
        return read_document(path)
    if text not in scenario_names():
        known = ", ".join(scenario_names())
        raise ScenarioError(f"no scenario '{text}'; expected {known}, or the path of a .yaml file")
    packaged = resources.files("tandem.sim").joinpath("scenarios", f"{text}.yaml")
    return parse_document(packaged.read_text(encoding="utf-8"), f"{text}.yaml")
