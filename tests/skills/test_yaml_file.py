"""The strict reader of YAML: what it takes, and where it stands.

What it refuses is in tests/outside/test_wrong_files.
"""

from __future__ import annotations

from math import inf, isnan

import pytest
from pydantic import BaseModel, JsonValue

from tandem.skills.ports.sources import DocumentError, Source
from tandem.skills.yaml_file import LONGEST_NUMBER, parse_document, validate


class Thing(BaseModel):
    number: int
    edges: tuple[float, ...] = ()


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a: 1", {"a": 1}),
        ("a: -0.5", {"a": -0.5}),
        ("a: 1e6", {"a": 1e6}),
        ("a: 5.", {"a": 5.0}),
        ("a: -.inf", {"a": -inf}),
        ("a: ~", {"a": None}),
        ("a:", {"a": None}),
        ("a: true", {"a": True}),
        ("a: '035'", {"a": "035"}),
        ("a: 0.1.0", {"a": "0.1.0"}),
        ("a: table_west", {"a": "table_west"}),
        ("a: &b [1, 2]\nc: *b", {"a": [1, 2], "c": [1, 2]}),
        ("{x: 1, y: 2, n: 3}", {"x": 1, "y": 2, "n": 3}),
        ("", None),
    ],
)
def test_values_are_those_of_the_core_schema(text: str, value: JsonValue) -> None:
    assert parse_document(text, "f")[0] == value


def test_not_a_number_is_a_number() -> None:
    data, _ = parse_document("a: .nan", "f")
    assert isinstance(data, dict)
    assert isinstance(data["a"], float)
    assert isnan(data["a"])


def test_digits_without_end_are_text() -> None:
    """Python refuses to turn 4,301 digits into a number; a model then says that a number was expected."""
    digits = "9" * (LONGEST_NUMBER + 1)
    assert parse_document(f"a: {digits}", "f")[0] == {"a": digits}


def test_each_value_has_its_line() -> None:
    _, source = parse_document("a: 1\nb:\n  - {c: 1}\n  - d:\n      - 2\n", "f")
    assert source.at("b.0.c") == "f: b.0.c (line 3)"
    assert source.at("b.1.d.0") == "f: b.1.d.0 (line 5)"
    assert source.at("b.1.missing") == "f: b.1.missing (line 4)"
    assert source.at("") == "f: (the whole document)"


def test_steps_that_the_file_lacks_are_passed_over() -> None:
    """Pydantic puts the name of a union's member into its path."""
    source = Source("f", {"": 1, "faults": 1, "faults.0": 2, "faults.0.lasts": 3})
    assert source.at("faults.0.camera_dark.lasts") == "f: faults.0.camera_dark.lasts (line 3)"


def test_a_model_takes_no_text_for_a_number_and_lists_for_tuples() -> None:
    assert validate({"number": 1, "edges": [1, 2.5]}, Source("f"), Thing).edges == (1.0, 2.5)
    with pytest.raises(DocumentError, match=r'f: number: expected a whole number, found "1"'):
        validate({"number": "1"}, Source("f"), Thing)


def test_each_mistake_has_its_line() -> None:
    data, source = parse_document("number: x\nedges: [1, a]\n", "f.yaml")
    with pytest.raises(DocumentError) as caught:
        validate(data, source, Thing)
    first, second = str(caught.value).splitlines()
    assert first.startswith("f.yaml: number (line 1): ")
    assert second.startswith("f.yaml: edges.1 (line 2): ")
