"""Where a device stands in no world, the worlds that there are: those of a runtime, and those that are files."""

from collections.abc import Iterable
from dataclasses import replace

from onika.files import world as world_file
from onika.store.site import Site
from onika.store.world_source import WORLD_FOLDER
from onika.words.fault import Fault
from onika.words.reason import Reason

_KEYS = ("host.no_world_of_device", "host.no_such_world")


def with_worlds(faults: Iterable[Fault], site: Site) -> list[Fault]:
    """The same faults; those of a world that is not there name the worlds of the search path too (law 16).

    A runtime knows of files those alone that a plan brings along.
    """
    return [_named(fault, site) if fault.reason.key in _KEYS else fault for fault in faults]


def _named(fault: Fault, site: Site) -> Fault:
    offered = fault.reason.args.get("worlds")
    names = {str(name) for name in offered} if isinstance(offered, tuple | list) else set()
    names.update(file_worlds(site))
    if not names:
        return fault
    return replace(fault, reason=Reason.of(fault.reason.key, **{**fault.reason.args, "worlds": tuple(sorted(names))}))


def file_worlds(site: Site) -> tuple[str, ...]:
    """The names of the worlds that are files, of every base directory of the search path."""
    folders = (base.path / WORLD_FOLDER for base in site.directories)
    return tuple(sorted({path.stem for folder in folders for path in folder.glob(f"*{world_file.ENDING}")}))
