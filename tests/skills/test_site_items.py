"""Items of a site file: boxes and cylinders, and what is refused with file, path and reason."""

from __future__ import annotations

import re
from importlib import resources
from pathlib import Path

import pytest

from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import DocumentError
from tandem.skills.site import load

TIN = "{item: 20, name: tin, shape: cylinder, diameter: 0.066, height: 0.09, tag_size: 0.048}"


def with_item(words: str, folder: Path) -> Path:
    shipped = (resources.files("tandem.skills") / "sites" / "pantry.yaml").read_text("utf-8")
    assert TIN in shipped
    file = folder / "pantry.yaml"
    file.write_text(shipped.replace(TIN, f"{{item: 20, {words}, tag_size: 0.048}}"), "utf-8")
    return file


@pytest.mark.parametrize(
    ("words", "size"),
    [
        ("size: [0.06, 0.06, 0.08]", (0.06, 0.06, 0.08)),
        ("shape: box, size: [0.06, 0.06, 0.08]", (0.06, 0.06, 0.08)),
        ("shape: cylinder, diameter: 0.07, height: 0.08", (0.07, 0.07, 0.08)),
    ],
)
def test_an_item_has_the_size_of_the_box_about_it(
    words: str, size: tuple[float, ...], tmp_path: Path
) -> None:
    item = load(str(with_item(words, tmp_path))).item(20)
    assert item is not None
    assert item.size == size
    assert item.shape == ("cylinder" if "cylinder" in words else "box")


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("shape: cylinder, height: 0.09", r"items\.0 \(line \d+\): expected a diameter \(m\)"),
        ("shape: cylinder, diameter: 0.066", r"items\.0 \(line \d+\): expected a height \(m\)"),
        ("shape: cylinder, size: [0.06, 0.06, 0.09]", r"items\.0 \(line \d+\): expected a diameter \(m\)"),
        (
            "shape: cylinder, diameter: -0.1, height: 0.09",
            r"items\.0\.diameter \(line \d+\): expected greater than 0, found -0\.1$",
        ),
        (
            "shape: cylinder, diameter: 0.066, height: 0.09, size: [0.066, 0.066, 0.09]",
            r"items\.0\.size \(line \d+\): expected either size, of a box, or diameter",
        ),
        (
            "shape: cylinder, diameter: 0.066, height: 0.09, size: [0.06, 0.06, 0.09]",
            r"items\.0 \(line \d+\): expected diameter and height of a cylinder, and no other size",
        ),
        ("diameter: 0.066, height: 0.09", r"items\.0 \(line \d+\): expected no diameter"),
        ("size: [0.06, 0.06, 0.09], height: 0.09", r"items\.0 \(line \d+\): expected no height"),
        ("hands: []", r"items\.0 \(line \d+\): expected a size, the three edges of a box"),
        (
            "shape: cone, diameter: 0.066, height: 0.09",
            r"items\.0\.shape \(line \d+\): expected 'box' or 'cylinder', found \"cone\"",
        ),
        (
            "shape: cylinder, diameter: 0.04, height: 0.09",
            r"items\.0 \(line \d+\): expected a tag_size of at most 0\.04 m",
        ),
    ],
)
def test_measures_that_are_not_those_of_the_shape_are_refused(
    words: str, reason: str, tmp_path: Path
) -> None:
    file = with_item(words, tmp_path)
    with pytest.raises(DocumentError, match=rf"^{re.escape(str(file))}: {reason}"):
        load(str(file))


def test_a_site_reads_on_the_wire_as_in_its_file() -> None:
    site = load("pantry")
    assert Site.model_validate_json(site.model_dump_json()) == site


MUG = "{name: mug, size: [0.06, 0.06, 0.08], colour: [0.9, 0.1, 0.1]}"


def with_items(items: str, folder: Path) -> Path:
    shipped = (resources.files("tandem.skills") / "sites" / "pantry.yaml").read_text("utf-8")
    head, _ = shipped.split("\nitems:\n")
    file = folder / "pantry.yaml"
    file.write_text(f"{head}\nitems: [{items}]\n", "utf-8")
    return file


@pytest.mark.parametrize(
    ("items", "number"),
    [
        (MUG, 1409),
        (f"{TIN}, {{name: bowl, size: [0.06, 0.06, 0.08]}}, {MUG}", 1409),
        (MUG.replace("name", "item: 600, name"), 600),
    ],
    ids=["alone", "after others", "said"],
)
def test_an_item_may_be_of_name_and_shape_only(items: str, number: int, tmp_path: Path) -> None:
    item = load(str(with_items(items, tmp_path))).meant("mug")
    assert item is not None
    assert (item.item, item.tag_size, item.seen_edge) == (number, None, pytest.approx(0.048))


@pytest.mark.parametrize(
    ("items", "reason"),
    [
        (
            "{size: [0.06, 0.06, 0.06]}",
            r"items\.0 \(line \d+\): expected a name \(text\), or item, its number",
        ),
        (
            "{name: mug, size: [0.06, 0.06, 0.06], tag_size: 0.048}",
            r"items\.0 \(line \d+\): expected item, the number of its tag \(0 to 586\), beside tag_size",
        ),
        ("{name: 5, size: [0.06, 0.06, 0.06]}", r"items\.0 \(line \d+\): expected a name \(text\), or item"),
        (
            "{name: screw, size: [0.06, 0.06, 0.06]}, {name: soup, size: [0.06, 0.06, 0.06]}",
            r"items \(line \d+\): .* 2900 is .* screw and soup; say item: with .* number for screw or soup",
        ),
        (
            f"{{item: 1409, name: bowl, size: [0.06, 0.06, 0.06]}}, {MUG}",
            r"items \(line \d+\): .* bowl and mug; say item: with another number for mug",
        ),
        (
            f"{TIN}, {TIN.replace('tin', 'can')}",
            r"items \(line \d+\): expected each number once; 20 is that of two items, tin and can, found",
        ),
        (f"{MUG}, {MUG}", r"\(the whole document\): names of items: expected unique names, twice there: mug"),
    ],
)
def test_an_item_of_which_nothing_tells_the_number_is_refused(
    items: str, reason: str, tmp_path: Path
) -> None:
    file = with_items(items, tmp_path)
    with pytest.raises(DocumentError, match=rf"^{re.escape(str(file))}: {reason}"):
        load(str(file))


def test_a_tag_has_the_number_of_one(tmp_path: Path) -> None:
    file = with_item("size: [0.06, 0.06, 0.06]", tmp_path)
    file.write_text(file.read_text("utf-8").replace("item: 20, size", "item: 600, size"), "utf-8")
    with pytest.raises(DocumentError, match=r"expected an item of 0 to 586, the numbers of tags, or"):
        load(str(file))
