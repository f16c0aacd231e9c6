"""The arithmetic of poses in plain Python: the trees and the executive load no numpy.

The messages and what their names say are in ``skills/ports/pose.py``.
"""

from __future__ import annotations

import math

from tandem.skills.ports.message import Quaternion, Vector3
from tandem.skills.ports.pose import FloorPose, Pose


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the Hamilton product a b (first b, then a)."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """Return the inverse rotation."""
    return (-q[0], -q[1], -q[2], q[3])


def rotate(q: Quaternion, v: Vector3) -> Vector3:
    """Return v turned by q."""
    x, y, z, w = q
    vx, vy, vz = v
    tx, ty, tz = 2 * (y * vz - z * vy), 2 * (z * vx - x * vz), 2 * (x * vy - y * vx)
    return (
        vx + w * tx + y * tz - z * ty,
        vy + w * ty + z * tx - x * tz,
        vz + w * tz + x * ty - y * tx,
    )


def compose(a_in_b: Pose, point_in_a: Pose) -> Pose:
    """Return the pose in b of what is known in a (T_ba T_a)."""
    moved = add(a_in_b.position, rotate(a_in_b.orientation, point_in_a.position))
    return Pose(position=moved, orientation=multiply(a_in_b.orientation, point_in_a.orientation))


def invert(a_in_b: Pose) -> Pose:
    """Return b in a."""
    back = conjugate(a_in_b.orientation)
    return Pose(position=rotate(back, scale(a_in_b.position, -1.0)), orientation=back)


def transform(a_in_b: Pose, point_in_a: Vector3) -> Vector3:
    """Return the point in b."""
    return add(a_in_b.position, rotate(a_in_b.orientation, point_in_a))


def add(a: Vector3, b: Vector3) -> Vector3:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vector3, b: Vector3) -> Vector3:
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vector3, factor: float) -> Vector3:
    """Return a times the factor."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def length(a: Vector3) -> float:
    """Return the Euclidean norm."""
    return math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])


def distance(a: Pose, b: Pose) -> float:
    """Return the metres between two origins."""
    return length(subtract(a.position, b.position))


def angle_between(a: Quaternion, b: Quaternion) -> float:
    """Return the angle in radians of the rotation from a to b, in [0, pi]."""
    x, y, z, w = multiply(conjugate(a), b)
    return 2.0 * math.atan2(math.sqrt(x * x + y * y + z * z), abs(w))


def about(axis: Vector3, angle: float) -> Quaternion:
    """Return the rotation by ``angle`` radians about an axis of any length above zero."""
    size = length(axis)
    if size == 0.0:
        raise ValueError("an axis of rotation has a length above zero")
    s = math.sin(angle / 2.0) / size
    return (axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2.0))


def from_rpy(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the rotation R_z(yaw) R_y(pitch) R_x(roll)."""
    z, y, x = about((0, 0, 1), yaw), about((0, 1, 0), pitch), about((1, 0, 0), roll)
    return multiply(multiply(z, y), x)


def from_axes(x: Vector3, y: Vector3, z: Vector3) -> Quaternion:
    """Return the rotation whose columns are the given orthonormal axes (Shepperd 1978)."""
    trace = x[0] + y[1] + z[2]
    if trace > 0.0:
        s = 2.0 * math.sqrt(trace + 1.0)
        q = ((y[2] - z[1]) / s, (z[0] - x[2]) / s, (x[1] - y[0]) / s, s / 4.0)
    elif x[0] >= y[1] and x[0] >= z[2]:
        s = 2.0 * math.sqrt(1.0 + x[0] - y[1] - z[2])
        q = (s / 4.0, (y[0] + x[1]) / s, (z[0] + x[2]) / s, (y[2] - z[1]) / s)
    elif y[1] >= z[2]:
        s = 2.0 * math.sqrt(1.0 + y[1] - x[0] - z[2])
        q = ((y[0] + x[1]) / s, s / 4.0, (z[1] + y[2]) / s, (z[0] - x[2]) / s)
    else:
        s = 2.0 * math.sqrt(1.0 + z[2] - x[0] - y[1])
        q = ((z[0] + x[2]) / s, (z[1] + y[2]) / s, s / 4.0, (x[1] - y[0]) / s)
    return q


def turned(pose: Pose, point: Vector3, angle: float) -> Pose:
    """Return the pose turned by ``angle`` (rad) about the vertical through a point of the same frame."""
    turn = about((0.0, 0.0, 1.0), angle)
    return Pose(
        position=add(point, rotate(turn, subtract(pose.position, point))),
        orientation=multiply(turn, pose.orientation),
    )


def yaw_of(q: Quaternion) -> float:
    """Return the heading in radians: the direction of the turned x axis in the xy plane."""
    forward = rotate(q, (1.0, 0.0, 0.0))
    return math.atan2(forward[1], forward[0])


def wrap(angle: float) -> float:
    """Return the same angle in (-pi, pi]."""
    wrapped = math.remainder(angle, 2.0 * math.pi)
    return math.pi if wrapped == -math.pi else wrapped


def to_pose(floor: FloorPose) -> Pose:
    """Return the floor pose as a pose with z = 0."""
    return Pose(position=(floor.x, floor.y, 0.0), orientation=about((0, 0, 1), floor.yaw))


def to_floor(pose: Pose) -> FloorPose:
    """Return x, y and heading of a pose."""
    return FloorPose(x=pose.position[0], y=pose.position[1], yaw=yaw_of(pose.orientation))


def floor_distance(a: FloorPose, b: FloorPose) -> float:
    """Return the metres between two floor poses."""
    return math.hypot(a.x - b.x, a.y - b.y)
