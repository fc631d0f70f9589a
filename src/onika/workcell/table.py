"""The floor and the table as parts: the table's top is where all heights of the assembly are counted from."""

from onika.workcell.arm import SHOULDER_M
from onika.workcell.part import THINGS, WorldPart

TOP_M = -0.36
"""Height of the table's top in the world, whose origin is the left arm's shoulder."""

_MIDDLE, _HALF, _THICK = 0.65, (0.35, 0.50), 0.02


def floor(drawn: bool) -> WorldPart:
    """An endless floor."""
    look = 'material="paper"' if drawn else str(THINGS)
    return WorldPart(bodies=f'<geom name="floor" type="plane" size="0 0 0.05" pos="0 0 {-SHOULDER_M}" {look}/>')


def top_at(x: float, y: float) -> float:
    """How high in the world something lies on the table at this place, or beside it on the floor."""
    on_it = abs(x - _MIDDLE) <= _HALF[0] and abs(y) <= _HALF[1]
    return TOP_M if on_it else -SHOULDER_M


def table(drawn: bool) -> WorldPart:
    """A table of 0.7 by 1.0 m between the arms."""
    look = 'material="wood"' if drawn else f'friction="0.6 0.01 0.001" condim="4" {THINGS}'
    top = (
        f'<geom name="table" type="box" size="{_HALF[0]} {_HALF[1]} {_THICK}" '
        f'pos="{_MIDDLE} 0 {TOP_M - _THICK}" {look}/>'
    )
    return WorldPart(bodies=top + (_drawn_legs() if drawn else ""))


def _drawn_legs() -> str:
    under = TOP_M - 2 * _THICK
    half = (under + SHOULDER_M) / 2
    shapes = [(0.022, 0.022, half, i * 0.31, j * 0.46, under - half) for i in (-1, 1) for j in (-1, 1)]
    shapes += [(0.31, 0.012, 0.03, 0.0, j * 0.46, under - 0.03) for j in (-1, 1)]
    shapes += [(0.012, 0.46, 0.03, i * 0.31, 0.0, under - 0.03) for i in (-1, 1)]
    return "".join(
        f'<geom type="box" size="{wide} {deep} {high}" pos="{_MIDDLE + x} {y} {z}" material="wood_dark"/>'
        for wide, deep, high, x, y, z in shapes
    )
