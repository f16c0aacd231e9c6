"""``tandem map``: show, save and clear the map of occupied space."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Final

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.commands.stop_commands import By, person
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.skills.ports.occupancy import MapEdit, Occupancy

WIDTH: Final = 76
"""Characters of the plan's lines, at the most."""
OF: Final = "map of occupied space (`occupancy` of the site file switches it on)"
Saved = Annotated[bool, typer.Option("--saved", help="Delete the saved file as well.")]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(help="Show, save and clear the map of occupied space.", no_args_is_help=True)
    group.command("show")(connects(show))
    group.command("save")(connects(save))
    group.command("clear")(connects(clear))
    app.add_typer(group, name="map")


def show(*, as_json: Json = False, bus: BusOptions) -> None:
    """Print which space is occupied and not in the site file, as a plan seen from above."""
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.cli.shapes import print_json  # noqa: PLC0415
    from tandem.skills.ports.keys import Nothing  # noqa: PLC0415
    from tandem.skills.ports.world import OCCUPANCY_NOW  # noqa: PLC0415

    with Connection(bus) as connection:
        found = connection.ask(OCCUPANCY_NOW, Nothing(), of=OF)
    if as_json:
        print_json(found)
        return
    for line in (about(found), *plan(found)):
        typer.echo(line)


def save(*, by: By = "", as_json: Json = False, bus: BusOptions) -> None:
    """Have the robot write its map beside the site file; it begins with it at the next start."""
    from tandem.skills.ports.occupancy import MapEdit  # noqa: PLC0415

    _edit(bus, MapEdit.SAVE, by, as_json=as_json)


def clear(*, saved: Saved = False, by: By = "", as_json: Json = False, bus: BusOptions) -> None:
    """Empty the robot's map; what stands there is seen again."""
    from tandem.skills.ports.occupancy import MapEdit  # noqa: PLC0415

    _edit(bus, MapEdit.CLEAR_SAVED if saved else MapEdit.CLEAR, by, as_json=as_json)


def about(found: Occupancy) -> str:
    """Return how much is occupied, in a line."""
    many = len(found.numbers())
    cells = f"{many} cell{'' if many == 1 else 's'} of {100.0 * found.resolution:g} cm"
    return f"{cells} occupied{f'; {found.problem}' if found.problem else ''}"


def plan(found: Occupancy) -> list[str]:
    """Return the cells seen from above, north up: # occupied at some height, . nowhere."""
    nx, ny, _ = found.shape
    many = math.ceil(nx / WIDTH)
    taken = {
        (
            round((x - found.origin[0]) / found.resolution) // many,
            round((y - found.origin[1]) / found.resolution) // (2 * many),
        )
        for x, y, _ in found.corners()
    }
    rows = range(math.ceil(ny / (2 * many)) - 1, -1, -1)  # a character is twice as high as it is wide
    return ["".join("#" if (x, y) in taken else "." for x in range(math.ceil(nx / many))) for y in rows]


def _edit(options: BusOptions, edit: MapEdit, by: str, *, as_json: bool) -> None:
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.cli.shapes import print_json  # noqa: PLC0415
    from tandem.skills.ports.occupancy import EditMap, MapEdit  # noqa: PLC0415
    from tandem.skills.ports.world import OCCUPANCY_EDIT  # noqa: PLC0415

    with Connection(options) as connection:
        connection_by = by or person(connection.options)
        done = connection.ask(OCCUPANCY_EDIT, EditMap(edit=edit, by=connection_by), of=OF)
    if not done.done:
        raise CommandError(f"the map is not changed: {done.reason}", ExitCode.BAD_INPUT)
    if as_json:
        print_json(done)
    elif edit is MapEdit.SAVE:
        typer.echo(f"{done.cells} cells are saved in {done.path}")
    else:
        file = f"; {done.path} is deleted" if edit is MapEdit.CLEAR_SAVED and done.path else ""
        typer.echo(f"{done.cells} cells are forgotten{file}")
