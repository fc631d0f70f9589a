"""Where the rooms of the house are drawn: in rows, few arrows crossing, each room near those that it has to do with."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from house_rooms import HOUSE, Name, Room

EDGE = 14
"""Between the wall of a room and what is in it."""
LANE = 12
"""The width of an arrow that passes a row."""
_GAP = 26
"""Between rooms of a row."""
_RISE = 36
"""Between rows."""
_HEAD = 48
"""What name and number of files of a room take."""
_LETTER = 8.2
"""The width of a letter of a room's name, nearly."""


@dataclass
class _Slot:
    """A place in a row: a room, or the lane of an arrow that passes."""

    room: Room | None
    arrow: tuple[Name, Name] | None = None
    width: float = LANE
    x: float = 0
    above: list["_Slot"] = field(default_factory=list)
    below: list["_Slot"] = field(default_factory=list)

    @property
    def centre(self) -> float:
        return self.x + self.width / 2


def lay_out(room: Room) -> None:
    """Give a room and all within their sizes, and those within their places."""
    for row in room.rows:
        for inner in row:
            lay_out(inner)
    room.width = max(96.0, len(room.name) * _LETTER + 30)
    room.height = _HEAD
    if not room.rows:
        return
    slots = _slots(room)
    _order(slots)
    _spread(slots)
    left = min(slot.x for row in slots for slot in row)
    y: float = _HEAD if room.name != HOUSE else 2 * EDGE
    for row in slots:
        tallest = max(slot.room.height for slot in row if slot.room)
        for slot in row:
            x = slot.x - left + EDGE
            if slot.room:
                slot.room.x, slot.room.y = x, y + (tallest - slot.room.height) / 2
                slot.room.top, slot.room.foot = y, y + tallest
            elif slot.arrow:
                room.lanes.setdefault(slot.arrow, []).extend([(x + LANE / 2, y), (x + LANE / 2, y + tallest)])
        y += tallest + _RISE
    room.width = max(room.width, max(slot.x + slot.width for row in slots for slot in row) - left + 2 * EDGE)
    room.height = y - _RISE + EDGE


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
