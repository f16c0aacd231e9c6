"""Read a site file: YAML checked against ``tandem.skills.ports.site.Site``, and for places that can't be."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import resources
from pathlib import Path

from tandem.skills.geometry.floor_plan import FloorPlan
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import DocumentError
from tandem.skills.yaml_file import parse_document, read_document, validate


def names() -> tuple[str, ...]:
    """Return the names of the sites that come with the package."""
    folder = resources.files("tandem.skills") / "sites"
    return tuple(
        sorted(each.name.removesuffix(".yaml") for each in folder.iterdir() if each.name.endswith(".yaml"))
    )


def load(name_or_path: str) -> Site:
    """Return a site by its name, or by the path of a file.

    Raises:
        DocumentError: when there is no such site, or when it is wrong.
    """
    path = Path(name_or_path)
    if path.suffix in {".yaml", ".yml"}:
        data, source = read_document(path)
    elif name_or_path in names():
        packaged = resources.files("tandem.skills") / "sites" / f"{name_or_path}.yaml"
        data, source = parse_document(packaged.read_text("utf-8"), f"{name_or_path}.yaml")
    else:
        raise DocumentError(
            f"no site {name_or_path!r}; expected {', '.join(names())}, or the path of a .yaml file"
        )
    site = validate(data, source, Site)
    if misplaced := [f"{source.at(where)}: {reason}" for where, reason in _misplaced(site)]:
        raise DocumentError("\n".join(misplaced))
    return site


def _misplaced(site: Site) -> Iterator[tuple[str, str]]:
    """Give the paths of places where no robot can stand, with the reason."""
    x_min, y_min, x_max, y_max = site.bounds
    if not (x_min < x_max and y_min < y_max):
        yield "bounds", "expected x_min, y_min, x_max, y_max with each minimum below its maximum"
        return
    plan = FloorPlan(site)
    stands: list[tuple[str, FloorPose]] = [("home", site.home)]
    stands += [(f"spots.{index}.pose", spot.pose) for index, spot in enumerate(site.spots)]
    for where, pose in stands:
        if plan.room(pose.x, pose.y) <= 0.0:
            yield where, f"({pose.x:g}, {pose.y:g}) is inside furniture or outside the bounds"
