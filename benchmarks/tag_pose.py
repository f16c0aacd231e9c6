"""Error of tag positions over distance, in the camera's frame, on the sim's own pictures with Demo's noise.

``python -m benchmarks.tag_pose [--tiny]``: one item of 6 cm (tag of 48 mm) in the room of Demo, seen from 20
to 35 degrees above, turned away by 0 to 45 degrees; the truth is where the item was put.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.rows import Row, quantile
from tandem.sim.camera import camera_header
from tandem.sim.render import Job, Painter, PainterSettings, Scene
from tandem.sim.render_world import Posed, Snapshot, View, looking_at
from tandem.sim.robots.registry import robot_model
from tandem.sim.robots.sensors import CAMERA_FIELD, camera_sensor
from tandem.sim.scenario import Noise, load_scenario
from tandem.sim.scene import SceneBody, build_scene, item_name
from tandem.sim.tags import tags_in_item
from tandem.skills.geometry.poses import angle_between, compose, conjugate, distance, invert, rotate
from tandem.skills.perception import tags
from tandem.skills.ports.image import RgbdImage, decode
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.site import load

ITEM = 29
DISTANCES = (0.5, 0.75, 1.0, 1.25, 1.5, 2.0)
ANGLES = (0.0, 15.0, 30.0, 45.0)
PICTURES = 8
"""At each distance and angle."""


@dataclass(frozen=True)
class Sample:
    """One picture: what was asked for, and how far off the answer was (None: not found)."""

    away: float
    angle: float
    error: float | None
    turn: float
    seconds: float


class Room:
    """The room of Demo, painted from anywhere."""

    def __init__(self, *, tiny: bool) -> None:
        """Build it."""
        site, scenario = load("lab"), load_scenario("Demo")
        self.noise: Noise = scenario.noise
        self.bodies: tuple[SceneBody, ...] = build_scene(site, scenario)
        self.item = next(body for body in self.bodies if body.name == item_name(ITEM))
        label = self.item.label
        assert label is not None
        self.sizes = {ITEM: label.tag_size or 0.0}
        self.painter = Painter(
            PainterSettings(urdfs=(robot_model("tiago_dual").physics_urdf,), hardware=not tiny)
        )
        self._painted = 0

    def picture(self, camera_in_map: Pose) -> RgbdImage:
        """Return what the camera sees there; the robot stands out of the way."""
        header = camera_header(camera_sensor("optical"), RobotTime(boot="b", seconds=0.0))
        self._painted += 1
        job = Job(
            number=self._painted,
            scene=Scene(1, self.bodies if self._painted == 1 else None),
            snapshot=Snapshot(robots=(Posed(Pose(position=(-2.5, 2.5, 0.0)), ()),), bodies=()),
            view=View(camera_in_map, header.width, header.height, CAMERA_FIELD),
            header=header,
            noise=self.noise,
            noise_key=(1, self._painted),
        )
        return decode(self.painter.paint(job))


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure: what a list of samples says at each distance, up to 45 degrees."""
    room = Room(tiny=False)
    try:
        taken = list(samples(room, np.random.default_rng(1), pictures=1 if quick else PICTURES))
    finally:
        room.painter.close()
    for away in DISTANCES:
        row = [each for each in taken if each.away == away]
        errors = [each.error * 1000.0 for each in row if each.error is not None]
        turns = [math.degrees(each.turn) for each in row if each.error is not None]
        what, aim = f"tag at {away:g} m", 5.0 if away == 1.0 else None
        note = f"found in {len(errors)} of {len(row)} pictures"
        yield Row(f"{what}, error of position, median", quantile(errors, 0.5), "mm", aim, note=note)
        yield Row(f"{what}, error of position, p95", quantile(errors, 0.95), "mm")
        yield Row(f"{what}, error of angle, median", quantile(turns, 0.5), "degrees")
    spent = [1e3 * each.seconds for each in taken]
    note = f"1280 x 720, {room.painter.renderer}"
    yield Row("tags in a picture, median", quantile(spent, 0.5), "ms", note=note)
    yield Row("tags in a picture, p95", quantile(spent, 0.95), "ms")


def samples(room: Room, rng: np.random.Generator, *, pictures: int = PICTURES) -> Iterator[Sample]:
    """Take pictures from all distances and angles."""
    faces = [compose(room.item.pose, face) for face in tags_in_item((0.06, 0.06, 0.06))]
    west = min(faces, key=lambda face: face.position[0])
    out = rotate(west.orientation, (0.0, 0.0, 1.0))
    heading = math.atan2(out[1], out[0])
    for away in DISTANCES:
        for angle in ANGLES:
            for _ in range(pictures):
                side = heading + math.radians(angle) * rng.choice((-1, 1))
                up = math.radians(rng.uniform(20, 35))
                direction = (math.cos(side) * math.cos(up), math.sin(side) * math.cos(up), math.sin(up))
                eye = tuple(p + away * d for p, d in zip(west.position, direction, strict=True))
                aside = rng.uniform(-0.12, 0.12, 3)
                target = tuple(p + a for p, a in zip(west.position, aside, strict=True))
                camera = looking_at((eye[0], eye[1], eye[2]), (target[0], target[1], target[2]))
                yield _sample(room, camera, west, away, angle)


def _sample(room: Room, camera: Pose, truth_in_map: Pose, away: float, angle: float) -> Sample:
    image = room.picture(camera)
    truth = compose(invert(camera), truth_in_map)
    up = rotate(conjugate(camera.orientation), (0.0, 0.0, 1.0))
    started = time.perf_counter()
    found = tags.find(image, room.sizes, up)
    seconds = time.perf_counter() - started
    near = [each for each in found if distance(each.tag_in_camera, truth) < 0.03]
    if not near:
        return Sample(away, angle, None, 0.0, seconds)
    best = min(near, key=lambda each: angle_between(each.tag_in_camera.orientation, truth.orientation))
    turn = angle_between(best.tag_in_camera.orientation, truth.orientation)
    return Sample(away, angle, distance(best.tag_in_camera, truth), turn, seconds)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tiny", action="store_true", help="draw with TinyRenderer")
    room = Room(tiny=parser.parse_args().tiny)
    taken = list(samples(room, np.random.default_rng(1)))
    print(f"renderer {room.painter.renderer}, {len(taken)} pictures, tag {room.sizes[ITEM] * 1000:.0f} mm")
    print("distance  found   position mm: median   p95   angle deg: median   p95   ms")
    for away in DISTANCES:
        row = [each for each in taken if each.away == away]
        errors = [each.error * 1000 for each in row if each.error is not None]
        turns = [math.degrees(each.turn) for each in row if each.error is not None]
        if not errors:
            print(f"{away:6.2f} m   0/{len(row)}")
            continue
        milliseconds = 1000 * np.median([each.seconds for each in row])
        position = f"{np.median(errors):20.2f} {np.percentile(errors, 95):5.2f}"
        turned = f"{np.median(turns):19.2f} {np.percentile(turns, 95):5.2f}"
        print(f"{away:6.2f} m  {len(errors):3}/{len(row)} {position} {turned} {milliseconds:4.0f}")
    room.painter.close()


if __name__ == "__main__":
    main()
