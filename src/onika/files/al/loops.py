"""Finds the loops of a flow that can be written as blocks: well formed, apart or nested (reading 23)."""

from collections.abc import Sequence
from dataclasses import dataclass

from onika.model.application import Icon


@dataclass(frozen=True, slots=True)
class LoopBlock:
    """A loop as a block of statements; the test is the first or the last of them."""

    tag: str
    first: int
    last: int
    tests_first: bool
    condition: str


def loops(heads: Sequence[Icon | None]) -> tuple[LoopBlock, ...]:
    """The loops among statements, each given by the icon that bears its marks, None where there is none.

    A tag that is lacking a partner or a test, or whose loop would cross another one, is none of them.
    """
    places: dict[str, list[int]] = {}
    for at, icon in enumerate(heads):
        if icon is not None and icon.while_tag is not None:
            places.setdefault(icon.while_tag, []).append(at)
    whole = {tag: _loop(tag, heads, at) for tag, at in places.items()}
    blocks: list[LoopBlock] = []
    begun: list[str] = []
    for at, icon in enumerate(heads):
        tag = icon.while_tag if icon is not None else None
        loop = whole.get(tag) if tag is not None else None
        if loop is None:
            continue
        if at == loop.first:
            begun.append(loop.tag)
        elif begun[-1] == loop.tag:
            begun.pop()
            blocks.append(loop)
        else:
            begun.remove(loop.tag)  # it crosses one that began within it
    return tuple(sorted(blocks, key=lambda loop: loop.first))


def _loop(tag: str, heads: Sequence[Icon | None], at: Sequence[int]) -> LoopBlock | None:
    """The loop of a tag by itself."""
    if len(at) != 2:
        return None
    first, last = (heads[place] for place in at)
    if first is None or last is None or first.while_test == last.while_test:
        return None
    test, anchor = (first, last) if first.while_test else (last, first)
    if anchor.while_if:
        return None
    return LoopBlock(tag, at[0], at[1], first.while_test, test.while_if)
