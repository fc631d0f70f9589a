"""Which lines of a text stand in a newer one too, found in time that grows with the length of the texts only.

Few changes are found as they are: as few lines as can be count as changed (Myers, "An O(ND) Difference Algorithm and
Its Variations", 1986). Where there are many, the lines that each text has once divide both into parts; in a part
without any such line all counts as changed.
"""

from bisect import bisect_left
from collections import Counter
from collections.abc import Hashable, Iterator, Sequence
from typing import NamedTuple

MOST_CHANGES = 300
"""Lines that go or come in one part; with more, the part is divided."""


class Match(NamedTuple):
    """Lines that are the same in both texts, one after the other."""

    old: int
    new: int
    lines: int


class _Part(NamedTuple):
    """Lines of both texts that stand between the same others."""

    old: range
    new: range


def matches(old: Sequence[Hashable], new: Sequence[Hashable]) -> list[Match]:
    """The lines that stay, in order; the last match is empty and stands at the ends."""
    numbers: dict[Hashable, int] = {}
    before = [numbers.setdefault(line, len(numbers)) for line in old]
    after = [numbers.setdefault(line, len(numbers)) for line in new]
    pairs = _pairs(before, after, _Part(range(len(old)), range(len(new))), may_divide=True)
    return [*_joined(pairs), Match(len(old), len(new), 0)]


def _joined(pairs: Iterator[tuple[int, int]]) -> Iterator[Match]:
    match = Match(0, 0, 0)
    for old, new in pairs:
        if (old, new) == (match.old + match.lines, match.new + match.lines):
            match = match._replace(lines=match.lines + 1)
            continue
        if match.lines:
            yield match
        match = Match(old, new, 1)
    if match.lines:
        yield match


def _pairs(before: list[int], after: list[int], part: _Part, *, may_divide: bool) -> Iterator[tuple[int, int]]:
    """The lines of a part that stay, as pairs of their places."""
    old, new = part
    most = min(len(old), len(new))
    head = next((at for at in range(most) if before[old[at]] != after[new[at]]), most)
    tail = next((at for at in range(most - head) if before[old[-1 - at]] != after[new[-1 - at]]), most - head)
    yield from zip(old[:head], new[:head], strict=True)
    middle = _Part(old[head : len(old) - tail], new[head : len(new) - tail])
    if middle.old and middle.new:
        yield from _pairs_between(before, after, middle, may_divide=may_divide)
    yield from zip(old[len(old) - tail :], new[len(new) - tail :], strict=True)


def _pairs_between(before: list[int], after: list[int], part: _Part, *, may_divide: bool) -> Iterator[tuple[int, int]]:
    """Those of a part that begins and ends with changes."""
    path = _shortest_path([before[at] for at in part.old], [after[at] for at in part.new])
    if path is not None:
        yield from ((part.old[old], part.new[new]) for old, new in path)
    elif may_divide:
        begin = (part.old.start, part.new.start)
        for old, new in [*_anchors(before, after, part), (part.old.stop, part.new.stop)]:
            gap = _Part(range(begin[0], old), range(begin[1], new))
            yield from _pairs(before, after, gap, may_divide=False)
            if old < part.old.stop:
                yield old, new
            begin = (old + 1, new + 1)


def _anchors(before: list[int], after: list[int], part: _Part) -> list[tuple[int, int]]:
    """The lines that each text has once in this part, as many as stand in the same order in both."""
    in_old = Counter(before[at] for at in part.old)
    in_new = Counter(after[at] for at in part.new)
    place = {after[at]: at for at in part.new if in_new[after[at]] == 1}
    candidates = [(at, place[before[at]]) for at in part.old if in_old[before[at]] == 1 and before[at] in place]
    return _rising(candidates)


def _rising(pairs: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """The longest row of these pairs whose second numbers rise as the first ones do."""
    ends: list[int] = []
    last: list[int] = []
    former: list[int] = []
    for number, (_, new) in enumerate(pairs):
        length = bisect_left(ends, new)
        ends[length : length + 1] = [new]
        former.append(last[length - 1] if length else -1)
        last[length : length + 1] = [number]
    row = []
    number = last[-1] if last else -1
    while number >= 0:
        row.append(pairs[number])
        number = former[number]
    return row[::-1]


def _shortest_path(old: list[int], new: list[int]) -> list[tuple[int, int]] | None:
    """The pairs of lines that stay where as few as can be go or come; None: there are too many that do.

    `reached[diagonal]` is how far one comes in `old` with so many changes; places in `new` are those less the diagonal.
    """
    reached = {1: 0}
    history: list[dict[int, int]] = []
    for changes in range(min(len(old) + len(new), MOST_CHANGES) + 1):
        came: dict[int, int] = {}
        lowest = -changes + 2 * max(0, changes - len(new))
        highest = changes - 2 * max(0, changes - len(old))
        for diagonal in range(lowest, highest + 1, 2):
            at = max(reached.get(diagonal + 1, -1), reached.get(diagonal - 1, -2) + 1)
            while at < len(old) and at - diagonal < len(new) and old[at] == new[at - diagonal]:
                at += 1
            came[diagonal] = at
        history.append(came)
        if came.get(len(old) - len(new)) == len(old):
            return _walked_back(history, len(old), len(new))
        reached = came
    return None


def _walked_back(history: list[dict[int, int]], old: int, new: int) -> list[tuple[int, int]]:
    """The pairs on the way that led to the ends of both texts."""
    pairs = []
    for changes in range(len(history) - 1, -1, -1):
        diagonal = old - new
        former = history[changes - 1] if changes else {}
        down, right = former.get(diagonal + 1, -1), former.get(diagonal - 1, -2) + 1
        begin = max(down, right) if changes else 0
        while old > begin:
            old, new = old - 1, new - 1
            pairs.append((old, new))
        if changes:
            old, new = (old, new - 1) if down >= right else (old - 1, new)
    return pairs[::-1]
