"""The meshes of the worlds of a recorded run, as a page draws them; a world without their files is drawn as boxes."""

import gzip

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.show.meshes import made
from onika.store.mesh_folder import MeshFolder
from onika.store.site import Site

MOST_BYTES = 1_500_000
"""All meshes of a file together, packed; beyond it boxes stand for those that are left."""


def meshes(subject: ReviewedRun, site: Site, folder: MeshFolder | None) -> dict[str, bytes]:
    """By the names of their contents; none where there is no folder in which they are kept."""
    drawn: dict[str, bytes] = {}
    size = 0
    for world in subject.review.worlds if folder is not None else ():
        shapes = subject.review.shapes(world) or []
        names = dict.fromkeys(str(shape["mesh"]) for shape in shapes if shape.get("mesh"))
        for name in _made(folder, site, world, [*names]):
            packed = folder.packed(name) if folder is not None else None
            if packed is not None and size + len(packed) <= MOST_BYTES:
                size += len(packed)
                drawn[name] = gzip.decompress(packed)
    return drawn


def _made(folder: MeshFolder | None, site: Site, world: str, names: list[str]) -> list[str]:
    if folder is None or not names:
        return []
    return made(folder, site, world, names)
