"""Read a site file: YAML checked against ``tandem.skills.ports.site.Site``, and for places that can't be."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import resources
from pathlib import Path
from typing import Final

from pydantic import JsonValue

from tandem.skills.geometry.floor_plan import FloorPlan
from tandem.skills.ports.plugins import UNTRIED, Group, Loaded
from tandem.skills.ports.plugins import load as load_plugins
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import LAST_TAG, Site, number_of
from tandem.skills.ports.sources import DocumentError
from tandem.skills.yaml_file import parse_document, read_document, validate

SUFFIXES: Final = (".yaml", ".yml")


def names() -> tuple[str, ...]:
    """Return the names of the sites that come with the package."""
    folder = resources.files("tandem.skills") / "sites"
    return tuple(
        sorted(each.name.removesuffix(".yaml") for each in folder.iterdir() if each.name.endswith(".yaml"))
    )


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[Path]:
    """Return the site files of other packages: an entry point under ``tandem.sites`` names a ``Path``.

    Args:
        left_out: plug-ins that are known not to load (``tandem.skills.ports.plugins.load``).
    """
    return load_plugins(Group.SITES, _checked_path, taken=names(), left_out=left_out)


def locate(name_or_path: str, beside: Path | None = None) -> str:
    """Return what ``load`` takes in any folder: the name of a site that ships, or a file's full path.

    Args:
        name_or_path: of a site that ships or is plugged in; or a path of a .yaml file.
        beside: the file that names it, to which a path is relative; None: the current folder.

    Raises:
        DocumentError: when there is no such site.
    """
    path = Path(name_or_path)
    if path.suffix in SUFFIXES:
        return str((path if beside is None else beside.parent / path).absolute())
    if name_or_path in names():
        return name_or_path
    loaded = plugged()
    if name_or_path in loaded.found:
        return str(loaded.found[name_or_path])
    known = ", ".join((*names(), *loaded.found))
    why = "".join(f"; {each}" for each in loaded.broken if each.plugin.name == name_or_path)
    raise DocumentError(f"no site {name_or_path!r}; expected {known}, or the path of a .yaml file{why}")


def load(name_or_path: str) -> Site:
    """Return a site by its name, or by the path of a file.

    Raises:
        DocumentError: when there is no such site, or when it is wrong.
    """
    if name_or_path in names():
        packaged = resources.files("tandem.skills") / "sites" / f"{name_or_path}.yaml"
        data, source = parse_document(packaged.read_text("utf-8"), f"{name_or_path}.yaml")
    elif Path(name_or_path).suffix in SUFFIXES:
        data, source = read_document(Path(name_or_path))
    else:
        data, source = read_document(Path(locate(name_or_path)))
    if unnumbered := [f"{source.at(where)}: {reason}" for where, reason in _number(data)]:
        raise DocumentError("\n".join(unnumbered))
    site = validate(data, source, Site)
    if twice := [f"{source.at(where)}: {reason}" for where, reason in _told_twice(data)]:
        raise DocumentError("\n".join(twice))
    if misplaced := [f"{source.at(where)}: {reason}" for where, reason in _misplaced(site)]:
        raise DocumentError("\n".join(misplaced))
    return site


def _items_of(data: JsonValue) -> Iterator[tuple[str, dict[str, JsonValue]]]:
    """Give the items that a file tells, each with its path."""
    items = data.get("items") if isinstance(data, dict) else None
    for index, item in enumerate(items if isinstance(items, list) else ()):
        if isinstance(item, dict):
            yield f"items.{index}", item


def _number(data: JsonValue) -> Iterator[tuple[str, str]]:
    """Number the items of which a file says only the name; give the paths of others without a number."""
    for where, item in _items_of(data):
        if "item" in item:
            continue
        name = item.get("name")
        if item.get("tag_size") is not None:
            yield where, f"expected item, the number of its tag (0 to {LAST_TAG}), beside tag_size"
        elif not isinstance(name, str) or not name:
            yield where, "expected a name (text), or item, its number"
        else:
            item["item"] = number_of(name)


def _told_twice(data: JsonValue) -> Iterator[tuple[str, str]]:
    """Give the paths of sizes in a file that stand beside a diameter, with the reason.

    On the wire a cylinder has both, for readers that know boxes only; in a file one would be forgotten.
    """
    for where, item in _items_of(data):
        if "size" in item and "diameter" in item:
            yield f"{where}.size", "expected either size, of a box, or diameter and height; found both"


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


def _checked_path(_: str, value: object) -> Path:
    path = Path(value) if isinstance(value, str | Path) else None
    if path is None or path.suffix not in SUFFIXES:
        raise TypeError(f"expected the pathlib.Path of a .yaml file; found {value!r}")
    if not path.is_file():
        raise TypeError(f"expected a file; there is none at {path}")
    return path.absolute()
