"""Whether the loops of a flow are well formed (requirement E01, reading 23)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.model.application import Action, AppFlow, Icon, actions
from onika.model.syntax import Syntax
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class Loop:
    """A well-formed loop: the positions of its first and last action; the test is one of them, the anchor the other."""

    tag: str
    start: int
    end: int
    test: int

    @property
    def is_top(self) -> bool:
        """Whether the test comes first."""
        return self.test == self.start


@dataclass(frozen=True, slots=True)
class _Mark:
    """A tag at an action, whichever of its icons bears it."""

    position: int
    icon: Icon


_Marks = dict[str, list[_Mark]]


def faults(
    flow: AppFlow, syntax: Syntax, where: Reason, place: Place, every: Sequence[Action] | None = None
) -> tuple[Fault, ...]:
    """What is wrong with the loop tags of a flow; `where` names it in the text.

    A tag stands at exactly two different actions of the flow, exactly one of them the test; loops are apart or one
    within the other. A mark on a target counts for its action, which bears one (reading 24, requirement D06). The
    condition of a loop stands at its test. Flows of branches are not looked into. `every` are the actions of the flow,
    where they are known already.
    """
    marked = _marked(flow, actions(flow, syntax) if every is None else every)
    faults_of_loops = (*_counts(marked, where), *_shared(marked, where), *_crossings(marked, where))
    return tuple(Fault(Place(place.file, mark.icon.line), reason, NOT_RUN) for mark, reason in faults_of_loops)


def loops(flow: AppFlow, every: Sequence[Action]) -> tuple[Loop, ...]:
    """The well-formed loops of a flow whose actions are `every`."""
    marked = _marked(flow, every)
    broken = {mark.icon.while_tag for mark, _ in (*_counts(marked, NOTHING), *_shared(marked, NOTHING))}
    whole = {tag: loop for tag, loop in _whole(marked).items() if tag not in broken}
    crossing = {loop for pair in _crossing(whole) for loop in pair}
    return tuple(loop for loop in whole.values() if loop not in crossing)


_Reasons = Iterator[tuple[_Mark, Reason]]


def _marked(flow: AppFlow, every: Sequence[Action]) -> _Marks:
    """For every tag the marks that bear it, in the order of the flow."""
    owners = {at: action.position for action in every for at in range(action.position, action.end)}
    marked: _Marks = {}
    for at, step in enumerate(flow.steps):
        if isinstance(step, Icon) and step.while_tag is not None:
            marked.setdefault(step.while_tag, []).append(_Mark(owners.get(at, at), step))
    return marked


def _at(mark: _Mark) -> Reason:
    return Reason.of("rules.step", name=mark.icon.onikon.name, position=mark.position)


def _counts(marked: _Marks, where: Reason) -> _Reasons:
    for tag, marks in marked.items():
        places = {mark.position for mark in marks}
        tests = {mark.position for mark in marks if mark.icon.while_test}
        if len(places) == 1 and len(marks) == 2:
            yield marks[0], Reason.of("rules.loop_at_one_action", tag=tag, flow=where, at=_at(marks[0]))
        elif len(places) != 2:
            last = _at(marks[-1])
            yield marks[-1], Reason.of("rules.loop_tag_count", tag=tag, flow=where, count=len(places), at=last)
        if len(tests) != 1:
            last = _at(marks[-1])
            yield marks[-1], Reason.of("rules.loop_test_count", tag=tag, flow=where, count=len(tests), at=last)
        for mark in marks:
            if mark.icon.while_if and mark.position not in tests:
                yield mark, Reason.of("rules.loop_condition_misplaced", tag=tag, flow=where, at=_at(mark))


def _shared(marked: _Marks, where: Reason) -> _Reasons:
    """Actions whose job bears one tag and whose target another: an action keeps one mark only."""
    tags: dict[int, dict[str, _Mark]] = {}
    for tag, marks in marked.items():
        for mark in marks:
            tags.setdefault(mark.position, {}).setdefault(tag, mark)
    for _, several in sorted(tags.items()):
        if len(several) > 1:
            last = list(several.values())[-1]
            yield last, Reason.of("rules.loops_share_action", flow=where, tags=tuple(several), at=_at(last))


def _whole(marked: _Marks) -> dict[str, Loop]:
    """The loops whose tag stands at two actions, by tag."""
    loops_by_tag = {}
    for tag, marks in marked.items():
        places = sorted({mark.position for mark in marks})
        tests = [mark.position for mark in marks if mark.icon.while_test]
        if len(places) == 2:
            loops_by_tag[tag] = Loop(tag, places[0], places[1], tests[0] if tests else places[1])
    return loops_by_tag


def _crossings(marked: _Marks, where: Reason) -> _Reasons:
    for pair in _crossing(_whole(marked)):
        spans = tuple(Reason.of("rules.loop_span", tag=loop.tag, start=loop.start, end=loop.end) for loop in pair)
        yield marked[pair[1].tag][0], Reason.of("rules.loops_cross", flow=where, loops=spans)


def _crossing(spans: dict[str, Loop]) -> Iterator[tuple[Loop, Loop]]:
    """Loops are opened and closed like brackets: what is open above one that closes crosses it."""
    opened = sorted(spans.values(), key=lambda loop: (-loop.start, loop.end))
    is_open: list[Loop] = []
    for loop in sorted(spans.values(), key=lambda loop: (loop.end, -loop.start)):
        while opened and opened[-1].start <= loop.end:
            is_open.append(opened.pop())
        at = is_open.index(loop)
        yield from ((loop, other) for other in is_open[at + 1 :] if loop.start < other.start)
        del is_open[at]
