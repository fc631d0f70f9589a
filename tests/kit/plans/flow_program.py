"""The program of a flow for tests, from nested parts: a loop, a branch, a nested application is one call each.

program(Do(0), bottom("round", Do(1), Do(2)), branch([Do(3)], [Do(4)]))
"""

from collections.abc import Callable, Iterable, Sequence

from onika.wire.plan import Again, Choose, Fork, Halt, Instruction, Join, Jump, Unless

Part = Instruction | Callable[[int], Sequence[Instruction]]
"""An instruction, or what makes instructions that begin at a place."""


def program(*parts: Part) -> tuple[Instruction, ...]:
    """The parts one after the other and a Halt; a Halt between them begins another stretch."""
    return (*_laid(0, parts), Halt())


def bottom(name: str, *parts: Part, condition: str = "") -> Part:
    """A loop whose test comes last: of the value of its last part, or of the condition."""

    def lay(place: int) -> Sequence[Instruction]:
        return [*_laid(place, parts), Again(name, place, condition)]

    return lay


def top(name: str, test: Part, *parts: Part, condition: str = "") -> Part:
    """A loop whose test comes first: of the value of `test`, or of the condition."""

    def lay(place: int) -> Sequence[Instruction]:
        tested = _laid(place, [test])
        body = _laid(place + len(tested) + 1, parts)
        after = place + len(tested) + len(body) + 2
        return [*tested, Unless(name, after, condition), *body, Jump(place, name)]

    return lay


def branch(*ways: Sequence[Part], conditions: tuple[str, ...] = (), name: str = "") -> Part:
    """One of several ways: by the value, or by the first condition that holds."""

    def lay(place: int) -> Sequence[Instruction]:
        starts: list[int] = []
        bodies: list[list[Instruction]] = []
        at = place + 1
        for way in ways:
            starts.append(at)
            bodies.append(_laid(at, way))
            at += len(bodies[-1]) + 1
        laid: list[Instruction] = [Choose(tuple(starts), conditions, name)]
        for body in bodies:
            laid += [*body, Jump(at)]
        return laid

    return lay


def nested(children: Iterable[tuple[int, int]], *parts: Part, name: str = "") -> Part:
    """A nested parallel application: other flows, each from a place of its program, beside these parts."""

    def lay(place: int) -> Sequence[Instruction]:
        flows = tuple(children)
        return [Fork(flows, name), *_laid(place + 1, parts), Join(tuple(flow for flow, _ in flows))]

    return lay


def _laid(place: int, parts: Iterable[Part]) -> list[Instruction]:
    laid: list[Instruction] = []
    for part in parts:
        laid += part(place + len(laid)) if callable(part) else [part]
    return laid
