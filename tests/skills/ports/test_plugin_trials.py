"""A plug-in that ends its process at import ends a child of ours only, and is known from then on."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tandem.skills.ports import plugin_trials
from tandem.skills.ports.plugin_memory import path_of_memory, remember, remembered
from tandem.skills.ports.plugins import Group, Plugin, load
from tandem.skills.ports.plugins import installed as declared
from tests.fakes.packages import Installed

GOOD = "VALUE = 'mine'\n"
ENDS = {
    "exits": ("import os\nos._exit(3)", "its import ended its process (exit code 3)"),
    "crashes": ("import os\nos.kill(os.getpid(), 11)", "its import ended its process (SIGSEGV)"),
    "says_why": (
        "import os\nos.write(2, b'no licence\\n')\nos.abort()",
        "its import ended its process (SIGABRT): no licence",
    ),
}


def as_it_is(_: str, value: object) -> object:
    """Take anything."""
    return value


def plugins(installed: Installed, **modules: str) -> tuple[Plugin, ...]:
    """Install a package with a plug-in in each module."""
    installed.add("somebody", modules, {"tandem.nodes": {name: f"{name}:VALUE" for name in modules}})
    return declared(Group.NODES)


@pytest.mark.parametrize("bad", ENDS)
def test_it_is_left_out_with_what_happened_and_what_to_do(installed: Installed, bad: str) -> None:
    source, error = ENDS[bad]
    plugins(installed, a_good=GOOD, bad=source, good=GOOD)
    loaded = load(Group.NODES, as_it_is)
    assert dict(loaded.found) == {"a_good": "mine", "good": "mine"}
    (broken,) = loaded.broken
    assert broken.error == f"{error}; mend somebody or uninstall it, and try it with `tandem plugins`"


def test_one_that_hangs_whatever_is_raised_in_it_is_ended(installed: Installed) -> None:
    hangs = "while True:\n    try:\n        while True: pass\n    except BaseException: pass"
    plugins(installed, hangs=hangs)
    (broken,) = load(Group.NODES, as_it_is, within=0.5).broken
    assert broken.error.startswith("its import took longer than 0.5 s; mend somebody")


def test_what_was_tried_is_not_tried_again_until_its_files_change(
    installed: Installed, monkeypatch: pytest.MonkeyPatch
) -> None:
    plugins(installed, bad=ENDS["exits"][0], good=GOOD)
    first = load(Group.NODES, as_it_is)
    with monkeypatch.context() as patch:
        patch.setattr(plugin_trials, "_tried", None)
        assert load(Group.NODES, as_it_is) == first
    (installed.folder / "bad.py").write_text("VALUE = 'mended'\n")
    assert dict(load(Group.NODES, as_it_is).found) == {"bad": "mended", "good": "mine"}


def test_a_change_in_a_package_below_the_module_is_noticed(installed: Installed) -> None:
    (installed.folder / "app" / "tasks").mkdir(parents=True)
    for file in ("__init__.py", "tasks/__init__.py", "tasks/tour.py"):
        (installed.folder / "app" / file).write_text("")
    (plugin,) = (Plugin(Group.TASKS, "tour", "app", "1.0", "app.tasks.tour:TASK"),)
    remember({plugin: ""})
    assert remembered([plugin]) == {plugin.key: ""}
    (installed.folder / "app" / "tasks" / "deeper.py").write_text("1 / 0")
    assert remembered([plugin]) == {}
    assert "app" not in sys.modules


@pytest.mark.parametrize("held", [b"", b"[]", b'{"a": 3}', b"\xff"])
def test_a_memory_that_cannot_be_read_is_none(
    installed: Installed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, held: bytes
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    path = path_of_memory(os.environ)
    path.parent.mkdir(parents=True)
    path.write_bytes(held)
    those = plugins(installed, good=GOOD)
    assert remembered(those) == {}
    remember({those[0]: ""})
    assert remembered(those) == {those[0].key: ""}


def test_where_nothing_can_be_kept_each_command_tries_anew(
    installed: Installed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    those = plugins(installed, bad=ENDS["exits"][0])
    assert load(Group.NODES, as_it_is).broken
    assert remembered(those) == {}
