"""The head's RGB-D camera: takes a snapshot of the world, has it drawn, and publishes the picture.

It works only while somebody listens. In lockstep a picture is drawn at once and published ``latency`` robot
seconds after its stamp; with a worker it is published when it is there, and not before that.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import pybullet

from tandem.sim.render import Job, Renderer, Scene
from tandem.sim.render_world import Posed, Snapshot, View, looking_at
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.keys import rgbd
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.sensors import CameraSensor

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tandem.sim.body import RobotBody
    from tandem.sim.scenario import Noise
    from tandem.sim.urdf import Array
    from tandem.sim.world import World
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.message import RobotTime, Vector3

PHOTO_FIELD: Final = math.radians(60.0)
"""Horizontal field of photographs for people."""
LATENCY: Final = 0.06
"""Robot seconds from exposure to message: what such a camera and its driver take."""


def camera_header(sensor: CameraSensor, stamp: RobotTime) -> RgbdHeader:
    """Return a picture's header; the centre of the first pixel is at (0, 0)."""
    focal = sensor.width / 2 / math.tan(sensor.horizontal_fov / 2)
    return RgbdHeader(
        stamp=stamp,
        camera=sensor.name,
        width=sensor.width,
        height=sensor.height,
        fx=focal,
        fy=focal,
        cx=(sensor.width - 1) / 2,
        cy=(sensor.height - 1) / 2,
    )


def pose_of(matrix: Array) -> Pose:
    """Return a 4x4 transform as a pose."""
    x, y, z = ((float(matrix[0, i]), float(matrix[1, i]), float(matrix[2, i])) for i in range(3))
    position = (float(matrix[0, 3]), float(matrix[1, 3]), float(matrix[2, 3]))
    return Pose(position=position, orientation=from_axes(x, y, z))


class Studio:
    """Makes snapshots and jobs of a world with its robots, and hands them to a renderer.

    It is shared by the camera and by whoever wants photographs; each result goes to the one who asked.
    """

    def __init__(
        self, world: World, robots: Sequence[RobotBody], renderer: Renderer, *, noise: Noise, seed: int
    ) -> None:
        self._renderer = renderer
        self._number = 0
        self._results: dict[int, bytes] = {}
        self._unwanted: set[int] = set()
        self.restart(world, robots, noise=noise, seed=seed)

    def restart(self, world: World, robots: Sequence[RobotBody], *, noise: Noise, seed: int) -> None:
        """Show another world, or the same one made anew; pictures still under way are dropped."""
        self._world = world
        self._robots = tuple((robot, _movable_joints(robot)) for robot in robots)
        self._noise = noise
        self._seed = seed
        self._first = self._number
        self._sent_revision = -1
        self._results.clear()

    def order(self, view: View, header: RgbdHeader | None = None) -> int:
        """Have the world drawn as it is now; return the job's number. Without a header it is a photograph."""
        self._number += 1
        revision = self._world.revision
        bodies = (
            None
            if revision == self._sent_revision
            else (*self._world.bodies.values(), *self._world.figures())
        )
        self._sent_revision = revision
        scene = Scene(revision, bodies)
        self._renderer.request(
            Job(
                number=self._number,
                scene=scene,
                snapshot=self.snapshot(),
                view=view,
                header=header,
                noise=self._noise,
                noise_key=(self._seed, self._number - self._first),
            )
        )
        return self._number

    def fetch(self, number: int) -> bytes | None:
        """Return a job's result, once; None while there is none.

        Raises:
            RenderError: when none will ever come.
        """
        done = self._renderer.poll()
        if done is not None and done.number in self._unwanted:
            self._unwanted.remove(done.number)
        elif done is not None and done.number > self._first:
            self._results[done.number] = done.payload
        return self._results.pop(number, None)

    def warm_up(self) -> None:
        """Have a picture made that nobody wants: the first takes seconds, as the renderer loads the room."""
        self._unwanted.add(self.order_photograph((0.0, 0.0, 2.0), (1.0, 0.0, 0.0), 64, 64))

    def warming(self) -> bool:
        """Say whether the picture that warms up is still being drawn.

        Raises:
            RenderError: when the renderer has died.
        """
        self.fetch(0)
        return bool(self._unwanted)

    @property
    def unfetched(self) -> int:
        """Pictures that are there and that nobody has fetched yet."""
        return len(self._results)

    def order_photograph(self, eye: Vector3, target: Vector3, width: int, height: int) -> int:
        """Have a photograph made for people, from any place in map; its result is a PNG."""
        return self.order(View(looking_at(eye, target), width, height, PHOTO_FIELD))

    def close(self) -> None:
        """End the renderer."""
        self._renderer.close()

    def snapshot(self) -> Snapshot:
        """Return how everything stands now."""
        return Snapshot(
            robots=tuple(_posed(robot, joints) for robot, joints in self._robots),
            bodies=(
                *((name, self._world.pose(name)) for name in self._world.movable()),
                *((figure.name, figure.pose) for figure in self._world.figures()),
            ),
        )


@dataclass(frozen=True)
class _Exposure:
    number: int
    seconds: float


class HeadCamera:
    """Publishes pictures while somebody listens.

    Args:
        bus: where they are published.
        studio: who draws them.
        robot: whose frame the camera's is.
        sensor: of the robot's description.
        rate: pictures a robot second.
        latency: robot seconds from a picture's stamp to its message, at the least.
    """

    rests: Final = False

    def __init__(
        self,
        bus: Bus,
        studio: Studio,
        robot: RobotBody,
        sensor: CameraSensor,
        *,
        rate: float,
        latency: float = LATENCY,
    ) -> None:
        self._bus = bus
        self._studio = studio
        self._robot = robot
        self._sensor, self._key = sensor, rgbd(sensor.name)
        self._period = 1.0 / rate
        self._latency = latency
        self._next = -math.inf
        self._exposed: _Exposure | None = None
        self._ready: deque[tuple[float, bytes]] = deque()

    def step(self, now: RobotTime) -> None:
        """Publish what is ready, and expose the next picture when it is time. Call once a period.

        Raises:
            RenderError: when the renderer has died.
        """
        self._collect()
        while self._ready and now.seconds >= self._ready[0][0] + self._latency - 1e-9:
            self._bus.publish(self._key, self._ready.popleft()[1])
        if self._exposed is None and now.seconds >= self._next - 1e-9 and self._bus.listened(self._key):
            on_time = now.seconds - self._next < self._period
            self._next = (self._next if on_time else now.seconds) + self._period
            self._expose(now)

    def late_by(self, now: RobotTime) -> float:
        """Return the robot seconds since the exposure that is still being drawn; 0 when there is none.

        A sim that runs faster than real time waits here, so that pictures keep up with the robot's clock.
        """
        return 0.0 if self._exposed is None else now.seconds - self._exposed.seconds

    def _expose(self, now: RobotTime) -> None:
        camera = pose_of(self._robot.frame_matrix(self._sensor.frame))
        view = View(camera, self._sensor.width, self._sensor.height, self._sensor.horizontal_fov)
        number = self._studio.order(view, camera_header(self._sensor, now))
        self._exposed = _Exposure(number, now.seconds)
        self._collect()

    def _collect(self) -> None:
        if self._exposed is None:
            return
        payload = self._studio.fetch(self._exposed.number)
        if payload is not None:
            self._ready.append((self._exposed.seconds, payload))
            self._exposed = None


def _posed(robot: RobotBody, joints: tuple[str, ...]) -> Posed:
    position, orientation = robot.base_pose()
    return Posed(
        base_in_map=Pose(position=position, orientation=orientation),
        joints=tuple((name, r.position) for name, r in zip(joints, robot.read(joints), strict=True)),
    )


def _movable_joints(robot: RobotBody) -> tuple[str, ...]:
    client = robot.physics.client
    return tuple(
        name
        for name, index in robot.joint_index.items()
        if pybullet.getJointInfo(robot.body, index, physicsClientId=client)[2] != pybullet.JOINT_FIXED
    )
