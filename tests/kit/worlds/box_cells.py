"""The world of the box assembly, of the shipped files."""

from functools import cache

import numpy as np

from onika.laws.frames import Array
from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.wire.world_source import WorldSource
from onika.workcell.cell.file_world import FileWorld

LAYOUT_M = {"waves": (0.70, 0.0), "triangle": (0.70, 0.28), "square": (0.70, -0.28), "cross": (0.50, -0.18)}
"""Where the boxes stand at the start, x and y in the world, from the lowest of the stack to the highest."""

TOP_M = -0.36
"""Height of the table."""

SIZE_M = 0.0508
"""Height of a box."""


@cache
def boxes_files() -> WorldSource:
    """All files of the world `boxes`."""
    source, faults = gather_world("boxes", open_site((), {}, None))
    if source is None or faults:
        raise ValueError(f"expected the files of the world boxes, found {faults}")
    return source


def boxes_world(seed: int | None = None) -> FileWorld:
    """The world itself; of a seed, its boxes stand up to a millimetre elsewhere."""
    return FileWorld(boxes_files(), seed)


def base_of(side: str) -> Array:
    """Frame 0 of the arm at a side in the world, double[4,4]."""
    (sheet,) = [sheet for sheet in boxes_world().devices() if sheet.name == f"arm_{side}"]
    return np.reshape(sheet.identity["BASE"], (4, 4))
