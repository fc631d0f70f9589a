"""The meshes of a world that is files, made ready for whoever draws it (requirement X19).

A scene names the meshes of its shapes. A page asks for them here before it fetches them; what is not there yet a
program of its own makes of the files on the search path. Where these are not the files of the runtime's world, the
names differ, and the page goes on drawing boxes.
"""

import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from functools import partial

from msgspec import MsgspecError, msgpack

from onika.desk.environment.outcome.outcome import Done, No, Steps, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.store.mesh_folder import MeshFolder
from onika.store.site import Site
from onika.store.world_source import gather_world
from onika.wire import act

MAKER = (sys.executable, "-m", "onika.workcell.composed.drawn_meshes")
_PATIENCE_S = 120
_MOST = 2000
"""Meshes that are asked for at a time."""


def meshes(model: Model, command: act.Meshes, outside: Services) -> Steps[Done | No]:
    """Make those that are not there yet; the value is the names of those that are there now."""
    if outside.state is None or outside.meshing is None:
        return Done(model, value=[])
    make = partial(
        made, MeshFolder(outside.state), outside.site, command.world.rpartition("/")[2], command.meshes[:_MOST]
    )
    model, names = yield Work(model, outside.meshing, make)
    return Done(model, value=names)


def made(folder: MeshFolder, site: Site, world: str, names: Sequence[str]) -> list[str]:
    """Have the meshes of a world in the folder; gives those of `names` that are there."""
    lacking = folder.lacking(names)
    source, _ = gather_world(world, site) if lacking else (None, ())
    if source is not None:
        with suppress(OSError, MsgspecError, subprocess.TimeoutExpired):  # then boxes stand for them
            folder.keep(_drawn(msgpack.encode(source), lacking))
    return folder.there(names)


def _drawn(source: bytes, names: Sequence[str]) -> dict[str, bytes]:
    """What the program that knows physics makes of a world; raises OSError, MsgspecError or TimeoutExpired."""
    done = subprocess.run(  # noqa: S603 - our own program
        [*MAKER, *names], input=source, capture_output=True, timeout=_PATIENCE_S, check=False
    )
    return msgpack.decode(done.stdout, type=dict[str, bytes])
