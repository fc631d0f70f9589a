"""A chain of joints read from a Denavit-Hartenberg table, as places that MuJoCo understands."""

import math
from dataclasses import dataclass

import numpy as np

from onika.laws.frames import Array, dh_transform, quaternion_of_rotation

REVOLUTE, PRISMATIC = 0, 1

SLIDES = 2.0 * math.pi
"""Added to a row's theta offset it says that the joint slides; a full turn more changes no frame."""


@dataclass(frozen=True, slots=True)
class Link:
    """One body whose frame is DH frame i: its place in frame i - 1 at q = 0, and its joint within itself.

    `axis` and `anchor` are the z axis and the origin of frame i - 1, expressed in frame i.
    """

    slides: bool
    position: tuple[float, ...]
    quaternion: tuple[float, ...]
    axis: tuple[float, ...]
    anchor: tuple[float, ...]


def kinds_of(dh: Array) -> Array:
    """What the rows say of their joints: double[n], 0 revolute, 1 prismatic where theta is a full turn or more."""
    return (dh[:, 3] >= SLIDES - 1e-9).astype(np.float64)


def links(dh: Array, kind: Array) -> tuple[Link, ...]:
    """The links of a table of rows (a m, alpha rad, d m, theta offset rad); `kind` 0 revolute, 1 prismatic."""
    return tuple(_link(row, bool(slides)) for row, slides in zip(dh, kind, strict=True))


def chain_pose(dh: Array, kind: Array, q: Array) -> Array:
    """Pose of the last DH frame in frame 0, by the product of the transforms (slow, plain; q in rad or m)."""
    pose = np.eye(4)
    for (a, alpha, d, theta), slides, value in zip(dh, kind, q, strict=True):
        pose = pose @ dh_transform(a, alpha, d + value * slides, theta + value * (1 - slides))
    return pose


def text_of(numbers: Array | tuple[float, ...]) -> str:
    """Numbers as MJCF writes them: with blanks, every digit kept."""
    return " ".join(repr(float(number)) for number in numbers)


def _link(row: Array, slides: bool) -> Link:
    pose = dh_transform(*(float(number) for number in row))
    turn = pose[:3, :3]
    return Link(
        slides,
        tuple(pose[:3, 3].tolist()),
        tuple(quaternion_of_rotation(turn).tolist()),
        tuple(turn[2].tolist()),
        tuple((-turn.T @ pose[:3, 3]).tolist()),
    )
