"""How kinds and statuses of nodes are shown; the signs are the field's usual ones."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from tandem.skills.ports.tasks import NodeStatus, TreeNode

KIND_SIGNS: Final = MappingProxyType(
    {
        "sequence": "→",
        "selector": "?",
        "parallel": "⇉",
        "recovery": "↻",
        "decorator": "δ",
        "condition": "◇",
        "action": "▢",
    }
)
KIND_SIGNS_ASCII: Final = MappingProxyType(
    {
        "sequence": "->",
        "selector": "?",
        "parallel": "=>",
        "recovery": "@",
        "decorator": "d",
        "condition": "<>",
        "action": "[]",
    }
)
STATUS_SIGNS: Final = MappingProxyType(
    {NodeStatus.INVALID: "·", NodeStatus.RUNNING: "▶", NodeStatus.SUCCESS: "✓", NodeStatus.FAILURE: "✗"}
)
STATUS_SIGNS_ASCII: Final = MappingProxyType(
    {NodeStatus.INVALID: ".", NodeStatus.RUNNING: "*", NodeStatus.SUCCESS: "+", NodeStatus.FAILURE: "x"}
)
STATUS_STYLES: Final = MappingProxyType(
    {
        NodeStatus.INVALID: "dim",
        NodeStatus.RUNNING: "bold yellow",
        NodeStatus.SUCCESS: "green",
        NodeStatus.FAILURE: "red",
    }
)
"""Styles of rich."""
FILLS: Final = MappingProxyType(
    {
        NodeStatus.INVALID: "#f5f5f2",
        NodeStatus.RUNNING: "#ffe9a8",
        NodeStatus.SUCCESS: "#cfe8cf",
        NodeStatus.FAILURE: "#f3c4bf",
    }
)
"""Colours of a node's box, by status."""
EDGES: Final = MappingProxyType(
    {
        "sequence": "#3d5a80",
        "selector": "#b5651d",
        "parallel": "#6b4c9a",
        "recovery": "#b0562c",
        "decorator": "#7a7a7a",
        "condition": "#2a7f6f",
        "action": "#444444",
    }
)
"""Colours of a node's border, by kind."""


def has_run(node: TreeNode) -> bool:
    """Say whether any node of the tree has been ticked."""
    return node.shown is not NodeStatus.INVALID or any(has_run(child) for child in node.children)
