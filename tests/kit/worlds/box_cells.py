"""The world of the box assembly, of the shipped files."""

from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.wire.world_source import WorldSource
from onika.workcell.cell.file_world import FileWorld


def boxes_files() -> WorldSource:
    """All files of the world `boxes`."""
    source, faults = gather_world("boxes", open_site((), {}, None))
    if source is None or faults:
        raise ValueError(f"expected the files of the world boxes, found {faults}")
    return source


def boxes_world(seed: int | None = None) -> FileWorld:
    """The world itself; of a seed, its boxes stand up to a millimetre elsewhere."""
    return FileWorld(boxes_files(), seed)
