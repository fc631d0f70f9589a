"""What there is to draw of a world that is files, with one robot or another at its places."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from onika.model.world import LampBlock
from onika.workcell.composed.composition import Composition, Offsets
from onika.workcell.composed.drawing import Drawing, drawing
from onika.workcell.plant import Plant
from onika.workcell.scene import BULB, GLOW, Shape3d

Standing = tuple[tuple[str, str], ...]


class CellScenes:
    """The scenes of one world, each worked out once; `offsets` are those of its parts."""

    def __init__(self, composition: Composition, offsets: Offsets, lamps: Iterable[LampBlock]) -> None:
        self._composition, self._offsets = composition, offsets
        self._paints = {shape: BULB for lamp in lamps for shape in lamp.shines}
        self._paints |= {shape: GLOW for lamp in lamps for shape in lamp.glows}
        self._drawings: dict[Standing, Drawing] = {}
        self._scenes: dict[Standing, list[Shape3d]] = {}

    def has(self, standing: Mapping[str, str]) -> bool:
        """Whether it has been worked out with these robots at their places."""
        return tuple(standing.items()) in self._drawings

    def keep(self, standing: Mapping[str, str], worked_out: Drawing) -> None:
        """It was worked out elsewhere."""
        self._drawings[tuple(standing.items())] = worked_out

    def drawing(self, standing: Mapping[str, str]) -> Drawing:
        """The world as it is drawn, with these robots at their places."""
        if not self.has(standing):
            self.keep(standing, drawing(Plant(self._composition.compile(standing, self._offsets, is_drawn=True))))
        return self._drawings[tuple(standing.items())]

    def of(self, standing: Mapping[str, str]) -> list[Shape3d]:
        """Its shapes, painted as its lamps are."""
        key = tuple(standing.items())
        if key not in self._scenes:
            shapes = self.drawing(standing).shapes
            self._scenes[key] = [replace(shape, paint=self._paints.get(shape.name, shape.paint)) for shape in shapes]
        return self._scenes[key]
