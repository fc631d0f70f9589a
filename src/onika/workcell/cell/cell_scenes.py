"""What there is to draw of a world that is files, with one robot or another at its places."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from onika.model.world import LampBlock
from onika.workcell.composed.composition import Composition, Offsets
from onika.workcell.plant import Plant
from onika.workcell.scene import BULB, GLOW, Shape3d, looked_at


class CellScenes:
    """The scenes of one world, each worked out once; `offsets` are those of its parts."""

    def __init__(self, composition: Composition, offsets: Offsets, lamps: Iterable[LampBlock]) -> None:
        self._composition, self._offsets = composition, offsets
        self._paints = {shape: BULB for lamp in lamps for shape in lamp.shines}
        self._paints |= {shape: GLOW for lamp in lamps for shape in lamp.glows}
        self._scenes: dict[tuple[tuple[str, str], ...], list[Shape3d]] = {}

    def plant(self, standing: Mapping[str, str]) -> Plant:
        """The world as it is drawn, at its start, with these robots at their places."""
        return Plant(self._composition.compile(standing, self._offsets, is_drawn=True))

    def of(self, standing: Mapping[str, str]) -> list[Shape3d]:
        """Its shapes, with these robots at their places."""
        key = tuple(standing.items())
        if key not in self._scenes:
            shapes = looked_at(self.plant(standing))
            self._scenes[key] = [replace(shape, paint=self._paints.get(shape.name, shape.paint)) for shape in shapes]
        return self._scenes[key]
