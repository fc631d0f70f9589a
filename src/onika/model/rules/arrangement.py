"""Lays out the tasks of a configuration: data flows from left to right, in columns (requirement C09).

A task stands one column to the right of the last that writes what it reads; hardware stands first, as in a cycle
(law 1), so that every loop is drawn back once. Within the columns tasks stand beside those with which they share
variables: the order of the barycentre method (Sugiyama, Tagawa and Toda 1981), a few sweeps both ways.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from onika.model.configuration import Configuration, Locus, Placed
from onika.model.rules import loci
from onika.model.rules.box import WIDTH, TaskBox
from onika.model.rules.order import Ports, rank

_COLUMN = WIDTH + 144
"""Pixels from column to column; the loci of the lines between them lie in the gap."""
_BETWEEN = 40
"""Pixels between the icons of a column."""
_TALL = 1600
"""Pixels after which the rest of a column stands in another one beside it."""
_MISSING = 90
"""Pixels that are kept for a task whose icon is not known."""
_GRID = 10
_SWEEPS = 4
_NEAR = 16
"""Pixels between two loci, at least."""


def arranged(
    configuration: Configuration,
    boxes: Mapping[str, TaskBox],
    hardware: Collection[str] = (),
    chosen: Collection[str] = (),
) -> Configuration:
    """The configuration with its tasks, or those that are chosen, in columns where they begin now; loci follow.

    boxes    the icons of its tasks, as far as they are known
    """
    placed = [each for each in configuration.placed if not chosen or each.task in chosen]
    if not placed:
        return configuration
    graph = _Graph.of(placed, boxes, hardware)
    corner = min(each.x for each in placed), min(each.y for each in placed)
    spots = _spots(graph.columns(), boxes, corner)
    moved = tuple(_at(each, spots.get(each.task)) for each in configuration.placed)
    used = {svar for name in spots if name in boxes for svar in boxes[name].uses}
    shown = {locus.svar: locus.show for locus in configuration.loci}
    kept = tuple(locus for locus in configuration.loci if locus.svar not in used)
    bare = replace(configuration, placed=moved, loci=kept)
    settled = loci.settled(bare, boxes, bare)
    apart = _apart(settled.loci, used)
    return replace(settled, loci=tuple(replace(locus, show=shown.get(locus.svar, True)) for locus in apart))


@dataclass(frozen=True, slots=True)
class _Graph:
    """Who writes what others read each cycle, without the ways back."""

    order: Sequence[str]
    writers: Mapping[str, Sequence[str]]
    readers: Mapping[str, Sequence[str]]

    @classmethod
    def of(cls, placed: Sequence[Placed], boxes: Mapping[str, TaskBox], hardware: Collection[str]) -> "_Graph":
        """That of some tasks."""
        ports = [_ports(each.task, boxes.get(each.task)) for each in placed]
        place = rank(ports, hardware)
        order = sorted(place, key=place.__getitem__)
        sources: dict[str, list[str]] = {}
        for task in ports:
            for svar in task.outvar:
                sources.setdefault(svar, []).append(task.name)
        writers: dict[str, list[str]] = {name: [] for name in order}
        readers: dict[str, list[str]] = {name: [] for name in order}
        for task in ports:
            found = dict.fromkeys(writer for svar in task.invar for writer in sources.get(svar, ()))
            for writer in found:
                if place[writer] < place[task.name]:
                    writers[task.name].append(writer)
                    readers[writer].append(task.name)
        return cls(order, writers, readers)

    def columns(self) -> list[list[str]]:
        """The tasks from left to right, each column from top to bottom."""
        depth: dict[str, int] = {}
        for name in self.order:
            depth[name] = max((depth[writer] + 1 for writer in self.writers[name]), default=0)
        columns: list[list[str]] = [[] for _ in range(max(depth.values()) + 1)]
        for name in self.order:
            columns[depth[name]].append(name)
        for sweep in range(_SWEEPS):
            self._sort(columns, self.writers if sweep % 2 == 0 else self.readers, is_back=sweep % 2 == 1)
        return columns

    def _sort(self, columns: list[list[str]], near: Mapping[str, Sequence[str]], *, is_back: bool) -> None:
        height = {name: at for column in columns for at, name in enumerate(column)}
        for column in reversed(columns) if is_back else columns:
            column.sort(key=lambda name: _mean([height[other] for other in near[name]], height[name]))
            height.update({name: at for at, name in enumerate(column)})


def _ports(name: str, box: TaskBox | None) -> Ports:
    """What a task reads and writes each cycle; the constants of a robot would put everything behind it."""
    pins = [pin for pin in box.pins if pin.kind.at_cycle] if box is not None else []
    invar = tuple(pin.svar for pin in pins if pin.kind.is_input)
    outvar = tuple(pin.svar for pin in pins if not pin.kind.is_input)
    return Ports(name, invar=invar, outvar=outvar)


def _mean(values: Sequence[int], otherwise: int) -> float:
    return sum(values) / len(values) if values else float(otherwise)


def _spots(
    columns: Sequence[Sequence[str]], boxes: Mapping[str, TaskBox], corner: tuple[int, int]
) -> dict[str, tuple[int, int]]:
    """Where each task stands: the columns stand side by side, their middles at one height."""
    parts = [part for column in columns for part in _cut(column, boxes)]
    heights = [sum(_height(name, boxes) + _BETWEEN for name in part) - _BETWEEN for part in parts]
    spots: dict[str, tuple[int, int]] = {}
    x = _on_grid(corner[0])
    for part, height in zip(parts, heights, strict=True):
        y = corner[1] + (max(heights) - height) // 2
        for name in part:
            spots[name] = x, _on_grid(y)
            y += _height(name, boxes) + _BETWEEN
        x += _COLUMN
    return spots


def _cut(column: Sequence[str], boxes: Mapping[str, TaskBox]) -> Iterator[list[str]]:
    part: list[str] = []
    height = 0
    for name in column:
        if part and height + _height(name, boxes) > _TALL:
            yield part
            part, height = [], 0
        part.append(name)
        height += _height(name, boxes) + _BETWEEN
    yield part


def _height(name: str, boxes: Mapping[str, TaskBox]) -> int:
    box = boxes.get(name)
    return _MISSING if box is None else box.height


def _on_grid(value: int) -> int:
    return round(value / _GRID) * _GRID


def _at(placed: Placed, spot: tuple[int, int] | None) -> Placed:
    return placed if spot is None else replace(placed, x=spot[0], y=spot[1], in_left=True)


def _apart(standing: Sequence[Locus], moved: Collection[str]) -> Iterator[Locus]:
    """Loci that lie upon each other one below the other."""
    taken = [(locus.x, locus.y) for locus in standing if locus.svar not in moved]
    for locus in standing:
        x, y = locus.x, locus.y
        if locus.svar in moved:
            while any(abs(x - left) < _NEAR and abs(y - top) < _NEAR for left, top in taken):
                y += _NEAR
            taken.append((x, y))
        yield locus if y == locus.y else replace(locus, y=y)
