"""The rooms of the house as its imports show them: packages on their floors, and which of them use which.

Floors are those of the import contract in pyproject.toml; rooms, files and uses are read from src/onika. A use that
follows from others is left out: where A uses B and B uses C, A is not said to use C.
"""

import tomllib
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from import_graph import imports, sources

HOUSE = "onika"
"""The package whose rooms are the floors; it has no walls of its own."""

Name = str
_Edges = Mapping[Name, set[Name]]


@dataclass
class Room:
    """A package: its files that stand in no room within it, the rows of rooms within, and where it is drawn."""

    name: Name
    files: int
    says: str
    rows: list[list["Room"]] = field(default_factory=list)
    edges: dict[Name, set[Name]] = field(default_factory=dict)
    back: set[tuple[Name, Name]] = field(default_factory=set)
    """Arrows that close a circle; they are drawn in red."""
    width: float = 0
    height: float = 0
    x: float = 0
    y: float = 0
    top: float = 0
    foot: float = 0
    """Where its row begins and ends, in the room around it."""
    lanes: dict[tuple[Name, Name], list[tuple[float, float]]] = field(default_factory=dict)
    """For each arrow between rooms within: the points at which it passes the rows between."""

    @property
    def total(self) -> int:
        """Its files, those of the rooms within included."""
        return self.files + sum(room.total for row in self.rows for room in row)


def house(root: Path) -> Room:
    """All rooms with their arrows, not yet laid out."""
    files = [path for path in sources(root) if len(path.parts) > 2 or path.stem not in ("__init__", "__main__")]
    uses = imports(root)
    whole = _room(root, PurePosixPath(HOUSE), files, uses)
    rooms = {room.name: room for row in whole.rows for room in row}
    floors = [[name for name in floor if name in rooms] for floor in _floors_of(root)]
    whole.rows = [[rooms[name] for name in floor] for floor in floors]
    standing = {name for floor in floors for name in floor}
    whole.edges = _needed({name: used & standing for name, used in whole.edges.items() if name in standing})
    return whole


def _floors_of(root: Path) -> list[list[Name]]:
    """The floors of the import contract, the upmost first."""
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = project["tool"]["importlinter"]["contracts"]
    layers = next(contract["layers"] for contract in contracts if contract["id"] == "floors")
    return [[name.strip() for name in layer.split("|")] for layer in layers]


def _room(
    root: Path, place: PurePosixPath, files: list[PurePosixPath], uses: set[tuple[PurePosixPath, PurePosixPath]]
) -> Room:
    """The room of a package, with the rooms of the packages in it. At the top a module is a room too."""
    depth = len(place.parts)
    is_top = depth == 1
    inside = [path for path in files if path.is_relative_to(place)]
    names = sorted({path.parts[depth] for path in inside if len(path.parts) > depth + 1 or is_top})
    rooms = [_room(root, place / name, files, uses) for name in names]
    own = sum(len(path.parts) == depth + 1 and path.suffix == ".py" for path in inside)
    room = Room(place.name.removesuffix(".py"), max(own, is_top), _says(root, place))
    if place.suffix == ".py":
        room.files = 1
        return room
    counts: Counter[tuple[Name, Name]] = Counter()
    standing = {inner.name for inner in rooms}
    for importer, imported in uses:
        if importer.is_relative_to(place) and imported.is_relative_to(place):
            left, right = (path.parts[depth].removesuffix(".py") for path in (importer, imported))
            if left != right and {left, right} <= standing:
                counts[left, right] += 1
    room.edges, room.back = _without_circles(counts, standing)
    room.rows = _rows(rooms, room.edges)
    return room


def _says(root: Path, place: PurePosixPath) -> str:
    """The first line of a package's docstring."""
    path = root / "src" / place
    path = path if place.suffix else path / "__init__.py"
    return path.read_text(encoding="utf-8").partition("\n")[0].strip('"') if path.exists() else ""


def _reach(start: Name, edges: _Edges) -> set[Name]:
    """All that is used from `start` on, over any number of arrows."""
    reached: set[Name] = set()
    waiting = [start]
    while waiting:
        for name in edges.get(waiting.pop(), ()):
            if name not in reached:
                reached.add(name)
                waiting.append(name)
    return reached


def _without_circles(
    counts: Mapping[tuple[Name, Name], int], names: Iterable[Name]
) -> tuple[dict[Name, set[Name]], set[tuple[Name, Name]]]:
    """The arrows that are needed, and those that were taken out because they close a circle: the weakest of each."""
    edges: dict[Name, set[Name]] = {name: set() for name in names}
    for left, right in counts:
        edges[left].add(right)
    back = set()
    while circle := [(counts[pair], pair) for pair in counts if pair not in back and pair[0] in _reach(pair[1], edges)]:
        _, weakest = min(circle)
        edges[weakest[0]].discard(weakest[1])
        back.add(weakest)
    return _needed(edges), back


def _needed(edges: _Edges) -> dict[Name, set[Name]]:
    """The arrows that do not follow from others."""
    return {
        name: {target for target in used if not any(target in _reach(other, edges) for other in used)}
        for name, used in edges.items()
    }


def _rows(rooms: list[Room], edges: _Edges) -> list[list[Room]]:
    """Rooms in rows: whoever is used stands below; the upmost row is of those whom no neighbour uses."""
    row: dict[Name, int] = {}

    def depth(name: Name) -> int:
        if name not in row:
            users = [user for user, used in edges.items() if name in used]
            row[name] = 1 + max((depth(user) for user in users), default=-1)
        return row[name]

    rows: dict[int, list[Room]] = {}
    for room in rooms:
        rows.setdefault(depth(room.name), []).append(room)
    return [rows[number] for number in sorted(rows)]
