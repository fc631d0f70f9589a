"""Equation (7), insertion and deletion, holes and loops, read a second time on plain lists of type names.

Written from §5.5.3, §5.5.4, §5.7.1, D03, D19, D22 and readings 23, 24, 33 and 37; it shares no code with the rules. A
flow is the list of its icons' types with None for a hole, without the start and the end that are implied.
"""

from collections.abc import Mapping, Sequence
from itertools import combinations, pairwise

Edges = Mapping[str, tuple[int, int]]
"""Left and right edge of every type, by its name in small letters."""

Line = list[str | None]


def words(kind: str) -> list[str]:
    return kind.lower().split()


def edges_of(kind: str, edges: Edges) -> tuple[int, int] | None:
    """Of an unknown job or application those of the complete one; an unknown target has none (D16)."""
    if kind.lower() in edges:
        return edges[kind.lower()]
    if "object" in words(kind):
        return None
    if "job" in words(kind):
        return edges["complete job"]
    return edges["complete application"] if "application" in words(kind) else None


def equation_7(a: str, b: str, edges: Edges) -> bool:
    """L(T(b)) = R(T(a))."""
    left, right = edges_of(a, edges), edges_of(b, edges)
    return left is not None and right is not None and right[0] == left[1]


def left_of(line: Line, after: int) -> int:
    """The icon that is meant by a place: a hole means its left neighbour (reading 33); -1 is the start."""
    while after >= 0 and line[after] is None:
        after -= 1
    return after


def may_insert(line: Line, after: int, b: str, edges: Edges) -> bool:
    at = left_of(line, after)
    return equation_7(line[at] or "" if at >= 0 else "Application start", b, edges)


def insert(line: Line, after: int, b: str, edges: Edges) -> Line:
    at = left_of(line, after)
    rest = line[at + 1 :]
    while rest and rest[0] is None:
        rest = rest[1:]
    following = rest[0] if rest else "Application end"
    assert following is not None
    return [*line[: at + 1], b, *([] if equation_7(b, following, edges) else [None]), *rest]


def settled(line: Line, edges: Edges) -> Line:
    """With a hole exactly where two neighbours do not fit."""
    result: Line = []
    before = "Application start"
    for kind in [*(kind for kind in line if kind is not None), "Application end"]:
        result += [kind] if equation_7(before, kind, edges) else [None, kind]
        before = kind
    return result[:-1]


def delete(line: Line, at: int, edges: Edges) -> Line:
    head, rest = line[:at], line[at + 1 :]
    while head and head[-1] is None:
        head = head[:-1]
    while rest and rest[0] is None:
        rest = rest[1:]
    before, after = (head[-1] if head else "Application start"), (rest[0] if rest else "Application end")
    assert before is not None
    assert after is not None
    return [*head, *([] if equation_7(before, after, edges) else [None]), *rest]


def is_whole(line: Line, edges: Edges) -> bool:
    """No hole, and every icon fits the one before it, from the start to the end."""
    row = ["Application start", *line, "Application end"]
    return all(a is not None and b is not None and equation_7(a, b, edges) for a, b in pairwise(row))


def is_target(kind: str) -> bool:
    return "object" in words(kind)


def needs_target(kind: str, edges: Edges) -> bool:
    """D22; what is unknown acts as complete (D16)."""
    acts = {"job", "application"} & set(words(kind)) and not is_target(kind)
    return bool(acts) and "complete" not in words(kind) and kind.lower() in edges


def actions(line: Line, edges: Edges) -> list[tuple[int, ...]]:
    """The positions of each action's icons: one, or a job and its target."""
    result: list[tuple[int, ...]] = []
    at = 0
    while at < len(line):
        kind = line[at]
        following = line[at + 1] if at + 1 < len(line) else None
        if kind is None or is_target(kind):
            at += 1
        elif (
            needs_target(kind, edges) and following is not None and is_target(following) and following.lower() in edges
        ):
            result.append((at, at + 1))
            at += 2
        else:
            result.append((at,))
            at += 1
    return result


def loops_are_well_formed(
    groups: Sequence[tuple[int, ...]], tags: Mapping[int, str], tests: Mapping[int, bool]
) -> bool:
    """Reading 23; an action's mark may stand on either of its icons and counts once (reading 24, D06)."""
    marks: dict[str, list[tuple[int, bool]]] = {}
    for number, group in enumerate(groups):
        own = {tags[at] for at in group if at in tags}
        if len(own) > 1:
            return False
        for tag in own:
            marks.setdefault(tag, []).append((number, any(tests[at] for at in group if at in tags)))
    if any(not any(at in group for group in groups) for at in tags):
        return False
    if any(len(each) != 2 or each[0][1] == each[1][1] for each in marks.values()):
        return False
    spans = [(each[0][0], each[1][0]) for each in marks.values()]
    return not any(a < c <= b < d or c < a <= d < b for (a, b), (c, d) in combinations(spans, 2))


def loops_take_time(
    groups: Sequence[tuple[int, ...]], line: Line, tags: Mapping[int, str], tests: Mapping[int, bool]
) -> bool:
    """Whether no way leads round without a job; the loops are well formed. A no-op as test always goes on (D11)."""
    is_noop = ["nop" in words(line[group[0]] or "") for group in groups]
    marks: dict[str, list[int]] = {}
    for number, group in enumerate(groups):
        for tag in {tags[at] for at in group if at in tags}:
            marks.setdefault(tag, []).append(number)
    ways = {number: {number + 1} for number in range(len(groups))}
    for first, last in marks.values():
        is_top = any(tests[at] for at in groups[first] if at in tags)
        if is_top:
            ways[last] = {first}
            ways[first] = {first + 1} if is_noop[first] else {first + 1, last + 1}
        else:
            ways[last] = {first} if is_noop[last] else {first, last + 1}
    for start in range(len(groups)):
        reached, waiting = set[int](), [start] if is_noop[start] else []
        while waiting:
            for number in ways[waiting.pop()] - reached:
                if number == start:
                    return False
                if number < len(groups) and is_noop[number]:
                    reached.add(number)
                    waiting.append(number)
    return True
