"""Clauses about lasers, cliff sensors, cameras and odometry."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.executive.conformance.recording import Pictures
from tandem.skills.geometry.chain import Chain
from tandem.skills.ports import keys

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.hardware import Odometry, RgbdHeader
    from tandem.skills.ports.sensors import CameraSensor

SCAN_JITTER: Final = 0.2
"""Share by which a laser's period may be off on average: motors turn as they like, and scans get lost."""
PICTURE_WITHIN: Final = 3.0
"""Robot seconds after which a look gives a camera up (CAMERA_SILENT)."""
PICTURES: Final = 2
"""That are waited for: the second one shows that the camera goes on."""
FOCAL: Final = 0.02
"""Share by which a focal length may differ from the described field of view: 1 cm in 50 cm sideways, which is
what a hand forgives."""
FLOOR: Final = 0.02
"""Metres by which a cliff sensor may be off over an even floor: within it, a base at an edge goes on."""
ODOMETRY_WITHIN: Final = 0.5
"""Robot seconds without odometry after which the base brakes."""
JUMP: Final = (0.03, 0.05)
"""m and rad by which odometry may step beyond what the drive's speed explains."""


def _lasers(bench: Bench) -> Steps:
    if not bench.robot.lasers:
        raise Skip("the robot has no laser")
    for laser in bench.robot.lasers:
        topic = keys.laser(laser.name)
        scans = bench.recording.messages(topic)
        if len(scans) < 2:  # noqa: PLR2004 - a period lies between two
            raise Broken(f"scans on {topic.key}", f"{len(scans)}")
        for scan in scans:
            if len(scan.ranges) != laser.beams:
                raise Broken(f"{laser.beams} ranges on {topic.key}", f"{len(scan.ranges)}")
        steps = [after.stamp.since(before.stamp) or 0.0 for before, after in pairwise(scans)]
        mean = sum(steps) / len(steps)
        if abs(mean - laser.period) > SCAN_JITTER * laser.period:
            raise Broken(f"a scan every {laser.period:g} s on {topic.key}", f"one every {mean:.3f} s")
    yield


def _cliffs(bench: Bench) -> Steps:
    if not bench.robot.cliff_sensors:
        raise Skip("the robot has no cliff sensor")
    told = bench.recording.messages(keys.CLIFFS)
    for sensor in bench.robot.cliff_sensors:
        read = [(each.stamp, far) for each in told if (far := each.of(sensor.name)) is not None]
        if len(read) < 2:  # noqa: PLR2004 - a period lies between two
            raise Broken(f"readings of {sensor.name} on {keys.CLIFFS.key}", f"{len(read)}")
        mean = (read[-1][0].since(read[0][0]) or 0.0) / (len(read) - 1)
        if mean > (1.0 + SCAN_JITTER) * sensor.period:
            raise Broken(f"a reading of {sensor.name} every {sensor.period:g} s", f"one every {mean:.3f} s")
        mount = Chain.from_urdf(bench.robot.urdf, bench.robot.base_frame, sensor.frame).pose({})
        height = mount.position[2]
        worst = max((far for _, far in read), key=lambda far: abs(far - height))
        if abs(worst - height) > FLOOR:
            raise Broken(f"{sensor.name} to read {height:.3f} m over an even floor", f"{worst:.3f} m")
    yield


def _cameras(bench: Bench) -> Steps:
    if not bench.robot.cameras:
        raise Skip("the robot has no camera")
    for camera in bench.robot.cameras:
        pictures = Pictures(bench.bus, camera.name)

        def seen(pictures: Pictures = pictures) -> bool:
            pictures.step()
            return bool(pictures.wrong) or len(pictures.headers) >= PICTURES

        try:
            came = yield from bench.until(seen, PICTURE_WITHIN)
        finally:
            pictures.close()
        if pictures.wrong:
            raise Broken(f"an RGB-D picture on {keys.rgbd(camera.name)}", pictures.wrong)
        if not came:
            raise Broken(
                f"{PICTURES} pictures of {camera.name} in {PICTURE_WITHIN:g} s", f"{len(pictures.headers)}"
            )
        for header in pictures.headers:
            _judge_picture(header, camera)
        first, last = pictures.headers[0], pictures.headers[-1]
        if last.stamp.is_after(first.stamp) is False:
            raise Broken(f"stamps of {camera.name} that rise", "one that does not")


def _judge_picture(header: RgbdHeader, camera: CameraSensor) -> None:
    size = (camera.name, camera.width, camera.height)
    if (header.camera, header.width, header.height) != size:
        found = f"{header.camera}, {header.width} x {header.height}"
        raise Broken(f"pictures of {camera.name}, {camera.width} x {camera.height}", found)
    focal = camera.width / (2.0 * math.tan(camera.horizontal_fov / 2.0))
    if abs(header.fx - focal) > FOCAL * focal:
        raise Broken(
            f"fx of {focal:.1f} px for {camera.horizontal_fov:.3f} rad of {camera.name}", f"{header.fx:.1f}"
        )
    if not (0.0 <= header.cx < camera.width and 0.0 <= header.cy < camera.height):
        raise Broken(
            f"the principal point of {camera.name} in the picture", f"({header.cx:.1f}, {header.cy:.1f})"
        )


def _odometry(bench: Bench) -> Steps:
    if bench.robot.drive is None:
        raise Skip("the robot has no drive")
    told = bench.recording.messages(keys.ODOMETRY)
    if not told:
        raise Broken(f"odometry on {keys.ODOMETRY.key}", "none")
    for before, after in pairwise(told):
        _judge_step(bench, before, after)
    newest = bench.recording.clock
    late = None if newest is None else newest.stamp.since(told[-1].stamp)
    if late is not None and late > ODOMETRY_WITHIN:
        raise Broken(f"odometry at least every {ODOMETRY_WITHIN:g} s", f"none for {late:.2f} s")
    yield


def _judge_step(bench: Bench, before: Odometry, after: Odometry) -> None:
    took = after.stamp.since(before.stamp)
    if took is None:
        return
    if not 0.0 < took <= ODOMETRY_WITHIN:
        raise Broken(f"odometry at least every {ODOMETRY_WITHIN:g} s, with stamps that rise", f"{took:.3f} s")
    drive, old, new = bench.robot.driven, before.base_in_odom, after.base_in_odom
    way, turn = math.hypot(new.x - old.x, new.y - old.y), abs(math.remainder(new.yaw - old.yaw, math.tau))
    fastest = max(drive.forward, drive.backward)
    if way > fastest * took + JUMP[0] or turn > drive.turn * took + JUMP[1]:
        raise Broken("odometry that goes on where it was", f"a jump of {way:.3f} m and {turn:.3f} rad")


CLAUSES: Final = (
    Clause(
        "laser_fits",
        "Each laser tells scans with the described number of beams, at its period.",
        "interface.md#lasersensor",
        _lasers,
    ),
    Clause(
        "cliffs_fit",
        "Each cliff sensor tells at its period how far the floor is; over an even one, how high it is.",
        "interface.md#cliffsensor",
        _cliffs,
    ),
    Clause(
        "camera_fits",
        "Each camera tells pictures of the described size and field of view while somebody subscribes.",
        "interface.md#rgbdheader",
        _cameras,
    ),
    Clause(
        "odometry_continuous",
        "Odometry comes at least twice a second, with stamps that rise, and never jumps.",
        "endpoints.md",
        _odometry,
    ),
)
