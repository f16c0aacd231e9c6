"""Whoever hears goes through the check of what enters; nobody who publishes chooses how it is delivered."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Final

import pytest

ROOT: Final = Path(__file__).parents[2]
ROOMS: Final = ("executive", "skills", "sim", "trees")
MAY_SUBSCRIBE: Final = {
    "skills/ports/keys.py": "Latest, which checks",
    "skills/ports/hearing.py": "Heard, which checks",
    "skills/ports/forwarding_bus.py": "a bus around a bus",
    "skills/testing/faulty_bus.py": "a bus around a bus",
    "skills/scoped_bus.py": "a bus around a bus",
    "sim/faulty_link.py": "a bus around a bus",
    "executive/conformance/recording.py": "the hardware check: it tells what is wrong with a message",
    "executive/trials/campaigns/crash_points.py": "a bus around a bus",
    "executive/records/pictures.py": "a recorder: what is no picture is not written",
    "skills/ports/serving.py": "documents that are put instead of asked: served, so checked as questions are",
}


def sources() -> list[Path]:
    return sorted(path for room in ROOMS for path in (ROOT / room).rglob("*.py"))


def called(path: Path) -> set[str]:
    calls = [node.func for node in ast.walk(ast.parse(path.read_text("utf-8"))) if isinstance(node, ast.Call)]
    return {func.attr for func in calls if isinstance(func, ast.Attribute)}


@pytest.mark.parametrize("path", sources(), ids=lambda path: str(path.relative_to(ROOT)))
def test_nobody_reads_what_has_not_been_checked(path: Path) -> None:
    name = str(path.relative_to(ROOT))
    if "subscribe" in called(path):
        assert name in MAY_SUBSCRIBE, (
            "hear through tandem.skills.ports.keys.Latest or tandem.skills.ports.hearing.Heard"
        )


def test_the_list_is_of_files_that_subscribe() -> None:
    assert [name for name in MAY_SUBSCRIBE if "subscribe" not in called(ROOT / name)] == []


def test_the_parser_that_overflows_is_called_in_one_place() -> None:
    """``json.loads`` of a thousand brackets in one another raises RecursionError, which is no ValueError.

    A hundred thousand of them on ``hw/clock`` ended the recorder.
    """
    reads = {str(path.relative_to(ROOT)) for path in sources() if "json.loads(" in path.read_text("utf-8")}
    assert reads == {
        "skills/ports/documents.py",  # parse, which counts the brackets first
        "skills/ports/plain_json.py",  # read_json
        "skills/wire/configs.py",  # what this process has written itself
        "executive/web/app.py",  # catches it
        "executive/trials/campaigns/fuzz.py",  # what this process has written itself
        "executive/system/plugin_probe.py",  # its arguments, of the process that starts it
    }


def test_strays_are_told_from_messages_in_one_place() -> None:
    """A subscription of zenoh's own hears wildcards and deletions, too; ``strays.hear`` counts them.

    Of tokens, which are no messages, each session asks zenoh itself.
    """
    own = re.compile(r"(?<!liveliness\(\))\.declare_subscriber\(")
    found = {str(path.relative_to(ROOT)) for path in sources() if own.search(path.read_text("utf-8"))}
    assert found == {"skills/wire/strays.py"}


def test_congestion_is_decided_in_one_place() -> None:
    """Zenoh's ``BLOCK`` in any publisher holds up its process for seconds when a reader stands still."""
    blocks = re.compile(r"CongestionControl\.BLOCK\b")
    blocking = [str(path.relative_to(ROOT)) for path in sources() if blocks.search(path.read_text("utf-8"))]
    deciding = {
        str(path.relative_to(ROOT)) for path in sources() if "congestion_control" in path.read_text("utf-8")
    }
    assert blocking == []
    assert deciding == {"skills/wire/configs.py", "skills/wire/zenoh_bus.py"}
