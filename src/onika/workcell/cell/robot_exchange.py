"""Another robot made ready for a place of a living world: its model, and what there is to draw of it.

It is worked out in a copy of the process that steps the world, and changes nothing there; see decision 51.
"""

from collections.abc import Mapping

from msgspec import Struct, msgpack

from onika.workcell.cell.cell_scenes import CellScenes
from onika.workcell.composed.composition import Composition, Offsets
from onika.workcell.composed.drawing import Drawing


class Readied(Struct, frozen=True):
    """What one copy tells the other; the model as MuJoCo writes it."""

    model: bytes
    drawing: Drawing


_encode = msgpack.Encoder().encode
_decode = msgpack.Decoder(Readied).decode


class RobotExchange:
    """The world of a composition as it will be with these robots at their places."""

    def __init__(
        self, composition: Composition, scenes: CellScenes, standing: Mapping[str, str], offsets: Offsets
    ) -> None:
        self._composition, self._scenes = composition, scenes
        self._standing, self._offsets = dict(standing), offsets

    @property
    def is_ready(self) -> bool:
        """Whether all of it is at hand."""
        return self._composition.is_kept(self._standing, self._offsets) and self._scenes.has(self._standing)

    def work_out(self) -> bytes:
        """What takes long; raises ValueError with the reason why there is no such world."""
        model = self._composition.binary(self._standing, self._offsets)
        return _encode(Readied(model, self._scenes.drawing(self._standing)))

    def take(self, worked_out: bytes) -> None:
        """Have at hand what was worked out."""
        readied = _decode(worked_out)
        self._composition.keep_ahead(self._standing, self._offsets, readied.model)
        self._scenes.keep(self._standing, readied.drawing)
