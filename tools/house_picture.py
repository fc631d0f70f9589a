"""Draws the house from its imports: packages as rooms on their floors, arrows for who uses whom.

Usage: python tools/house_picture.py > house.svg; `python tools/generate.py` writes docs/pictures/house.svg. Floors are
those of the import contract in pyproject.toml; rooms, files and arrows are read from src/onika. An arrow that follows
from others is left out: where A uses B and B uses C, no arrow is drawn from A to C.
"""

import tomllib
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path, PurePosixPath
from xml.sax.saxutils import escape

from import_graph import imports, sources

ROOT = Path(__file__).parents[1]

_Name = str
_Edges = Mapping[_Name, set[_Name]]
_Point = tuple[float, float]

_HOUSE = "onika"
"""The package whose rooms are the floors; it has no walls of its own."""
_GAP = 26
"""Between rooms of a row."""
_LANE = 12
"""The width of an arrow that passes a row."""
_RISE = 36
"""Between rows."""
_EDGE = 14
"""Between the wall of a room and what is in it."""
_HEAD = 48
"""What name and number of files of a room take."""
_LETTER = 8.2
"""The width of a letter of a room's name, nearly."""
_KEY = "An arrow leads from a package to one that it uses; those that follow from others are left out."
_STYLE = """\
text { font-family: system-ui, 'Segoe UI', Helvetica, Arial, sans-serif; fill: #1d2b3a; text-anchor: middle }
.name { font-size: 15px; font-weight: 600 }
.files { font-size: 11.5px; fill: #5b6b7c }
.key { font-size: 12.5px; fill: #5b6b7c; text-anchor: start }
.room { fill: #fff; stroke: #51667d; stroke-width: 1.4 }
.floor { fill: #eef2f6 }
.inner { fill: #f6f8fb; stroke: #51667d; stroke-width: 1.4 }
.use { fill: none; stroke: #6f8bab; stroke-width: 1.5 }
.back { fill: none; stroke: #c0392b; stroke-width: 1.8 }
.use-tip { fill: #6f8bab }
.back-tip { fill: #c0392b }
"""


@dataclass
class Room:
    """A package: its files that stand in no room within it, the rows of rooms within, and where it is drawn."""

    name: _Name
    files: int
    says: str
    rows: list[list["Room"]] = field(default_factory=list)
    edges: dict[_Name, set[_Name]] = field(default_factory=dict)
    back: set[tuple[_Name, _Name]] = field(default_factory=set)
    """Arrows that close a circle; they are drawn in red."""
    width: float = 0
    height: float = 0
    x: float = 0
    y: float = 0
    top: float = 0
    foot: float = 0
    """Where its row begins and ends, in the room around it."""
    lanes: dict[tuple[_Name, _Name], list[tuple[float, float]]] = field(default_factory=dict)
    """For each arrow between rooms within: the points at which it passes the rows between."""

    @property
    def total(self) -> int:
        """Its files, those of the rooms within included."""
        return self.files + sum(room.total for row in self.rows for room in row)


def picture(root: Path = ROOT) -> str:
    """The picture as SVG."""
    house = _house(root)
    _lay_out(house)
    width, height = house.width, house.height + 20
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" role="img">',
        "<title>The packages of Onika on their floors, and who uses whom</title>",
        f"<style>\n{_STYLE}</style>",
        f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fff"/>',
        *_floors(house),
        *_drawn(house, 0, 0),
        _text(
            _EDGE,
            height - 12,
            "key",
            _KEY,
        ),
        "</svg>",
        "",
    ]
    return "\n".join(parts)


def _house(root: Path) -> Room:
    """All rooms with their arrows, not yet laid out."""
    files = [path for path in sources(root) if len(path.parts) > 2 or path.stem not in ("__init__", "__main__")]
    uses = imports(root)
    house = _room(root, PurePosixPath(_HOUSE), files, uses)
    rooms = {room.name: room for row in house.rows for room in row}
    floors = [[name for name in floor if name in rooms] for floor in _floors_of(root)]
    house.rows = [[rooms[name] for name in floor] for floor in floors]
    standing = {name for floor in floors for name in floor}
    house.edges = _needed({name: used & standing for name, used in house.edges.items() if name in standing})
    return house


def _floors_of(root: Path) -> list[list[_Name]]:
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
    counts: Counter[tuple[_Name, _Name]] = Counter()
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


def _reach(start: _Name, edges: _Edges) -> set[_Name]:
    """All that is used from `start` on, over any number of arrows."""
    reached: set[_Name] = set()
    waiting = [start]
    while waiting:
        for name in edges.get(waiting.pop(), ()):
            if name not in reached:
                reached.add(name)
                waiting.append(name)
    return reached


def _without_circles(
    counts: Mapping[tuple[_Name, _Name], int], names: Iterable[_Name]
) -> tuple[dict[_Name, set[_Name]], set[tuple[_Name, _Name]]]:
    """The arrows that are needed, and those that were taken out because they close a circle: the weakest of each."""
    edges: dict[_Name, set[_Name]] = {name: set() for name in names}
    for left, right in counts:
        edges[left].add(right)
    back = set()
    while circle := [(counts[pair], pair) for pair in counts if pair not in back and pair[0] in _reach(pair[1], edges)]:
        _, weakest = min(circle)
        edges[weakest[0]].discard(weakest[1])
        back.add(weakest)
    return _needed(edges), back


def _needed(edges: _Edges) -> dict[_Name, set[_Name]]:
    """The arrows that do not follow from others."""
    return {
        name: {target for target in used if not any(target in _reach(other, edges) for other in used)}
        for name, used in edges.items()
    }


def _rows(rooms: list[Room], edges: _Edges) -> list[list[Room]]:
    """Rooms in rows: whoever is used stands below; the upmost row is of those whom no neighbour uses."""
    row: dict[_Name, int] = {}

    def depth(name: _Name) -> int:
        if name not in row:
            users = [user for user, used in edges.items() if name in used]
            row[name] = 1 + max((depth(user) for user in users), default=-1)
        return row[name]

    rows: dict[int, list[Room]] = {}
    for room in rooms:
        rows.setdefault(depth(room.name), []).append(room)
    return [rows[number] for number in sorted(rows)]


@dataclass
class _Slot:
    """A place in a row: a room, or the lane of an arrow that passes."""

    room: Room | None
    arrow: tuple[_Name, _Name] | None = None
    width: float = _LANE
    x: float = 0
    above: list["_Slot"] = field(default_factory=list)
    below: list["_Slot"] = field(default_factory=list)

    @property
    def centre(self) -> float:
        return self.x + self.width / 2


def _lay_out(room: Room) -> None:
    """Give a room and all within their sizes, and those within their places."""
    for row in room.rows:
        for inner in row:
            _lay_out(inner)
    room.width = max(96.0, len(room.name) * _LETTER + 30)
    room.height = _HEAD
    if not room.rows:
        return
    slots = _slots(room)
    _order(slots)
    _spread(slots)
    left = min(slot.x for row in slots for slot in row)
    y: float = _HEAD if room.name != _HOUSE else 2 * _EDGE
    for row in slots:
        tallest = max(slot.room.height for slot in row if slot.room)
        for slot in row:
            x = slot.x - left + _EDGE
            if slot.room:
                slot.room.x, slot.room.y = x, y + (tallest - slot.room.height) / 2
                slot.room.top, slot.room.foot = y, y + tallest
            elif slot.arrow:
                room.lanes.setdefault(slot.arrow, []).extend([(x + _LANE / 2, y), (x + _LANE / 2, y + tallest)])
        y += tallest + _RISE
    room.width = max(room.width, max(slot.x + slot.width for row in slots for slot in row) - left + 2 * _EDGE)
    room.height = y - _RISE + _EDGE


def _slots(room: Room) -> list[list[_Slot]]:
    """The rooms within as slots, with a lane in each row that an arrow passes."""
    slots = [[_Slot(inner, width=inner.width) for inner in row] for row in room.rows]
    place = {slot.room.name: (number, slot) for number, row in enumerate(slots) for slot in row if slot.room}
    for name, used in sorted(room.edges.items()):
        top, upper = place[name]
        for target in sorted(used):
            bottom, lower = place[target]
            if bottom <= top:
                continue
            before = upper
            for number in range(top + 1, bottom):
                lane = _Slot(None, (name, target))
                slots[number].append(lane)
                _join(before, lane)
                before = lane
            _join(before, lower)
    return slots


def _join(upper: _Slot, lower: _Slot) -> None:
    upper.below.append(lower)
    lower.above.append(upper)


def _order(slots: list[list[_Slot]]) -> None:
    """Order each row by the middle of what its slots are joined with, down and up again, to spare crossings."""
    place = {id(slot): _share(number, row) for row in slots for number, slot in enumerate(row)}
    for _ in range(12):
        for row in slots[1:]:
            _sort(row, [_middle(slot.above, place, place[id(slot)]) for slot in row], place)
        for row in reversed(slots[:-1]):
            _sort(row, [_middle(slot.below, place, place[id(slot)]) for slot in row], place)


def _sort(row: list[_Slot], keys: list[float], place: dict[int, float]) -> None:
    order = sorted(range(len(row)), key=lambda number: keys[number])
    row[:] = [row[number] for number in order]
    place.update({id(slot): _share(number, row) for number, slot in enumerate(row)})


def _share(number: int, row: list[_Slot]) -> float:
    """How far along its row the slot of this number stands, from 0 to 1."""
    return number / max(len(row) - 1, 1)


def _middle(slots: Iterable[_Slot], place: Mapping[int, float], otherwise: float) -> float:
    places = [place[id(slot)] for slot in slots]
    return sum(places) / len(places) if places else otherwise


def _spread(slots: list[list[_Slot]]) -> None:
    """Give each slot its x: rows are packed about the middle, then drawn towards what they are joined with."""
    for row in slots:
        width = sum(slot.width for slot in row) + _GAP * (len(row) - 1)
        x = -width / 2
        for slot in row:
            slot.x = x
            x += slot.width + _GAP
    for turn in range(40):
        for row in slots if turn % 2 == 0 else reversed(slots):
            wanted = [_wanted(slot) for slot in row]
            _settle(row, wanted)


def _wanted(slot: _Slot) -> float:
    joined = [*slot.above, *slot.below]
    return sum(other.centre for other in joined) / len(joined) - slot.width / 2 if joined else slot.x


def _settle(row: list[_Slot], wanted: list[float]) -> None:
    """Move the slots of a row towards what they want, none over another: the mean of packing from both sides."""
    rightward: list[float] = []
    edge = float("-inf")
    for slot, x in zip(row, wanted, strict=True):
        rightward.append(max(x, edge))
        edge = rightward[-1] + slot.width + _GAP
    leftward: list[float] = []
    edge = float("inf")
    for slot, x in zip(reversed(row), reversed(wanted), strict=True):
        leftward.append(min(x, edge - slot.width))
        edge = leftward[-1] - _GAP
    for slot, right, left in zip(row, rightward, reversed(leftward), strict=True):
        slot.x = (right + left) / 2


def _floors(house: Room) -> Iterable[str]:
    """A band behind each floor."""
    for row in house.rows:
        top = min(room.y for room in row) - 8
        bottom = max(room.y + room.height for room in row) + 8
        yield f'<rect class="floor" x="0" y="{top:.0f}" width="{house.width:.0f}" height="{bottom - top:.0f}"/>'


def _drawn(room: Room, x: float, y: float) -> Iterable[str]:
    """The arrows between the rooms within, then the rooms."""
    rooms = {inner.name: inner for row in room.rows for inner in row}
    for name, used in sorted(room.edges.items()):
        for target in sorted(used):
            yield from _arrow(rooms[name], rooms[target], room.lanes.get((name, target), []), x, y)
    for lower, upper in sorted(room.back):
        yield from _circle(rooms[lower], rooms[upper], x, y)
    for inner in rooms.values():
        left, top = x + inner.x, y + inner.y
        kind = "inner" if inner.rows else "room"
        size = f'width="{inner.width:.0f}" height="{inner.height:.0f}"'
        yield f'<g><title>{escape(inner.says)}</title><rect class="{kind}" x="{left:.0f}" y="{top:.0f}" {size} rx="5"/>'
        yield _text(left + inner.width / 2, top + 21, "name", inner.name)
        yield _text(left + inner.width / 2, top + 38, "files", _counted(inner)) + "</g>"
        yield from _drawn(inner, left, top)


def _counted(room: Room) -> str:
    return "1 file" if room.total == 1 else f"{room.total} files"


def _arrow(upper: Room, lower: Room, lanes: list[_Point], x: float, y: float) -> Iterable[str]:
    """An arrow from the foot of one room down to the head of another, by the lanes between."""
    start, end = _middle_of(upper), _middle_of(lower)
    points = [(start, upper.y + upper.height), (start, upper.foot), *lanes, (end, lower.top), (end, lower.y)]
    yield from _line([(px + x, py + y) for px, py in points], "use")


def _circle(lower: Room, upper: Room, x: float, y: float) -> Iterable[str]:
    """An arrow that closes a circle: from the head of a room up to the foot of one that uses it."""
    start, end = _middle_of(lower) + _LANE, _middle_of(upper) + _LANE
    yield from _line([(start + x, lower.y + y), (end + x, upper.y + upper.height + y)], "back")


def _middle_of(room: Room) -> float:
    return room.x + room.width / 2


def _line(points: list[_Point], kind: str) -> Iterable[str]:
    path = f"M{points[0][0]:.0f} {points[0][1]:.0f}"
    for (left, top), (right, bottom) in pairwise(points):
        bend = (bottom - top) / 2
        is_straight = round(left) == round(right)
        curve = f"C{left:.0f} {top + bend:.0f} {right:.0f} {bottom - bend:.0f} {right:.0f} {bottom:.0f}"
        path += f" V{bottom:.0f}" if is_straight else f" {curve}"
    (x, y), is_up = points[-1], points[-1][1] < points[0][1]
    yield f'<path class="{kind}" d="{path}"/>'
    yield f'<path class="{kind}-tip" d="M{x:.0f} {y:.0f} l-4 {7 if is_up else -7} h8 z"/>'


def _text(x: float, y: float, kind: str, words: str) -> str:
    return f'<text class="{kind}" x="{x:.0f}" y="{y:.0f}">{escape(words)}</text>'


if __name__ == "__main__":
    print(picture(), end="")
