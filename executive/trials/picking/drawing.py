"""The figures of one run, into a folder."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from tandem.executive.trials.picking.pictures import Album, scene_panels, workflow_panels
from tandem.executive.trials.picking.plans import repositioning_figure, search_figure
from tandem.sim.render import Painter, PainterSettings

if TYPE_CHECKING:
    from tandem.executive.trials.picking.settings import PickingRun
    from tandem.executive.trials.picking.witness import Shot
    from tandem.sim.station import Station
    from tandem.skills.ports.site import Site


def write_figures(folder: Path, run: PickingRun, site: Site, station: Station, shots: Sequence[Shot]) -> None:
    """Draw those figures that the run has something to show for."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, plan in (("2-search", search_figure), ("4-new-try", repositioning_figure)):
        drawn = plan(run, site)
        if drawn is not None:
            (folder / f"figure-{name}-{run.run}.svg").write_text(drawn, encoding="utf-8")
    painter = Painter(
        PainterSettings(urdfs=tuple(each.model.physics_urdf for each in station.robots.values()))
    )
    album = Album(painter, tuple(station.world.bodies.values()), run.item, site)
    try:
        for name, panels in (
            ("10-scene", scene_panels(run, shots)),
            ("11-workflow", workflow_panels(run, shots)),
        ):
            if panels:
                album.write(folder / f"figure-{name}-{run.run}.webp", panels)
    finally:
        painter.close()
