"""The saved map of occupied space: where it lies, and files that are refused with path and reason."""

from importlib import resources
from pathlib import Path

import numpy as np
import pytest

from tandem.skills import map_file, site
from tandem.skills.ports.lattice import Lattice, packed
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import Occupancy, OccupancySetting, SavedMap
from tandem.skills.ports.sources import DocumentError

LATTICE = Lattice.of_site(site.load("picking"), OccupancySetting())
NUMBERS = np.array([3, 77, 4000])


def saved(lattice: Lattice = LATTICE, name: str = "picking") -> SavedMap:
    told = Occupancy(
        stamp=RobotTime(boot="b", seconds=1.0),
        version=3,
        origin=lattice.origin,
        shape=lattice.shape,
        resolution=lattice.resolution,
        cells=packed(NUMBERS),
    )
    return SavedMap(site=name, occupancy=told)


def test_what_is_saved_is_loaded(tmp_path: Path) -> None:
    path = tmp_path / "maps" / "picking.map.json"
    assert map_file.load(path, "picking", LATTICE) is None
    map_file.save(path, saved())
    numbers = map_file.load(path, "picking", LATTICE)
    assert numbers is not None
    assert numbers.tolist() == NUMBERS.tolist()


def test_it_lies_beside_the_site_file_or_with_the_robots_data() -> None:
    assert map_file.path_of("/rooms/mine.yaml", "/data") == Path("/rooms/mine.map.json")
    assert map_file.path_of("picking", "/data") == Path("/data/picking.map.json")
    assert map_file.path_of("picking", None) is None


@pytest.mark.parametrize(
    ("document", "words"),
    [
        ("{", "expected JSON: EOF"),
        ("{}", "site: expected a value"),
        (saved(name="lab").model_dump_json(), "site: expected 'picking', found 'lab'"),
        (
            saved(Lattice.over((-2, -2, 2, 2), 1.7, 0.1)).model_dump_json(),
            "occupancy.shape: expected .80, 80, 34.",
        ),
        (saved().model_dump_json().replace('"format":1', '"format":2'), "occupancy.format: "),
        (saved().model_dump_json().replace(packed(NUMBERS), "AAAA"), "four bytes a cell"),
    ],
    ids=["no JSON", "no map", "another site", "another resolution", "another format", "cells that are none"],
)
def test_a_wrong_file_is_refused_with_path_and_reason(tmp_path: Path, document: str, words: str) -> None:
    path = tmp_path / "room.map.json"
    path.write_text(document)
    with pytest.raises(DocumentError, match=words) as refused:
        map_file.load(path, "picking", LATTICE)
    assert str(refused.value).startswith(f"{path}: ")
    assert map_file.REMEDY in str(refused.value)


def test_a_wrong_map_of_a_site_is_found_before_anything_starts(tmp_path: Path) -> None:
    lab = resources.files("tandem.skills") / "sites" / "lab.yaml"
    room = tmp_path / "room.yaml"
    room.write_text(lab.read_text("utf-8") + "\noccupancy: {}\n")
    map_file.check(str(room), None)
    (tmp_path / "room.map.json").write_text("nothing")
    with pytest.raises(DocumentError, match=r"room.map.json"):
        map_file.check(str(room), None)
    room.write_text(lab.read_text("utf-8"))
    map_file.check(str(room), None)
