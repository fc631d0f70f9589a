"""The textbook's table of an arm that is given by screws, where a closed form of inverse kinematics knows the arm."""

import math
from dataclasses import dataclass

import numpy as np

from onika.laws.frames import Array

EXACT = 1e-9
"""How far axes may be from meeting (m), and from parallel or square (rad), for a closed form to count as exact."""


@dataclass(frozen=True, slots=True)
class FamilyTable:
    """A Denavit-Hartenberg table double[n,4] with its first and last frame, at q = 0 in the frame 0 of the screws."""

    dh: Array
    first: Array
    last: Array


def frame(x: Array, z: Array, place: Array) -> Array:
    """The pose double[4,4] with these axes x and z at a place."""
    pose = np.eye(4)
    pose[:3, 0], pose[:3, 1], pose[:3, 2], pose[:3, 3] = x, np.cross(z, x), z, place
    return pose


def turn_about(z: Array, before: Array, after: Array) -> float:
    """The angle in rad from one direction to another about the axis z to which both are square."""
    return math.atan2(float(np.cross(before, after) @ z), float(before @ after))


def across(z: Array, way: Array) -> Array:
    """The part of a way that is square to the unit axis z."""
    part: Array = way - (way @ z) * z
    return part
