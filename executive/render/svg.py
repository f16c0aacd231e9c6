"""A tree as SVG, written by hand."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final
from xml.sax.saxutils import escape

from tandem.executive.render.layout import BOX_HEIGHT, Layout, PlacedNode, lay_out
from tandem.executive.render.signs import EDGES, FILLS, KIND_SIGNS
from tandem.skills.ports.tasks import TreeNode

TIP_NAMES: Final = 3
"""Names of a path that a tooltip shows: its own and the nearest above."""
STYLE: Final = (
    "path{fill:none;stroke:#b8b8b0;stroke-width:1.2}rect{stroke-width:1.4}"
    ".s{text-anchor:middle;font-weight:bold}"
)


def svg(root: TreeNode) -> str:
    """Return the tree as an SVG document; a box's tooltip has the end of its path, its type and message."""
    layout = lay_out(root)
    width, height = f"{layout.width:.0f}", f"{layout.height:.0f}"
    return "\n".join(
        (
            (
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
                f' viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="12">'
            ),
            f"<title>{escape(root.name)}</title>",
            f"<style>{STYLE}</style>",
            '<rect width="100%" height="100%" fill="white"/>',
            *_edges(layout),
            *(_box(box) for box in layout.boxes),
            "</svg>\n",
        )
    )


def _edges(layout: Layout) -> Iterator[str]:
    for parent, child in layout.edges:
        a, b = layout.boxes[parent], layout.boxes[child]
        x, middle = a.x + a.width, (max(a.x + a.width, b.x - 36.0) + b.x) / 2.0
        yield (
            f'<path d="M{x:.0f} {a.y:.1f}H{b.x - 36.0:.0f}'
            f'C{middle:.0f} {a.y:.1f} {middle:.0f} {b.y:.1f} {b.x:.0f} {b.y:.1f}"/>'
        )


def _box(box: PlacedNode) -> str:
    node = box.node
    top, edge = box.y - BOX_HEIGHT / 2.0, EDGES[node.kind]
    corner = {"condition": BOX_HEIGHT / 2.0, "action": 3.0}.get(node.kind, 7.0)
    names = node.path.split("/")
    above = node.path if len(names) <= TIP_NAMES else f"…/{'/'.join(names[-TIP_NAMES:])}"
    since = "" if node.shown is node.status else ", set back since"
    tip = f"{above}\n{node.type} ({node.kind}), {node.shown}{since}"
    tip += f"\n{node.message}" if node.message else ""
    return (
        f"<g><title>{escape(tip)}</title>"
        f'<rect x="{box.x:.0f}" y="{top:.1f}" width="{box.width:.0f}" height="{BOX_HEIGHT:.0f}"'
        f' rx="{corner:.0f}" fill="{FILLS[node.shown]}" stroke="{edge}"/>'
        f'<text class="s" x="{box.x + 13.0:.0f}" y="{box.y + 4.0:.1f}" fill="{edge}">'
        f"{escape(KIND_SIGNS[node.kind])}</text>"
        f'<text x="{box.x + 25.0:.0f}" y="{box.y + 4.0:.1f}">{escape(node.name)}</text></g>'
    )
