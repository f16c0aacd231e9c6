"""The saved map of occupied space: a file beside the site's."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final

from pydantic import ValidationError

from tandem.skills import site as sites
from tandem.skills.ports.occupancy import SavedMap
from tandem.skills.ports.problems import in_words, problems_of
from tandem.skills.ports.sources import DocumentError
from tandem.skills.synced_file import replace_file

if TYPE_CHECKING:
    from tandem.skills.ports.lattice import Lattice, Numbers

SUFFIX: Final = ".map.json"
REMEDY: Final = "move it away, or delete it: the robot then begins with an empty map"


def path_of(site: str, data: str | None) -> Path | None:
    """Return where the map of a site is kept; None: nowhere.

    Args:
        site: name of a site that ships, or path of a site file: the map lies beside that.
        data: folder of what a robot keeps, where the maps of sites that ship lie.
    """
    if site in sites.names():
        return None if data is None else Path(data) / f"{site}{SUFFIX}"
    return Path(sites.locate(site)).with_suffix(SUFFIX)


def save(path: Path, saved: SavedMap) -> None:
    """Write it; it is on the disk when the call returns.

    Raises:
        OSError: when it can't be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_file(path, saved.model_dump_json(indent=2) + "\n")


def load(path: Path, site: str, lattice: Lattice) -> Numbers | None:
    """Return the numbers of the cells that are occupied in the file, rising; None when there is no file.

    Args:
        path: of the file.
        site: name of the site that it must be a map of.
        lattice: the cells that it must have.

    Raises:
        DocumentError: naming the file, the path in it, and what was expected.
    """
    from tandem.skills.ports.lattice import Lattice, numbers_of  # noqa: PLC0415 - loads numpy

    try:
        text = path.read_bytes()
    except FileNotFoundError:
        return None
    except OSError as error:
        raise DocumentError(f"{path}: can't be read: {error.strerror}") from None
    try:
        saved = SavedMap.model_validate_json(text)
    except ValidationError as error:
        raise DocumentError(f"{path}: {in_words(problems_of(error))}; {REMEDY}") from None
    if saved.site != site:
        raise DocumentError(f"{path}: site: expected {site!r}, found {saved.site!r}; {REMEDY}")
    found = Lattice.of(saved.occupancy)
    for name in ("origin", "shape", "resolution"):
        expected, there = getattr(lattice, name), getattr(found, name)
        if expected != there:
            raise DocumentError(
                f"{path}: occupancy.{name}: expected {expected} (bounds and resolution of site {site}), "
                f"found {there}; {REMEDY}"
            )
    return numbers_of(saved.occupancy)


def check(site: str, data: str | None) -> None:
    """Read a site's map, if it has one, before anything starts.

    Args:
        site: name of a site, or path of a site file.
        data: folder of what the robot keeps.

    Raises:
        DocumentError: as ``load``.
    """
    loaded, path = sites.load(site), path_of(site, data)
    if loaded.occupancy is not None and path is not None:
        from tandem.skills.ports.lattice import Lattice  # noqa: PLC0415 - loads numpy

        load(path, loaded.name, Lattice.of_site(loaded, loaded.occupancy))
