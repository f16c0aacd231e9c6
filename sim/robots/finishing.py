"""The last steps of every robot: weld what is rigid, put parents first, check it, draw what collides."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tandem.sim.urdf import Array, UrdfDocument

DARK: Final = ("finger", "wheel", "caster", "_2_link")
"""Links with one of these in their name are drawn dark."""
COLOURS: Final = {"White": "0.92 0.92 0.90 1", "DarkGrey": "0.16 0.16 0.17 1"}
"""Where the robot's own URDF defines none: pybullet draws a colour that nobody defines as it likes."""


def finish(document: UrdfDocument, keep: Iterable[str]) -> tuple[str, dict[str, tuple[str, Array]]]:
    """Weld what is rigid, check it, draw what collides; return the URDF for the physics, and all frames.

    The document gets the welded frames back, without mass: it is then the description's.

    Args:
        document: with its grippers on.
        keep: links on fixed joints that stay links of their own.
    """
    import numpy as np  # noqa: PLC0415 - what the robots are called and take is known without

    document.weld(keep)
    document.parents_first()
    frames = {link: (link, np.eye(4)) for link in document.links()} | document.welded
    _draw_collision_shapes(document)
    document.check()
    physics_urdf = document.text()
    for name, (link, at) in sorted(document.welded.items()):
        document.add_frame(name, link, at)
    return physics_urdf, frames


def _draw_collision_shapes(document: UrdfDocument) -> None:
    """Show the collision shapes: they draw fast, and what is seen is what collides."""
    for name in document.links():
        link = document.link(name)
        for visual in link.findall("visual"):
            link.remove(visual)
        colour = "DarkGrey" if any(word in name for word in DARK) else "White"
        for collision in link.findall("collision"):
            visual = ET.SubElement(link, "visual")
            for part in collision:
                if part.tag in ("origin", "geometry"):
                    visual.append(part)
            ET.SubElement(visual, "material", name=colour)
    defined = {material.get("name") for material in document.root.findall("material")}
    for name, rgba in COLOURS.items():
        if name not in defined:
            material = ET.Element("material", name=name)
            ET.SubElement(material, "color", rgba=rgba)
            document.root.insert(0, material)
