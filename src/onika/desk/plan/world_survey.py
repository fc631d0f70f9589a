"""Which worlds and robots that are files a check looks at, and what is wrong before they are compiled (X19)."""

from collections.abc import Sequence
from pathlib import Path

from onika.files import robot, world
from onika.store.site import Site
from onika.store.world_source import gather_robot, gather_world
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault


def world_sources(files: Sequence[Path], site: Site) -> tuple[tuple[WorldSource, ...], list[Fault]]:
    """The worlds among some files, and each robot among them that stands in none of these, in a world of its own.

    Of a text that cannot be read nothing is said here.
    """
    sources: list[WorldSource] = []
    faults: list[Fault] = []
    for file in (file for file in files if file.suffix == world.ENDING):
        source, found = gather_world(file.stem, site.at(file.absolute().parent.parent))
        sources += [source] if source is not None else []
        faults += found
    standing = {read.name for source in sources for read in source.files}
    for file in (file for file in files if file.suffix == robot.ENDING):
        if f"robot/{file.name}" in standing:
            continue
        source, found = gather_robot(file.stem, site.at(file.absolute().parent.parent))
        sources += [source] if source is not None else []
        faults += found
    return tuple(sources), faults
