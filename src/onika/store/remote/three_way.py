"""Two changed texts and the one that both came from become one, line by line (requirements F03, X09).

A line of our formats is a statement of its own. So where both sides have changed lines beside each other and each has
as many as there were, these are merged one by one; and where an icon was moved on both sides, which means nothing to
what it does, the own place counts.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.files.line_matching import matches

_LAYOUT = ("COORDS", "INLEFT")
"""Keywords of lines that say where something stands, and nothing of what it does."""
_OURS, _BASE, _THEIRS, _END = "<<<<<<< ", "||||||| ", "=======", ">>>>>>> "


@dataclass(frozen=True, slots=True)
class Stretch:
    """Lines of the three texts that stand between lines which all of them have."""

    base: tuple[str, ...]
    mine: tuple[str, ...]
    theirs: tuple[str, ...]

    @property
    def settled(self) -> tuple[str, ...] | None:
        """What becomes of it: what one side has changed alone, or both alike; None where they contradict."""
        if self.mine in (self.theirs, self.base):
            return self.theirs
        if self.theirs == self.base:
            return self.mine
        if len(self.base) == len(self.mine) == len(self.theirs) > 1:
            rows = [
                Stretch((base,), (mine,), (theirs,)).settled
                for base, mine, theirs in zip(self.base, self.mine, self.theirs, strict=True)
            ]
            return None if None in rows else tuple(line for row in rows if row for line in row)
        return self.mine if self._is_layout else None

    @property
    def _is_layout(self) -> bool:
        sides = (self.base, self.mine, self.theirs)
        return all(len(side) == 1 and side[0].split()[:1] == self.base[0].split()[:1] for side in sides) and (
            self.base[0].split()[:1] in [[word] for word in _LAYOUT]
        )


@dataclass(frozen=True, slots=True)
class MergedText:
    """The merged text; where the sides contradict, both stand in it between marks, and it is no file to be used."""

    text: str
    conflicts: int


def merged(base: str, mine: str, theirs: str) -> MergedText:
    """Merge what `mine` and `theirs` have changed of `base`."""
    parts: list[str] = []
    conflicts = 0
    for stretch in _stretches(*(text.splitlines(keepends=True) for text in (base, mine, theirs))):
        settled = stretch.settled
        if settled is None:
            conflicts += 1
            settled = tuple(_marked(stretch))
        parts += settled
    return MergedText("".join(parts), conflicts)


def _stretches(base: Sequence[str], mine: Sequence[str], theirs: Sequence[str]) -> Iterator[Stretch]:
    """The three texts from their beginnings to their ends: what is the same in all of them, and what lies between."""
    ours, others = _places(base, mine), _places(base, theirs)
    at = (0, 0, 0)
    for line in range(len(base)):
        if line not in ours or line not in others:
            continue
        here = (line, ours[line], others[line])
        yield from _between(base, mine, theirs, at, here)
        same = (base[line],)
        yield Stretch(same, same, same)
        at = (line + 1, ours[line] + 1, others[line] + 1)
    yield from _between(base, mine, theirs, at, (len(base), len(mine), len(theirs)))


def _between(
    base: Sequence[str], mine: Sequence[str], theirs: Sequence[str], at: tuple[int, ...], to: tuple[int, ...]
) -> Iterator[Stretch]:
    if at != to:
        yield Stretch(tuple(base[at[0] : to[0]]), tuple(mine[at[1] : to[1]]), tuple(theirs[at[2] : to[2]]))


def _places(base: Sequence[str], text: Sequence[str]) -> dict[int, int]:
    """Where lines of the base stand in a text, of those that are still there."""
    return {match.old + step: match.new + step for match in matches(base, text) for step in range(match.lines)}


def _marked(stretch: Stretch) -> Iterator[str]:
    """Both sides, and what was there before, between marks that stand at the beginnings of lines."""
    for mark, side in ((f"{_OURS}mine", stretch.mine), (f"{_BASE}before", stretch.base), (_THEIRS, stretch.theirs)):
        yield f"{mark}\n"
        for line in side:
            yield line if line.endswith("\n") else f"{line}\n"
    yield f"{_END}theirs\n"
