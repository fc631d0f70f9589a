"""Whether the loops of a flow are well formed (requirement E01, decision 23)."""

from collections.abc import Iterator
from itertools import combinations

from onika.model.application import AppFlow, Icon, Step, actions
from onika.model.syntax import Syntax
from onika.words.fault import Fault, Place


def faults(flow: AppFlow, syntax: Syntax, where: str, place: Place) -> tuple[Fault, ...]:
    """What is wrong with the loop tags of a flow; `where` names it in the text.

    A tag stands at exactly two different actions of the flow, exactly one of them the test; loops are apart or one
    within the other. A mark on a target counts for its action, which bears one (decision 24, requirement D06).
    """
    marked = _marked(flow, syntax)
    found = (*_counts(marked, where), *_shared(marked, where), *_crossings(marked, where))
    return tuple(_fault(place, *fault) for fault in found)


_Marks = dict[str, list[tuple[int, bool]]]


def _marked(flow: AppFlow, syntax: Syntax) -> _Marks:
    """For every tag the positions of the actions that bear it, each with whether it is the test."""
    owners: dict[int, int] = {}
    for action in actions(flow, syntax):
        owners |= dict.fromkeys(range(action.position, action.end), action.position)
    marked: _Marks = {}
    for at, step in enumerate(flow.steps):
        tag = _tag(step)
        if isinstance(step, Icon) and tag is not None:
            marked.setdefault(tag, []).append((owners.get(at, at), step.while_test))
    return marked


def _tag(step: Step) -> str | None:
    return step.while_tag if isinstance(step, Icon) else None


def _counts(marked: _Marks, where: str) -> Iterator[tuple[str, str]]:
    for tag, marks in marked.items():
        places = {position for position, _ in marks}
        tests = {position for position, is_test in marks if is_test}
        if len(places) == 1 and len(marks) == 2:
            yield f"the loop tag {tag} at two actions of {where}", "it twice at one"
        elif len(places) != 2:
            yield f"the loop tag {tag} twice in {where}", f"{len(places)} times"
        if len(tests) != 1:
            yield f"exactly one test icon of the loop {tag} in {where}", f"{len(tests)}"


def _shared(marked: _Marks, where: str) -> Iterator[tuple[str, str]]:
    """Actions whose job bears one tag and whose target another: an action keeps one mark only."""
    tags: dict[int, list[str]] = {}
    for tag, marks in marked.items():
        for position in {position for position, _ in marks}:
            tags.setdefault(position, []).append(tag)
    for position, several in sorted(tags.items()):
        if len(several) > 1:
            yield f"one loop tag at an action of {where}", f"{' and '.join(several)} at step {position}"


def _crossings(marked: _Marks, where: str) -> Iterator[tuple[str, str]]:
    spans = {tag: sorted({position for position, _ in marks}) for tag, marks in marked.items()}
    whole = {tag: span for tag, span in spans.items() if len(span) == 2}
    for (tag, (start, end)), (other, (start2, end2)) in combinations(whole.items(), 2):
        if start < start2 <= end < end2 or start2 < start <= end2 < end:
            yield (
                f"loops that do not cross in {where}",
                f"{tag} (steps {start} to {end}) and {other} ({start2} to {end2})",
            )


def _fault(place: Place, expected: str, found: str) -> Fault:
    return Fault(place, expected, found, "the application is not run")
