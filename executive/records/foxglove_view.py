"""What Foxglove draws by itself, made of our messages: joints, transforms, scene, laser and log.

Its messages are protobuf with schemas that its viewer knows. They stand beside ours under ``foxglove/...``,
thinned to what an eye sees: ours have everything.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from foxglove.messages import (
    Color,
    CompressedImage,
    CubePrimitive,
    CylinderPrimitive,
    FrameTransform,
    FrameTransforms,
    JointState,
    LaserScan,
    Log,
    LogLevel,
    Pose,
    Quaternion,
    SceneEntity,
    SceneUpdate,
    Timestamp,
    Vector3,
)
from foxglove.messages import JointStates as JointStatesShown

from tandem.executive.records.incidents import Incidents
from tandem.executive.records.mcap_file import OURS
from tandem.executive.records.mcap_writing import McapFile, Schema
from tandem.executive.records.recording import Attachment, Recorded
from tandem.skills.geometry.poses import to_pose
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.hearing import Ear, Reason
from tandem.skills.ports.keys import DESCRIPTION, JOINT_STATES
from tandem.skills.ports.message import Quaternion as OurQuaternion
from tandem.skills.ports.message import Vector3 as OurVector
from tandem.skills.ports.message import read_leniently
from tandem.skills.ports.pose import Pose as OurPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import LaserScan as OurScan
from tandem.skills.ports.shapes import is_round, solid
from tandem.skills.ports.world import ROBOT_POSE, SCENE, PlanningScene, RobotPose, SceneObject

EVERY: Final = 0.05
"""Robot seconds between two of one key, at the least: 20 a second look smooth."""
SCANS_EVERY: Final = 0.2
"""Robot seconds between two scans, likewise: each has hundreds of ranges, and five a second show a room."""
MAP: Final = "map"
GREY: Final = Color(r=0.6, g=0.6, b=0.65, a=0.8)
ORANGE: Final = Color(r=0.95, g=0.55, b=0.1, a=0.9)
"""Of items, so that they stand out from furniture, which is grey. Both let a little through: what is behind
shows."""
Shown = JointStatesShown | FrameTransforms | SceneUpdate | LaserScan | Log


class FoxgloveView:
    """Adds to a file what Foxglove draws of a message; implements ``recording_sink.Shows``.

    Args:
        ear: counts what can't be read; one of its own, which nobody asks, unless given.
    """

    def __init__(self, ear: Ear | None = None) -> None:
        self._ear = Ear() if ear is None else ear
        self._robot: RobotDescription | None = None
        self._last: dict[str, float] = {}
        self._incidents = Incidents()
        self._views: dict[str, tuple[str, float, Callable[[Recorded], Shown]]] = {
            JOINT_STATES.key: ("foxglove/joints", EVERY, _joints),
            ROBOT_POSE.key: ("foxglove/transforms", EVERY, self._transforms),
            SCENE.key: ("foxglove/scene", 0.0, self.scene),
        }

    def learn(self, attachment: Attachment) -> None:
        """Learn the robot's frames and lasers, once it has said who it is."""
        if attachment.name == DESCRIPTION.key:
            robot = self._ear.read(DESCRIPTION.key, DESCRIPTION.decode_answer, attachment.data)
            if robot is None:
                return
            self._robot = robot
            for laser in self._robot.lasers:
                key = f"hw/{laser.name}/laser"
                self._views[key] = (f"foxglove/{laser.name}", SCANS_EVERY, self._scan_of(laser.name))

    def __call__(self, file: McapFile, message: Recorded) -> None:
        """Write what is drawn of a message; one that can't be read is not drawn."""
        cause = self._incidents.hear(message)
        if cause is not None:
            log = Log(timestamp=_time(message), level=LogLevel.Error, message=cause.words, name=cause.kind)
            _put(file, "foxglove/log", log, message)
        view = self._views.get(message.key)
        if view is None:
            return
        topic, every, made = view
        if message.at - self._last.get(topic, -every) < every:
            return
        self._last[topic] = message.at
        try:
            shown = made(message)
        except Exception as error:  # noqa: BLE001 - whatever a stranger found: ours has it as it was
            self._ear.refuse(message.key, Reason.MALFORMED, f"{type(error).__name__}: {error}")
            return
        _put(file, topic, shown, message)

    def _transforms(self, message: Recorded) -> FrameTransforms:
        pose = to_pose(read_leniently(RobotPose, message.payload).base_in_map)
        frame = "base_footprint" if self._robot is None else self._robot.base_frame
        transform = FrameTransform(
            timestamp=_time(message),
            parent_frame_id=MAP,
            child_frame_id=frame,
            translation=_vector(pose.position),
            rotation=_quaternion(pose.orientation),
        )
        return FrameTransforms(transforms=[transform])

    def scene(self, message: Recorded) -> SceneUpdate:
        """Return what stands in the map, and what each hand holds, in its frame.

        An entity replaces the one of its name, so an empty hand is told, too.
        """
        said, when = read_leniently(PlanningScene, message.payload), _time(message)
        hands = () if self._robot is None else self._robot.end_effectors
        entities = [_entity(when, MAP, "scene", [each for each in said.objects if each.attached_to is None])]
        for hand in hands:
            held = [each for each in said.objects if each.attached_to == hand.side]
            entities.append(_entity(when, hand.frame, f"held/{hand.side}", held))
        return SceneUpdate(entities=entities)

    def _scan_of(self, name: str) -> Callable[[Recorded], Shown]:
        assert self._robot is not None
        sensor = next(each for each in self._robot.lasers if each.name == name)
        end = sensor.angle_min + sensor.angle_step * (sensor.beams - 1)

        def scan(message: Recorded) -> LaserScan:
            ranges = read_leniently(OurScan, message.payload).ranges
            return LaserScan(
                timestamp=_time(message),
                frame_id=sensor.frame,
                start_angle=sensor.angle_min,
                end_angle=end,
                ranges=list(ranges),
            )

        return scan


def put_picture(file: McapFile, key: str, camera: str, jpeg: bytes, when: Recorded) -> None:
    """Write a camera's picture; ``when``: a message with the time of it."""
    image = CompressedImage(timestamp=_time(when), frame_id=camera, data=jpeg, format="jpeg")
    schema = CompressedImage.get_schema()
    known = Schema(schema.name, schema.encoding, schema.data)
    file.show(f"foxglove/camera/{camera}", known, image.encode(), when, {OURS: "jpeg", "key": key})


def _put(file: McapFile, topic: str, shown: Shown, when: Recorded) -> None:
    schema = shown.get_schema()
    file.show(topic, Schema(schema.name, schema.encoding, schema.data), shown.encode(), when)


def _time(message: Recorded) -> Timestamp:
    seconds = 0.0 if message.stamp is None else max(0.0, message.stamp.seconds)
    return Timestamp(sec=int(seconds), nsec=round((seconds - int(seconds)) * 1e9))


def _joints(message: Recorded) -> JointStatesShown:
    said = read_leniently(JointStates, message.payload)
    rows = zip(said.names, said.positions, said.velocities, said.efforts, strict=True)
    joints = [
        JointState(name=name, position=position, velocity=velocity, effort=effort)
        for name, position, velocity, effort in rows
    ]
    return JointStatesShown(timestamp=_time(message), joints=joints)


def _entity(when: Timestamp, frame: str, name: str, objects: list[SceneObject]) -> SceneEntity:
    cubes: list[CubePrimitive] = []
    cylinders: list[CylinderPrimitive] = []
    for each in objects:
        pose, size = _pose(each.box.pose), _vector(each.box.size)
        colour = ORANGE if each.kind == "item" else GREY
        if is_round(solid(each.box)):
            cylinders.append(
                CylinderPrimitive(pose=pose, size=size, bottom_scale=1.0, top_scale=1.0, color=colour)
            )
        else:
            cubes.append(CubePrimitive(pose=pose, size=size, color=colour))
    locked = frame != MAP  # what is held moves with its hand
    return SceneEntity(
        timestamp=when, frame_id=frame, id=name, frame_locked=locked, cubes=cubes, cylinders=cylinders
    )


def _pose(pose: OurPose) -> Pose:
    return Pose(position=_vector(pose.position), orientation=_quaternion(pose.orientation))


def _vector(said: OurVector) -> Vector3:
    x, y, z = said
    return Vector3(x=x, y=y, z=z)


def _quaternion(said: OurQuaternion) -> Quaternion:
    x, y, z, w = said
    return Quaternion(x=x, y=y, z=z, w=w)
