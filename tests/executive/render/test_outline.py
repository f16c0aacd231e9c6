"""A picture of a large tree: what is left out by rule, what it says of that, and that it fits a page."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from tandem.executive.render.example import example_request, tree_of
from tandem.executive.render.layout import lay_out, overlaps
from tandem.executive.render.outline import fits
from tandem.executive.render.text import lines, lines_within
from tandem.executive.render.view import NoSuchNodeError, View
from tandem.skills.ports.tasks import NodeStatus, TreeNode
from tandem.skills.site import load
from tandem.trees.registry import discover


def node(name: str, kind: str, *children: TreeNode, running: bool = False, phase: bool = False) -> TreeNode:
    return TreeNode.model_validate(
        {
            "path": name,
            "name": name,
            "kind": kind,
            "type": "Phase" if phase else "Node",
            "status": "RUNNING" if running else "INVALID",
            "children": children,
        }
    )


def leaf(name: str, *, running: bool = False) -> TreeNode:
    return node(name, "action", running=running)


def shown(root: TreeNode) -> list[str]:
    return [str(line) for line in lines(root)]


def fetch() -> TreeNode:
    kind, site = discover()["fetch"], load("lab")
    return tree_of(kind, site, example_request(kind, site))


RECOVERY = node("get", "recovery", leaf("grasp"), leaf("again"), leaf("elsewhere"))
GOAL = node("held", "selector", node("held?", "condition"), leaf("pick it up"))
DEEP = node("all", "sequence", node("near", "sequence", leaf("survey"), leaf("drive")), leaf("grasp"))


@pytest.mark.parametrize(
    ("view", "tree", "expected"),
    [
        (View(hide=("recoveries",)), RECOVERY, ["↻ get (+2 recoveries)", "└─ ▢ grasp"]),
        (View(hide=("guards",)), node("x", "sequence", GOAL), ["→ x", "└─ ▢ pick it up"]),
        (
            View(hide=("recoveries", "guards")),
            node("x", "sequence", RECOVERY),
            ["→ x", "└─ ▢ grasp (+2 recoveries)"],
        ),
        (View(depth=1), DEEP, ["→ all", "├─ → near (+2 nodes)", "└─ ▢ grasp"]),
        (View(depth=0), DEEP, ["→ all", "├─ → near", "│  ├─ ▢ survey", "│  └─ ▢ drive", "└─ ▢ grasp"]),
        (View(everything=True, focus="near"), DEEP, ["→ near", "├─ ▢ survey", "└─ ▢ drive"]),
        (
            View(hide=("guards",)),
            node("x", "sequence", node("p", "decorator", GOAL, phase=True)),
            ["→ x", "└─ δ p"],
        ),
    ],
)
def test_a_view_leaves_out_what_it_says(view: View, tree: TreeNode, expected: list[str]) -> None:
    assert shown(view.of(tree)) == expected


def test_a_step_of_a_recovery_that_runs_stays() -> None:
    ran = node("get", "recovery", leaf("grasp"), leaf("again", running=True), leaf("elsewhere"), running=True)
    assert shown(View(hide=("recoveries",)).of(ran)) == [
        "▶ ↻ get (+1 recovery)",
        "├─ · ▢ grasp",
        "└─ ▶ ▢ again",
    ]


def test_a_chain_has_the_status_that_its_parent_sees() -> None:
    """Held already, so the work under the goal never ran."""
    held = node("x", "sequence", GOAL.model_copy(update={"status": NodeStatus.SUCCESS}))
    assert shown(View(hide=("guards",)).of(held)) == ["· → x", "└─ ✓ ▢ pick it up"]


def test_the_picture_of_a_fetch_fits_a_page_and_has_each_phase() -> None:
    drawn = View().of(fetch())
    layout = lay_out(drawn)
    assert fits(layout)
    assert overlaps(layout) == []
    names = [each.name for each in drawn.walk()]
    assert [name for name in names if name in {"request", "search", "pick", "place", "home"}] == [
        "request",
        "search",
        "pick",
        "place",
        "home",
    ]
    assert len(names) < 40


@pytest.mark.parametrize("task", discover())
def test_the_picture_of_every_task_fits_a_page(task: str) -> None:
    kind, site = discover()[task], load("bimanual")
    assert fits(lay_out(View().of(tree_of(kind, site, example_request(kind, site)))))


@pytest.mark.parametrize(
    ("name", "said"),
    [("grip", "no node 'grip' among its 5; similar: 'grasp'"), ("twice", "the name of 2 nodes")],
)
def test_a_focus_that_is_not_one_node_is_told(name: str, said: str) -> None:
    twice = node("b", "sequence", leaf("twice"), leaf("twice"))
    tree = DEEP if name == "grip" else twice
    with pytest.raises(NoSuchNodeError, match=said):
        View(focus=name).of(tree)


def running_at(root: TreeNode, path: Sequence[str]) -> TreeNode:
    """Return the tree with the nodes along a path of names running."""
    children = tuple(
        running_at(child, path[1:]) if path[1:] and child.name == path[1] else child
        for child in root.children
    )
    return root.model_copy(update={"status": NodeStatus.RUNNING, "children": children})


def leaves(root: TreeNode) -> list[str]:
    return [each.path for each in root.walk() if not each.children]


@pytest.mark.parametrize("height", [5, 12, 22])
def test_every_leaf_that_runs_is_within_the_terminal(height: int) -> None:
    tree = fetch()
    missed = []
    for path in leaves(tree):
        ran = lines_within(running_at(tree, path.split("/")), height)
        if len(ran) > height or not any(
            line.name == path.split("/")[-1] and line.status is NodeStatus.RUNNING for line in ran
        ):
            missed.append(path)
    assert missed == []
