"""Draws the house from its imports: packages as rooms on their floors, arrows for who uses whom.

Usage: python tools/house_picture.py > house.svg; `python tools/generate.py` writes docs/pictures/house.svg.
"""

from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from xml.sax.saxutils import escape

from house_layout import EDGE, LANE, lay_out
from house_rooms import Room, house

ROOT = Path(__file__).parents[1]

_Point = tuple[float, float]

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


def picture(root: Path = ROOT) -> str:
    """The picture as SVG."""
    whole = house(root)
    lay_out(whole)
    width, height = whole.width, whole.height + 20
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" role="img">',
        "<title>The packages of Onika on their floors, and who uses whom</title>",
        f"<style>\n{_STYLE}</style>",
        f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fff"/>',
        *_floors(whole),
        *_drawn(whole, 0, 0),
        _text(EDGE, height - 12, "key", _KEY),
        "</svg>",
        "",
    ]
    return "\n".join(parts)


def _floors(whole: Room) -> Iterable[str]:
    """A band behind each floor."""
    for row in whole.rows:
        top = min(room.y for room in row) - 8
        bottom = max(room.y + room.height for room in row) + 8
        yield f'<rect class="floor" x="0" y="{top:.0f}" width="{whole.width:.0f}" height="{bottom - top:.0f}"/>'


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
    start, end = _middle_of(lower) + LANE, _middle_of(upper) + LANE
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
