"""Meshes of a world as a page draws them: `python -m onika.workcell.composed.drawn_meshes NAME ... < files > meshes`.

The input is a `WorldSource`, the output their bytes by name, both in msgpack; names that no robot of the world has are
lacking. It is a program of its own, so that this work takes no time of anything that moves. Exit 0: there is an answer.
"""

import sys
from collections.abc import Iterator, Set

import mujoco
import numpy as np
from msgspec import msgpack

from onika.laws.mesh import encoded, mesh_name, thinned
from onika.wire.world_source import WorldSource
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.scene import mesh_of


def main(words: list[str]) -> int:
    """Read the files, write the meshes; gives the exit code."""
    mujoco.set_mju_user_warning(lambda _text: None)
    files = msgpack.decode(sys.stdin.buffer.read(), type=WorldSource)
    sys.stdout.buffer.write(msgpack.encode(drawn_meshes(files, frozenset(words))))
    return 0


def drawn_meshes(files: WorldSource, names: Set[str]) -> dict[str, bytes]:
    """Those of these meshes that the world has, whichever robots stand at its places; see `mesh.encoded`."""
    made: dict[str, bytes] = {}
    for model in _models(files):
        for number in range(model.nmesh):
            corners, triangles = mesh_of(model, number)
            name = mesh_name(corners, triangles)
            if name in names and name not in made:
                made[name] = _bytes(corners, triangles)
        if len(made) == len(names):
            break
    return made


def _models(files: WorldSource) -> Iterator[mujoco.MjModel]:
    """The world as it is drawn, as often as it takes until each robot has stood at a place of its own."""
    try:
        composition = Composition(SourceTexts(files))
    except ValueError:
        return  # whoever opens it is told why
    robots = {place.name: composition.at(place) for place in composition.places}
    for turn in range(max((len(there) for there in robots.values()), default=1)):
        standing = {place: there[min(turn, len(there) - 1)] for place, there in robots.items()}
        try:
            yield composition.compile(standing, {}, is_drawn=True)
        except ValueError:
            continue


def _bytes(corners: "np.ndarray[tuple[int, ...], np.dtype[np.float32]]", triangles: object) -> bytes:
    """One mesh, thinned, within the box around it."""
    whole = corners.astype(float)
    lowest, highest = whole.min(axis=0), whole.max(axis=0)
    return encoded(
        *thinned(whole, np.asarray(triangles, dtype=np.int64)), (lowest + highest) / 2, (highest - lowest) / 2
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
