"""A tree in Graphviz's language, for those who have it."""

from __future__ import annotations

import json
from collections.abc import Iterator

from tandem.executive.render.folded import note_of
from tandem.executive.render.signs import EDGES, FILLS, KIND_SIGNS
from tandem.skills.ports.tasks import TreeNode


def dot(root: TreeNode) -> str:
    """Return the tree as a digraph."""
    return "\n".join(
        (
            f"digraph {_quoted(root.name)} {{",
            "  ordering=out; rankdir=LR;",
            '  node [shape=box, style="rounded,filled", fontname="Helvetica", fontsize=11];',
            *_nodes(root),
            "}",
        )
    )


def _nodes(node: TreeNode) -> Iterator[str]:
    note = note_of(node)
    label = _quoted(f"{KIND_SIGNS[node.kind]} {node.name}" + (f"\n{note}" if note else ""))
    fill, edge = _quoted(FILLS[node.shown]), _quoted(EDGES[node.kind])
    yield f"  {_quoted(node.path)} [label={label}, fillcolor={fill}, color={edge}];"
    for child in node.children:
        yield f"  {_quoted(node.path)} -> {_quoted(child.path)};"
        yield from _nodes(child)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)
