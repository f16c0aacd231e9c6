"""A tree as SVG, written by hand."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final
from xml.sax.saxutils import escape

from tandem.executive.render.folded import note_of
from tandem.executive.render.layout import BOX_HEIGHT, GAP, Layout, PlacedNode, lay_out
from tandem.executive.render.signs import EDGES, FILLS, KIND_SIGNS
from tandem.skills.ports.tasks import TreeNode

TIP_NAMES: Final = 3
"""Names of a path that a tooltip shows: its own and the nearest above."""
STYLE: Final = (
    "path{fill:none;stroke:#b8b8b0;stroke-width:1.2}rect{stroke-width:1.4}"
    ".s{text-anchor:middle;font-weight:bold}.n{font-size:10px;fill:#5f5f5a}"
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
        x, middle = a.x + a.width, (max(a.x + a.width, b.x - GAP) + b.x) / 2.0
        yield (
            f'<path d="M{x:.0f} {a.y:.1f}H{b.x - GAP:.0f}'
            f'C{middle:.0f} {a.y:.1f} {middle:.0f} {b.y:.1f} {b.x:.0f} {b.y:.1f}"/>'
        )


def _box(box: PlacedNode) -> str:
    node = box.node
    note, edge = note_of(node), EDGES[node.kind]
    top, line = box.y - box.height / 2.0, box.y - (6.0 if note else 0.0)
    corner = {"condition": BOX_HEIGHT / 2.0, "action": 3.0}.get(node.kind, 7.0)
    names = node.path.split("/")
    above = node.path if len(names) <= TIP_NAMES else f"…/{'/'.join(names[-TIP_NAMES:])}"
    since = "" if node.shown is node.status else ", set back since"
    tip = f"{above}\n{node.type} ({node.kind}), {node.shown}{since}"
    tip += "".join(f"\n{text}" for text in (node.message, note) if text)
    second = (
        f'<text class="n" x="{box.x + 25.0:.0f}" y="{line + 17.0:.1f}">{escape(note)}</text>' if note else ""
    )
    return (
        f"<g><title>{escape(tip)}</title>"
        f'<rect x="{box.x:.0f}" y="{top:.1f}" width="{box.width:.0f}" height="{box.height:.0f}"'
        f' rx="{corner:.0f}" fill="{FILLS[node.shown]}" stroke="{edge}"/>'
        f'<text class="s" x="{box.x + 13.0:.0f}" y="{line + 4.0:.1f}" fill="{edge}">'
        f"{escape(KIND_SIGNS[node.kind])}</text>"
        f'<text x="{box.x + 25.0:.0f}" y="{line + 4.0:.1f}">{escape(node.name)}</text>{second}</g>'
    )
