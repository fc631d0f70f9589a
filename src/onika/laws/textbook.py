"""Arms as textbooks print them, Denavit-Hartenberg tables and masses in their frames, as screws and links of frame 0.

A row of DH is a m, alpha rad, d m, theta offset rad (standard convention; a full turn more: the joint slides). A row of
DYN is mass kg, centre x y z m in frame i, principal inertia about it kg m2, armature kg m2, viscous friction N m s/rad.
"""

import numpy as np

from onika.laws.arm import ArmModel
from onika.laws.chain import kinds_of
from onika.laws.frames import Array, Numbers, as_array, dh_transform
from onika.laws.screws import sliding, turning

_DUST = 1e-15  # what is left of the cosine of a right angle


def frames_at_rest(dh: Numbers) -> list[Array]:
    """Poses double[4,4] of the frames 0 to n of a table in frame 0 at q = 0."""
    poses = [np.eye(4)]
    for row in as_array(dh, (np.size(dh) // 4, 4)):
        pose = poses[-1] @ dh_transform(*row.tolist())
        poses.append(np.where(np.abs(pose) < _DUST, 0.0, pose))
    return poses


def screws_of(dh: Numbers, kind: Numbers | None = None) -> Array:
    """SCREW double[n,6] of a table; `kind` double[n] is 1 where a joint slides, left out it is read from the table."""
    table = as_array(dh, (np.size(dh) // 4, 4))
    kinds = as_array(kinds_of(table) if kind is None else kind, (len(table),))
    rows = [
        sliding(pose[:3, 2]) if slide else turning(pose[:3, 2], pose[:3, 3])
        for pose, slide in zip(frames_at_rest(table), kinds, strict=False)
    ]
    return np.array(rows)


def links_of(dh: Numbers, dyn: Numbers) -> Array:
    """LINK double[n,13] of a table and the masses in its frames; without dry friction."""
    frames = frames_at_rest(dh)[1:]
    return np.array([_link(pose, row) for pose, row in zip(frames, as_array(dyn, (len(frames), 9)), strict=True)])


def load_of(dh: Numbers, load: Numbers) -> Array:
    """LOAD double[4]: mass and centre, from the last frame of a table to frame 0."""
    mass, *centre = as_array(load, (4,)).tolist()
    return np.array([mass, *(frames_at_rest(dh)[-1] @ [*centre, 1.0])[:3]])


def tool_of(dh: Numbers, tool: Numbers) -> Array:
    """TOOL double[4,4], from the last frame of a table to frame 0."""
    return frames_at_rest(dh)[-1] @ as_array(tool, (4, 4))


def serial_arm(
    dh: Numbers,
    dyn: Numbers | None = None,
    load: Numbers | None = None,
    base: Numbers | None = None,
    tool: Numbers | None = None,
    kind: Numbers | None = None,
) -> ArmModel:
    """The arm of a table: masses in its frames, `load` and `tool` in its last one, `base` frame 0 in the world."""
    return ArmModel(
        screws_of(dh, kind),
        None if dyn is None else links_of(dh, dyn),
        None,
        None if load is None else load_of(dh, load),
        base,
        tool_of(dh, np.eye(4) if tool is None else tool),
    )


def _link(pose: Array, row: Array) -> Array:
    """One row of LINK: a body's mass and inertia, turned from its frame to frame 0."""
    turn = pose[:3, :3]
    inertia = turn @ np.diag(row[4:7]) @ turn.T
    moments = (inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[0, 2], inertia[1, 2])
    centre = pose @ [*row[1:4], 1.0]
    return np.array([row[0], *centre[:3], *moments, row[7], row[8], 0.0])
