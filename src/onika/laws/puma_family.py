"""Whether six screws are those of the PUMA family, and the table that its closed form of the inverse reads.

Axes 1 and 2 meet at a right angle, 3 is parallel to 2, 4 square to 3, and 4, 5, 6 meet at right angles in the wrist;
axis 4 points from the elbow to the wrist.
"""

import math

import numpy as np

from onika.laws.family_table import EXACT, FamilyTable, across, frame, turn_about
from onika.laws.frames import Array
from onika.laws.screws import places, slides

_QUARTER = math.pi / 2


def puma_table(screw: Array) -> FamilyTable | None:
    """The table behind SCREW double[6,6]; None where it is of another family."""
    if screw.shape != (6, 6) or slides(screw).any() or not _is_bent_so(screw[:, :3]):
        return None
    z, p = screw[:, :3], places(screw)
    shoulder = p[0] + (z[0] @ (p[1] - p[0])) * z[0]
    upper = across(z[1], p[2] - shoulder)
    a2 = float(np.linalg.norm(upper))
    if a2 <= EXACT:
        return None
    x1, x2, x3, x4, x5 = (
        np.cross(z[1], z[0]),
        upper / a2,
        np.cross(z[2], z[3]),
        np.cross(z[4], z[3]),
        np.cross(z[4], z[5]),
    )
    from_elbow = p[3] - (shoulder + upper)
    d3, a3 = float(from_elbow @ z[2]), float(from_elbow @ x3)
    elbow = shoulder + upper + d3 * z[2] + a3 * x3
    d4 = float((p[4] - elbow) @ z[3])
    wrist = elbow + d4 * z[3]
    if d4 <= EXACT or not _meet(screw, z, shoulder, wrist):
        return None
    offsets = (turn_about(z[1], x1, x2), turn_about(z[2], x2, x3), turn_about(z[3], x3, x4), turn_about(z[4], x4, x5))
    dh = np.array(
        [
            [0.0, -_QUARTER, 0.0, 0.0],
            [a2, 0.0, 0.0, offsets[0]],
            [a3, _QUARTER, d3, offsets[1]],
            [0.0, -_QUARTER, d4, offsets[2]],
            [0.0, _QUARTER, 0.0, offsets[3]],
            [0.0, 0.0, 0.0, 0.0],
        ]
    )
    return FamilyTable(dh, frame(x1, z[0], shoulder), frame(x5, z[5], wrist))


def _is_bent_so(z: Array) -> bool:
    """Whether the axes point as those of the family."""
    square = (z[0] @ z[1], z[2] @ z[3], z[3] @ z[4], z[4] @ z[5])
    apart = float(np.linalg.norm(z[1] - z[2]))
    return max(map(abs, square)) <= EXACT and apart <= EXACT


def _meet(screw: Array, z: Array, shoulder: Array, wrist: Array) -> bool:
    """Whether axes 1 and 2 meet in the shoulder, 4, 5 and 6 in the wrist."""
    gaps = [_gap(screw[k], z[k], place) for k, place in ((1, shoulder), (3, wrist), (4, wrist), (5, wrist))]
    return max(gaps) <= EXACT


def _gap(row: Array, axis: Array, place: Array) -> float:
    """How far a place is from an axis."""
    return float(np.linalg.norm(across(axis, place - np.cross(axis, row[3:]))))
