"""Joints as screws: where each joint of a chain or tree turns or slides, at q = 0 in frame 0.

A row of SCREW is (w, v): of a joint that turns the unit axis w and its moment v = p x w about the origin, p any place
on the axis; of one that slides w = 0 and the unit direction v (Lynch & Park, Modern Robotics, §3.3.2, §4.1). PARENT
names for each joint the one that bears it, -1 for the base. No joint has a pitch.
"""

import numpy as np
import numpy.typing as npt

from onika.laws.frames import Array, Numbers, as_array
from onika.laws.sentence import LawSentence

Parents = npt.NDArray[np.int64]
"""For each joint the number of the one that bears it, -1: the base."""

_UNIT = 1e-6  # how far a length may be from 1, and a moment from square to its axis


def turning(axis: Numbers, place: Numbers) -> Array:
    """The screw double[6] of a joint that turns about a unit axis through a place (m)."""
    return np.concatenate((np.asarray(axis, dtype=np.float64), np.cross(place, axis)))


def sliding(direction: Numbers) -> Array:
    """The screw double[6] of a joint that slides along a unit vector."""
    return np.concatenate((np.zeros(3), np.asarray(direction, dtype=np.float64)))


def slides(screw: Array) -> npt.NDArray[np.bool_]:
    """Which joints of double[n,6] slide."""
    return np.array([not row.any() for row in screw[:, :3]])


def places(screw: Array) -> Array:
    """A place double[n,3] (m) on each axis: the one nearest to the place of the joint before it, at first to frame 0.

    A direction in which a joint slides has no place of its own: it gets that of the joint before it.
    """
    here = np.zeros(3)
    result = np.empty((len(screw), 3))
    for k, (w, v) in enumerate(zip(screw[:, :3], screw[:, 3:], strict=True)):
        if w.any():
            on_axis = np.cross(w, v)
            here = on_axis + w * (w @ (here - on_axis))
        result[k] = here
    return result


def parents_of_chain(n: int) -> Parents:
    """PARENT of a chain of n joints, each borne by the one before it."""
    return np.arange(-1, n - 1)


def screws(numbers: Numbers) -> Array:
    """SCREW as double[n,6]; raises ValueError where a row is no screw without a pitch."""
    rows = as_array(numbers, (np.size(numbers) // 6, 6))
    for k, (row, slide) in enumerate(zip(rows, slides(rows), strict=True), 1):
        w, v = row[:3], row[3:]
        length = float(np.linalg.norm(v if slide else w))
        pitch = 0.0 if slide else float(w @ v)
        if not (abs(length - 1.0) <= _UNIT and abs(pitch) <= _UNIT):
            raise ValueError(
                LawSentence(
                    "laws.screw_unfit",
                    "expected joint {joint} as an axis of length 1 and a moment square to it, "
                    "found length {length:.6g} and pitch {pitch:.3g}",
                    joint=k,
                    length=length,
                    pitch=pitch,
                )
            )
    return rows


def parents(numbers: Numbers | Parents | None, n: int) -> Parents:
    """PARENT as int[n]; left out, that of a chain. Raises ValueError where a joint is not borne by one before it."""
    if numbers is None:
        return parents_of_chain(n)
    row = as_array(numbers, (n,)).astype(np.int64)
    for k, before in enumerate(row.tolist()):
        if not -1 <= before < k:
            raise ValueError(
                LawSentence(
                    "laws.parent_unfit",
                    "expected joint {joint} to be borne by a joint before it, or -1, found {found}",
                    joint=k + 1,
                    found=before,
                )
            )
    return row
