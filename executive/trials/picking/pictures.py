"""Figures of the order-picking paper as pictures: the planning scene (Fig. 10), the workflow (Fig. 11)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.executive.trials.picking.phases import is_turn
from tandem.executive.trials.picking.settings import PickingRun, Stretch
from tandem.executive.trials.picking.witness import Known, Shot
from tandem.sim.camera import PHOTO_FIELD
from tandem.sim.render import Job, Painter, Scene
from tandem.sim.render_world import View, looking_at
from tandem.sim.scene import item_name

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tandem.sim.scene import SceneBody
    from tandem.skills.ports.message import Vector3
    from tandem.skills.ports.site import Site

PANEL: Final = (400, 300)
"""Pixels of one picture, width and height."""
QUALITY: Final = 75
"""Of 100: WebP of five such pictures takes 50 kB."""
BAND: Final = 24
"""Pixels below each for its words."""
LETTERS: Final = 0.42
"""Scale of OpenCV's font: letters that fit the band, with room above and below."""
SCENE_COLOURS: Final[Mapping[Known, Vector3]] = {"there": (0.20, 0.75, 0.25), "held": (0.58, 0.22, 0.72)}
"""Green while the item is a thing of the scene, purple while it is attached: the paper's (IV-A)."""
BESIDE, BEHIND, ABOVE = 0.75, 0.25, 0.95
"""Metres from the robot to the eye of a close picture: over its shoulder, past a shelf's side."""
OVERVIEW: Final = 2.6
"""Metres above the floor of the eye that sees the whole room, over its corner."""
Colours = NDArray[np.uint8]


@dataclass(frozen=True)
class Panel:
    """One picture of a figure.

    Args:
        words: below it.
        shot: what it shows.
        close: whether robot and item fill it, or the whole room does.
        scene: whether the item has its colour in the planning scene.
    """

    words: str
    shot: Shot
    close: bool
    scene: bool


def scene_panels(run: PickingRun, shots: Sequence[Shot]) -> tuple[Panel, ...]:
    """Return Fig. 10, a to e; nothing when the item was not picked and placed."""
    drives = [each for each in run.stretches if each.node.startswith("drive to item")]
    grasp, attach = _last(run, "grasp"), _last(run, "attach")
    detach, withdraw = _last(run, "detach"), _last(run, "withdraw")
    if grasp is None or attach is None or detach is None or withdraw is None:
        return ()
    away = (drives[-1].begin + drives[-1].end) / 2 if drives else grasp.begin
    moments = (
        ("a) the base approaches the item", away, False),
        ("b) pre-grasp; the item is in the scene", grasp.begin, True),
        ("c) in the hand: attached", attach.end, True),
        ("d) let go: detached", detach.end, True),
        ("e) drawn back, hand and item apart", withdraw.end, True),
    )
    return tuple(Panel(words, _shot(shots, at), close, scene=True) for words, at, close in moments)


def workflow_panels(run: PickingRun, shots: Sequence[Shot]) -> tuple[Panel, ...]:
    """Return Fig. 11, a to d; nothing when the item was not picked and placed."""
    close, let_go = _last(run, "close"), _last(run, "let go")
    if close is None or let_go is None:
        return ()
    turns = [each for each in run.stretches if is_turn(each)]
    searched = turns[-1].end if turns else 0.0
    moments = (
        ("a) it looks for the item", searched, False),
        ("b) it picks the item", close.end, True),
        ("c) it puts the item down", let_go.begin, True),
        ("d) home, ready for the next request", run.lasted, False),
    )
    return tuple(Panel(words, _shot(shots, at), near, scene=False) for words, at, near in moments)


@dataclass(frozen=True)
class Album:
    """Draws panels.

    Args:
        painter: draws one picture.
        bodies: all that stands in the room.
        item: that is fetched.
        site: the room.
    """

    painter: Painter
    bodies: tuple[SceneBody, ...]
    item: int
    site: Site

    def write(self, path: Path, panels: Sequence[Panel]) -> None:
        """Draw them, in two rows, into a file; its kind follows from its ending.

        Raises:
            OSError: when it can't be written.
        """
        drawn = [_with_words(self._draw(panel, number), panel.words) for number, panel in enumerate(panels)]
        columns = math.ceil(len(drawn) / 2)
        drawn += [np.full_like(drawn[0], 255)] * (2 * columns - len(drawn))
        rows = [np.concatenate(drawn[row * columns : (row + 1) * columns], axis=1) for row in range(2)]
        path.touch()  # says why it can't be written, which OpenCV does not
        if not cv2.imwrite(str(path), np.concatenate(rows, axis=0), [cv2.IMWRITE_WEBP_QUALITY, QUALITY]):
            raise OSError(f"{path}: OpenCV could not write the picture")

    def _draw(self, panel: Panel, number: int) -> Colours:
        name, snapshot = item_name(self.item), panel.shot.snapshot
        colour = SCENE_COLOURS.get(panel.shot.known) if panel.scene else None
        bodies = self.bodies
        if colour is not None:
            bodies = tuple(
                replace(each, colour=colour, label=None) if each.name == name else each for each in bodies
            )
        (x, y, _), thing = snapshot.robots[0].base_in_map.position, dict(snapshot.bodies)[name].position
        bounds = self.site.bounds
        eye, target = _shoulder((x, y), thing, bounds) if panel.close else _corner(thing, bounds)
        view = View(looking_at(eye, target), *PANEL, PHOTO_FIELD)
        png = self.painter.paint(Job(number, Scene(number, bodies), snapshot, view))
        picture: Colours | None = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR)
        assert picture is not None, "the painter gives a PNG"
        return picture


def _shoulder(
    robot: tuple[float, float], thing: Vector3, bounds: tuple[float, float, float, float]
) -> tuple[Vector3, Vector3]:
    """Return eye and target of a picture over the robot's shoulder, on the side that has more room."""
    ahead = math.atan2(thing[1] - robot[1], thing[0] - robot[0])
    eyes = [
        (
            robot[0] - BEHIND * math.cos(ahead) - side * BESIDE * math.sin(ahead),
            robot[1] - BEHIND * math.sin(ahead) + side * BESIDE * math.cos(ahead),
        )
        for side in (1.0, -1.0)
    ]
    middle = ((bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2)
    eye = min(eyes, key=lambda each: math.dist(each, middle))
    target = ((robot[0] + 2 * thing[0]) / 3, (robot[1] + 2 * thing[1]) / 3, thing[2] * 0.8)
    return (*eye, ABOVE), target


def _corner(thing: Vector3, bounds: tuple[float, float, float, float]) -> tuple[Vector3, Vector3]:
    """Return eye and target of a picture of the room, over the corner that is farthest from the item."""
    corners = [(x, y) for x in bounds[::2] for y in bounds[1::2]]
    eye = max(corners, key=lambda each: math.dist(each, thing[:2]))
    middle = ((bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2)
    return (*eye, OVERVIEW), (*middle, 0.0)


def _with_words(picture: Colours, words: str) -> Colours:
    band: Colours = np.full((BAND, picture.shape[1], 3), 255, dtype=np.uint8)
    cv2.putText(band, words, (6, 16), cv2.FONT_HERSHEY_SIMPLEX, LETTERS, (30, 30, 30), 1, cv2.LINE_AA)
    return np.concatenate((picture, band), axis=0)


def _last(run: PickingRun, node: str) -> Stretch | None:
    """Return the last time that a node ended well."""
    return next((each for each in reversed(run.stretches) if each.node == node and each.ended_well), None)


def _shot(shots: Sequence[Shot], at: float) -> Shot:
    """Return the first one at a time or after it: what was done by then has been heard."""
    return next((each for each in shots if each.at >= at), shots[-1])
