"""Plug-ins of other packages are loaded; what is wrong with one is said of it, and harms no other."""

from __future__ import annotations

import signal
from importlib.metadata import EntryPoints, entry_points
from typing import Final

import pytest

from tandem.skills.ports.plugins import Group, load
from tandem.skills.ports.plugins import installed as declared
from tests.fakes.packages import Installed

GOOD = "VALUE = 'mine'\n"
TRIED: Final[dict[str, str]] = {}
"""All were tried before: none is tried in a process of its own."""
BAD = {
    "raises": ("raise ValueError('no licence\\nfound')", "ValueError: no licence found (", "raises.py:1)"),
    "exits": ("raise SystemExit(3)", "SystemExit: 3 (", "exits.py:1)"),
    "hangs": ("while True:\n    pass", "its import took longer than 0.3 s", ""),
    "swallows": (
        "while True:\n    try:\n        while True:\n            pass\n    except Exception:\n        pass",
        "its import took longer than 0.3 s",
        "",
    ),
    "wrong": ("VALUE = 7", "expected text; found int", ""),
    "lacks": ("OTHER = 7", "AttributeError: module 'lacks' has no attribute 'VALUE'", ""),
    "misspelt": ("VALU", "NameError: name 'VALU' is not defined (", "misspelt.py:1)"),
}


def text(_: str, value: object) -> str:
    """Take text only."""
    if not isinstance(value, str):
        raise TypeError(f"expected text; found {type(value).__name__}")  # as a group's own check does
    return value


@pytest.mark.parametrize("bad", BAD)
def test_one_that_can_not_be_loaded_is_named_and_the_rest_runs(installed: Installed, bad: str) -> None:
    source, error, place = BAD[bad]
    entries = {"a_bad": f"{bad}:VALUE", "good": "good:VALUE"}
    installed.add("somebody", {bad: source, "good": GOOD}, {"tandem.nodes": entries})
    loaded = load(Group.NODES, text, left_out=TRIED, within=0.3)
    assert dict(loaded.found) == {"good": "mine"}
    (broken,) = loaded.broken
    assert str(broken).startswith(f"plug-in nodes/a_bad (somebody 1.0) is left out: {error}")
    assert str(broken).endswith(place)
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


TAKEN: Final = (
    "the name 'theirs' is taken: by a-first 1.0; give one of the two another name in its pyproject.toml "
    "and install it again, or uninstall one"
)


@pytest.mark.parametrize(
    ("name", "taken", "error"),
    [
        ("theirs", (), TAKEN),
        ("fetch", ("fetch",), "the name 'fetch' is taken: Tandem's own; choose another one"),
        ("Of-mine", (), "expected a name of small letters, digits and _, that begins with a letter"),
    ],
)
def test_a_name_is_taken_once(installed: Installed, name: str, taken: tuple[str, ...], error: str) -> None:
    installed.add("a-first", {"first": GOOD}, {"tandem.nodes": {"theirs": "first:VALUE"}})
    installed.add("somebody", {"good": GOOD}, {"tandem.nodes": {name: "good:VALUE"}})
    loaded = load(Group.NODES, text, taken=taken, left_out=TRIED)
    assert dict(loaded.found) == {"theirs": "mine"}
    assert [(each.plugin.package, each.error) for each in loaded.broken] == [("somebody", error)]
    assert loaded.origins["theirs"].package == "a-first"


def test_one_that_is_known_not_to_load_is_not_tried(installed: Installed) -> None:
    installed.add("somebody", {"bad": "raise SystemExit"}, {"tandem.nodes": {"bad": "bad:VALUE"}})
    (plugin,) = declared(Group.NODES)
    (broken,) = load(Group.NODES, text, left_out={plugin.key: "it hung"}).broken
    assert broken.error == "it hung"


def test_ctrl_c_is_no_fault_of_a_plug_in(installed: Installed) -> None:
    installed.add("somebody", {"bad": "raise KeyboardInterrupt"}, {"tandem.nodes": {"bad": "bad:VALUE"}})
    with pytest.raises(KeyboardInterrupt):
        load(Group.NODES, text, left_out=TRIED)


def test_what_packages_declare_is_read_once_until_one_is_added(
    installed: Installed, monkeypatch: pytest.MonkeyPatch
) -> None:
    def entries(name: str) -> dict[str, dict[str, str]]:
        return {"tandem.tasks": {name: f"{name}_app:TASK"}}

    read: list[str] = []

    def reading(group: str) -> EntryPoints:
        read.append(group)
        return entry_points(group=group)

    monkeypatch.setattr("tandem.skills.ports.plugins.entry_points", reading)
    installed.add("one-app", {}, entries("one"))
    for _ in range(3):
        declared(Group.TASKS)
    assert len(read) == 1
    installed.add("two-app", {}, entries("two"))
    found = {each.name for each in declared(Group.TASKS)}
    assert {"one", "two"} <= found
