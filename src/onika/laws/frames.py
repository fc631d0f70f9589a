"""Frames: poses as 4x4 matrices, the nine numbers of a Cartesian target, rotations as vectors and angles.

A pose is `double[4,4]`: columns normal n, orientation o, approach a, position p in metres (Fu, Gonzalez & Lee,
Robotics, §2.2.10). A Cartesian target is `double[9]` in the order (a, n, p), o = a × n.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from onika.laws.sentence import LawSentence

Array = npt.NDArray[np.float64]
"""Any array of doubles."""

Numbers = Sequence[float] | npt.NDArray[np.float64]
"""A row of doubles as modules hold it: array, list or tuple."""

Rows = Sequence[Sequence[float]]
"""A matrix as plain numbers, row by row."""

_UNTURNED = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

SQUARE_TOLERANCE = 0.1
"""How far lengths may be from 1, and a · n from 0, before nine numbers are no orientation."""


def dh_transform(a: float, alpha: float, d: float, theta: float) -> Array:
    """Pose of frame i in frame i - 1 (standard Denavit-Hartenberg; Fu, Gonzalez & Lee, Eq. 2.2-29); m, rad."""
    ct, st, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return np.array(
        [[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [0.0, sa, ca, d], [0.0, 0.0, 0.0, 1.0]]
    )


def pose_of_nine(nine: Numbers, out: Array | None = None) -> Array:
    """The pose of nine numbers (a, n, p), made exactly orthogonal: a keeps its direction, n gives way.

    Raises ValueError where a or n is no unit vector, or they are not square to each other, within SQUARE_TOLERANCE.
    """
    ax, ay, az, nx, ny, nz, px, py, pz = nine.tolist() if isinstance(nine, np.ndarray) else nine
    length = _unit_length(ax, ay, az, "approach")
    ax, ay, az = ax / length, ay / length, az / length
    _unit_length(nx, ny, nz, "normal")
    along = ax * nx + ay * ny + az * nz
    if not abs(along) <= SQUARE_TOLERANCE:
        raise ValueError(
            LawSentence(
                "laws.pose_askew",
                "expected approach and normal square to each other, found a · n = {along:.3g}",
                along=float(along),
            )
        )
    nx, ny, nz = nx - along * ax, ny - along * ay, nz - along * az
    length = math.sqrt(nx * nx + ny * ny + nz * nz)
    nx, ny, nz = nx / length, ny / length, nz / length
    pose = np.empty((4, 4)) if out is None else out
    pose[0] = nx, ay * nz - az * ny, ax, px
    pose[1] = ny, az * nx - ax * nz, ay, py
    pose[2] = nz, ax * ny - ay * nx, az, pz
    pose[3] = 0.0, 0.0, 0.0, 1.0
    return pose


def nine_of_pose(pose: Array, out: Array | None = None) -> Array:
    """The nine numbers (a, n, p) of a pose."""
    nine = np.empty(9) if out is None else out
    nine[0:3] = pose[:3, 2]
    nine[3:6] = pose[:3, 0]
    nine[6:9] = pose[:3, 3]
    return nine


def inverse_pose(pose: Array) -> Array:
    """The pose of the old frame in the new one: rotation transposed, position turned back."""
    inverse = np.eye(4)
    inverse[:3, :3] = pose[:3, :3].T
    inverse[:3, 3] = -pose[:3, :3].T @ pose[:3, 3]
    return inverse


def rotation_log(rotation: Array) -> Array:
    """Axis times angle (rad, angle 0..pi) of a rotation matrix; at pi either sign of the axis is right."""
    return np.array(turn_between(_UNTURNED, rotation.tolist()))


def turn_between(first: Rows, second: Rows) -> tuple[float, float, float]:
    """Axis times angle (rad) of the turn from one rotation to another, rows of plain numbers, in the first one's frame.

    As the logarithm of first^T second, without an array: the first use of one in a while takes longer than all of this.
    """
    columns = tuple(zip(*first, strict=True))
    across = tuple(zip(*second, strict=True))
    relative = [[a * d + b * e + c * f for d, e, f in across] for a, b, c in columns]
    w, x, y, z = _quaternion(relative)
    if w < 0.0:
        w, x, y, z = -w, -x, -y, -z
    length = math.sqrt(x * x + y * y + z * z)
    scale = 2.0 if length < 1e-12 else 2.0 * math.atan2(length, w) / length
    return x * scale, y * scale, z * scale


def rotation_exp(vector: Numbers) -> Array:
    """The rotation matrix about `vector` by its length in rad (Rodrigues' formula)."""
    x, y, z = (float(part) for part in vector)
    angle = math.sqrt(x * x + y * y + z * z)
    if angle > 0.0:
        return rotation_about(x / angle, y / angle, z / angle, angle)
    return np.eye(3)


def rotation_about(x: float, y: float, z: float, angle: float) -> Array:
    """The rotation matrix about the unit axis (x, y, z) by `angle` rad."""
    c, s = math.cos(angle), math.sin(angle)
    t = 1.0 - c
    return np.array(
        [
            [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
        ]
    )


def quaternion_of_rotation(rotation: Array) -> Array:
    """Unit quaternion (w, x, y, z) of a rotation matrix, by the largest of its four parts (Shepperd 1978)."""
    return np.array(_quaternion(rotation.tolist()))


def rotation_of_quaternion(quaternion: Numbers) -> Array:
    """The rotation of a unit quaternion (w, x, y, z)."""
    w, x, y, z = (float(number) for number in quaternion)
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


def _quaternion(rotation: Rows) -> tuple[float, float, float, float]:
    (r00, r01, r02), (r10, r11, r12), (r20, r21, r22) = rotation
    parts = (r00 + r11 + r22, r00, r11, r22)
    largest = parts.index(max(parts))
    if largest == 0:
        w, x, y, z = 1.0 + parts[0], r21 - r12, r02 - r20, r10 - r01
    elif largest == 1:
        w, x, y, z = r21 - r12, 1.0 + r00 - r11 - r22, r01 + r10, r02 + r20
    elif largest == 2:
        w, x, y, z = r02 - r20, r01 + r10, 1.0 + r11 - r00 - r22, r12 + r21
    else:
        w, x, y, z = r10 - r01, r02 + r20, r12 + r21, 1.0 + r22 - r00 - r11
    length = math.sqrt(w * w + x * x + y * y + z * z)
    return w / length, x / length, y / length, z / length


def rotation_of_rpy(roll: float, pitch: float, yaw: float) -> Array:
    """Rz(yaw) Ry(pitch) Rx(roll), angles in rad about the fixed axes."""
    cr, sr, cp, sp, cy, sy = (
        *(math.cos(roll), math.sin(roll)),
        *(math.cos(pitch), math.sin(pitch)),
        *(math.cos(yaw), math.sin(yaw)),
    )
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def rpy_of_rotation(rotation: Array) -> tuple[float, float, float]:
    """Roll, pitch, yaw in rad, pitch within ±pi/2; looking straight up or down, yaw is 0."""
    flat = math.hypot(float(rotation[0, 0]), float(rotation[1, 0]))
    pitch = math.atan2(-float(rotation[2, 0]), flat)
    if flat < 1e-9:
        return math.atan2(-float(rotation[1, 2]), float(rotation[1, 1])), pitch, 0.0
    roll = math.atan2(float(rotation[2, 1]), float(rotation[2, 2]))
    return roll, pitch, math.atan2(float(rotation[1, 0]), float(rotation[0, 0]))


def _unit_length(x: float, y: float, z: float, what: str) -> float:
    length = math.sqrt(x * x + y * y + z * z)
    if not abs(length - 1.0) <= SQUARE_TOLERANCE:
        raise ValueError(
            LawSentence(
                "laws.vector_long",
                "expected {what} as a vector of length 1, found length {length:.3g}",
                what=what,
                length=length,
            )
        )
    return length


def as_array(numbers: Any, shape: tuple[int, ...]) -> Array:
    """Constants as a contiguous array of doubles of that shape; raises ValueError that names both shapes."""
    array = np.array(numbers, dtype=np.float64)
    if array.size != math.prod(shape):
        raise ValueError(
            LawSentence(
                "laws.shape_unlike",
                "expected {shape} numbers, found {found}",
                shape=str(shape),
                found=str(array.shape),
            )
        )
    return array.reshape(shape)
