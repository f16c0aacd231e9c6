"""CPU time of one depth image for the map of occupied space: ``python -m benchmarks.occupancy``.

A picture of 1280 x 720 pixels of the LoCoBot's room from its home, as its camera sees it; read, and what it
shows made into coal's octree. The second picture of a place has cells to free, so it is the one that counts.
"""

from __future__ import annotations

import time

import numpy as np

from benchmarks.rows import Row, spread
from tandem.sim.camera import camera_header
from tandem.sim.render import Job, Painter, PainterSettings, Scene
from tandem.sim.render_world import Posed, Snapshot, View
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import load_scenario
from tandem.sim.scene import build_scene
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import compose, to_pose
from tandem.skills.kinematics.bodies import CellsShape, geometry
from tandem.skills.perception.camera_frames import CameraMount
from tandem.skills.perception.clutter import HEIGHTS, Known
from tandem.skills.perception.jobs import Shot
from tandem.skills.perception.occupancy import MapJob, read_picture
from tandem.skills.ports.lattice import Lattice
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.site import load

TIMES = 40
"""Pictures of each view; a quick run reads three."""
VIEWS = ((0.0, -0.3), (1.2, -0.3), (-1.2, -0.5))
"""Pan and tilt (rad)."""


def main() -> None:
    """Print the rows."""
    for row in rows():
        print(f"{row.what:42} {row.value:8.2f} {row.unit:6} {row.note}")


def rows(*, quick: bool = False) -> list[Row]:
    """Measure CPU time, on this core: nobody else's work counts."""
    shots = _pictures()
    site = load("picking")
    lattice = Lattice.over(site.bounds, HEIGHTS[1], 0.05)
    known = Known(tuple(box_in_map(box) for each in site.furniture for box in each.boxes), (), (), 0.21)
    read, made, found = list[float](), list[float](), np.zeros(0, np.int64)
    for number in range(3 if quick else TIMES):
        shot = shots[number % len(shots)]
        job = MapJob(shot, lattice, found, known, (1280, 720))
        began = time.process_time()
        found = read_picture(job).occupied
        read.append(time.process_time() - began)
        shape, _ = CellsShape.of(lattice.centres(found), lattice.resolution)
        began = time.process_time()
        geometry(shape)
        made.append(time.process_time() - began)
    note = f"1280 x 720, {len(found)} cells of 5 cm in the end"
    return [
        *spread("a depth image for the map, CPU", read, note=note),
        *spread("coal's octree of the cells, CPU", made),
    ]


def _pictures() -> list[Shot]:
    """Return what the LoCoBot's camera sees from its start, drawn as its scenario says."""
    site, scenario, model = load("picking"), load_scenario("Locobot"), robot_model("locobot")
    mount, base = CameraMount(model.description), scenario.first.start
    painter = Painter(PainterSettings(urdfs=(model.physics_urdf,)))
    lens, shots = model.description.camera, list[Shot]()
    header = camera_header(lens, RobotTime(boot="b", seconds=0.0))
    try:
        for number, (pan, tilt) in enumerate(VIEWS, start=1):
            camera = mount.camera_in_base({"pan": pan, "tilt": tilt})
            job = Job(
                number=number,
                scene=Scene(1, build_scene(site, scenario) if number == 1 else None),
                snapshot=Snapshot(robots=(Posed(Pose(position=(9.0, 9.0, 0.0)), ()),), bodies=()),
                view=View(compose(to_pose(base), camera), lens.width, lens.height, lens.horizontal_fov),
                header=header,
                noise=scenario.noise,
                noise_key=(1, number),
            )
            shots.append(Shot(painter.paint(job), camera, base))
    finally:
        painter.close()
    return shots


if __name__ == "__main__":
    main()
