"""The mesh of a shape on its way to a page: named by what it consists of, with few triangles, as bytes (X19).

A page draws few triangles faster than a person sees the difference, and loads them sooner.
"""

from hashlib import sha256

import numpy as np
import numpy.typing as npt

MOST_TRIANGLES = 1500
"""Triangles of a mesh that is drawn; a few more where it could not be told what it is."""

Vertices = npt.NDArray[np.float64]
"""Corners, double[n,3] in metres."""

Triangles = npt.NDArray[np.int64]
"""Numbers of the corners of each triangle, int[m,3]."""

Weights = npt.NDArray[np.float64]
"""A number for each corner, or for each triangle."""

_FORMAT = b"onika mesh 1"
_NAME_SIGNS = 32
_FINEST, _COARSEST = 400.0, 8.0  # parts of the longest side that a cell is wide at least, and at last
_BEGIN = 0.5  # so much of the width at which plain surfaces would have as many triangles as may be left
_COARSER = 1.12
_LEAST_AREA = 1e-15  # of a corner without triangles (m2)
_LARGEST = 65535  # of sixteen bits
_SIDE_BITS = 20  # a cell's number on each axis has fewer bits


def mesh_name(vertices: npt.NDArray[np.float32], triangles: npt.NDArray[np.int32]) -> str:
    """What names a mesh: the digest of its corners and triangles as they are, and of how they are made bytes."""
    digest = sha256(_FORMAT)
    for part in (vertices, triangles):
        digest.update(len(part).to_bytes(8, "little"))
        digest.update(np.ascontiguousarray(part).tobytes())
    return digest.hexdigest()[:_NAME_SIGNS]


def thinned(vertices: Vertices, triangles: Triangles, most: int = MOST_TRIANGLES) -> tuple[Vertices, Triangles]:
    """Fewer triangles: corners within a cell become one, in cells that grow until at most `most` are left.

    It is their mean, weighted with the triangles' areas: large surfaces stay plain where fine details stand on them.
    """
    widest = float(np.ptp(vertices, axis=0).max()) if len(vertices) else 0.0
    if len(triangles) <= most or not widest:
        return vertices, triangles
    areas = _areas(vertices, triangles)
    weights: Weights = np.bincount(triangles.ravel(), np.repeat(areas, 3), len(vertices)).astype(float) + _LEAST_AREA
    cell = max(widest / _FINEST, _BEGIN * float(np.sqrt(2.0 * areas.sum() / most)))
    while True:
        merged, left = _merged(vertices, triangles, weights, cell)
        if len(left) <= most or cell > widest / _COARSEST:
            return merged, left
        cell *= _COARSER


def encoded(
    vertices: Vertices, triangles: Triangles, middle: npt.NDArray[np.float64], half: npt.NDArray[np.float64]
) -> bytes:
    """The counts of corners and triangles as uint32, the corners as uint16[n,3], the triangles as uint16[m,3].

    A corner is told within the box of `middle` and `half` sizes: 0 is its lowest end and 65535 its highest. All numbers
    are little-endian. Raises ValueError where there are more corners than sixteen bits can count.
    """
    if len(vertices) > _LARGEST:
        raise ValueError(f"expected at most {_LARGEST} corners, found {len(vertices)}")
    share = (vertices - middle) / np.where(half > 0.0, 2.0 * half, 1.0) + 0.5
    corners = np.rint(np.clip(share, 0.0, 1.0) * _LARGEST).astype("<u2")
    counts = np.array([len(vertices), len(triangles)], dtype="<u4")
    return counts.tobytes() + corners.tobytes() + triangles.astype("<u2").tobytes()


def _areas(vertices: Vertices, triangles: Triangles) -> Weights:
    first, second, third = (vertices[triangles[:, corner]] for corner in range(3))
    areas: Weights = np.linalg.norm(np.cross(second - first, third - first), axis=1) / 2.0
    return areas


def _merged(vertices: Vertices, triangles: Triangles, weights: Weights, cell: float) -> tuple[Vertices, Triangles]:
    """The corners of each cell as their mean, and the triangles that still have three corners, each once."""
    cells = np.rint((vertices - vertices.min(axis=0)) / cell).astype(np.int64)
    keys = (cells[:, 0] << 2 * _SIDE_BITS) | (cells[:, 1] << _SIDE_BITS) | cells[:, 2]
    _, place = np.unique(keys, return_inverse=True)
    place = place.ravel()
    whole = np.bincount(place, weights)
    means = np.stack([np.bincount(place, weights * vertices[:, axis]) / whole for axis in range(3)], axis=1)
    left = place[triangles]
    is_whole = (left[:, 0] != left[:, 1]) & (left[:, 1] != left[:, 2]) & (left[:, 2] != left[:, 0])
    left = left[is_whole]
    _, firsts = np.unique(np.sort(left, axis=1), axis=0, return_index=True)
    return means, left[np.sort(firsts)]
