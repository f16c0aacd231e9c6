"""What a scenario is shown with: ``tandem demo`` asks for it and tells how it ended."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, JsonValue

from tandem.sim.things import Coordinate, Name
from tandem.skills.ports.message import Message

Point = tuple[Coordinate, Coordinate, Coordinate]
Request = Annotated[dict[str, JsonValue], Field(min_length=1)]


class View(Message):
    """From where the picture of the end is taken: ``eye`` and ``target`` in map (m)."""

    eye: Point
    target: Point


class Beside(Message):
    """A request to another robot, which goes on beside the one that is shown."""

    robot: Name
    request: Request


class Demonstration(Message):
    """What is asked for: the demo ends with ``request``."""

    robot: Name = ""
    """Who is asked, where there are several; empty: the first that has an executive."""
    request: Request
    beside: tuple[Beside, ...] = ()
    view: View | None = None
    """None: none is taken."""
