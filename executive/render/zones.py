"""The workspace zones as text, SVG and PNG: seen from above, the robot at the bottom looking up."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from tandem.skills.bimanual.zones import ZonesFound
    from tandem.skills.ports.actions.bimanual import ZoneRow

COLOURS: Final = {"L": "#9ecae9", "R": "#f6b48f", "C": "#b5d6a7", "U": "#eeeeee"}
SIGNS: Final = {"L": "◧", "R": "◨", "C": "■", "U": "·"}
WORDS: Final = {"L": "S_L: left hand", "R": "S_R: right hand", "C": "C: both", "U": "U: neither"}
EDGE: Final = 18
"""Pixels of a cell."""
LEFT: Final = 60
"""Pixels left of the grid, for x."""
BELOW: Final = 70
"""Pixels below it, for y and the legend."""


def unicode_zones(found: ZonesFound) -> str:
    """Return the grid in signs, two for a cell, the left side of the robot to the left."""
    lines = [
        f"{row.x:5.2f}  {' '.join(SIGNS[each] for each in reversed(row.cells))}" for row in _far_first(found)
    ]
    width = 2 * len(found.rows[0].cells) - 1
    lines.append(f"{'x (m)':>5}  {'y = ' + format(-found.y0, '+.2f'):<{width - 6}}{found.y0:+.2f}")
    legend = "   ".join(f"{SIGNS[letter]} {words}" for letter, words in WORDS.items())
    lines.append(f"{legend}   at {found.height:.2f} m, torso at {found.torso:.2f} m")
    return "\n".join(lines)


def svg_zones(found: ZonesFound) -> str:
    """Return the same as an SVG document; a cell's tooltip has its place."""
    columns, rows = len(found.rows[0].cells), len(found.rows)
    width, height = LEFT + columns * EDGE + 20, rows * EDGE + BELOW
    return "\n".join(
        (
            (
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
                f' viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="12">'
            ),
            "<title>Workspace zones</title>",
            '<rect width="100%" height="100%" fill="white"/>',
            *_cells(found),
            *_labels(found),
            "</svg>\n",
        )
    )


def png_zones(found: ZonesFound) -> bytes:
    """Return the grid as a PNG file's content, without words."""
    import cv2  # noqa: PLC0415 - takes longer to load than all the rest
    import numpy as np  # noqa: PLC0415

    cells = [[_bgr(COLOURS[each]) for each in reversed(row.cells)] for row in _far_first(found)]
    picture = np.kron(np.array(cells, dtype=np.uint8), np.ones((EDGE, EDGE, 1), dtype=np.uint8))
    picture[::EDGE], picture[:, ::EDGE] = 255, 255
    done, content = cv2.imencode(".png", picture)
    if not done:
        raise OSError("OpenCV could not make a PNG of the zones")
    return bytes(content)


def _far_first(found: ZonesFound) -> list[ZoneRow]:
    return list(reversed(found.rows))


def _cells(found: ZonesFound) -> Iterator[str]:
    for i, row in enumerate(_far_first(found)):
        for j, each in enumerate(reversed(row.cells)):
            y = found.y0 + found.cell * (len(row.cells) - 1 - j)
            yield (
                f'<rect x="{LEFT + j * EDGE}" y="{i * EDGE}" width="{EDGE}" height="{EDGE}"'
                f' fill="{COLOURS[each]}" stroke="white">'
                f"<title>x {row.x:.2f} m, y {y:+.2f} m: {WORDS[each]}</title></rect>"
            )


def _labels(found: ZonesFound) -> Iterator[str]:
    rows, columns = len(found.rows), len(found.rows[0].cells)
    for i, row in enumerate(_far_first(found)):
        if i % 2 == 0:
            yield f'<text x="4" y="{i * EDGE + 13}">{row.x:.2f} m</text>'
    base = rows * EDGE + 16
    for j in range(0, columns, 4):
        y = found.y0 + found.cell * (columns - 1 - j)
        middle = LEFT + j * EDGE + EDGE // 2
        yield f'<text x="{middle}" y="{base}" text-anchor="middle">{y:+.2f}</text>'
    for k, (letter, words) in enumerate(WORDS.items()):
        left = LEFT + 150 * k
        yield f'<rect x="{left}" y="{base + 14}" width="14" height="14" fill="{COLOURS[letter]}"/>'
        yield f'<text x="{left + 20}" y="{base + 25}">{words}</text>'
    told = f"in the base, at {found.height:.2f} m, torso at {found.torso:.2f} m"
    yield f'<text x="{LEFT}" y="{base + 46}">{told}</text>'


def _bgr(text: str) -> tuple[int, int, int]:
    """Return "#rrggbb" as OpenCV's blue, green, red."""
    return (int(text[5:7], 16), int(text[3:5], 16), int(text[1:3], 16))
