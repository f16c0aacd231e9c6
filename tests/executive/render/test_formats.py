"""Pictures of trees: names are there, files are what they claim to be, boxes do not overlap."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from typing import Literal

import pytest
from py_trees.behaviours import Success

from tandem.executive.cli.commands.tree_commands import Format
from tandem.executive.render.example import NoExampleError, example_request, tree_of
from tandem.executive.render.formats import FORMATS
from tandem.executive.render.layout import lay_out, overlaps
from tandem.executive.render.text import lines_within, unicode_text
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import NodeStatus, TreeNode
from tandem.skills.site import load
from tandem.trees.registry import discover
from tandem.trees.task import TaskType


def leaf(name: str, status: NodeStatus = NodeStatus.INVALID) -> TreeNode:
    return TreeNode(path=f"root/{name}", name=name, kind="action", type="Leaf", status=status)


SMALL = TreeNode(
    path="root",
    name="root",
    kind="selector",
    type="Selector",
    children=(
        TreeNode(path="root/seen?", name="seen?", kind="condition", type="Check"),
        TreeNode(
            path="root/both",
            name="both",
            kind="sequence",
            type="Sequence",
            children=(leaf('left <&> "right"'), leaf("then")),
        ),
    ),
)


@pytest.fixture(scope="module")
def fetch() -> TreeNode:
    kind, site = discover()["fetch"], load("lab")
    return tree_of(kind, site, example_request(kind, site))


@pytest.mark.parametrize("task", discover())
def test_the_tree_of_each_task_is_drawn_without_a_request(task: str) -> None:
    kind, site = discover()[task], load("bimanual")
    assert tree_of(kind, site, example_request(kind, site)).name == task


class Odd(Message):
    task: Literal["odd"] = "odd"
    how: str


def test_a_request_that_can_not_be_made_up_is_asked_for() -> None:
    kind = TaskType("odd", "", Odd, lambda _, __: (), lambda _, __: Success("odd"))
    with pytest.raises(NoExampleError, match="'how' is required and has no example; give the request"):
        example_request(kind, load("lab"))


def test_unicode_is_drawn_with_lines_and_signs() -> None:
    assert unicode_text(SMALL).splitlines() == [
        "? root",
        "├─ ◇ seen?",
        "└─ → both",
        '   ├─ ▢ left <&> "right"',
        "   └─ ▢ then",
    ]


def test_statuses_are_shown_once_there_are_any() -> None:
    ran = SMALL.model_copy(update={"status": NodeStatus.RUNNING, "message": "busy"})
    assert unicode_text(ran).startswith("▶ ? root: busy\n├─ · ◇ seen?")


def test_a_tree_too_high_is_folded_where_nothing_runs() -> None:
    ran = SMALL.model_copy(update={"status": NodeStatus.RUNNING})
    assert [str(line) for line in lines_within(ran, 3)] == ["▶ ? root", "└─ · → both (+2 nodes)"]


@pytest.mark.parametrize("name", [name for name in FORMATS if name != "png"])
def test_every_node_is_in_every_format_of_text(name: str, fetch: TreeNode) -> None:
    text = FORMATS[name](fetch).decode()
    assert [node.name for node in fetch.walk() if node.name not in text] == []


def test_ascii_is_ascii(fetch: TreeNode) -> None:
    FORMATS["ascii"](fetch).decode("ascii")


def test_svg_is_xml_with_a_box_for_each_node(fetch: TreeNode) -> None:
    root = ET.fromstring(FORMATS["svg"](SMALL))  # noqa: S314 - our own
    texts = [text.text for text in root.iter("{http://www.w3.org/2000/svg}text")]
    assert 'left <&> "right"' in texts
    drawn = ET.fromstring(FORMATS["svg"](fetch))  # noqa: S314 - our own
    boxes = list(drawn.iter("{http://www.w3.org/2000/svg}g"))
    assert len(boxes) == len(list(fetch.walk()))


def test_png_is_a_picture_of_the_layouts_size() -> None:
    content = FORMATS["png"](SMALL)
    assert content.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = int.from_bytes(content[16:20]), int.from_bytes(content[20:24])
    layout = lay_out(SMALL)
    assert (width, height) == (round(layout.width * 2), round(layout.height * 2))


def test_json_is_the_tree(fetch: TreeNode) -> None:
    assert TreeNode.model_validate(json.loads(FORMATS["json"](fetch))) == fetch


def test_dot_has_an_edge_for_each_child(fetch: TreeNode) -> None:
    assert FORMATS["dot"](fetch).decode().count(" -> ") == len(list(fetch.walk())) - 1


def test_no_box_touches_another_and_parents_stand_in_the_middle(fetch: TreeNode) -> None:
    layout = lay_out(fetch)
    assert overlaps(layout) == []
    rows = {box.node.path: box.y for box in layout.boxes}
    for node in fetch.walk():
        if node.children:
            middle = (rows[node.children[0].path] + rows[node.children[-1].path]) / 2
            assert rows[node.path] == pytest.approx(middle)


def test_all_is_within_the_picture(fetch: TreeNode) -> None:
    layout = lay_out(fetch)
    assert min(box.y for box in layout.boxes) > 12
    assert max(box.y for box in layout.boxes) < layout.height - 12
    assert max(box.x + box.width for box in layout.boxes) <= layout.width


def test_the_command_offers_every_format() -> None:
    assert [each.value for each in Format] == list(FORMATS)


def test_paths_are_unique(fetch: TreeNode) -> None:
    paths = [node.path for node in fetch.walk()]
    assert len(paths) == len(set(paths))
