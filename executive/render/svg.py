"""A tree as SVG, written by hand."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape

from executive.render.layout import BOX_HEIGHT, Layout, PlacedNode, lay_out
from executive.render.signs import EDGES, FILLS, KIND_SIGNS
from skills.ports.tasks import TreeNode


def svg(root: TreeNode) -> str:
    """Return the tree as an SVG document; a box's tooltip has its path, type and message."""
    layout = lay_out(root)
    width, height = f"{layout.width:.0f}", f"{layout.height:.0f}"
    return "\n".join(
        (
            (
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
                f' viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="12">'
            ),
            f"<title>{escape(root.name)}</title>",
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
            f'<path d="M {x:.1f} {a.y:.1f} L {b.x - 36.0:.1f} {a.y:.1f}'
            f' C {middle:.1f} {a.y:.1f} {middle:.1f} {b.y:.1f} {b.x:.1f} {b.y:.1f}"'
            ' fill="none" stroke="#b8b8b0" stroke-width="1.2"/>'
        )


def _box(box: PlacedNode) -> str:
    node = box.node
    top, edge = box.y - BOX_HEIGHT / 2.0, EDGES[node.kind]
    corner = {"condition": BOX_HEIGHT / 2.0, "action": 3.0}.get(node.kind, 7.0)
    tip = f"{node.path}\n{node.type} ({node.kind}), {node.status}" + (
        f"\n{node.message}" if node.message else ""
    )
    return (
        f"<g><title>{escape(tip)}</title>"
        f'<rect x="{box.x:.1f}" y="{top:.1f}" width="{box.width:.1f}" height="{BOX_HEIGHT}" rx="{corner}"'
        f' fill="{FILLS[node.status]}" stroke="{edge}" stroke-width="1.4"/>'
        f'<text x="{box.x + 13.0:.1f}" y="{box.y + 4.0:.1f}" text-anchor="middle" fill="{edge}"'
        f' font-weight="bold">{escape(KIND_SIGNS[node.kind])}</text>'
        f'<text x="{box.x + 25.0:.1f}" y="{box.y + 4.0:.1f}" fill="#222222">{escape(node.name)}</text></g>'
    )
